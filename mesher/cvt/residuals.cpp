#include "mesher/cvt/residuals.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesher/base/target_clones.hpp"

namespace pcvt {
namespace {

constexpr Eigen::Index kSitesPerTask = 1 << 14;
/// Number of partial sums; with fewer than 16 GCC does not vectorise the loop.
constexpr Eigen::Index kLanes = 16;

/// Maximum and sum of the squared residuals of sites, up to a factor that all of them share.
struct Squares {
    double largest = 0;
    double sum = 0;

    void add(const Squares& other) {
        largest = std::max(largest, other.largest);
        sum += other.sum;
    }
};

PCVT_TARGET_CLONES Squares squares_of(const double* gradient, const double* mass, Eigen::Index n) {
    double largest[kLanes] = {};
    double sum[kLanes] = {};
    const auto square = [=](Eigen::Index s) {
        const double x = gradient[2 * s];
        const double y = gradient[2 * s + 1];
        return (x * x + y * y) / (mass[s] * mass[s]);
    };
    Eigen::Index s = 0;
    for (; s + kLanes <= n; s += kLanes) {
        for (Eigen::Index k = 0; k < kLanes; ++k) {
            const double part = square(s + k);
            largest[k] = std::max(largest[k], part);
            sum[k] += part;
        }
    }
    Squares squares;
    for (; s < n; ++s) squares.add({square(s), square(s)});
    for (Eigen::Index k = 0; k < kLanes; ++k) squares.add({largest[k], sum[k]});
    return squares;
}

Residuals residuals_in_plane(const Eigen::VectorXd& gradient, const Eigen::VectorXd& mass,
                             double spacing, Workers& workers) {
    const Eigen::Index n = mass.size();
    std::vector<Squares> squares(static_cast<std::size_t>(n / kSitesPerTask + 1));
    workers.for_each(static_cast<int>(squares.size()), [&](int task) {
        const Eigen::Index first = task * kSitesPerTask;
        squares[task] = squares_of(gradient.data() + 2 * first, mass.data() + first,
                                   std::min(kSitesPerTask, n - first));
    });
    Squares total;
    for (const Squares& part : squares) total.add(part);
    const double per_h = 1 / (2 * spacing);
    return {std::sqrt(total.largest) * per_h, std::sqrt(total.sum / double(n)) * per_h};
}

/// In space these operations are a small part of an evaluation, so they are not vectorised.
Residuals residuals_in_space(const Eigen::VectorXd& gradient, const Eigen::VectorXd& mass,
                             double spacing) {
    Squares total;
    for (Eigen::Index s = 0; s < mass.size(); ++s) {
        const Eigen::Vector3d residual = gradient.segment<3>(4 * s) / (2 * mass[s]);
        total.add({residual.squaredNorm(), residual.squaredNorm()});
    }
    return {std::sqrt(total.largest) / spacing,
            std::sqrt(total.sum / double(mass.size())) / spacing};
}

}  // namespace

Residuals residuals(const Eigen::VectorXd& gradient, const Eigen::VectorXd& mass, double spacing,
                    Workers& workers) {
    return gradient.size() == 2 * mass.size() ? residuals_in_plane(gradient, mass, spacing, workers)
                                              : residuals_in_space(gradient, mass, spacing);
}

void steps_to_centroids(const Eigen::VectorXd& gradient, const Eigen::VectorXd& mass,
                        Eigen::VectorXf& steps) {
    steps.resize(gradient.size());
    const Eigen::Index numbers = gradient.size() / mass.size();
    for (Eigen::Index s = 0; s < mass.size(); ++s) {
        const double per_mass = -2 * mass[s];
        for (Eigen::Index k = numbers * s; k < numbers * (s + 1); ++k) {
            steps[k] = static_cast<float>(gradient[k] / per_mass);
        }
    }
}

}  // namespace pcvt
