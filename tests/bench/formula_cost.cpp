/// Measures formulas: nanoseconds a point of each operator and function, an evaluation with a
/// formula as the density in units of a uniform one, and the same of an iteration. CPU time of one
/// thread, least times of interleaved rounds, which a busy machine disturbs least. Last, an
/// evaluation with a picture.

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "io/run_files/density_expression.hpp"
#include "io/run_files/formula.hpp"
#include "mesher/plane/cvt/cvt.hpp"
#include "mesher/plane/density/density_survey.hpp"
#include "mesher/plane/density/pixel_grid.hpp"
#include "mesher/plane/energy/density_energy.hpp"

namespace pcvt {
namespace {

constexpr int kSites = 4000;
constexpr int kRounds = 15;
constexpr int kIterations = 60;
const std::string kDensity = "1+200*exp(-((x-0.8)^2+(y-0.5)^2)/0.03)";

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

/// Seconds a point of a formula in x and y, from 0.1 to 0.9.
double seconds_a_point(const std::string& text) {
    constexpr int kRepetitions = 2000;
    const std::vector<std::string> names{"x", "y"};
    FormulaEvaluator evaluate(read_formula(text, names));
    std::mt19937_64 random(1);
    for (int k = 0; k < evaluate.block(); ++k) {
        for (const int variable : {0, 1}) {
            evaluate.variable(variable)[k] =
                0.1 + 0.8 * static_cast<double>(random() >> 11) * 0x1p-53;
        }
    }
    double least = 1;
    for (int round = 0; round < kRounds; ++round) {
        const double seconds = seconds_of([&] {
            for (int k = 0; k < kRepetitions; ++k) evaluate(evaluate.block());
        });
        least = std::min(least, seconds);
    }
    return least / kRepetitions / evaluate.block();
}

void print_functions() {
    std::vector<std::string> formulas;
    for (const char* name : {"+", "-", "*", "/", "<", "&&", "^"}) {
        formulas.push_back(std::string("x") + name + "y");
    }
    for (const char* name :
         {"exp",  "ln",   "log2", "log10", "sqrt",  "sin",   "cos",   "tan", "asin", "acos",
          "atan", "sinh", "cosh", "tanh",  "asinh", "acosh", "atanh", "abs", "sign", "rint"}) {
        formulas.push_back(std::string(name) + (std::string(name) == "acosh" ? "(1+x)" : "(x)"));
    }
    for (const char* text : {"atan2(x,y)", "min(x,y)", "x<y ? x : y", "x^2", kDensity.c_str()}) {
        formulas.push_back(text);
    }
    for (const std::string& text : formulas) {
        std::printf("%-40s %8.2f ns a point\n", text.c_str(), 1e9 * seconds_a_point(text));
    }
}

/// The triangulation of sites that an optimisation has spread by a density.
plane::MovingDelaunay graded_delaunay(const plane::Lattice& lattice,
                                      const plane::Density& density) {
    plane::CvtOptions options;
    options.run.max_iterations = 100;
    options.density = density;
    const plane::CvtResult start =
        compute_cvt(lattice, graded_points(lattice, density, kSites, 1), options);
    return plane::MovingDelaunay(start.delaunay.sites());
}

void print_evaluations() {
    const plane::Lattice lattice = plane::Lattice::rectangle(4, 1);
    const plane::Density density = expression_density(kDensity);
    Workers workers(1);
    plane::MovingDelaunay delaunay = graded_delaunay(lattice, density);
    plane::DensityPass pass(delaunay, workers, lattice, density, 1);
    plane::EnergyPass uniform_pass(delaunay, workers);
    Energy energy;
    pass.evaluate(energy);
    for (const double accuracy : {5e-6, 5e-9}) {
        pass.choose_orders(accuracy, true);
        double uniform = 1;
        double weighted = 1;
        for (int round = 0; round < 20 * kRounds; ++round) {
            uniform = std::min(uniform, seconds_of([&] { uniform_pass.evaluate(energy); }));
            weighted = std::min(weighted, seconds_of([&] { pass.evaluate(energy); }));
        }
        std::printf(
            "evaluation at %.0e: %6.0f ns a site, %5.1f uniform ones of %4.1f ns; %.1f points a "
            "site\n",
            accuracy, 1e9 * weighted / kSites, weighted / uniform, 1e9 * uniform / kSites,
            pass.evaluations_per_site());
    }
}

void print_iterations() {
    const plane::Lattice lattice = plane::Lattice::rectangle(4, 1);
    double least[2] = {1, 1};
    for (int round = 0; round < kRounds; ++round) {
        for (const bool has_density : {false, true}) {
            plane::CvtOptions options;
            options.run.max_iterations = kIterations;
            plane::Points points = uniform_points(lattice, kSites, 1);
            if (has_density) {
                options.density = expression_density(kDensity);
                points = graded_points(lattice, *options.density, kSites, 1);
            }
            const double seconds =
                seconds_of([&] { compute_cvt(lattice, std::move(points), options); });
            least[has_density ? 1 : 0] = std::min(least[has_density ? 1 : 0], seconds);
        }
    }
    std::printf("%d iterations: %.2f ms an iteration, %.1f uniform ones of %.2f ms\n", kIterations,
                1e3 * least[1] / kIterations, least[1] / least[0], 1e3 * least[0] / kIterations);
}

void print_picture() {
    constexpr int kPixels = 512;
    std::mt19937_64 random(1);
    std::vector<float> greys(kPixels * kPixels);
    for (float& grey : greys) grey = static_cast<float>(random() % 256) / 255.0F;
    const plane::Lattice lattice = plane::Lattice::rectangle(1, 1);
    const plane::Density density =
        plane::pixel_density({kPixels, kPixels, std::move(greys), 0.01, 1});
    Workers workers(1);
    plane::MovingDelaunay delaunay = graded_delaunay(lattice, density);
    plane::DensityPass pass(delaunay, workers, lattice, density, 1);
    Energy energy;
    double least = 1;
    for (int round = 0; round < kRounds; ++round) {
        least = std::min(least, seconds_of([&] { pass.evaluate(energy); }));
    }
    std::printf("evaluation with a picture of %d x %d: %.2f us a site, %.1f points a site\n",
                kPixels, kPixels, 1e6 * least / kSites, pass.evaluations_per_site());
}

}  // namespace
}  // namespace pcvt

int main() {
    pcvt::print_functions();
    pcvt::print_evaluations();
    pcvt::print_iterations();
    pcvt::print_picture();
    return 0;
}
