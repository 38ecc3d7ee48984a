#pragma once

#include <string>
#include <vector>

#include "io/run_files/phase_reader.hpp"
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

/// Reads the files of phases and of orientations, and adds their paths to `inputs`.
/// @throws InvalidInput, BadFile naming the option or the file with its line.
MaterialChoices material_choices(const CLI::App& app, const MaterialOptions& options,
                                 std::vector<std::string>& inputs);

/// Gives each site the phase of a table.
void set_phases(const PhaseFile& file, MaterialChoices& choices);

/// The elastic constants of --material; adds the paths of their files to `inputs`.
/// @throws InvalidInput, BadFile naming the option or the file with its line.
ElasticChoices elastic_choices(const MaterialOptions& options, std::vector<std::string>& inputs);

}  // namespace pcvt::cli
