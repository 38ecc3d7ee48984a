#pragma once

#include <functional>
#include <string>
#include <vector>

#include "plugin/job/job.hpp"
#include "plugin/job/job_start.hpp"

namespace pcvt {

/// Computes the tessellation of a job that has no aspect, from its start, whose points and areas
/// are moved from.
/// @param built  called once the first triangulation is built and evaluated.
plane::Tessellation tessellate(const Job& job, JobStart& start, JobMonitor& monitor,
                               const std::function<void()>& built);

/// The metric of the job's aspect, in the dimension of its domain.
plane::Metric metric_of(const Job& job, const PlaneDomain& domain);
space::Metric metric_of(const Job& job, const SpaceDomain& domain);
/// The job with its lattice, sites and density mapped to the round space of a metric.
Job in_round_space(const Job& job, const plane::Metric& metric);
Job in_round_space(const Job& job, const space::Metric& metric);

/// The file of the inclusions, or "fibres".
/// @pre the job has inclusions.
std::string inclusion_source(const Job& job);
/// Calls `work`, whose refusals begin with inclusion_source() and the line of the inclusion.
template <class Work>
auto naming_inclusions(const Job& job, const Work& work) {
    try {
        return work();
    } catch (const plane::BadInclusion& error) {
        throw InvalidInput(error.in_file(inclusion_source(job)));
    } catch (const InvalidInput& error) {
        throw InvalidInput(inclusion_source(job) + ": " + error.what());
    }
}

/// The words of the tags 1, 2, ... of the inclusions.
std::vector<std::string> inclusion_tags(const Job& job);
/// The names of the phases of a job, or of its tags outside of holes, as tag_materials() has them.
std::vector<std::string> file_phases(const Job& job);

/// The sites of a run at the iteration that `progress` reports, 2 x n, as wrapped_sites() gives
/// them once the run has ended; sites inside holes are among them. Empty where they are not known.
plane::Points progress_sites(const Job& job, const Progress& progress);

}  // namespace pcvt
