#include "plugin/job/space_start.hpp"

#include "mesher/base/checkpoint.hpp"
#include "mesher/space/cvt/coarse_start.hpp"
#include "mesher/space/search/lattice_pattern.hpp"
#include "mesher/space/search/lattice_stability.hpp"
#include "plugin/job/job_start.hpp"

namespace pcvt {
namespace {

space::Points coarse_points(const Job& job, JobMonitor& monitor) {
    RunOptions run = job.run;
    run.progress = [&](const Progress& progress) { return monitor.start_iteration(progress); };
    space::Points points = space::coarse_start(job.in_space().lattice, job.n_sites, job.seed, run);
    if (points.cols() == 0) throw Cancelled{};
    return points;
}

/// The sites of the best lattice, whose figures are noted.
space::Points lattice_points(const Job& job, StartFigures& figures) {
    Eigen::Matrix3d period;
    for (int k = 0; k < 3; ++k) period.col(k) = job.in_space().lattice.periods()[k];
    const space::LatticePattern pattern = space::best_lattice(period, job.n_sites);
    const auto& [a, d, f, b, c, e] = pattern.form;
    figures.pattern = PatternFigures{.basis = pattern.basis,
                                     .hermite = {a, d, f, b, c, e},
                                     .energy = pattern.energy,
                                     .stability = space::lattice_stability(pattern)};
    return pattern_points(pattern);
}

}  // namespace

space::Points space_start_points(const Job& job, JobMonitor& monitor, StartFigures& figures) {
    if (job.n_given() > 0) return job.in_space().points;
    figures.chosen = chosen_start(job);
    switch (figures.chosen) {
        case Start::kRandom:
            return uniform_points(job.in_space().lattice, job.n_sites, job.seed);
        case Start::kCoarse:
            return coarse_points(job, monitor);
        case Start::kLattice:
            return lattice_points(job, figures);
        case Start::kBest:
            break;
    }
    throw InternalError("no sites in space begin there");
}

}  // namespace pcvt
