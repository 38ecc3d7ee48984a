#include "plugin/cli/options/material_options.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <filesystem>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/run_files/material_reader.hpp"
#include "io/run_files/orientation_reader.hpp"
#include "mesher/base/error.hpp"

namespace pcvt::cli {
namespace {

/// Whether there is a file, which is not a folder, so that a phase may have the name of a folder.
bool is_a_file(const std::string& path) {
    std::error_code unknown;
    return std::filesystem::exists(path, unknown) && !std::filesystem::is_directory(path, unknown);
}

/// A file that exists wins over fractions.
void read_phase_choice(const std::string& text, MaterialChoices& choices,
                       std::vector<std::string>& inputs) {
    const TableName table = parse_table_name(text);
    if (is_a_file(table.path)) {
        set_phases(read_phases(table), choices);
        inputs.push_back(table.path);
        return;
    }
    try {
        choices.phases = parse_phases(text);
    } catch (const InvalidInput& error) {
        const bool may_be_file =
            text.substr(0, text.find(':')).find_first_of("./") != std::string::npos;
        throw InvalidInput("--phases " + in_quotes(text) + ": " + error.what() +
                           (may_be_file ? "; there is no file of that name" : ""));
    }
}

}  // namespace

void add_material_options(CLI::App& app, MaterialOptions& options) {
    app.option_defaults()->group("Materials");
    app.add_option("--phases", options.phases,
                   "each cell gets a phase; the fractions of the area or volume sum to 1, the\n"
                   "cells of a phase are spread evenly, drawn from --seed; or the phase of\n"
                   "each site, one name a line")
        ->type_name("NAME:FRACTION,...|FILE[:COLUMN]");
    app.add_option("--orientations", options.orientations,
                   "each cell gets an orientation: Bunge's angles phi1, Phi, phi2; random:\n"
                   "without a texture, drawn from --seed; else a table with three angles a\n"
                   "line, one line a site, or with columns phi1, Phi, phi2 or Euler1 to Euler3\n"
                   "in its header, or FILE:COLUMN,COLUMN,COLUMN, in degrees, or in radians as\n"
                   "its header or rad:FILE says; deg:FILE takes as degrees what looks like\n"
                   "radians; from a table of more lines than sites, or with a column weight or a\n"
                   "fourth COLUMN of weights, orientations are drawn, from --seed")
        ->type_name("random|FILE|deg:FILE|rad:FILE");
    app.add_option(
           "--material", options.materials,
           "of .inp with --job elastic, and of .vti: the elastic constants of a phase, E,NU,\n"
           "or C11,C12,C44 of cubic crystals, or C11,C12,C13,C33,C44 of hexagonal ones\n"
           "(axis z), in the unit of your choice; repeatable, once for each phase; same: all\n"
           "phases are the same steel, or with --orientations iron, in MPa; FILE.yaml: the\n"
           "constants of all phases, in the form of DAMASK")
        ->type_name("NAME:E,NU|FILE.yaml|same")
        ->allow_extra_args(false);
}

ElasticChoices elastic_choices(const MaterialOptions& options, std::vector<std::string>& inputs) {
    std::string all;
    for (const std::string& material : options.materials) all += material + "\n";
    if (options.materials.empty()) return {};
    try {
        return read_elastic_choices(all, inputs);
    } catch (const BadFile&) {
        throw;
    } catch (const InvalidInput& error) {
        throw InvalidInput(std::string("--material ") + error.what());
    }
}

void set_phases(const PhaseFile& file, MaterialChoices& choices) {
    choices.phases.clear();
    for (const std::string& name : file.names) choices.phases.push_back({.name = name});
    choices.site_phases = file.site_phases;
}

MaterialChoices material_choices(const CLI::App& app, const MaterialOptions& options,
                                 std::vector<std::string>& inputs) {
    MaterialChoices choices;
    if (app.count("--phases") > 0) read_phase_choice(options.phases, choices, inputs);
    if (app.count("--orientations") == 0) return choices;
    choices.draws_orientations = options.orientations == "random";
    if (choices.draws_orientations) return choices;
    const TableName table = orientation_table(options.orientations);
    OrientationTable read = read_orientations(table);
    choices.orientations = std::move(read.angles);
    choices.orientation_weights = std::move(read.weights);
    choices.orientation_source = std::move(read.source);
    inputs.push_back(table.path);
    return choices;
}

}  // namespace pcvt::cli
