/// Measures the cost of an evaluation with a density beside the density itself. Prints for several
/// densities the cost of one uniform evaluation, of one evaluation with the density, and of
/// evaluating the density once; and the ratio of the second to 1.3 times the density's time + 6
/// times the uniform evaluation. CPU time of one thread, medians of interleaved rounds.
///
/// Prediction for the ridge at 5e-6, with 25 points per site and a uniform pass of 25 ns: the
/// evaluation handles 0.8 KB of points, written and read once, about 600 operations (6 corners with
/// 30 each, 25 points with 4 for the position and 12 for the moments), or 75 vectors of 8, and 6
/// neighbours whose loads are independent. Including the uniform pass this takes 86 to 100 ns
/// beside the density, 0.71 of the limit where a density takes 5.2 ns.
///
/// Result (AMD EPYC with AVX-512 at 2.6 GHz, other work on the second core; g++ 12, -O3; medians of
/// 5 runs): the uniform pass takes 35 ns, the ridge 302 ns at 5e-6 and 469 ns at 5e-9, including
/// 137 and 273 ns for the density: 0.79 and 0.83 of the limit. A density of 22 ns: 0.75 and 0.79; a
/// formula: 0.79 and 0.78. With 60 flips before each evaluation it takes 3 to 5 % more. Batches of
/// 400 to 4096 points make no difference above 3 %.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <numbers>
#include <string>
#include <vector>

#include "io/run_files/density_expression.hpp"
#include "mesher/plane/density/density_survey.hpp"
#include "mesher/plane/energy/density_energy.hpp"

namespace pcvt {
namespace {

constexpr int kSites = 100'000;
constexpr int kLloydSteps = 10;
constexpr int kRounds = 15;
constexpr int kRows = 256;

double cpu_seconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

template <class Work>
double seconds_of(const Work& work) {
    const double begin = cpu_seconds();
    work();
    return cpu_seconds() - begin;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Random sites drawn from a density, after some Lloyd steps.
struct Place {
    Place(const plane::Lattice& lattice, const plane::Density& density)
        : delaunay(plane::Sites(lattice, graded_points(lattice, density, kSites, 1))),
          pass(delaunay, workers, lattice, density, 1),
          uniform_pass(delaunay, workers) {
        pass.evaluate(energy);
        Eigen::VectorXf step(2 * kSites);
        for (int k = 0; k < kLloydSteps; ++k) {
            for (int s = 0; s < kSites; ++s) {
                const plane::Vec2 gradient = energy.gradient.segment<2>(2 * Eigen::Index{s});
                step.segment<2>(2 * Eigen::Index{s}) =
                    (gradient / (-2 * energy.mass[s])).cast<float>();
            }
            delaunay.step(step, 1, workers);
            pass.evaluate(energy);
            delaunay.settle();
        }
    }
    Workers workers{1};
    plane::MovingDelaunay delaunay;
    plane::DensityPass pass;
    plane::EnergyPass uniform_pass;
    Energy energy;
};

/// Points close to each other, like the points of a cell.
std::vector<plane::DensityPoint> points_in_rows() {
    std::vector<plane::DensityPoint> points;
    for (int i = 0; i < kRows; ++i) {
        for (int j = 0; j < kRows; ++j) {
            const double u = (j + 0.3) / kRows;
            const double v = (i + 0.7) / kRows;
            points.push_back({u, v, u, v});
        }
    }
    return points;
}

void print_cost(const std::string& name, const plane::Density& density, double accuracy) {
    const plane::Lattice lattice = plane::Lattice::rectangle(1, 1);
    Place place(lattice, density);
    place.pass.choose_orders(accuracy, true);
    const std::vector<plane::DensityPoint> points = points_in_rows();
    const plane::DensityFunction function = density.make_function();
    std::vector<double> rho(points.size());
    std::vector<double> uniform;
    std::vector<double> weighted;
    std::vector<double> asking;
    for (int round = 0; round < kRounds; ++round) {
        place.uniform_pass.evaluate(place.energy);
        uniform.push_back(seconds_of([&] { place.uniform_pass.evaluate(place.energy); }));
        weighted.push_back(seconds_of([&] { place.pass.evaluate(place.energy); }));
        asking.push_back(seconds_of([&] { function(points, rho); }));
    }
    const double one = median(asking) / double(points.size());
    const double per_site = place.pass.evaluations_per_site();
    const double allowed = 1.3 * per_site * one + 6 * median(uniform) / kSites;
    std::printf("%-34s %8.0e %8.1f %9.0f %8.1f %8.2f %8.2f\n", name.c_str(), accuracy,
                1e9 * median(uniform) / kSites, 1e9 * median(weighted) / kSites, per_site,
                1e9 * one, median(weighted) / kSites / allowed);
}

void print_costs() {
    std::printf("%-34s %8s %8s %9s %8s %8s %8s\n", "ns a site, n = 100000", "accuracy", "uniform",
                "weighted", "asked", "ns each", "ratio");
    const plane::Density ridge = plane::shared_density([](const plane::DensityPoint& p) {
        const double d = (p.v - 0.5) / 0.08;
        return 1 + 99 * std::exp(-d * d);
    });
    const plane::Density smooth = plane::shared_density([](const plane::DensityPoint& p) {
        return std::exp(std::sin(2 * std::numbers::pi * p.u) +
                        std::cos(2 * std::numbers::pi * p.v));
    });
    const std::string formula = "exp(sin(2*pi*u)+cos(2*pi*v))";
    for (const double accuracy : {5e-6, 5e-9}) {
        print_cost("C++ ridge 1:100", ridge, accuracy);
        print_cost("C++ exp(sin + cos)", smooth, accuracy);
        print_cost(formula, expression_density(formula), accuracy);
    }
}

}  // namespace
}  // namespace pcvt

int main() {
    pcvt::print_costs();
    return 0;
}
