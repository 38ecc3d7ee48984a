#include "plugin/job_start.hpp"

namespace pcvt {
namespace {

JobStart lattice_start(const Job& job) {
    const LatticePattern pattern = best_lattice(job.lattice, job.n_sites);
    return {pattern_points(pattern), PatternOutcome{pattern, lattice_stability(pattern)}};
}

}  // namespace

JobStart job_start(const Job& job) {
    if (job.points.cols() > 0) return {job.points, {}};
    switch (job.start) {
        case Start::kRandom:
            return {uniform_points(job.lattice, job.n_sites, job.seed), {}};
        case Start::kLattice:
            return lattice_start(job);
        case Start::kCoarse:
        case Start::kBest:
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
