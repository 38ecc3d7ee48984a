#include "plugin/space/space_report.hpp"

#include <algorithm>

#include "io/run_files/report.hpp"
#include "mesher/base/choices.hpp"
#include "plugin/job/job.hpp"
#include "plugin/job/version.hpp"

namespace pcvt {
namespace {

std::array<double, 3> numbers(const space::Vec3& v) { return {v.x(), v.y(), v.z()}; }

std::optional<SpaceReport::Pattern> report_pattern(
    const std::optional<SpacePatternOutcome>& pattern) {
    if (!pattern) return std::nullopt;
    const auto& [lattice, stability] = *pattern;
    const auto& [a, d, f, b, c, e] = lattice.form;
    return SpaceReport::Pattern{
        .basis = {numbers(lattice.basis.col(0)), numbers(lattice.basis.col(1)),
                  numbers(lattice.basis.col(2))},
        .hermite = {a, d, f, b, c, e},
        .energy = lattice.energy,
        .minimum = minimum_name(stability.minimum),
        .smallest_eigenvalue = stability.smallest};
}

}  // namespace

std::string encode_space_report(const SpaceJob& job, const SpaceSummary& summary,
                                double seconds_optimising, double seconds_writing) {
    SpaceReport report;
    report.version = version();
    report.sites = summary.n_sites;
    for (std::size_t k = 0; k < 3; ++k) {
        report.lattice[k] = numbers(job.lattice.periods()[k]);
    }
    report.seed = job.seed;
    report.solver = find_row(kSpaceSolvers, [&](const SpaceSolverRow& row) {
                        return row.solver == job.run.solver;
                    })->word;
    report.start =
        job.points.cols() > 0 ? "file" : find_row(kSpaceStarts, [&](const SpaceStartRow& row) {
                                             return row.start == chosen_start(job);
                                         })->word;
    report.stop = stop_name(summary.run.stop);
    report.iterations = summary.run.iterations;
    report.evaluations = summary.run.evaluations;
    report.energy = summary.run.energy;
    report.energy_bound = summary.energy_bound;
    report.residual = summary.run.residual;
    report.rms_residual = summary.run.rms_residual;
    if (summary.minimum) report.minimum = minimum_name(*summary.minimum);
    report.faces = summary.face_counts;
    report.removed_edges = summary.n_removed_edges;
    report.volume = summary.proof.volume;
    report.boundary_pairs = summary.proof.n_boundary_pairs;
    report.translations = summary.proof.n_translations;
    report.boundary_is_manifold = summary.proof.boundary_is_manifold;
    report.threads = job.run.n_threads;
    report.seconds = {seconds_optimising, seconds_writing, seconds_optimising + seconds_writing};
    report.files = summary.files;
    report.pattern = report_pattern(summary.pattern);
    if (job.duplicates == Duplicates::kDrop) report.duplicates = job.dropped;
    return encode_report(report);
}

}  // namespace pcvt
