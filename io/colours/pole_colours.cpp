#include "io/colours/pole_colours.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "mesher/cells/orientations.hpp"

namespace pcvt {

std::array<std::uint8_t, 3> pole_colour(const BungeAngles& angles) {
    // The symmetries of a cube permute the components of the axis and change their signs.
    const Eigen::Vector3d axis = bunge_matrix(angles).col(2);
    std::array<double, 3> sorted{std::abs(axis.x()), std::abs(axis.y()), std::abs(axis.z())};
    std::sort(sorted.begin(), sorted.end(), std::greater<>());
    const auto& [largest, middle, least] = sorted;
    // The axis as a sum of multiples of the unit vectors along <001>, <011> and <111>.
    const std::array<double, 3> parts{largest - middle, (middle - least) * std::numbers::sqrt2,
                                      least * std::numbers::sqrt3};
    const double most = *std::max_element(parts.begin(), parts.end());
    std::array<std::uint8_t, 3> colour{};
    for (std::size_t k = 0; k < 3; ++k) {
        colour[k] = static_cast<std::uint8_t>(std::lround(255 * parts[k] / most));
    }
    return colour;
}

}  // namespace pcvt
