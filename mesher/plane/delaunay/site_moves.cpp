#include "mesher/plane/delaunay/site_moves.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/base/target_clones.hpp"

namespace pcvt::plane {
namespace {

/// Converts a translation in the frame to a change of reduced coordinates.
class ToLattice {
   public:
    explicit ToLattice(const ReducedFrame& frame)
        : per_ax_(1 / frame.ax), per_by_(1 / frame.by), bx_(frame.bx) {}
    struct Change {
        double u;
        double v;
    };
    Change operator()(double x, double y) const {
        const double v = y * per_by_;
        return {(x - bx_ * v) * per_ax_, v};
    }

   private:
    double per_ax_;
    double per_by_;
    double bx_;
};

/// Reduces a change by whole periods; NaN where the change is not finite.
double without_periods(double change) { return change - std::nearbyint(change); }

double rounded_or_zero(double part) { return snapped_displacement(std::isnan(part) ? 0 : part); }

struct Counts {
    std::int64_t not_finite = 0;
    std::int64_t outside = 0;
};

PCVT_TARGET_CLONES Counts move(const float* direction, double t, ToLattice to_lattice,
                               double* coordinates, Eigen::Index n) {
    Counts counts;
    for (Eigen::Index k = 0; k < 2 * n; k += 2) {
        const auto change = to_lattice(t * double(direction[k]), t * double(direction[k + 1]));
        const double du = without_periods(change.u);
        const double dv = without_periods(change.v);
        counts.not_finite += int(std::isnan(du)) | int(std::isnan(dv));
        const double u = coordinates[k] + rounded_or_zero(du);
        const double v = coordinates[k + 1] + rounded_or_zero(dv);
        counts.outside += int(!(std::min(u, v) >= -1)) | int(!(std::max(u, v) < 2));
        coordinates[k] = u;
        coordinates[k + 1] = v;
    }
    return counts;
}

}  // namespace

SiteMoves SiteMoves::back() const {
    SiteMoves moves = *this;
    moves.t_ = -t_;
    return moves;
}

/// The change of a site without its tie, less whole periods and not rounded; NaN where it is not
/// finite.
Vec2 SiteMoves::change_of(SiteId site) const {
    const float* d = direction_ + 2 * std::size_t(site);
    const auto change = ToLattice(frame_)(t_ * double(d[0]), t_ * double(d[1]));
    return {without_periods(change.u), without_periods(change.v)};
}

Vec2 SiteMoves::of(SiteId site) const {
    if (ties_ == nullptr) return change_of(site).unaryExpr(&rounded_or_zero);
    // An integer matrix times multiples of 2^-51 is exact.
    const auto& [representative, m] = (*ties_)[site];
    const Vec2 move = change_of(representative).unaryExpr(&rounded_or_zero);
    return {m[0] * move.x() + m[1] * move.y(), m[2] * move.x() + m[3] * move.y()};
}

SiteMoves::Outcome SiteMoves::apply_tied(SiteId begin, SiteId end, Points& coordinates) const {
    Outcome outcome{true, true};
    for (SiteId s = begin; s < end; ++s) {
        if (!change_of((*ties_)[s].representative).allFinite()) outcome.finite = false;
        coordinates.col(s) += of(s);
        const double least = coordinates.col(s).minCoeff();
        const double largest = coordinates.col(s).maxCoeff();
        if (!(least >= -1) || !(largest < 2)) outcome.in_range = false;
    }
    return outcome;
}

SiteMoves::Outcome SiteMoves::apply(SiteId begin, SiteId end, Points& coordinates) const {
    if (ties_ != nullptr) return apply_tied(begin, end, coordinates);
    const Counts counts = move(direction_ + 2 * std::size_t(begin), t_, ToLattice(frame_),
                               coordinates.data() + 2 * std::size_t(begin), end - begin);
    return {counts.not_finite == 0, counts.outside == 0};
}

}  // namespace pcvt::plane
