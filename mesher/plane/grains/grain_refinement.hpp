#pragma once

#include <functional>
#include <vector>

#include "mesher/plane/grains/grain_triangulation.hpp"

namespace pcvt::plane {

/// Refinement aims at angles above this, degrees; it exceeds the guaranteed kSmallestAngle
/// slightly.
inline constexpr double kWantedAngle = 22;

struct RefinementSizes {
    /// For each face of the cells, the target length of the edges inside it, length units.
    std::vector<double> of_cell;
    /// The target length for the edges of the cells; infinite: they are divided already.
    double of_edges;
};

/// The defects that refinement could not remove.
struct RefinementLeft {
    /// The number of triangles that were not improved.
    int n_given_up = 0;
    /// The end vertices of firm edges that prevented the improvement of a triangle with an angle of
    /// at most kSmallestAngle.
    std::vector<int> in_the_way;
    /// The face of the cells that has the most triangles, if these became too many and refinement
    /// stopped; else -1.
    int too_thin = -1;
};

/// Refines until edges have about the lengths in `sizes` and no angle is smaller than kWantedAngle,
/// except in triangles with three firm edges.
///
/// Example usage:
///   GrainTriangulation grains(guarded.cells);
///   const std::vector<double> of_cell(cells.site.size(), 0.05);
///   const RefinementLeft left = refine(grains, {.of_cell = of_cell, .of_edges = 0.05});
///
/// Implements J. Ruppert's Delaunay refinement (J. Algorithms 18, 1995) on the torus. A cell edge
/// is split if a vertex lies in its diametral circle. Otherwise a triangle that is too large or too
/// thin gets a vertex at its circumcentre, or nearer to its shortest edge if that suffices (A.
/// Ungor's off-centre). A split acts on both sides of an edge, so neighbouring cells remain
/// conforming. Triangles are processed by decreasing circumradius.
///
/// @param progress  called now and then with the share that is done, about, from 0 to 1; an
///                  exception that it throws ends the refinement. May be empty.
RefinementLeft refine(GrainTriangulation& grains, const RefinementSizes& sizes,
                      const std::function<void(double)>& progress = {});

}  // namespace pcvt::plane
