#include "mesher/plane/density/density_breaks.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/base/checkpoint.hpp"
#include "mesher/portable/portable_functions.hpp"

namespace pcvt::plane {
namespace {

constexpr int kProbeLines = 12;
constexpr int kBreakIntervals = 512;
/// A jump is a change of log(rho) by more than kLeastJump, and by more than kOverNeighbours times
/// the change in the neighbouring intervals.
constexpr double kLeastJump = 1e-3;
constexpr double kOverNeighbours = 4;
constexpr int kBisections = 60;
/// The fraction of a jump that must remain when its interval is a few ulps wide.
constexpr double kLeftOver = 0.5;
/// Jumps closer to each other than kSameLine belong to one line, if at least kWitnesses probe lines
/// meet it.
constexpr double kSameLine = 1e-12;
constexpr int kWitnesses = 3;
/// With more lines than this, cutting cells is not worthwhile.
constexpr std::size_t kMostBreaks = 64;

/// log(rho) along a line on which the other coordinate is constant.
class ProbeLine {
   public:
    ProbeLine(DensityProbe& probe, int axis, double across)
        : probe_(probe), axis_(axis), across_(across) {}

    double operator()(double along) const {
        *probe_.reserve(1) = point(along);
        return portable_log(probe_.evaluate_reserved()[0]);
    }
    /// Returns log(rho) at the ends of the intervals.
    std::vector<double> survey() const {
        for (int k = 0; k <= kBreakIntervals; ++k)
            *probe_.reserve(1) = point(double(k) / kBreakIntervals);
        std::vector<double> value;
        for (const double rho : probe_.evaluate_reserved()) value.push_back(portable_log(rho));
        return value;
    }

   private:
    DensityPoint point(double along) const {
        return axis_ == 0 ? probe_.point(along, across_) : probe_.point(across_, along);
    }

    DensityProbe& probe_;
    int axis_;
    double across_;
};

/// Bisects towards the larger change; appends the position if the change remains a jump.
void bisect(const ProbeLine& line, double low, double high, std::vector<double>& found) {
    double at_low = line(low);
    double at_high = line(high);
    const double change = std::abs(at_high - at_low);
    for (int k = 0; k < kBisections; ++k) {
        const double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high) break;
        const double value = line(middle);
        const bool below = std::abs(value - at_low) > std::abs(at_high - value);
        (below ? high : low) = middle;
        (below ? at_high : at_low) = value;
    }
    if (std::abs(at_high - at_low) > kLeftOver * change) found.push_back(high);
}

void find_jumps(const ProbeLine& line, std::vector<double>& found) {
    checkpoint();
    const std::vector<double> value = line.survey();
    const auto change = [&](int k) {
        return k < 0 || k >= kBreakIntervals ? 0.0 : std::abs(value[k + 1] - value[k]);
    };
    for (int k = 0; k < kBreakIntervals; ++k) {
        const double beside = std::max(change(k - 1), change(k + 1));
        if (change(k) <= std::max(kLeastJump, kOverNeighbours * beside)) continue;
        bisect(line, double(k) / kBreakIntervals, double(k + 1) / kBreakIntervals, found);
    }
}

std::vector<double> find_breaks(DensityProbe& probe, int axis) {
    constexpr double kGoldenSection = 0.6180339887498949;
    std::vector<double> jumps;
    for (int k = 0; k < kProbeLines; ++k) {
        const double turns = 0.137 + k * kGoldenSection;
        find_jumps(ProbeLine(probe, axis, turns - std::floor(turns)), jumps);
    }
    std::sort(jumps.begin(), jumps.end());
    std::vector<double> breaks;
    for (std::size_t k = 0; k < jumps.size();) {
        std::size_t end = k;
        while (end < jumps.size() && jumps[end] - jumps[k] <= kSameLine) ++end;
        if (end - k >= kWitnesses && jumps[k] < 1) breaks.push_back(jumps[k]);
        k = end;
    }
    if (breaks.size() > kMostBreaks) breaks.clear();
    return breaks;
}

}  // namespace

Density with_axis_breaks(const Lattice& lattice, Density density) {
    DensityProbe probe(lattice, density.make_function());
    density.u_breaks = find_breaks(probe, 0);
    density.v_breaks = find_breaks(probe, 1);
    return density;
}

}  // namespace pcvt::plane
