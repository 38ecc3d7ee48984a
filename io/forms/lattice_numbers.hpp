#pragma once

#include <Eigen/Core>
#include <span>
#include <utility>

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

}  // namespace pcvt
