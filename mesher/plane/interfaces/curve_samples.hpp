#pragma once

#include <algorithm>
#include <vector>

namespace pcvt::plane {

/// How fast the length of chords changes along a curve and with the distance from a limit.
inline constexpr double kGrading = 0.4;

/// A point of a curve: its parameter, its distance along the curve, and the longest chord there.
struct Sample {
    double parameter;
    double along;
    double size;
};

/// Bounds how fast sizes change along a closed curve, whose last sample is the first one again.
void grade(std::vector<Sample>& samples);

/// The number of chords up to each sample: the integral of 1 / size along the curve.
///
/// Example usage:
///
///     grade(samples);
///     const double n_chords = std::ceil(chord_counts(samples).back());
std::vector<double> chord_counts(const std::vector<Sample>& samples);

/// The parameter at `to`, where `from` runs through the counts of the samples.
template <class From, class To>
double interpolated(double at, const std::vector<Sample>& samples, const From& from, const To& to) {
    std::size_t low = 0;
    std::size_t high = samples.size() - 1;
    while (high - low > 1) {
        const std::size_t middle = (low + high) / 2;
        (from(middle) <= at ? low : high) = middle;
    }
    const double width = from(high) - from(low);
    const double share = width > 0 ? (at - from(low)) / width : 0;
    return to(low) + std::clamp(share, 0.0, 1.0) * (to(high) - to(low));
}

}  // namespace pcvt::plane
