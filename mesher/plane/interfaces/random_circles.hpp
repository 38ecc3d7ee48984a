#pragma once

#include <cstdint>
#include <optional>

#include "mesher/plane/interfaces/inclusion.hpp"

namespace pcvt::plane {

/// Fibres of equal size in random places.
struct RandomCircles {
    /// The part of the domain that all circles cover together, in (0, 1).
    double fraction;
    int n;
    /// The least distance between two circles, and between a circle and its images, length units;
    /// `nullopt`: a fifth of the radius, or a half or a quarter of that where circles find no place
    /// otherwise.
    std::optional<double> gap = {};
};

/// Places equal circles that keep the gap on the torus. Random points repel each other while the
/// circles round them grow (after B. Lubachevsky, F. Stillinger 1990), so that fractions are
/// reached at which random sequential placement finds no room: 0.7 and more, gaps included. The
/// same seed gives the same circles on every machine.
///
/// Example usage:
///
///     const auto fibres = random_circles(lattice, {.fraction = 0.5, .n = 30}, 1);
///     const InclusionSet set(lattice, circular_inclusions(fibres, 1));
///
/// @param lattice  upright if there are walls.
/// @param walls    from which circles keep the gap as well.
/// @throws InvalidInput if a number is out of range, or if circles do not fit or no place is found
///         for them.
std::vector<Circle> random_circles(const Lattice& lattice, const RandomCircles& wanted,
                                   std::uint64_t seed, Walls walls = Walls::kNone);

}  // namespace pcvt::plane
