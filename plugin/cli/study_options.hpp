#pragma once

#include <string>
#include <vector>

#include "plugin/study/study.hpp"

namespace CLI {
class App;
}

namespace pcvt::cli {

/// The options of `pcvt study` as the user typed them; empty if not given.
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

/// Adds the options and the examples to `app`; parsing fills `options`.
///
///   add_study_options(app, options);
///   app.parse(argc, argv);
///   const StudyRequest request = make_study_request(app, options);
void add_study_options(CLI::App& app, StudyOptions& options);

/// The study to compute, or to merge from files.
struct StudyRequest {
    /// A study to merge has only its name here.
    Study study;
    StudyShard shard;
    int n_threads = 1;
};

/// The study that the options describe.
/// @param app  that of add_study_options, after parsing.
/// @throws InvalidInput, LimitExceeded naming the option.
StudyRequest make_study_request(const CLI::App& app, const StudyOptions& options);

}  // namespace pcvt::cli
