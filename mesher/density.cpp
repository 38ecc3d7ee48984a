#include "mesher/density.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>

namespace pcvt {
namespace {

std::string digits(double value) {
    if (std::isnan(value)) return "not a number";
    std::array<char, 32> text;
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6);
    return {text.data(), end.ptr};
}

}  // namespace

Density shared_density(DensityFunction function) {
    return {[function = std::move(function)] { return function; }};
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

void DensityProbe::refuse(const DensityPoint& point, double rho) {
    const bool in_limits = std::isfinite(rho) && rho > 0;
    throw BadDensity(
        "the density is " + digits(rho) + " at x = " + digits(point.x) + ", y = " +
        digits(point.y) + " (u = " + digits(point.u) + ", v = " + digits(point.v) + "); " +
        (in_limits ? "keep it between 1e-60 and 1e60" : "make it positive and finite everywhere"));
}

std::unique_ptr<DensityProbe> DensityProbes::take() {
    const std::lock_guard lock(mutex_);
    if (idle_.empty()) return std::make_unique<DensityProbe>(lattice_, density_.make_function());
    auto probe = std::move(idle_.back());
    idle_.pop_back();
    return probe;
}

void DensityProbes::lend(const std::function<void(DensityProbe&)>& work) {
    std::unique_ptr<DensityProbe> probe = take();
    work(*probe);
    const std::lock_guard lock(mutex_);
    range_.add(probe->take_range());
    idle_.push_back(std::move(probe));
}

}  // namespace pcvt
