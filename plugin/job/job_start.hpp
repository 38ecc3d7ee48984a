#pragma once

#include <optional>
#include <span>

#include "mesher/plane/symmetry/symmetric_sites.hpp"
#include "plugin/job/job.hpp"
#include "plugin/job/run_summary.hpp"

namespace pcvt {

/// Where the sites of a job begin, and what is known of that place.
struct JobStart {
    /// 2 x n, length units.
    plane::Points points;
    /// The sites of jobs with a symmetry, in place of `points`; numbered by columns.
    std::optional<plane::SymmetricSites> symmetric = {};
    /// Sites of the user keep their numbers; all others are numbered by columns.
    plane::Numbering numbering = plane::Numbering::kByColumns;
    /// The target areas of jobs that have them, in the order of the result's sites, length^2.
    Eigen::VectorXd areas = {};
    /// For CvtOptions.
    double precondition_below = plane::CvtOptions().precondition_below;
    bool relaxes_active_sites = false;
    StartFigures figures;
    /// The evaluations of the global search.
    int evaluations = 0;
    bool cancelled = false;
};

/// A start as options, reports and runs know it.
struct StartRow {
    Start start;
    /// In options and reports.
    const char* word;
    /// PCVT_START_... of pcvt.h.
    int abi_value;
    /// Whether cells of different sizes, by a density or by prescribed areas, can begin there.
    bool with_sizes;
    /// Whether sites in space can begin there.
    bool in_space;
    /// For the command's help, with its line breaks; may be empty.
    const char* help;
    JobStart (*make)(const Job& job, const ProgressCallback& callback);
};

/// All starts, in the order of the enumerators.
std::span<const StartRow> start_rows();
const StartRow& start_row(Start start);

/// Refuses given sites that coincide with earlier ones, within 1e-9 h, or leaves them out of the
/// job, with their areas, orientations and lines, as job.duplicates says. A host calls it once its
/// job is complete. Sites that are not finite or too far away are left to the run.
///
///   settle_duplicates(job);
///   run_job(job, {});
///
/// @throws DuplicateSites with all pairs.
void settle_duplicates(Job& job);

/// The sites that a job begins with.
///
///   JobStart start = job_start(job, callback);
///   if (!start.cancelled) use(start.points);
///
/// @param job       in the round space, if it has an aspect.
/// @param callback  called by the coarse start and the global search once an iteration; false
///                  cancels.
/// @throws InvalidInput as scaled_areas does, before any computation.
JobStart job_start(const Job& job, const ProgressCallback& callback);

/// The start of a job whose sites are not given: what it states, else coarse from 1000 sites on
/// that are optimised, if coarse cells resolve its density and no sizes are prescribed, else
/// random.
Start chosen_start(const Job& job);

}  // namespace pcvt
