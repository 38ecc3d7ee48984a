#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/formats/output_files.hpp"
#include "plugin/job/job.hpp"

namespace pcvt {

/// One output of a job.
using JobFile = OutputFile;

/// The content that a job in the plane has for its files, besides the density.
FormatRequest format_request(const Job& job);

/// Job::tile at the origin of the domain, in the plane.
plane::TileOptions tile_options(const Job& job);

/// The files of a job in the order of its outputs, without the report.
///
///   for (const JobFile& file : plan_files(job)) std::puts(file.paths.front().c_str());
///
/// @throws InvalidInput for an unknown extension, for a mesh that its format cannot hold, and for
///         two files of the job, or a file and an input, with the same path.
std::vector<JobFile> plan_files(const Job& job);

/// Requires that all files and the report can be written. Completes or removes the unfinished sets
/// of earlier runs, and returns one line for each set.
/// @throws OutputError
std::vector<std::string> require_all_writable(const Job& job, const std::vector<JobFile>& files);

/// Requires a file that holds the mid-side nodes of a job of order 2. The files of other formats
/// hold only its corners.
/// @throws InvalidInput if the job has files, and none of them holds mid-side nodes.
void check_order(const Job& job, const std::vector<JobFile>& files);

/// Requires for each choice in job.file_options a file whose format takes it, and elastic constants
/// where a file would give several phases the same ones.
/// @param phases  those of the cells outside of holes.
/// @throws InvalidInput if the job has files, and none of them takes the choice.
void check_file_options(const Job& job, const std::vector<JobFile>& files,
                        const std::vector<std::string>& phases);

/// The colour of "none" or "#rrggbb".
/// @throws InvalidInput for other words.
std::optional<Colour> background_colour(const std::string& word);

}  // namespace pcvt
