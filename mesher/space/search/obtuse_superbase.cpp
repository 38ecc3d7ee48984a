#include "mesher/space/search/obtuse_superbase.hpp"

#include <cmath>

#include "mesher/base/error.hpp"

namespace pcvt::space {
namespace {

/// Scalar products up to this part of the longest square count as zero.
constexpr double kZero = 1e-13;
/// Multiples are subtracted only where they shorten a vector by more than rounding.
constexpr double kHalf = 0.5 * (1 + 1e-12);
/// Far more steps than any lattice needs whose scalar products are not lost in rounding.
constexpr int kMostSteps = 10'000;

/// Counts a step of a reduction.
void count_step(int& steps) {
    if (++steps <= kMostSteps) return;
    throw InvalidInput("the period vectors are nearly dependent; give three independent ones");
}

double dot(const LatticeVector& s, const LatticeVector& t, const Eigen::Matrix3d& metric) {
    return s.cast<double>().dot(metric * t.cast<double>());
}

/// Subtracts multiples of each vector from the others until none becomes shorter, so that Selling's
/// reduction, which adds vectors once at a time, needs a few steps only.
void shorten(std::array<LatticeVector, 3>& basis, const Eigen::Matrix3d& metric) {
    int steps = 0;
    for (bool changed = true; changed;) {
        changed = false;
        count_step(steps);
        for (int j = 0; j < 3; ++j) {
            const double square = dot(basis[j], basis[j], metric);
            for (int i = 0; i < 3; ++i) {
                if (i == j) continue;
                const double ratio = dot(basis[i], basis[j], metric) / square;
                if (std::abs(ratio) <= kHalf) continue;
                basis[i] -= static_cast<std::int64_t>(std::round(ratio)) * basis[j];
                changed = true;
            }
        }
    }
}

}  // namespace

std::array<LatticeVector, 4> obtuse_superbase(std::array<LatticeVector, 3> basis,
                                              const Eigen::Matrix3d& metric) {
    shorten(basis, metric);
    std::array<LatticeVector, 4> v{basis[0], basis[1], basis[2], -(basis[0] + basis[1] + basis[2])};
    int steps = 0;
    for (bool changed = true; changed;) {
        changed = false;
        count_step(steps);
        double longest = 0;
        for (const LatticeVector& vector : v) {
            longest = std::max(longest, dot(vector, vector, metric));
        }
        for (int i = 0; i < 4 && !changed; ++i) {
            for (int j = i + 1; j < 4 && !changed; ++j) {
                if (dot(v[i], v[j], metric) <= kZero * longest) continue;
                // Reverse one of the two vectors and add it to the other two.
                for (int k = 0; k < 4; ++k) {
                    if (k != i && k != j) v[k] += v[i];
                }
                v[i] = -v[i];
                changed = true;
            }
        }
    }
    return v;
}

double second_moment(const std::array<LatticeVector, 4>& superbase, const Eigen::Matrix3d& metric) {
    double p[4][4];
    for (int i = 0; i < 4; ++i) {
        for (int j = i + 1; j < 4; ++j) {
            p[i][j] = p[j][i] = -dot(superbase[i], superbase[j], metric);
        }
    }
    const double pairs[3][2] = {{p[0][1], p[2][3]}, {p[0][2], p[1][3]}, {p[0][3], p[1][2]}};
    double sum = 0;
    double cycles = 0;
    double stars = 0;
    for (int k = 0; k < 3; ++k) {
        // A cycle of length four leaves out two opposite edges.
        const double* next = pairs[(k + 1) % 3];
        sum += pairs[k][0] + pairs[k][1];
        cycles += pairs[k][0] * pairs[k][1] * next[0] * next[1];
    }
    for (int i = 0; i < 4; ++i) {
        const int j = (i + 1) % 4;
        const int k = (i + 2) % 4;
        const int l = (i + 3) % 4;
        stars += p[i][j] * p[i][k] * p[i][l] * (p[j][k] + p[j][l] + p[k][l]);
    }
    return (sum + 2 * cycles + stars) / 36;
}

}  // namespace pcvt::space
