#pragma once

#include <vector>

#include "mesher/grains/grain_triangulation.hpp"

namespace pcvt {

/// Refinement aims at angles above this, degrees: a little more than is promised.
inline constexpr double kWantedAngle = 22;

struct RefinementSizes {
    /// For each face of the cells how long edges inside of it are, length units.
    std::vector<double> of_cell;
    /// The same for the edges of cells; infinite: they are cut already.
    double of_edges;
};

/// What refinement could not do.
struct RefinementLeft {
    /// Triangles given up as they are.
    int n_given_up = 0;
    /// Vertices at the ends of firm edges that stood in the way of a triangle with an angle that is
    /// not above kSmallestAngle.
    std::vector<int> in_the_way;
};

/// Refines until edges are as long as `sizes` tells and no angle is smaller than kWantedAngle, but
/// for triangles whose three edges are firm.
///
/// J. Ruppert's Delaunay refinement (J. Algorithms 18, 1995) on the torus: a cell edge is split
/// where a vertex lies in the circle over it, else a triangle that is too large or too thin gets a
/// vertex in its circumcentre, or nearer to its shortest edge where that is enough (A. Ungor's
/// off-centre). A split acts on both sides of an edge, so cells stay conforming. Largest
/// circumradius first.
RefinementLeft refine(GrainTriangulation& grains, const RefinementSizes& sizes);

}  // namespace pcvt
