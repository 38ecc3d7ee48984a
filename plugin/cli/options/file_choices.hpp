#pragma once

#include <string>

#include "io/forms/file_options.hpp"
#include "plugin/cli/options/number_texts.hpp"

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
    std::string voxels;
    std::string coriolis;
    std::string element;
    std::string job;
    std::string surface;
};

/// Adds the options to `app`; parsing fills `choices`, and `numbers` of files.
///
///   add_file_choices(app, options.files, options.numbers);
///   app.parse(argc, argv);
///   job.file_options = file_options(app, options.files);
void add_file_choices(CLI::App& app, FileChoices& choices, NumberTexts& numbers);

/// The choices, without the numbers.
/// @throws InvalidInput naming the option.
FileOptions file_options(const CLI::App& app, const FileChoices& choices);

}  // namespace pcvt::cli
