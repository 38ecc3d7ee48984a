#pragma once

#include <vector>

#include "mesher/space/grains/grain_surface.hpp"

namespace pcvt::space {

/// Moves the inner nodes of faces that are not plane normal to them, to the mean of the heights of
/// the boundary that has mean value coordinates as weights (Floater, 2003: "Mean value
/// coordinates"). grain_surface() takes the heights of the nearest points of the boundary, which
/// leave steep triangles in a narrow face: a thin cell beside it may have no point that sees them
/// all.
///
/// Example usage:
///     smooth_heights(complex, {face}, surface);
///
/// Law, tested by number:
///   (1) Heights that are linear in the plane of the face on its boundary are so everywhere.
void smooth_heights(const CellComplex& complex, const std::vector<int>& faces,
                    GrainSurface& surface);

}  // namespace pcvt::space
