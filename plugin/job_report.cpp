#include "plugin/job_report.hpp"

#include "io/report.hpp"
#include "plugin/version.hpp"

namespace pcvt {
namespace {

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

}  // namespace

std::string encode_job_report(const Job& job, const JobOutcome& outcome) {
    const JobSeconds& seconds = outcome.seconds;
    return encode_report({
        .version = version(),
        .sites = outcome.n_sites,
        .lattice = job.lattice,
        .seed = job.seed,
        .solver = solver_name(job.solver),
        .start = job.points.cols() > 0 ? "file" : "random",
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
    });
}

}  // namespace pcvt
