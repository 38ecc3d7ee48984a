#include "mesher/cells/orientations.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "mesher/base/checkpoint.hpp"
#include "mesher/portable/portable_angles.hpp"

namespace pcvt {
namespace {

/// Separates the numbers from those that uniform_points draws from the same seed.
constexpr std::uint64_t kSeedOfOrientations = 0x8cb92ba72f3d8dd7;
constexpr std::uint64_t kSeedOfEntries = 0x3c79ac492ba7b653;

/// In (0, 1).
double uniform(std::mt19937_64& generator) {
    return std::ldexp(double(generator() >> 12) + 0.5, -52);
}

}  // namespace

Eigen::Matrix3d bunge_matrix(const BungeAngles& angles) {
    const auto [c1, s1] = cos_sin_of_degrees(angles.phi1);
    const auto [c, s] = cos_sin_of_degrees(angles.Phi);
    const auto [c2, s2] = cos_sin_of_degrees(angles.phi2);
    Eigen::Matrix3d g;
    g << c1 * c2 - s1 * s2 * c, s1 * c2 + c1 * s2 * c, s2 * s,   //
        -c1 * s2 - s1 * c2 * c, -s1 * s2 + c1 * c2 * c, c2 * s,  //
        s1 * s, -c1 * s, c;
    return g;
}

std::vector<BungeAngles> random_orientations(int n, std::uint64_t seed) {
    std::mt19937_64 generator(seed ^ kSeedOfOrientations);
    std::vector<BungeAngles> orientations;
    for (int k = 0; k < n; ++k) {
        checkpoint_each(k);
        orientations.push_back({360 * uniform(generator), degrees_of_cosine(uniform(generator)),
                                360 * uniform(generator)});
    }
    return orientations;
}

std::vector<int> draw_entries(std::span<const double> weights, int n, std::uint64_t seed) {
    std::mt19937_64 generator(seed ^ kSeedOfEntries);
    const double step = std::accumulate(weights.begin(), weights.end(), 0.0) / n;
    const double first = uniform(generator) * step;
    // Equidistant points on the line of all weights fall on their entries.
    std::vector<int> entries;
    double end = 0;
    for (int k = 0; k < std::ssize(weights); ++k) {
        checkpoint_each(k);
        end += weights[k];
        while (std::ssize(entries) < n && first + double(std::ssize(entries)) * step < end) {
            entries.push_back(k);
        }
    }
    // The sum of the weights and `end` are the same sum, so the last point can be missed only by
    // the rounding of its place.
    while (std::ssize(entries) < n) entries.push_back(entries.back());
    for (int k = n - 1; k > 0; --k) {
        std::swap(entries[k], entries[static_cast<int>(uniform(generator) * (k + 1))]);
    }
    return entries;
}

AngleRange angle_range(std::span<const BungeAngles> orientations) {
    AngleRange range{orientations.front(), orientations.front()};
    for (double BungeAngles::*angle : {&BungeAngles::phi1, &BungeAngles::Phi, &BungeAngles::phi2}) {
        for (const BungeAngles& angles : orientations) {
            range.least.*angle = std::min(range.least.*angle, angles.*angle);
            range.greatest.*angle = std::max(range.greatest.*angle, angles.*angle);
        }
    }
    return range;
}

}  // namespace pcvt
