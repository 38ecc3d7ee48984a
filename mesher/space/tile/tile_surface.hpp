#pragma once

#include <vector>

#include "mesher/space/mesh/polyhedral_mesh.hpp"

namespace pcvt::space {

/// The boundary of a tile of polyhedra: a closed surface whose faces are matched in pairs. Glued
/// along the pairs, the tile becomes the flat 3-torus.
///
/// Laws, which prove_surface() proves by number:
///   (1) Every point belongs to a face, and every face has three distinct corners or more.
///   (2) The surface is a closed, oriented manifold: each directed edge occurs once and so does its
///       reverse, and the faces at each point are one fan.
///   (3) partner[partner[f]] = f and offset[partner[f]] = -offset[f], which is not (0, 0, 0); the
///       corners of the partner are those of the face plus the translation, traversed backwards.
///   (4) The surface encloses the volume of the domain.
///   (5) Where sites are stated, each face lies halfway between the site of its cell and that of
///   the
///       cell in front of it, which is the cell of its partner, translated back, or both are one
///       site, whose cell a box cuts there.
struct TileSurface {
    Lattice lattice;
    /// Positions, length units.
    std::vector<Vec3> points = {};
    /// On these points, counter-clockwise seen from outside.
    Faces faces = {};
    /// The cell behind each face.
    std::vector<SiteId> cell = {};
    /// The face that each face becomes by the translation of `offset`.
    std::vector<int> partner = {};
    std::vector<Offset> offset = {};
    /// The image of each site that lies in its cell, 3 x n; no column if they are not stated.
    Points sites = Points(3, 0);

    int n_faces() const { return faces.n_faces(); }
};

/// Returns the boundary of a tile, in the order of its patches.
///
/// Example usage:
///     const TileSurface surface = tile_surface(mesh, sites_in_cells(sites, mesh));
///     const SurfaceProof proof = prove_surface(surface);
TileSurface tile_surface(const PolyhedralMesh& mesh, const Points& sites);

}  // namespace pcvt::space
