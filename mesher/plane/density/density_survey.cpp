#include "mesher/plane/density/density_survey.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>

#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/density/pixel_grid.hpp"
#include "mesher/plane/density/quadrature.hpp"

namespace pcvt::plane {
namespace {

/// The majorant is the largest value at the corners of a square times this.
constexpr double kHeadroom = 1.25;
/// After this number of rejections the candidate is accepted: the density of its square is far
/// below the majorant almost everywhere.
constexpr int kTrials = 1000;
/// Candidates per evaluation.
constexpr int kCandidates = 4096;
/// Least number of intervals of the product rule along each direction.
constexpr int kSurveyIntervals = 128;
constexpr int kIntegralOrder = 4;

/// A candidate for a site, accepted if rho^(1/2) exceeds the threshold.
struct Candidate {
    double u;
    double v;
    double threshold;
};

/// Splits [0, 1) at the breaks and into intervals of at most 1 / kSurveyIntervals; returns the
/// nodes and weights of a Gauss rule on each interval.
GaussRule composite_rule(std::vector<double> breaks) {
    breaks.push_back(0);
    breaks.push_back(1);
    std::sort(breaks.begin(), breaks.end());
    const GaussRule gauss = gauss_rule(kIntegralOrder, 0);
    GaussRule rule;
    for (std::size_t k = 1; k < breaks.size(); ++k) {
        const double length = breaks[k] - breaks[k - 1];
        const int parts = std::max(1, static_cast<int>(std::ceil(length * kSurveyIntervals)));
        for (int p = 0; p < parts; ++p) {
            for (int i = 0; i < kIntegralOrder; ++i) {
                rule.nodes.push_back(breaks[k - 1] + (p + gauss.nodes[i]) * length / parts);
                rule.weights.push_back(gauss.weights[i] * length / parts);
            }
        }
    }
    return rule;
}

}  // namespace

DensitySurvey::DensitySurvey(const Lattice& lattice, const Density& density, int resolution)
    : lattice_(lattice), resolution_(resolution), probe_(lattice, density.make_function()) {
    rho_.reserve(static_cast<std::size_t>(resolution) * resolution);
    for (int j = 0; j < resolution; ++j) {
        checkpoint();
        DensityPoint* const row = probe_.reserve(resolution);
        for (int i = 0; i < resolution; ++i) {
            row[i] = probe_.point(double(i) / resolution, double(j) / resolution);
        }
        const std::span<const double> rho = probe_.evaluate_reserved();
        rho_.insert(rho_.end(), rho.begin(), rho.end());
    }
    range_ = probe_.take_range();
    range_.require_contrast();
}

double DensitySurvey::unit() const {
    const double mean = std::accumulate(rho_.begin(), rho_.end(), 0.0) / double(rho_.size());
    int exponent = 0;
    std::frexp(mean, &exponent);
    return std::ldexp(1.0, exponent);
}

double DensitySurvey::mean_root_squared() const {
    double sum = 0;
    for (const double rho : rho_) sum += std::sqrt(rho);
    const double mean = sum / double(rho_.size());
    return mean * mean;
}

double DensitySurvey::steepest() const {
    const std::array lengths{lattice_.a().norm() / resolution_, lattice_.b().norm() / resolution_};
    const auto at = [&](int i, int j) {
        return rho_[(j % resolution_) * resolution_ + i % resolution_];
    };
    double steepest = 0;
    for (int j = 0; j < resolution_; ++j) {
        for (int i = 0; i < resolution_; ++i) {
            const double here = std::log(at(i, j));
            steepest = std::max({steepest, std::abs(std::log(at(i + 1, j)) - here) / lengths[0],
                                 std::abs(std::log(at(i, j + 1)) - here) / lengths[1]});
        }
    }
    return steepest;
}

double DensitySurvey::majorant(int i, int j) const {
    const auto at = [&](int column, int row) {
        return rho_[(row % resolution_) * resolution_ + column % resolution_];
    };
    const double most = std::max({at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)});
    return kHeadroom * std::sqrt(most);
}

Points DensitySurvey::draw(int n, std::uint64_t seed) {
    if (n < 1) throw InvalidInput("the number of sites must be at least 1");
    // Sum the majorants of the squares, to draw squares in proportion to them.
    std::vector<double> sums;
    sums.reserve(rho_.size());
    double total = 0;
    for (int k = 0; k < static_cast<int>(rho_.size()); ++k) {
        total += majorant(k % resolution_, k / resolution_);
        sums.push_back(total);
    }
    // Draw candidates and reject those above the root of the density.
    std::mt19937_64 generator(seed);
    const auto uniform = [&generator] { return std::ldexp(double(generator() >> 11), -53); };
    Points points(2, n);
    std::vector<Candidate> candidates;
    int trial = 0;
    for (int filled = 0; filled < n;) {
        checkpoint();
        candidates.resize(std::min(n - filled, kCandidates));
        for (Candidate& candidate : candidates) {
            const auto found = std::upper_bound(sums.begin(), sums.end(), uniform() * total);
            const int k = static_cast<int>(std::min(found, sums.end() - 1) - sums.begin());
            const int i = k % resolution_;
            const int j = k / resolution_;
            candidate.u = (i + uniform()) / resolution_;
            candidate.v = (j + uniform()) / resolution_;
            candidate.threshold = uniform() * majorant(i, j);
            *probe_.reserve(1) = probe_.point(candidate.u, candidate.v);
        }
        const std::span<const double> rho = probe_.evaluate_reserved();
        for (std::size_t k = 0; k < candidates.size(); ++k) {
            const bool rejected = candidates[k].threshold >= std::sqrt(rho[k]);
            if (rejected && trial++ < kTrials) continue;
            points.col(filled++) = lattice_.to_position({candidates[k].u, candidates[k].v});
            trial = 0;
        }
    }
    return points;
}

Points graded_points(const Lattice& lattice, const Density& density, int n, std::uint64_t seed) {
    const int resolution = std::clamp(2 * static_cast<int>(std::sqrt(n)), kSurveyResolution, 1024);
    return DensitySurvey(lattice, density, resolution).draw(n, seed);
}

double integral(const Lattice& lattice, const Density& density) {
    if (density.pixels) return density.pixels->mean() * lattice.area();
    const GaussRule along = composite_rule(density.u_breaks);
    const GaussRule up = composite_rule(density.v_breaks);
    DensityProbe probe(lattice, density.make_function());
    double sum = 0;
    for (std::size_t j = 0; j < up.nodes.size(); ++j) {
        checkpoint();
        DensityPoint* const row = probe.reserve(along.nodes.size());
        for (std::size_t i = 0; i < along.nodes.size(); ++i) {
            row[i] = probe.point(along.nodes[i], up.nodes[j]);
        }
        const std::span<const double> rho = probe.evaluate_reserved();
        double part = 0;
        for (std::size_t i = 0; i < rho.size(); ++i) part += along.weights[i] * rho[i];
        sum += up.weights[j] * part;
    }
    return sum * lattice.area();
}

}  // namespace pcvt::plane
