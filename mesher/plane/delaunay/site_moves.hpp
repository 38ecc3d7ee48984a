#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesher/plane/geometry/reduced_frame.hpp"
#include "mesher/plane/geometry/sites.hpp"

namespace pcvt::plane {

/// A site whose move is an integer matrix times the move of its representative, in reduced
/// coordinates. A lattice isometry defines the matrix, together with the mirror on which the
/// representative lies, if any.
struct MoveTie {
    SiteId representative = 0;
    /// Row by row. Sums of two entries of a row times 1/2 are at most 1.
    std::array<std::int8_t, 4> matrix{1, 0, 0, 1};
};

/// The change of the sites' reduced coordinates in one step: t times a direction, reduced by whole
/// periods.
///
/// Moves are rounded to multiples of 2^-51, as coordinates are. A move is therefore exact, and
/// since rounding is symmetric, the move with -t restores the coordinates exactly.
class SiteMoves {
   public:
    /// @param direction  x, y, x, y, ... in the frame. Not copied: it must live and stay unchanged
    ///                   for as long as this object is used.
    /// @param ties       nullptr, or one for each site; of the direction then only the entries of
    ///                   representatives count. Not copied.
    SiteMoves(const ReducedFrame& frame, const Eigen::VectorXf& direction, double t,
              const std::vector<MoveTie>* ties = nullptr)
        : frame_(frame), direction_(direction.data()), t_(t), ties_(ties) {}

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
    /// @param coordinates  2 x n, in [-1, 2) before, in [-1.5, 2.5) after, or with ties in [-2, 3).
    Outcome apply(SiteId begin, SiteId end, Points& coordinates) const;

   private:
    Vec2 change_of(SiteId site) const;
    Outcome apply_tied(SiteId begin, SiteId end, Points& coordinates) const;

    ReducedFrame frame_;
    const float* direction_;
    double t_;
    const std::vector<MoveTie>* ties_;
};

}  // namespace pcvt::plane
