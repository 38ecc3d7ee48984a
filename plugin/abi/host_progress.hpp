#pragma once

#include <cfenv>

#include "plugin/job/job.hpp"
#include "plugin/job/job_progress.hpp"
#include "plugin/pcvt.h"

namespace pcvt::abi {

/// The progress callback of a host, with its data.
struct HostProgress {
    /// nullptr: none.
    pcvt_progress_callback call;
    void* data;
    /// The job whose sites the callback may get; must outlive the run. nullptr: none.
    const Job* job = nullptr;
};

/// Returns the callback of a run that calls the one of the host; empty where the host has none.
///
/// Example usage:
///     const HostProgress to{options.progress, options.progress_data};
///     const JobCallback callback = job_callback(to, energy_bound, host);
///     JobMonitor monitor(callback, job);
///
/// @param energy_bound  of pcvt_progress; NaN: unknown.
/// @param host          must outlive the callback.
JobCallback job_callback(const HostProgress& to, double energy_bound, const std::fenv_t& host);

}  // namespace pcvt::abi
