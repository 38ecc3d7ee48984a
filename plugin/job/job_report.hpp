#pragma once

#include <string>

#include "plugin/job/job.hpp"
#include "plugin/job/run_summary.hpp"

namespace pcvt {

/// Encodes the figures of a run as JSON: one key a line, first those of every run, then those of
/// the options that the job uses. Numbers are the shortest decimals that read back, text is UTF-8
/// (invalid bytes become U+FFFD). Keys are never renamed, because programs read them.
///
/// Example usage:
///     outputs.stage(job.report, encode_job_report(job, summary));
///
/// @throws InternalError if a number is not finite.
std::string encode_job_report(const Job& job, const RunSummary& summary);

}  // namespace pcvt
