#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/outputs/output_set.hpp"
#include "plugin/job/job_files.hpp"
#include "plugin/job/space_job.hpp"

namespace pcvt {

/// What the files of a job hold.
struct SpaceContent {
    const SpaceTile& tile;
    /// The sites in the domain, 3 x n, for .txt files.
    space::Points points;
    /// For files of tetrahedra; nothing if there is none.
    std::optional<space::TetrahedralMesh> tetrahedra = {};
};

/// The file of an output.
/// @throws InvalidInput for a format that holds nothing of space, and for one that holds no
///         tetrahedra, or no removed edges, where the job has them.
JobFile space_file(const Job& job, const std::string& path);

/// Encodes the files, proves their bytes and lets these reach the disk under hidden names.
/// @returns the files whose single precision does not hold the tile, which are not staged.
std::vector<RefusedFile> stage_space_files(const std::vector<JobFile>& files,
                                           const SpaceContent& content,
                                           const SpaceFileOptions& options, JobMonitor& monitor,
                                           OutputSet& outputs);

}  // namespace pcvt
