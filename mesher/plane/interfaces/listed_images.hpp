#pragma once

#include <string>
#include <vector>

#include "mesher/plane/geometry/lattice.hpp"
#include "mesher/plane/interfaces/inclusion.hpp"

namespace pcvt::plane {

/// Whether two shapes are one: both circles, ellipses or polygons, whose centres, semi-axes and
/// corners agree within 1e-9 of the size of the first, the radius of its bounding circle. Angles of
/// ellipses count modulo 180 degrees. Polygons may start at different corners, but must go through
/// them in one order.
bool is_same_shape(const Shape& first, const Shape& second);

/// The shapes of a list without those that are images of an earlier one with the same tag.
///
/// Example usage:
///     // The circles at the four corners of the unit square are one.
///     const std::vector<Inclusion> shapes = without_listed_images(square, Walls::kNone, corners);
///     const InclusionSet set(square, shapes);
///
/// Laws, tested by number:
///   (1) Images that are listed after their shape do not change the result.
///   (2) Between walls, the translations are those along the walls.
///   (3) A shape that differs from an image in its tag, its size or its kind remains.
///
/// @param domain  upright if it has walls.
/// @param listed  need not be valid; what InclusionSet refuses may remain.
/// Cost: of order n, for shapes of which few have the same centre.
std::vector<Inclusion> without_listed_images(const Lattice& domain, Walls walls,
                                             const std::vector<Inclusion>& listed);

/// Whether the second shape lies at the place of an image of the first, in which it should be
/// listed if it lies inside: its centre agrees with that of an image by a period, and its kind.
bool lies_on_image(const Lattice& reduced, const Inclusion& first, const Inclusion& second);

/// Complains about the second of two shapes that meet, on the torus of a reduced basis; the
/// complaint says if the shape lies on an image of the first.
std::string complaint_of_overlap(const Lattice& reduced, const Inclusion& first,
                                 const Inclusion& second);

}  // namespace pcvt::plane
