#include "mesher/space/delaunay/moving_tetrahedra.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "mesher/space/delaunay/tetrahedra_untangling.hpp"
#include "mesher/space/geometry/hilbert_curve.hpp"

namespace pcvt::space {
namespace {

/// A local repair that moves back more sites than this share, and more than this number, costs more
/// than a new build.
constexpr double kMostHeldShare = 0.2;
constexpr std::size_t kMostHeldAtLeast = 16;

/// Where more facets than this for each site may not be locally Delaunay, a local repair costs more
/// than a new build.
constexpr double kMostSuspectFacets = 1.5;

/// After flips of this share of the tetrahedra, most of them lie far from their neighbours in
/// memory.
constexpr double kFlipsUntilSorting = 0.1;

/// The longest move of one step, periods.
constexpr double kFarthest = 2;
constexpr int kSitesPerTask = 1 << 14;

double unit_near(double length) {
    int exponent = 0;
    std::frexp(length, &exponent);
    return std::ldexp(1.0, exponent);
}

Points in_order(const Points& coordinates, const std::vector<SiteId>& order) {
    Points ordered(3, coordinates.cols());
    for (Eigen::Index s = 0; s < coordinates.cols(); ++s)
        ordered.col(s) = coordinates.col(order[s]);
    return ordered;
}

}  // namespace

MovingTetrahedra::MovingTetrahedra(const Sites& sites)
    : lattice_(sites.lattice()),
      reduction_(sites.reduction()),
      gram_(gram_of(reduction_.reduced)),
      unit_(unit_near(sites.spacing())),
      spacing_(sites.spacing() / unit_),
      frame_(reduction_.reduced, unit_),
      order_(hilbert_order(sites.coordinates())),
      coordinates_(in_order(sites.coordinates(), order_)),
      tetrahedra_(torus_tetrahedra(wrapped_sites())) {}

bool MovingTetrahedra::step(const Eigen::VectorXf& direction, double t, Workers& workers) {
    before_.resize(3, n_sites());
    std::atomic<bool> valid = true;
    workers.for_each(n_sites() / kSitesPerTask + 1, [&](int task) {
        const SiteId end = std::min(n_sites(), (task + 1) * kSitesPerTask);
        for (SiteId s = task * kSitesPerTask; s < end; ++s) {
            const auto d = direction.segment<3>(kNumbersPerSite * Eigen::Index{s}).cast<double>();
            const Vec3 move = frame_.to_lattice(t * d);
            if (!(move.cwiseAbs().maxCoeff() <= kFarthest)) valid = false;
            before_.col(s) = coordinates_.col(s) + snapped_displacement(move);
        }
    });
    if (!valid) return false;
    before_.swap(coordinates_);
    settled_ = false;
    keep_in_range();
    return true;
}

void MovingTetrahedra::step_back() {
    coordinates_.swap(before_);
    settled_ = true;
    keep_in_range();
}

void MovingTetrahedra::keep_in_range() {
    std::vector<Offset> change;
    for (SiteId s = 0; s < n_sites(); ++s) {
        const Vec3 at = coordinates_.col(s);
        if (at.minCoeff() >= -1 && at.maxCoeff() < 2) continue;
        const Vec3 whole = at.array().floor();
        coordinates_.col(s) -= whole;
        if (!settled_) before_.col(s) -= whole;
        if (valid_.cols() > 0) valid_.col(s) -= whole;
        change.resize(static_cast<std::size_t>(n_sites()));
        change[s] = {int(whole.x()), int(whole.y()), int(whole.z())};
    }
    if (!change.empty()) tetrahedra_.add_to_offsets(change);
}

void MovingTetrahedra::certify() {
    keep_sorted();
    valid_ = coordinates_;
}

void MovingTetrahedra::keep_sorted() {
    const auto limit = static_cast<std::int64_t>(kFlipsUntilSorting * tetrahedra_.n_tetrahedra());
    if (n_flips_ - n_flips_sorted_ <= limit) return;
    tetrahedra_.sort();
    n_flips_sorted_ = n_flips_;
}

Suspects MovingTetrahedra::violations(Suspects suspects) const {
    std::erase_if(suspects.tetrahedra,
                  [this](int t) { return is_positive(tetrahedra_, coordinates_, t); });
    // The test of a facet needs positive tetrahedra.
    if (!suspects.tetrahedra.empty()) return suspects;
    std::erase_if(suspects.facets, [this](int f) {
        return is_locally_delaunay(tetrahedra_, coordinates_, gram_, f);
    });
    return suspects;
}

std::optional<ExchangedTetrahedra> MovingTetrahedra::restore(Suspects wrong) {
    if (double(wrong.facets.size()) > kMostSuspectFacets * n_sites()) return std::nullopt;
    return wrong.tetrahedra.empty() ? flip(wrong.facets)
                                    : untangle(wrong.tetrahedra, std::move(wrong.facets));
}

std::optional<ExchangedTetrahedra> MovingTetrahedra::flip(const std::vector<int>& facets) {
    TetrahedraFlips flips(tetrahedra_, coordinates_, gram_);
    const bool done = flips.flip(facets);
    n_flips_ += flips.n_flips();
    if (!done) return std::nullopt;
    return flips.take_exchanged();
}

std::optional<ExchangedTetrahedra> MovingTetrahedra::untangle(const std::vector<int>& inverted,
                                                              std::vector<int> facets) {
    if (valid_.cols() == 0) return std::nullopt;
    const auto share = static_cast<std::size_t>(kMostHeldShare * n_sites());
    TetrahedraUntangling untangling(tetrahedra_, valid_, coordinates_, gram_);
    const bool done =
        untangling.run(inverted, std::move(facets), std::max(share, kMostHeldAtLeast));
    n_flips_ += untangling.n_flips();
    if (!done) return std::nullopt;
    return untangling.take_exchanged();
}

bool MovingTetrahedra::rebuild() {
    valid_.resize(3, 0);
    const Sites sites = wrapped_sites();
    if (sites.duplicates().first >= 0) return false;
    // The sites before the step get the same offsets.
    if (!settled_) before_ -= coordinates_ - sites.coordinates();
    coordinates_ = sites.coordinates();
    tetrahedra_ = torus_tetrahedra(sites);
    n_flips_sorted_ = n_flips_;
    ++n_rebuilds_;
    return true;
}

PeriodicDelaunay MovingTetrahedra::release(TorusTetrahedra tetrahedra) {
    tetrahedra_ = std::move(tetrahedra);
    return release();
}

PeriodicDelaunay MovingTetrahedra::release() {
    std::vector<Offset> change(static_cast<std::size_t>(n_sites()));
    Points coordinates(3, n_sites());
    for (SiteId s = 0; s < n_sites(); ++s) {
        change[s] = wrap(coordinates_.col(s)).whole;
        coordinates.col(order_[s]) = coordinates_.col(s);
    }
    tetrahedra_.add_to_offsets(change);
    tetrahedra_.renumber_sites(order_);
    return {Sites(lattice_, reduction_, std::move(coordinates)), std::move(tetrahedra_)};
}

}  // namespace pcvt::space
