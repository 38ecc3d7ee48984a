#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mesher/base/workers.hpp"
#include "mesher/plane/delaunay/lawson_flips.hpp"
#include "mesher/plane/delaunay/moving_delaunay.hpp"
#include "mesher/plane/delaunay/patch_plan.hpp"

namespace pcvt::plane {

/// A compact copy of a part of a MovingDelaunay, in which some sites move and all others stay.
///
/// It has the interface of a moving triangulation, with the same frame and unit; its sites are the
/// moving ones, numbered as in PatchPlan::moving. Flips take place inside of the patch only: an
/// edge on its border counts as locally Delaunay. The sites that move are two rings of triangles
/// away from the border, so that this seldom matters; an evaluation of the whole triangulation
/// restores it where it does.
///
/// Example usage:
///
///     DelaunayPatch patch(whole, plans, 0);
///     PatchPass pass(patch);
///     if (patch.step(direction, t, workers) && pass.evaluate(energy)) patch.settle();
///     whole.adopt(patch.moving(), patch.coordinates(), patch.flips());
class DelaunayPatch final : private FlipObserver {
   public:
    static constexpr int kDimension = 2;
    static constexpr int kNumbersPerSite = 2;
    static constexpr bool kStepsUnrestored = false;

    /// @param plans   made for the current triangulation of `whole`.
    /// @param number  the plan of this patch.
    DelaunayPatch(const MovingDelaunay& whole, const PatchPlans& plans, int number);
    DelaunayPatch(const DelaunayPatch&) = delete;
    DelaunayPatch& operator=(const DelaunayPatch&) = delete;

    /// The number of sites that move.
    int n_sites() const { return static_cast<int>(plan_.moving.size()); }
    double spacing() const { return spacing_; }
    double unit() const { return unit_; }
    const ReducedFrame& frame() const { return frame_; }
    /// A column for each site, those that move first; reduced basis.
    const Points& coordinates() const { return coordinates_; }
    const TorusTriangulation& triangulation() const { return triangulation_; }

    /// Moves the sites by t times `direction` (frame, units). Does not restore the triangulation.
    /// @returns false if a move is not finite, or if a site would leave [-1, 2); no site has moved
    ///          then.
    bool step(const Eigen::VectorXf& direction, double t, Workers& workers);
    bool step(Eigen::VectorXf&& direction, double t, Workers& workers) = delete;
    void step_back();
    void settle() { settled_ = true; }
    bool settled() const { return settled_; }

    bool is_certainly_delaunay(int h) const {
        return pcvt::plane::is_certainly_delaunay(triangulation_, coordinates_, gram_, h);
    }
    /// Restores the triangulation by flips; no triangle may be inverted. Empties `suspects`.
    /// @returns the number of flips.
    std::int64_t flip(std::vector<int>& suspects);

    /// The sites of the whole triangulation that move, and the halfedges there that were flipped,
    /// in order.
    std::span<const SiteId> moving() const { return plan_.moving; }
    std::span<const int> flips() const { return flips_; }

   private:
    void before_flip(int h) override { flips_.push_back(halfedge_of_whole(h)); }
    void after_flip(int /*h*/) override {}
    int halfedge_of_whole(int h) const { return 3 * plan_.triangles[h / 3] + h % 3; }

    Gram gram_;
    double unit_;
    double spacing_;
    ReducedFrame frame_;
    PatchPlan plan_;
    Points coordinates_;
    TorusTriangulation triangulation_;
    std::optional<SiteMoves> moves_;
    bool settled_ = true;
    std::vector<int> flips_;
};

}  // namespace pcvt::plane
