#include "plugin/job/job_start.hpp"

#include "mesher/cvt/coarse_start.hpp"
#include "mesher/delaunay/spatial_sort.hpp"
#include "mesher/density/density_survey.hpp"
#include "mesher/search/global_search.hpp"

namespace pcvt {
namespace {

/// Below this random sites cost nothing, and the paper's statistics want them.
constexpr int kFewestForCoarse = 1000;

Start chosen_start(const Job& job) {
    if (job.start) return *job.start;
    // With a density that jumps, what the coarse cells miss makes higher minima.
    const bool coarse = job.n_sites >= kFewestForCoarse && job.max_iterations != 0 && !job.density;
    return coarse ? Start::kCoarse : Start::kRandom;
}

JobStart drawn_start(const Job& job) {
    JobStart start;
    start.points = job.density ? graded_points(job.lattice, *job.density, job.n_sites, job.seed)
                               : uniform_points(job.lattice, job.n_sites, job.seed);
    return start;
}

JobStart refined_start(const Job& job, const JobCallback& callback) {
    JobStart start;
    start.points =
        coarse_start(job.lattice, job.n_sites, {job.seed, job.n_threads, job.density, callback});
    start.precondition_below = kPreconditionAfterCoarse;
    start.cancelled = start.points.cols() == 0;
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
    JobStart start;
    start.points = std::move(result.points);
    start.pattern = PatternOutcome{result.lattice, lattice_stability(result.lattice)};
    start.found = std::move(result.found);
    start.evaluations = result.evaluations;
    start.cancelled = result.cancelled;
    return start;
}

JobStart found_start(const Job& job, const JobCallback& callback) {
    switch (chosen_start(job)) {
        case Start::kRandom:
            return drawn_start(job);
        case Start::kLattice:
            return lattice_start(job);
        case Start::kBest:
            return best_start(job, callback);
        case Start::kCoarse:
            return refined_start(job, callback);
    }
    throw InternalError("no such start");
}

}  // namespace

JobStart job_start(const Job& job, const JobCallback& callback) {
    JobStart start;
    if (job.points.cols() > 0) {
        start.points = job.points;
        return start;
    }
    start = found_start(job, callback);
    if (!start.cancelled) start.points = spatially_sorted(job.lattice, start.points);
    return start;
}

const char* start_name(const Job& job) {
    if (job.points.cols() > 0) return "file";
    switch (chosen_start(job)) {
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
