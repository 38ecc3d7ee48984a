#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/outputs/output_set.hpp"
#include "io/space_formats.hpp"
#include "plugin/space/space_job.hpp"

namespace pcvt {

/// What the files of a job hold.
struct SpaceContent {
    const SpaceTile& tile;
    /// The sites in the domain, 3 x n, for .txt files.
    space::Points points;
    /// For files of tetrahedra; nothing if there is none.
    std::optional<space::TetrahedralMesh> tetrahedra = {};
};

/// One output of a job.
struct SpaceJobFile {
    /// As the user named it, without a slash at the end of a folder.
    std::string path;
    const SpaceFormat* format;
};

/// The outputs of a job in their order.
///
/// Example usage:
///     for (const SpaceJobFile& file : plan_space_files(job)) std::puts(file.path.c_str());
///
/// @throws InvalidInput for a format that holds no volumes, for one that holds no tetrahedra where
/// the
///         job names these, and for two equal paths.
std::vector<SpaceJobFile> plan_space_files(const Job& job);

/// Requires that all files can be written. Completes or removes the unfinished sets of earlier
/// runs, and returns one line for each set.
/// @throws OutputError
std::vector<std::string> require_space_files_writable(const Job& job,
                                                      const std::vector<SpaceJobFile>& files);

/// Encodes the files, proves their bytes and lets these reach the disk under hidden names.
/// @returns the files whose single precision does not hold the tile, which are not staged.
std::vector<RefusedFile> stage_space_files(const std::vector<SpaceJobFile>& files,
                                           const SpaceContent& content,
                                           const SpaceFileOptions& options, JobMonitor& monitor,
                                           OutputSet& outputs);

}  // namespace pcvt
