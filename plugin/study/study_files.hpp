#pragma once

#include <string>
#include <vector>

#include "plugin/study/study.hpp"

namespace pcvt {

/// One file of a study, planned before anything is computed.
struct StudyFile {
    std::string path;
    bool is_picture;
    /// Into the tables or pictures of the result.
    std::size_t index;
};

/// The files for the outputs asked for. `NAME.csv` stands for all tables (NAME.csv, NAME-runs.csv,
/// ...), `NAME.svg` for all pictures, and a folder (one that is there, or a name with a slash at
/// its end) for both under the study's name. A shard has one table, its runs, and no picture:
/// `NAME.csv` is that table, in a folder STUDY-shard-1-of-4.csv.
/// @param inputs  files that are read: no output may stand in their place.
/// @throws InvalidInput for another extension, and where two files have one path.
std::vector<StudyFile> plan_study_files(const std::vector<std::string>& outputs,
                                        const std::string& study, StudyShard shard,
                                        const std::vector<std::string>& inputs);

/// Writes them, all or none.
/// @throws OutputError as OutputSet does.
void write_study(const StudyResult& result, const std::vector<StudyFile>& files, bool force);

}  // namespace pcvt
