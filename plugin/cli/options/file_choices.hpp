#pragma once

#include <string>

#include "io/forms/file_options.hpp"

namespace CLI {
class App;
}

namespace pcvt::cli {

/// The options that choose the forms of files, as the user typed them; empty if not given.
struct FileChoices {
    std::string colour;
    std::string background;
    std::string glb_nodes;
    bool float32 = false;
    std::string pixels;
    std::string voxels;
    std::string coriolis;
    std::string cut;
    std::string element;
    std::string job;
    std::string thickness;
    std::string surface;
};

/// Adds the options to `app`; parsing fills `choices`.
///
///   add_file_choices(app, options.files);
///   app.parse(argc, argv);
///   job.file_options = file_options(app, options.files);
void add_file_choices(CLI::App& app, FileChoices& choices);

/// @throws InvalidInput, LimitExceeded naming the option.
FileOptions file_options(const CLI::App& app, const FileChoices& choices);

}  // namespace pcvt::cli
