#pragma once

#include "mesher/lattice/reduced_frame.hpp"
#include "mesher/lattice/sites.hpp"

namespace pcvt {

/// What a step adds to the coordinates of sites in the reduced basis: t times a direction, without
/// the whole periods.
///
/// Moves are rounded to multiples of 2^-51, as coordinates are: so a move is exact, and that of
/// minus t, since rounding is symmetric, leads back exactly.
class SiteMoves {
   public:
    /// @param direction  x, y, x, y, ... in the frame. Not copied: it must live and stay as it is
    ///                   for as long as moves are asked for.
    SiteMoves(const ReducedFrame& frame, const Eigen::VectorXf& direction, double t)
        : frame_(frame), direction_(direction.data()), t_(t) {}

    /// The moves that lead back.
    SiteMoves back() const;
    /// That of one site; zero where it would not be finite.
    Vec2 of(SiteId site) const;

    struct Outcome {
        /// Whether all moves were finite.
        bool finite;
        /// Whether no coordinate left [-1, 2).
        bool in_range;
    };
    /// Moves sites `begin` to `end`.
    /// @param coordinates  2 x n, in [-1, 2) before, in [-1.5, 2.5) after.
    Outcome apply(SiteId begin, SiteId end, Points& coordinates) const;

   private:
    ReducedFrame frame_;
    const float* direction_;
    double t_;
};

}  // namespace pcvt
