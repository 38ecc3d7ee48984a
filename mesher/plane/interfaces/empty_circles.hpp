#pragma once

#include <span>

#include "mesher/plane/interfaces/interface_sites.hpp"

namespace pcvt::plane {

/// The circles of interfaces, sorted for the question whether a point lies inside of one.
///
/// Example usage:
///
///     const EmptyCircles circles(set.reduction().reduced, pairs.circles);
///     const bool is_free = !circles.contain(set.reduction().reduced.to_lattice(p));
class EmptyCircles {
   public:
    EmptyCircles(const Lattice& reduced, std::span<const EmptyCircle> circles);

    /// Whether a circle, enlarged by a thousandth of its radius, contains the point.
    /// @param u  reduced basis, anywhere.
    bool contain(const Vec2& u) const;

   private:
    Lattice reduced_;
    /// Squares across the domain, and for each the circles that may meet it, with the images that
    /// do: entries begin_[k] ... begin_[k + 1] - 1 belong to square k.
    std::array<int, 2> count_{};
    std::vector<int> begin_;
    struct Image {
        Vec2 centre;
        double radius;
    };
    std::vector<Image> images_;
};

}  // namespace pcvt::plane
