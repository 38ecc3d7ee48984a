#include "mesher/plane/delaunay/delaunay_patch.hpp"

#include <utility>

namespace pcvt::plane {
namespace {

Points local_coordinates(const Points& whole, const PatchPlan& plan) {
    Points points(2, static_cast<Eigen::Index>(plan.moving.size() + plan.others.size()));
    Eigen::Index next = 0;
    for (const SiteId site : plan.moving) points.col(next++) = whole.col(site);
    for (const SiteId site : plan.others) points.col(next++) = whole.col(site);
    return points;
}

TorusTriangulation local_triangulation(const TorusTriangulation& whole, const PatchPlans& plans,
                                       int number) {
    const PatchPlan& plan = plans.patch(number);
    const std::size_t n = plan.triangles.size();
    std::vector<SiteId> corners(3 * n);
    std::vector<CornerOffsets> offsets(n);
    std::vector<int> opposite(3 * n);
    for (int t = 0; t < static_cast<int>(n); ++t) {
        const int of_whole = plan.triangles[t];
        offsets[t] = whole.corner_offsets()[of_whole];
        for (int k = 0; k < 3; ++k) {
            const int h = 3 * t + k;
            corners[h] = plans.place_of_site(whole.corner_sites()[3 * of_whole + k]);
            const int beyond = whole.opposite(3 * of_whole + k);
            const int neighbour = plans.place_of_triangle(number, beyond / 3);
            opposite[h] = neighbour < 0 ? h : 3 * neighbour + beyond % 3;
        }
    }
    return TorusTriangulation::part(static_cast<int>(plan.moving.size() + plan.others.size()),
                                    std::move(corners), std::move(offsets), std::move(opposite));
}

}  // namespace

DelaunayPatch::DelaunayPatch(const MovingDelaunay& whole, const PatchPlans& plans, int number)
    : gram_(whole.gram()),
      unit_(whole.unit()),
      spacing_(whole.spacing()),
      frame_(whole.frame()),
      plan_(plans.patch(number)),
      coordinates_(local_coordinates(whole.coordinates(), plan_)),
      triangulation_(local_triangulation(whole.triangulation(), plans, number)) {}

bool DelaunayPatch::step(const Eigen::VectorXf& direction, double t, Workers& /*workers*/) {
    const SiteMoves moves(frame_, direction, t);
    const SiteMoves::Outcome outcome = moves.apply(0, n_sites(), coordinates_);
    if (!outcome.finite || !outcome.in_range) {
        moves.back().apply(0, n_sites(), coordinates_);
        return false;
    }
    settled_ = false;
    moves_ = moves;
    return true;
}

void DelaunayPatch::step_back() {
    moves_->back().apply(0, n_sites(), coordinates_);
    settled_ = true;
}

std::int64_t DelaunayPatch::flip(std::vector<int>& suspects) {
    return LawsonFlips(triangulation_, coordinates_, gram_).flip(suspects, this);
}

}  // namespace pcvt::plane
