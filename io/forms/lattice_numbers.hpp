#pragma once

#include <Eigen/Core>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace pcvt {

/// Returns the lattice whose periods have these coordinates: those of the first period, then those
/// of the next one.
///
/// Example usage:
///     const auto lattice = lattice_from<plane::Lattice>(std::array{1.0, 0.0, 0.5, 0.9});
///
/// @pre numbers.size() is the square of the dimension.
/// @throws InvalidInput as the constructor of the lattice.
template <class Lattice>
Lattice lattice_from(std::span<const double> numbers) {
    constexpr std::size_t kSize = Lattice::kDimension;
    using Point = typename Lattice::Point;
    return [&]<std::size_t... k>(std::index_sequence<k...>) {
        return Lattice(Point(Eigen::Map<const Point>(&numbers[k * kSize]))...);
    }
    (std::make_index_sequence<kSize>());
}

/// Returns the numbers of seam_name(), "seam_I_J" or "seam_I_J_K"; none for any other name, or if
/// one is beyond kLargestOffset.
std::vector<int> offset_in_name(std::string_view name);

}  // namespace pcvt
