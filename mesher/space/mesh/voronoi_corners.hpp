#pragma once

#include <vector>

#include "mesher/space/mesh/cell_complex.hpp"

namespace pcvt::space {

/// The corners of Voronoi cells: circumcentres of tetrahedra, those of cospherical sites once. With
/// weights those of power cells, the points of equal power distance to four sites.
struct VoronoiCorners {
    /// Positions, length units.
    std::vector<Vec3> positions;
    /// The image of a vertex at the circumcentre of each tetrahedron, in the tetrahedron's frame.
    std::vector<VertexImage> of_tetrahedron;
};

/// Merges circumcentres of adjacent tetrahedra within 1e-9 h of each other. The centre of a
/// tetrahedron that is flat up to the rounding of its sites (four sites on a circle) is not
/// determined; it becomes the one of an adjacent tetrahedron, since that edge of the diagram has no
/// corner between its ends.
///
/// Example usage:
///     const VoronoiCorners corners = voronoi_corners(sites, tetrahedra);
///     const Vec3 centre = corners.positions[corners.of_tetrahedron[t].vertex];
///
/// @param weights  length^2, one a site; empty for Voronoi cells.
VoronoiCorners voronoi_corners(const Sites& sites, const TorusTetrahedra& tetrahedra,
                               const Eigen::VectorXd& weights = {});

}  // namespace pcvt::space
