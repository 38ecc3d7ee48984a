#include "plugin/job_start.hpp"

#include "mesher/global_search.hpp"

namespace pcvt {
namespace {

JobStart drawn_start(const Job& job) {
    JobStart start;
    start.points = uniform_points(job.lattice, job.n_sites, job.seed);
    return start;
}

JobStart lattice_start(const Job& job) {
    const LatticePattern pattern = best_lattice(job.lattice, job.n_sites);
    JobStart start;
    start.points = pattern_points(pattern);
    start.pattern = PatternOutcome{pattern, lattice_stability(pattern)};
    return start;
}

JobStart best_start(const Job& job, const JobCallback& callback) {
    const int budget = job.budget > 0 ? job.budget : default_search_budget(job.n_sites);
    SearchResult result =
        search_minimum(job.lattice, job.n_sites, {job.seed, budget, job.n_threads, callback});
    return {.points = std::move(result.points),
            .pattern = PatternOutcome{result.lattice, lattice_stability(result.lattice)},
            .found = std::move(result.found),
            .evaluations = result.evaluations,
            .cancelled = result.cancelled};
}

}  // namespace

JobStart job_start(const Job& job, const JobCallback& callback) {
    if (job.points.cols() > 0) {
        JobStart start;
        start.points = job.points;
        return start;
    }
    switch (job.start) {
        case Start::kRandom:
            return drawn_start(job);
        case Start::kLattice:
            return lattice_start(job);
        case Start::kBest:
            return best_start(job, callback);
        case Start::kCoarse:
            break;
    }
    throw InvalidInput(std::string("the start ") + start_name(job) +
                       " is not available yet; take another");
}

const char* start_name(const Job& job) {
    if (job.points.cols() > 0) return "file";
    switch (job.start) {
        case Start::kRandom:
            return "random";
        case Start::kCoarse:
            return "coarse";
        case Start::kLattice:
            return "lattice";
        case Start::kBest:
            return "best";
    }
    return "";
}

}  // namespace pcvt
