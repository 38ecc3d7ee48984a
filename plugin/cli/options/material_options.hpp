#pragma once

#include <string>
#include <vector>

#include "mesher/cells/elastic_choices.hpp"
#include "mesher/cells/material_choices.hpp"

namespace CLI {
class App;
}

namespace pcvt::cli {

/// The options of materials, as the user typed them; empty if not given.
struct MaterialOptions {
    std::string phases;
    std::string orientations;
    std::vector<std::string> materials = {};
};

/// Adds the options to `app`; parsing fills `options`.
///
///   add_material_options(app, options.materials);
///   app.parse(argc, argv);
///   job.materials = material_choices(app, options.materials, job.inputs);
void add_material_options(CLI::App& app, MaterialOptions& options);

/// Reads the file of orientations, and adds its path to `inputs`.
/// @throws InvalidInput, BadFile naming the option or the file with its line.
MaterialChoices material_choices(const CLI::App& app, const MaterialOptions& options,
                                 std::vector<std::string>& inputs);

/// The elastic constants of --material.
/// @throws InvalidInput naming the option.
ElasticChoices elastic_choices(const MaterialOptions& options);

}  // namespace pcvt::cli
