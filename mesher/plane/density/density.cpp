#include "mesher/plane/density/density.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/simd.hpp"
#include "mesher/base/target_clones.hpp"
#include "mesher/portable/decimal_text.hpp"

namespace pcvt::plane {
namespace {

std::string digits(double value) {
    if (std::isnan(value)) return "not a number";
    std::array<char, 32> text;
    char* const end =
        write_decimal(text.data(), text.data() + text.size(), value, std::chars_format::general, 6);
    return {text.data(), end};
}

bool is_density(double rho) { return rho >= kLeastDensity && rho <= kGreatestDensity; }

[[noreturn]] void throw_bad_density(const DensityPoint& p, double rho) {
    const bool positive = std::isfinite(rho) && rho > 0;
    throw BadDensity(
        "the density is " + digits(rho) + " at x = " + digits(p.x) + ", y = " + digits(p.y) +
        " (u = " + digits(p.u) + ", v = " + digits(p.v) + "); " +
        (positive ? "keep it between 1e-60 and 1e60" : "make it positive and finite everywhere"));
}

/// Extends a range by n numbers, rounded up to full lanes; returns whether all of them are
/// admissible densities.
PCVT_TARGET_CLONES bool find_extremes(const double* rho, std::size_t n, double& least,
                                      double& greatest) {
    Lanes low = Lanes{} + least;
    Lanes high = Lanes{} + greatest;
    // Stays zero unless a number is infinite or NaN.
    Lanes not_finite{};
    for (std::size_t k = 0; k < n; k += kLanes) {
        Lanes r;
        std::memcpy(&r, rho + k, sizeof r);
        low = r < low ? r : low;
        high = r > high ? r : high;
        not_finite += 0 * r;
    }
    bool is_sound = true;
    for (int k = 0; k < kLanes; ++k) {
        least = std::min(least, low[k]);
        greatest = std::max(greatest, high[k]);
        is_sound &= not_finite[k] == 0;
    }
    return is_sound && least >= kLeastDensity && greatest <= kGreatestDensity;
}

}  // namespace

Density fixed_to_lattice(Density density, const Lattice& lattice) {
    density.make_function = [make = std::move(density.make_function), lattice]() {
        return [function = make(), lattice, fixed = std::vector<DensityPoint>()](
                   std::span<const DensityPoint> points, std::span<double> rho) mutable {
            fixed.assign(points.begin(), points.end());
            for (DensityPoint& p : fixed) {
                const Vec2 x = lattice.a() * p.u + lattice.b() * p.v;
                p.x = x.x();
                p.y = x.y();
            }
            function(fixed, rho);
            // Here the message names the point on `lattice`.
            const auto bad = std::find_if_not(rho.begin(), rho.end(), is_density);
            if (bad != rho.end()) throw_bad_density(fixed[std::size_t(bad - rho.begin())], *bad);
        };
    };
    return density;
}

void DensityRange::add(const DensityRange& other) {
    least = std::min(least, other.least);
    greatest = std::max(greatest, other.greatest);
    n_evaluations += other.n_evaluations;
}

void DensityRange::require_contrast() const {
    if (!(greatest > kMostContrast * least)) return;
    throw BadDensity("the density ranges from " + digits(least) + " to " + digits(greatest) +
                     ", a contrast above 1e12; raise its least value");
}

DensityPoint* DensityProbe::reserve(std::size_t n) {
    const std::size_t first = n_reserved_;
    n_reserved_ += n;
    if (points_.size() < n_reserved_) points_.resize(2 * n_reserved_);
    return points_.data() + first;
}

std::array<double*, 4> DensityProbe::reserve_columns(std::size_t n, std::size_t n_repeats) {
    const std::size_t first = n_columns_;
    n_columns_ += n;
    n_repeats_ += n_repeats;
    std::array<double*, 4> place{};
    for (std::size_t k = 0; k < 4; ++k) {
        if (!function_.uses()[k]) continue;
        if (columns_[k].size() < n_columns_) columns_[k].resize(2 * n_columns_);
        place[k] = columns_[k].data() + first;
    }
    return place;
}

PointColumns DensityProbe::columns() const {
    PointColumns points{{}, n_columns_};
    for (std::size_t k = 0; k < 4; ++k) {
        if (function_.uses()[k]) points.coordinate[k] = columns_[k].data();
    }
    return points;
}

DensityPoint DensityProbe::column_point(std::size_t k) const {
    const auto number = [&](std::size_t i) { return function_.uses()[i] ? columns_[i][k] : 0; };
    DensityPoint p{number(0), number(1), number(2), number(3)};
    // Compute the coordinates without columns from the others.
    if (!function_.uses()[0]) return point(p.u, p.v);
    if (function_.uses()[2]) return p;
    const double area = a_.x() * b_.y() - a_.y() * b_.x();
    p.u = (p.x * b_.y() - p.y * b_.x()) / area;
    p.v = (a_.x() * p.y - a_.y() * p.x) / area;
    return p;
}

/// Checks the first n values.
/// @param point  point(k) is the point of value k.
void DensityProbe::check(std::size_t n, const std::function<DensityPoint(std::size_t)>& point) {
    double* const rho = rho_.data();
    // The padding of the last lanes adds no new extreme.
    std::fill_n(rho + n, kLanes, n == 0 ? 1 : rho[0]);
    DensityRange range = range_;
    const bool in_limits = n == 0 || find_extremes(rho, n, range.least, range.greatest);
    if (!in_limits) {
        const auto k = static_cast<std::size_t>(std::find_if_not(rho, rho + n, is_density) - rho);
        throw_bad_density(point(k), rho[k]);
    }
    range.n_evaluations += static_cast<std::int64_t>(n);
    range_ = range;
}

std::span<const double> DensityProbe::evaluate(std::span<const DensityPoint> points) {
    const std::size_t n = points.size();
    if (rho_.size() < n + kLanes) rho_.resize(n + kLanes);
    function_(points, {rho_.data(), n});
    check(n, [&](std::size_t k) { return points[k]; });
    return {rho_.data(), n};
}

std::span<const double> DensityProbe::evaluate_reserved() {
    const std::span<const DensityPoint> points{points_.data(), std::exchange(n_reserved_, 0)};
    if (n_columns_ == 0) return evaluate(points);
    const std::size_t n_points = points.size();
    const std::size_t n = n_points + n_columns_;
    if (rho_.size() < n + kLanes) rho_.resize(n + kLanes);
    if (n_points > 0) function_(points, {rho_.data(), n_points});
    function_(columns(), rho_.data() + n_points);
    n_columns_ = 0;
    const std::size_t n_repeats = std::exchange(n_repeats_, 0);
    check(n, [&](std::size_t k) { return k < n_points ? points[k] : column_point(k - n_points); });
    range_.n_evaluations -= static_cast<std::int64_t>(n_repeats);
    return {rho_.data(), n};
}

std::unique_ptr<DensityProbe> DensityProbes::take() {
    const std::lock_guard lock(mutex_);
    if (idle_.empty()) return std::make_unique<DensityProbe>(lattice_, density_.make_function());
    auto probe = std::move(idle_.back());
    idle_.pop_back();
    return probe;
}

void DensityProbes::with_probe(const std::function<void(DensityProbe&)>& work) {
    std::unique_ptr<DensityProbe> probe = take();
    work(*probe);
    const std::lock_guard lock(mutex_);
    range_.add(probe->take_range());
    idle_.push_back(std::move(probe));
}

std::vector<double> densities_at(const Density& density, const Lattice& lattice,
                                 const Points& points) {
    DensityProbe probe(lattice, density.make_function());
    std::vector<DensityPoint> wrapped;
    for (Eigen::Index k = 0; k < points.cols(); ++k) {
        checkpoint_each(k);
        const Vec2 u = lattice.to_lattice(points.col(k));
        wrapped.push_back(probe.point(u.x() - std::floor(u.x()), u.y() - std::floor(u.y())));
    }
    const std::span<const double> rho = probe.evaluate(wrapped);
    return {rho.begin(), rho.end()};
}

}  // namespace pcvt::plane
