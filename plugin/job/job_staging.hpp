#pragma once

#include <functional>
#include <string>
#include <vector>

#include "io/outputs/output_set.hpp"
#include "plugin/job/job.hpp"
#include "plugin/job/job_files.hpp"
#include "plugin/job/job_progress.hpp"

namespace pcvt {

/// Makes the bytes of the files of a job. Any number of threads may call it at once.
struct FileContent {
    std::function<std::vector<EncodedFile>(const JobFile& file)> encode;
    /// Reads encoded files back and compares.
    /// @throws InternalError, or CoarsePrecision where single precision does not hold the tile.
    std::function<void(const JobFile& file, const std::vector<EncodedFile>& encoded)> prove;
};

/// Encodes the files, proves their bytes and lets these reach the disk under hidden names; in the
/// plane as many at a time as the job has threads.
///
/// @returns for each file why its single precision does not hold the tile, and the file is not
///          staged; empty for the others.
/// @throws the fault of the first file in the list that has another one.
std::vector<std::string> stage_files(const Job& job, const std::vector<JobFile>& files,
                                     const FileContent& content, JobMonitor& monitor,
                                     OutputSet& outputs);

/// Waits for other runs that write to the same folders, and reports that.
/// @returns one line for each set of a run that died meanwhile.
/// @throws as OutputSet::wait_for_turn().
std::vector<std::string> wait_for_turn(OutputSet& outputs, JobMonitor& monitor);

}  // namespace pcvt
