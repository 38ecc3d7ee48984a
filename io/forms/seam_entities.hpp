#pragma once

#include <array>
#include <vector>

#include "mesher/space/proof/tetrahedral_proof.hpp"

namespace pcvt {

/// The triangles of the boundary that one translation takes to their partners.
struct SeamSurface {
    /// The translation to the partner, and the index of that surface.
    space::Offset offset;
    int partner;
    /// Counter-clockwise seen from outside; triangle k of the partner is the image of triangle k.
    std::vector<std::array<int, 3>> triangles = {};
    /// The points inside, which lie on none of its curves.
    std::vector<int> points = {};
};

/// The edges between the same surfaces, all of whose images lie between the same surfaces.
struct SeamCurve {
    /// The curve of which this one is an image, or the curve itself; the translation from there.
    int master;
    space::Offset offset;
    /// Indices of the surfaces that meet here, rising.
    std::vector<int> surfaces;
    /// Edge k is the image of edge k of the master.
    std::vector<std::array<int, 2>> edges = {};
    /// The points inside, and those in which it ends.
    std::vector<int> points = {};
    std::vector<int> ends = {};
};

/// A point of the boundary in which curves end, or that several surfaces touch.
struct SeamPoint {
    int point;
    /// The index of the entity of which this one is an image, or of the point itself; the
    /// translation from there.
    int master;
    space::Offset offset;
};

/// The boundary of a tile of tetrahedra, divided as Gmsh and solvers need it. Laws, tested by
/// number:
///
///   (1) Each pair of boundary triangles lies on a surface and its partner.
///   (2) Each point of the tile lies inside of one surface or one curve, is a SeamPoint, or lies
///       inside of the tile; all images of a point on the boundary are of one kind.
///   (3) Curves and SeamPoints are images of their masters, which are their own masters.
struct SeamEntities {
    /// By positive offsets; each before its partner.
    std::vector<SeamSurface> surfaces = {};
    std::vector<SeamCurve> curves = {};
    std::vector<SeamPoint> points = {};
    /// The points inside of the tile.
    std::vector<int> inner_points = {};
};

/// Example usage:
///     const SeamEntities entities = seam_entities(mesh, prove_tetrahedra(mesh));
///     for (const SeamSurface& surface : entities.surfaces) write(surface.triangles);
///
/// Cost: s log s for s triangles of the boundary, and O(points).
SeamEntities seam_entities(const space::TetrahedralMesh& mesh,
                           const space::TetrahedralProof& proof);

}  // namespace pcvt
