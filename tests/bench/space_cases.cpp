#include <optional>

#include "mesher/space/space_mirrors.hpp"
#include "mesher/space_cvt/space_cvt.hpp"
#include "mesher/space_energy/moving_tetrahedra.hpp"
#include "tests/bench/cases.hpp"
#include "tests/bench/space_peers.hpp"

namespace pcvt::bench {
namespace {

SpaceLattice cube() { return SpaceLattice::box(1, 1, 1); }

Points3 random_points(int n) { return uniform_points(cube(), n, 1); }

benchmark::internal::Benchmark* add_in_cube(const std::string& what, int n,
                                            const std::function<void(benchmark::State&)>& body) {
    return add_case(what + "/cube/" + std::to_string(n), body);
}

/// Runs until the RMS residual is at most `rms`.
SpaceCvtResult run_space_to_rms(int n, double rms, const ProgressCallback& look = {}) {
    SpaceCvtOptions options;
    options.tolerance = 0;
    options.progress = [&](const Progress& progress) {
        if (look) look(progress);
        return progress.rms_residual > rms;
    };
    return compute_space_cvt(cube(), random_points(n), options);
}

/// Times the computation from points to triangulation, without its destruction.
void add_space_peer(const std::string& what, SpacePeer* peer, int n) {
    add_in_cube(what, n, [=](benchmark::State& state) {
        const Points3 points = random_points(n);
        for ([[maybe_unused]] auto _ : state) {
            SpaceTriangulation result = peer(points);
            state.PauseTiming();
            if (result.n_vertices != n) state.SkipWithError("not all points were inserted");
            result.structure.reset();
            state.ResumeTiming();
        }
    });
}

/// The first triangulation, from wrapped sites.
void add_space_build(const std::string& what, int n, TorusTetrahedra (*build)(const SpaceSites&)) {
    add_in_cube(what, n, [=](benchmark::State& state) {
        const SpaceSites sites(cube(), random_points(n));
        for ([[maybe_unused]] auto _ : state) {
            std::optional<TorusTetrahedra> tetrahedra(build(sites));
            state.PauseTiming();
            tetrahedra.reset();
            state.ResumeTiming();
        }
    });
}

TorusTetrahedra by_mirrors(const SpaceSites& sites) {
    return {sites.n_sites(), space_mirrors(sites).tetrahedra};
}

/// F, gradient and certificate after a small step of the sites, in the converging regime.
void add_space_evaluation(int n) {
    add_in_cube("space_evaluation", n, [=](benchmark::State& state) {
        const SpaceCvtResult start = run_space_to_rms(n, kConverging);
        Workers workers(1);
        MovingTetrahedra moving(start.delaunay.sites);
        SpaceEnergy energy;
        const Eigen::VectorXf step =
            Eigen::VectorXf::Random(MovingTetrahedra::kNumbersPerSite * Eigen::Index{n});
        double way = kConverging * moving.spacing();
        for ([[maybe_unused]] auto _ : state) {
            state.PauseTiming();
            way = -way;
            moving.step(step, way);
            state.ResumeTiming();
            if (!moving.evaluate(workers, energy)) state.SkipWithError("sites coincide");
            moving.settle();
            benchmark::DoNotOptimize(energy.value);
        }
        state.counters["rebuilds"] = moving.n_rebuilds();
    });
}

/// A whole run; reports the time per iteration.
void add_space_iteration(int n) {
    const auto body = [=](benchmark::State& state) {
        for ([[maybe_unused]] auto _ : state) {
            const double start = cpu_seconds();
            double first = 0;
            double last = 0;
            Progress end;
            const SpaceCvtResult result = run_space_to_rms(n, kEnd, [&](const Progress& progress) {
                last = cpu_seconds();
                if (progress.iteration == 0) first = last;
                end = progress;
                return true;
            });
            state.SetIterationTime((last - first) / end.iteration);
            state.counters["run_seconds"] = cpu_seconds() - start;
            state.counters["iterations"] = end.iteration;
            state.counters["evaluations"] = end.evaluations;
            state.counters["rebuilds"] = result.n_rebuilds;
        }
    };
    add_in_cube("space_iteration", n, body)->UseManualTime()->Iterations(1);
}

}  // namespace

void add_space_cases(int n) {
    add_space_peer("cgal_plain_3", cgal_plain_in_space, n);
    add_space_build("space_build", n, space_tetrahedra);
    add_space_build("space_mirrors", n, by_mirrors);
    add_space_peer("cgal_periodic_3", cgal_periodic_in_space, n);
    add_space_evaluation(n);
    add_space_iteration(n);
}

}  // namespace pcvt::bench
