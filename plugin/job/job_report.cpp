#include "plugin/job/job_report.hpp"

#include <algorithm>

#include "io/run_files/report.hpp"
#include "plugin/job/job_start.hpp"
#include "plugin/job/version.hpp"

namespace pcvt {
namespace {

std::optional<Report::Pattern> report_pattern(const std::optional<PatternOutcome>& pattern) {
    if (!pattern) return std::nullopt;
    const auto& [lattice, stability] = *pattern;
    return Report::Pattern{.basis = lattice.basis,
                           .hermite = {lattice.form.a, lattice.form.b, lattice.form.d},
                           .energy = lattice.energy,
                           .minimum = minimum_name(stability.minimum),
                           .smallest_eigenvalue = stability.smallest};
}

const char* solver_name(Solver solver) {
    switch (solver) {
        case Solver::kLloyd:
            return "lloyd";
        case Solver::kNewton:
            return "newton";
        case Solver::kLbfgs:
        case Solver::kPlainLbfgs:
            return "lbfgs";
    }
    return "";
}

/// Over all tiles of the run.
std::optional<double> shortest_box_edge(const RunSummary& outcome) {
    std::optional<double> shortest;
    for (const TileFigures& tile : outcome.tiles) {
        if (!tile.box_shortest_edge) continue;
        shortest = std::min(shortest.value_or(*tile.box_shortest_edge), *tile.box_shortest_edge);
    }
    return shortest;
}

std::optional<Report::Grains> report_grains(const RunSummary& outcome) {
    for (const TileFigures& tile : outcome.tiles) {
        if (!tile.grains) continue;
        Report::Grains grains{tile.grains->n_triangles, tile.grains->smallest_angle, {}};
        for (const SharpGrainCorner& corner : tile.grains->sharp_corners) {
            grains.sharp_corners.push_back({corner.site, corner.point, corner.angle});
        }
        return grains;
    }
    return std::nullopt;
}

std::optional<Report::Density> report_density(const Job& job, const RunSummary& outcome) {
    if (!outcome.density) return std::nullopt;
    const DensityFigures& figures = *outcome.density;
    return Report::Density{.name = job.density_name,
                           .least = figures.least,
                           .greatest = figures.greatest,
                           .evaluations_per_site = figures.evaluations_per_site,
                           .mass = figures.mass,
                           .mass_deviation = figures.mass_deviation,
                           .expected_energy = figures.expected_energy,
                           .spacing_deviation = figures.spacing_deviation,
                           .quadrature_error = figures.quadrature_error,
                           .rough_cells = figures.n_rough_cells};
}

}  // namespace

std::string encode_job_report(const Job& job, const RunSummary& outcome) {
    const JobSeconds& seconds = outcome.seconds;
    return encode_report({
        .version = version(),
        .sites = outcome.n_sites,
        .lattice = job.lattice,
        .seed = job.seed,
        .solver = solver_name(job.solver),
        .start = start_name(job),
        .stop = stop_name(outcome.stop),
        .iterations = outcome.iterations,
        .evaluations = outcome.evaluations,
        .hessians = outcome.hessians,
        .cg_products = outcome.cg_products,
        .energy = outcome.energy,
        .energy_bound = outcome.energy_bound,
        .residual = outcome.residual,
        .minimum = outcome.minimum ? std::optional<std::string>(minimum_name(*outcome.minimum))
                                   : std::nullopt,
        .hexagons = outcome.n_hexagons,
        .valences = outcome.valences,
        .mirrors = outcome.n_mirrors,
        .threads = job.n_threads,
        .seconds = {seconds.build, seconds.optimize, seconds.write, seconds.total},
        .files = outcome.files,
        .found = outcome.found,
        .pattern = report_pattern(outcome.pattern),
        .box_shortest_edge = shortest_box_edge(outcome),
        .grains = report_grains(outcome),
        .density = report_density(job, outcome),
    });
}

}  // namespace pcvt
