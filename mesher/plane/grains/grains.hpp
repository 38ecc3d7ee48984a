#pragma once

#include <functional>
#include <string>

#include "mesher/base/error.hpp"
#include "mesher/plane/grains/triangle_shape.hpp"
#include "mesher/plane/mesh/periodic_mesh.hpp"

namespace pcvt::plane {

/// A corner of a cell, or of a piece of one, where an angle of at most kSmallestAngle is
/// unavoidable: either the angle of the corner itself is that small, or it is at most 60 degrees
/// and another corner at the same vertex has less than 7 degrees.
struct NamedCorner {
    /// The index of the corner in the cells.
    int corner;
    /// The angle of the corner, degrees.
    double angle;
};

/// The cells, meshed by triangles.
struct Grains {
    /// One face per triangle (`kGrains`), with the site of its cell.
    PeriodicMesh triangles;
    /// For each triangle, its face of the cells, whose frame it shares.
    std::vector<int> cell;
    std::vector<NamedCorner> named_corners;
    /// The smallest angle outside the named corners, degrees.
    double smallest_angle;
};

/// A cell, or a piece of one, needs too many triangles.
class ThinCell : public LimitExceeded {
   public:
    explicit ThinCell(SiteId site)
        : ThinCell(site, "the cell of site " + std::to_string(site) +
                             " is too thin to be meshed by grains") {}
    /// @param what  the whole message.
    ThinCell(SiteId site, const std::string& what) : LimitExceeded(what), site_(site) {}
    SiteId site() const { return site_; }

   private:
    SiteId site_;
};

/// Meshes each cell, or each piece of one, by triangles with edges about `size` long.
///
/// Example usage:
///   const double h = std::sqrt(lattice.area() / n);
///   const PeriodicMesh cells = without_short_edges(cell_mesh(delaunay), kShortGrainEdge * h);
///   const Grains grains = mesh_grains(cells, h / 3);
///
/// Sharp corners get a guard (corner_guards.hpp), Ruppert's algorithm refines the rest
/// (grain_refinement.hpp), and smoothing widens the remaining thin triangles (grain_smoothing.hpp).
/// Laws, tested by number:
///   (1) The triangles are a mesh of the same torus: V - E + F = 0, and the triangles of a cell
///       cover it.
///   (2) Neighbouring cells share the vertices on their common edge, also across a seam.
///   (3) All angles outside the named corners are above kSmallestAngle. (No proof is known;
///       thousands of hard random cells were tested, and smallest_angle reports the result.)
/// Cost: O(n log n) in the number of triangles.
///
/// @param cells  simple polygons. In a tile, a triangle takes the placement of its cell.
/// @param size   length units, above 0.
/// @param progress  as refine()'s.
/// @throws ThinCell if a cell is thousands of times longer than wide.
Grains mesh_grains(const PeriodicMesh& cells, double size,
                   const std::function<void(double)>& progress = {});

/// Meshes cells with each of their edges cut into `parts` parts, or into more where good angles or
/// guards require it. The target size inside a cell is the average length of the parts of its
/// edges.
/// @param parts  above 0.
Grains mesh_grains_per_edge(const PeriodicMesh& cells, int parts,
                            const std::function<void(double)>& progress = {});

}  // namespace pcvt::plane
