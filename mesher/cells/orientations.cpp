#include "mesher/cells/orientations.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "mesher/base/checkpoint.hpp"
#include "mesher/portable/portable_angles.hpp"

namespace pcvt {
namespace {

/// Separates the numbers from those that uniform_points draws from the same seed.
constexpr std::uint64_t kSeedOfOrientations = 0x8cb92ba72f3d8dd7;

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
