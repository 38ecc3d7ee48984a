#pragma once

#include "mesher/plane/interfaces/inclusion_set.hpp"

namespace pcvt::plane {

/// Slides nodes along a curve onto the sides of the set's box, where a side crosses the curve
/// within a fifth of a chord from the node; without a box, none. The vertices of cells at nodes do
/// not move when a box cuts cells, and a node close to a side, but not on it, would make slivers.
///
/// Law (1): a node that slid lies on its side of the box to rounding errors.
///
/// Example usage:
///
///     slide_onto_box(set, ellipse, degrees);
///     const double scale = scale_to_area(ellipse, degrees);

/// @param degrees  of EllipseAxes::at_degrees(), increasing, less than a turn in all. The nodes lie
///                 on the ellipse times scale_to_area().
void slide_onto_box(const InclusionSet& set, const EllipseAxes& ellipse,
                    std::vector<double>& degrees);

/// The factor by which the nodes' polygon needs to be scaled from its centre so that it has the
/// area of the ellipse.
double scale_to_area(const EllipseAxes& ellipse, const std::vector<double>& degrees);

/// @param along   unit vector.
/// @param places  distances from the point `from` along a straight line, increasing; the first and
///                the last one stay.
void slide_onto_box(const InclusionSet& set, const Vec2& from, const Vec2& along,
                    std::vector<double>& places);

}  // namespace pcvt::plane
