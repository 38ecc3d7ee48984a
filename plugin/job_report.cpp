#include "plugin/job_report.hpp"

#include "io/report.hpp"
#include "plugin/version.hpp"

namespace pcvt {
namespace {

std::optional<Report::Density> report_density(const Job& job, const JobOutcome& outcome) {
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

std::string encode_job_report(const Job& job, const JobOutcome& outcome) {
    const JobSeconds& seconds = outcome.seconds;
    return encode_report({
        .version = version(),
        .sites = outcome.n_sites,
        .lattice = job.lattice,
        .seed = job.seed,
        .solver = job.solver == Solver::kLloyd ? "lloyd" : "lbfgs",
        .start = job.points.cols() > 0 ? "file" : "random",
        .stop = stop_name(outcome.stop),
        .iterations = outcome.iterations,
        .evaluations = outcome.evaluations,
        .energy = outcome.energy,
        .energy_bound = outcome.energy_bound,
        .residual = outcome.residual,
        .hexagons = outcome.n_hexagons,
        .valences = outcome.valences,
        .mirrors = outcome.n_mirrors,
        .threads = job.n_threads,
        .seconds = {seconds.build, seconds.optimize, seconds.write, seconds.total},
        .files = outcome.files,
        .density = report_density(job, outcome),
    });
}

}  // namespace pcvt
