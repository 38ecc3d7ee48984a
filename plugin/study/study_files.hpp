#pragma once

#include <string>
#include <vector>

#include "io/outputs/commit_locks.hpp"
#include "io/outputs/output_set.hpp"
#include "plugin/study/study.hpp"

namespace pcvt {

/// Returns the bytes of a file.
/// @param index  into the tables or pictures of the result.
using StudyEncoder = std::string(const Study& study, const StudyResult& result, std::size_t index);

/// One file of a study, planned before anything is computed.
struct StudyFile {
    std::string path;
    StudyEncoder* encode;
    std::size_t index;
};

/// The files of the requested outputs. `NAME.csv` means all tables (NAME.csv, NAME-runs.csv, ...),
/// `NAME.svg` all pictures, `NAME.html` a page with all of them, and a folder (an existing one, or
/// a name that ends in a slash) everything, under the study's name. A shard has one table, its
/// runs, and no picture or page: `NAME.csv` is that table; in a folder its name is
/// STUDY-shard-1-of-4.csv.
/// @param inputs  files that the study reads; no output may replace them.
/// @throws InvalidInput for another extension, or if two files have the same path.
std::vector<StudyFile> plan_study_files(const std::vector<std::string>& outputs,
                                        const std::string& study, StudyShard shard,
                                        const std::vector<std::string>& inputs);

/// Stages all files, for a commit by the caller.
void stage_study(const Study& study, const StudyResult& result, const std::vector<StudyFile>& files,
                 OutputSet& outputs);

/// Writes all files, or none, once no other run writes to their folders.
/// @param waiting  called with words when the files have to wait for another run; may be empty.
/// @returns one line for each set of files of a run that died meanwhile.
/// @throws OutputError as OutputSet does; Cancelled.
std::vector<std::string> write_study(const Study& study, const StudyResult& result,
                                     const std::vector<StudyFile>& files, bool force,
                                     const WaitingCallback& waiting);

}  // namespace pcvt
