#include "mesher/plane/interfaces/interface_fit.hpp"

#include <cmath>
#include <string>

#include "mesher/base/error.hpp"

namespace pcvt::plane {
namespace {

constexpr double kLeastScale = 0.8;
constexpr double kLargestScale = 3;
constexpr double kScaleStep = 1.25;
constexpr int kBisections = 7;
/// A number of sites that is named suffices with this reserve.
constexpr double kSiteReserve = 1.02;
constexpr int kMostEstimates = 30;

using Spacing = std::function<double(const Vec2&)>;

class Fit {
   public:
    /// @param n  the number of cells of spacing h: the integral of 1 / h^2.
    Fit(const InclusionSet& set, double n, const Spacing& spacing)
        : set_(set), n_(n), spacing_(spacing) {}

    /// Places the seeds for a scale and returns the number of sites that it needs.
    double place(double scale) {
        scale_ = scale;
        interfaces_ =
            place_interface_sites(set_, [&](const Vec2& p) { return scale * spacing_(p); });
        const double beside = n_ - cells_at_chords();
        return interfaces_.n_seeds() + std::max(0.0, beside) / (scale * scale);
    }
    InterfaceFit take(int n) {
        const int n_free = n - interfaces_.n_seeds();
        return {std::move(interfaces_), n_free, scale_};
    }

   private:
    /// How many cells of spacing h have the area of the seeds' cells, which reach twice as far from
    /// the chord as the seeds.
    double cells_at_chords() const {
        const Lattice& reduced = set_.reduction().reduced;
        double sum = 0;
        for (const Chord& chord : interfaces_.chords) {
            const Vec2 along = chord.to - chord.from;
            const Vec2 seed = reduced.to_position(interfaces_.coordinates.col(chord.inside));
            const double area = 4 * cross(along, seed - chord.from);
            const double h = spacing_(chord.from);
            sum += area / (h * h);
        }
        return sum;
    }

    const InclusionSet& set_;
    double n_;
    const Spacing& spacing_;
    double scale_ = 1;
    InterfaceSites interfaces_;
};

/// The least number of sites that suffices, up to a reserve.
std::string sufficient_number(const InclusionSet& set, int n, const Spacing& spacing) {
    double enough = n;
    for (int k = 0; k < kMostEstimates; ++k) {
        const double finer = std::sqrt(n / enough);
        const Spacing scaled = [&](const Vec2& p) { return finer * spacing(p); };
        const double needed = Fit(set, enough, scaled).place(kLargestScale);
        if (needed <= enough) return std::to_string(static_cast<long>(std::ceil(enough)));
        enough = kSiteReserve * needed;
    }
    return "more than " + std::to_string(static_cast<long>(enough));
}

}  // namespace

InterfaceFit fit_interface_sites(const InclusionSet& set, int n, const Spacing& spacing) {
    Fit fit(set, n, spacing);
    // Find a scale that suffices, then a smaller one.
    double low = kLeastScale;
    double high = 1;
    while (fit.place(high) > n) {
        if (high == kLargestScale) {
            throw InvalidInput(std::to_string(n) + " sites are too few for the inclusions; take " +
                               sufficient_number(set, n, spacing));
        }
        low = high;
        high = std::min(kScaleStep * high, kLargestScale);
    }
    for (int k = 0; k < kBisections; ++k) {
        const double middle = (low + high) / 2;
        (fit.place(middle) > n ? low : high) = middle;
    }
    fit.place(high);
    return fit.take(n);
}

}  // namespace pcvt::plane
