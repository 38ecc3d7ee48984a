#pragma once

#include "mesher/lattice/reduced_frame.hpp"
#include "mesher/lattice/sites.hpp"

namespace pcvt {

/// The change of the sites' reduced coordinates in one step: t times a direction, reduced by whole
/// periods.
///
/// Moves are rounded to multiples of 2^-51, as coordinates are. A move is therefore exact, and
/// since rounding is symmetric, the move with -t restores the coordinates exactly.
class SiteMoves {
   public:
    /// @param direction  x, y, x, y, ... in the frame. Not copied: it must live and stay unchanged
    ///                   for as long as this object is used.
    SiteMoves(const ReducedFrame& frame, const Eigen::VectorXf& direction, double t)
        : frame_(frame), direction_(direction.data()), t_(t) {}

    /// Returns the inverse moves.
    SiteMoves back() const;
    /// The move of one site; zero where it would not be finite.
    Vec2 of(SiteId site) const;

    struct Outcome {
        /// Whether all moves were finite.
        bool finite;
        /// Whether no coordinate left [-1, 2).
        bool in_range;
    };
    /// Moves the sites begin ... end - 1.
    /// @param coordinates  2 x n, in [-1, 2) before, in [-1.5, 2.5) after.
    Outcome apply(SiteId begin, SiteId end, Points& coordinates) const;

   private:
    ReducedFrame frame_;
    const float* direction_;
    double t_;
};

}  // namespace pcvt
