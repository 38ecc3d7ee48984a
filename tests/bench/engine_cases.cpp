#include <malloc.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <memory>
#include <string>

#include "mesher/plane/cvt/cvt.hpp"
#include "mesher/plane/energy/energy.hpp"
#include "tests/bench/cases.hpp"
#include "tests/bench/mirror_run.hpp"

namespace pcvt::bench {
namespace {

/// Runs until the RMS residual is at most `rms`.
plane::CvtResult run_to_rms(const Input& input, double rms, const ProgressCallback& look = {},
                            Solver solver = Solver::kPlainLbfgs) {
    plane::CvtOptions options;
    options.run.solver = solver;
    options.run.tolerance = 0;
    options.run.progress = [&](const Progress& progress) {
        if (look) look(progress);
        return progress.rms_residual > rms;
    };
    return compute_cvt(input.lattice, input.sites(), options);
}

/// The first triangulation, from wrapped sites.
void add_build(const Input& input) {
    add_case("build", input, [=](benchmark::State& state) {
        const plane::Sites sites(input.lattice, input.sites());
        for ([[maybe_unused]] auto _ : state) {
            auto delaunay = std::make_unique<plane::MovingDelaunay>(sites);
            state.PauseTiming();
            if (delaunay->counts().n_mirrors) state.SkipWithError("the strips failed");
            delaunay.reset();
            state.ResumeTiming();
        }
    });
}

/// F, gradient and certificate after a small step of the sites, in the converging regime.
void evaluate_repeatedly(benchmark::State& state, const Input& input, int n_threads) {
    const plane::CvtResult start = run_to_rms(input, kConverging);
    Workers workers(n_threads);
    plane::MovingDelaunay delaunay(start.delaunay.sites());
    plane::EnergyPass pass(delaunay, workers);
    Energy energy;
    Eigen::VectorXf step = Eigen::VectorXf::Random(2 * Eigen::Index{input.n});
    double way = kConverging * delaunay.spacing();
    for ([[maybe_unused]] auto _ : state) {
        state.PauseTiming();
        way = -way;
        delaunay.step(step, way, workers);
        state.ResumeTiming();
        if (!pass.evaluate(energy)) state.SkipWithError("sites coincide");
        delaunay.settle();
        benchmark::DoNotOptimize(energy.value);
    }
}

void add_evaluation(const Input& input) {
    add_case("evaluation", input,
             [=](benchmark::State& state) { evaluate_repeatedly(state, input, 1); });
}

/// A whole run to an RMS residual; reports the time per iteration.
void add_iteration(const Input& input, double rms) {
    const auto body = [=](benchmark::State& state) {
        for ([[maybe_unused]] auto _ : state) {
            const double start = cpu_seconds();
            double first = 0;
            double last = 0;
            Progress end;
            const plane::CvtResult result = run_to_rms(input, rms, [&](const Progress& progress) {
                last = cpu_seconds();
                if (progress.iteration == 0) first = last;
                end = progress;
                return true;
            });
            state.SetIterationTime((last - first) / end.iteration);
            state.counters["run_seconds"] = cpu_seconds() - start;
            state.counters["iterations"] = end.iteration;
            state.counters["evaluations"] = end.evaluations;
            state.counters["flips_per_site"] = double(result.counts.n_flips) / input.n;
            state.counters["rebuilds"] = result.counts.n_rebuilds;
        }
    };
    add_case("iteration", input, body)->UseManualTime()->Iterations(1);
}

/// A run with the usual solver, which preconditions long waves towards its end.
void add_usual_run(const Input& input) {
    const auto body = [=](benchmark::State& state) {
        for ([[maybe_unused]] auto _ : state) {
            const plane::CvtResult result = run_to_rms(input, kEnd, {}, Solver::kLbfgs);
            state.counters["iterations"] = result.run.iterations;
        }
    };
    add_case("usual_run", input, body)->Iterations(1);
}

/// The same run with a new mirror diagram for each evaluation.
void add_mirror_run(const Input& input) {
    const auto body = [=](benchmark::State& state) {
        for ([[maybe_unused]] auto _ : state) {
            state.counters["evaluations"] =
                mirror_run(input.lattice, input.sites(), kEnd).run.evaluations;
        }
    };
    add_case("mirror_run", input, body)->Iterations(1);
}

/// A field of /proc/self/status, in bytes.
double status_bytes(const std::string& field) {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        double kilobytes = 0;
        if (word == field + ":" && status >> kilobytes) return 1024 * kilobytes;
    }
    return std::numeric_limits<double>::quiet_NaN();
}

/// The peak of resident memory during a run that fills the optimiser's history, with malloc's
/// defaults: the cases before this one use a heap that keeps everything (warm_the_heap).
void add_memory(const Input& input) {
    const auto body = [=](benchmark::State& state) {
        constexpr int kIterations = 12;
        for ([[maybe_unused]] auto _ : state) {
            cool_the_heap();
            std::ofstream("/proc/self/clear_refs") << "5";
            const double before = status_bytes("VmRSS");
            plane::CvtOptions options;
            options.run.max_iterations = kIterations;
            benchmark::DoNotOptimize(compute_cvt(input.lattice, input.sites(), options));
            state.counters["bytes_per_site"] = (status_bytes("VmHWM") - before) / input.n;
        }
    };
    add_case("memory", input, body)->Iterations(1);
}

/// The runs behind the paper's statistics: many small ones, each to a residual of 1e-8.
void add_small_runs(const Input& input) {
    const auto body = [=](benchmark::State& state) {
        constexpr int kRuns = 5000;
        for ([[maybe_unused]] auto _ : state) {
            int converged = 0;
            for (std::uint64_t seed = 0; seed < kRuns; ++seed) {
                plane::CvtOptions options;
                options.run.tolerance = 1e-8;
                const plane::Points points = uniform_points(input.lattice, input.n, seed);
                converged +=
                    compute_cvt(input.lattice, points, options).run.stop == Stop::kConverged;
            }
            state.counters["converged"] = converged;
        }
    };
    add_case("small_runs", input, body)->Iterations(1);
}

}  // namespace

void add_engine_cases(const Input& input) {
    add_build(input);
    add_evaluation(input);
    if (input.lattice_name == "unit" && input.n >= 100'000) {
        const auto body = [=](benchmark::State& state) { evaluate_repeatedly(state, input, 2); };
        add_case("evaluation_2_threads", input, body)->UseRealTime();
    }
    add_iteration(input, kEnd);
    if (input.lattice_name == "unit" && input.n == 100'000) add_usual_run(input);
    if (input.lattice_name == "unit" && input.n == 10'000) add_mirror_run(input);
}

void add_large_case(const Input& input) { add_iteration(input, kConverging); }

void add_single_cases() {
    const plane::Lattice unit = plane::Lattice::rectangle(1, 1);
    add_abi_case({"unit", unit, 100'000});
    add_small_runs({"unit", unit, 150});
    add_memory({"unit", unit, 1'000'000});
}

}  // namespace pcvt::bench
