#pragma once

#include <string>
#include <vector>

#include "plugin/study/study.hpp"

namespace CLI {
class App;
}

namespace pcvt::cli {

/// The options of `pcvt study` as they were typed; empty where they were not.
struct StudyOptions {
    std::string name;
    std::string sites;
    std::string runs;
    std::string seed;
    std::string shard;
    std::vector<std::string> merge;
    std::vector<std::string> outputs;
    std::string threads;
    bool force = false;
    bool quiet = false;
};

/// Gives `app` the options, its description and its examples; parsing fills `options`.
void add_study_options(CLI::App& app, StudyOptions& options);

/// What is to be done.
struct StudyRequest {
    Study study;
    StudyShard shard;
    /// Not empty: the study comes from these files, and `study` has only the name.
    std::vector<std::string> merge;
    int n_threads = 1;
};

/// @param app  the one that add_study_options was given, after parsing.
/// @throws InvalidInput, LimitExceeded naming the option.
StudyRequest make_study_request(const CLI::App& app, const StudyOptions& options);

}  // namespace pcvt::cli
