#include <optional>

#include "mesher/cells/target_areas.hpp"
#include "mesher/space/cvt/cvt.hpp"
#include "mesher/space/cvt/volume_cvt.hpp"
#include "mesher/space/cvt/volume_newton.hpp"
#include "mesher/space/delaunay/mirror_diagram.hpp"
#include "mesher/space/energy/energy_pass.hpp"
#include "mesher/space/voxels/voxel_image.hpp"
#include "tests/bench/cases.hpp"
#include "tests/bench/space_peers.hpp"

namespace pcvt::bench {
namespace {

space::Lattice cube() { return space::Lattice::box(1, 1, 1); }

space::Points random_points(int n) { return uniform_points(cube(), n, 1); }

benchmark::internal::Benchmark* add_in_cube(const std::string& what, int n,
                                            const std::function<void(benchmark::State&)>& body) {
    return add_case(what + "/cube/" + std::to_string(n), body);
}

/// Runs until the RMS residual is at most `rms`.
space::CvtResult run_space_to_rms(int n, double rms, const ProgressCallback& look = {}) {
    space::CvtOptions options;
    options.run.tolerance = 0;
    options.run.progress = [&](const Progress& progress) {
        if (look) look(progress);
        return progress.rms_residual > rms;
    };
    return space::compute_cvt(cube(), random_points(n), options);
}

/// Times the computation from points to triangulation, without its destruction.
void add_space_peer(const std::string& what, SpacePeer* peer, int n) {
    add_in_cube(what, n, [=](benchmark::State& state) {
        const space::Points points = random_points(n);
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
void add_space_build(const std::string& what, int n,
                     space::TorusTetrahedra (*build)(const space::Sites&)) {
    add_in_cube(what, n, [=](benchmark::State& state) {
        const space::Sites sites(cube(), random_points(n));
        for ([[maybe_unused]] auto _ : state) {
            std::optional<space::TorusTetrahedra> tetrahedra(build(sites));
            state.PauseTiming();
            tetrahedra.reset();
            state.ResumeTiming();
        }
    });
}

space::TorusTetrahedra by_mirrors(const space::Sites& sites) {
    return {sites.n_sites(), space::mirror_diagram(sites).tetrahedra};
}

/// F, gradient and certificate after a small step of the sites, in the converging regime.
void add_space_evaluation(int n) {
    add_in_cube("space_evaluation", n, [=](benchmark::State& state) {
        const space::CvtResult start = run_space_to_rms(n, kConverging);
        Workers workers(1);
        space::MovingTetrahedra moving(start.delaunay.sites);
        space::EnergyPass pass(moving, workers);
        Energy energy;
        const Eigen::VectorXf step =
            Eigen::VectorXf::Random(space::MovingTetrahedra::kNumbersPerSite * Eigen::Index{n});
        double way = kConverging * moving.spacing();
        for ([[maybe_unused]] auto _ : state) {
            state.PauseTiming();
            way = -way;
            moving.step(step, way, workers);
            state.ResumeTiming();
            if (!pass.evaluate(energy)) state.SkipWithError("sites coincide");
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
            const space::CvtResult result =
                run_space_to_rms(n, kEnd, [&](const Progress& progress) {
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

/// Volumes whose equivalent diameters have a lognormal law of spread 0.35.
Eigen::VectorXd grain_volumes(int n) {
    const Eigen::VectorXd diameters =
        draw_areas(parse_area_law("lognormal:0.35"), n, 1).cwiseSqrt();
    const Eigen::VectorXd volumes = diameters.array().cube();
    return volumes / volumes.sum();
}

/// Weights for prescribed volumes of fixed random sites to 1e-10, from their tetrahedra.
void add_volume_newton(int n) {
    add_in_cube("volume_newton", n, [=](benchmark::State& state) {
        const space::MovingTetrahedra moving(space::Sites(cube(), random_points(n)));
        const Eigen::VectorXd given = grain_volumes(n);
        Eigen::VectorXd volumes(n);
        for (SiteId s = 0; s < n; ++s) volumes[s] = given[moving.original_id(s)];
        volumes *= moving.frame().volume() / volumes.sum();
        Workers workers(1);
        SizeFigures figures;
        for ([[maybe_unused]] auto _ : state) {
            space::VolumeNewton newton(moving, workers);
            figures = newton.solve(volumes, 1e-10);
        }
        if (!figures.converged) state.SkipWithError("the volumes were not reached");
        state.counters["newton_steps"] = figures.newton_steps;
        state.counters["trials"] = figures.trials;
        state.counters["products"] = figures.products;
        state.counters["error"] = figures.largest_relative_error;
    });
}

/// Five bold centroidal steps from volumes by rank.
void add_space_grains(int n) {
    add_in_cube("space_grains", n, [=](benchmark::State& state) {
        const space::Points points = random_points(n);
        const Eigen::VectorXd volumes = grain_volumes(n);
        for ([[maybe_unused]] auto _ : state) {
            const space::VolumeCvtResult result = compute_volume_cvt(
                cube(), points,
                {.volumes = volumes, .by_rank = true, .run = {.max_iterations = 5}});
            state.counters["newton_steps"] = result.volumes.newton_steps;
            state.counters["error"] = result.largest_error;
        }
    });
}

}  // namespace

void add_voxel_case(int n) {
    add_in_cube("space_voxels", n, [=](benchmark::State& state) {
        const auto delaunay = space::periodic_delaunay(space::Sites(cube(), random_points(n)));
        const space::VoxelGrid grid = voxel_grid(cube(), {0, 0, 0}, {256, 256, 256});
        for ([[maybe_unused]] auto _ : state) {
            benchmark::DoNotOptimize(voxel_image(delaunay, {}, grid, 1).site.data());
        }
    });
}

void add_space_cases(int n) {
    add_space_peer("cgal_plain_3", cgal_plain_in_space, n);
    add_space_build("space_build", n, space::torus_tetrahedra);
    add_space_build("space_mirrors", n, by_mirrors);
    add_space_peer("cgal_periodic_3", cgal_periodic_in_space, n);
    add_space_evaluation(n);
    add_space_iteration(n);
    add_volume_newton(n);
    add_space_grains(n);
}

void add_small_space_cases(int n) {
    add_space_peer("cgal_plain_3", cgal_plain_in_space, n);
    add_volume_newton(n);
    add_space_grains(n);
}

}  // namespace pcvt::bench
