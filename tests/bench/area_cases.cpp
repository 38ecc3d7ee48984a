#include "mesher/cells/target_areas.hpp"
#include "mesher/plane/cvt/area_cvt.hpp"
#include "tests/bench/cases.hpp"

namespace pcvt::bench {
namespace {

Eigen::VectorXd grain_areas(const Input& input) {
    const AreaLaw law = parse_area_law("lognormal:0.42");
    return scaled_areas(draw_areas(law, input.n, 1), input.n, input.lattice.area());
}

/// Sites and areas in the order and unit of a triangulation.
struct AreaProblem {
    plane::MovingDelaunay delaunay;
    Eigen::VectorXd areas;

    explicit AreaProblem(const Input& input)
        : delaunay(plane::Sites(input.lattice, input.sites())), areas(input.n) {
        const Eigen::VectorXd given = grain_areas(input);
        for (SiteId s = 0; s < input.n; ++s) areas[s] = given[delaunay.original_id(s)];
        areas *= delaunay.frame().ax * delaunay.frame().by / areas.sum();
    }
};

/// Weights for prescribed areas of fixed random sites, from a triangulation.
void add_newton(const Input& input) {
    add_case("area_newton", input, [=](benchmark::State& state) {
        const AreaProblem problem(input);
        Workers workers(1);
        SizeFigures figures;
        for ([[maybe_unused]] auto _ : state) {
            plane::AreaNewton newton(problem.delaunay, workers);
            figures = newton.solve(problem.areas, plane::area_tolerance(input.n));
        }
        if (!figures.converged) state.SkipWithError("the areas were not reached");
        state.counters["newton_steps"] = figures.newton_steps;
        state.counters["trials"] = figures.trials;
        state.counters["products"] = figures.products;
        state.counters["error"] = figures.largest_relative_error;
    });
}

/// One pass over the triangles: areas and heights of orthocentres.
void add_pass(const Input& input) {
    add_case("power_pass", input, [=](benchmark::State& state) {
        const AreaProblem problem(input);
        const Eigen::VectorXd weights = Eigen::VectorXd::Zero(input.n);
        const plane::WeightedTriangulation regular{problem.delaunay.triangulation(),
                                                   problem.delaunay.coordinates(),
                                                   problem.delaunay.frame(), weights};
        Workers workers(1);
        std::vector<double> heights;
        Eigen::VectorXd mass;
        for ([[maybe_unused]] auto _ : state) {
            measure_masses(regular, workers, heights, mass);
            benchmark::DoNotOptimize(mass.data());
        }
    });
}

/// Five centroidal steps, as for grains of metals.
void add_grains(const Input& input) {
    add_case("grains", input, [=](benchmark::State& state) {
        const Eigen::VectorXd areas = grain_areas(input);
        for ([[maybe_unused]] auto _ : state) {
            const plane::AreaCvtResult result = compute_area_cvt(
                input.lattice, input.sites(), {.areas = areas, .run = {.max_iterations = 5}});
            state.counters["error"] = result.areas.largest_relative_error;
        }
    });
}

}  // namespace

void add_area_cases(const Input& input) {
    add_newton(input);
    add_pass(input);
    add_grains(input);
}

}  // namespace pcvt::bench
