#include "plugin/cli/options/material_options.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/run_files/orientation_reader.hpp"
#include "mesher/base/error.hpp"

namespace pcvt::cli {
namespace {

/// The path and the unit of FILE, deg:FILE or rad:FILE.
std::pair<std::string, AngleUnit> orientation_file(const std::string& text) {
    constexpr std::size_t kPrefix = 4;
    if (text.starts_with("deg:")) return {text.substr(kPrefix), AngleUnit::kDegrees};
    if (text.starts_with("rad:")) return {text.substr(kPrefix), AngleUnit::kRadians};
    return {text, AngleUnit::kGuessed};
}

}  // namespace

void add_material_options(CLI::App& app, MaterialOptions& options) {
    app.option_defaults()->group("Materials");
    app.add_option("--phases", options.phases,
                   "each cell gets a phase; the fractions of the area sum to 1, and the\n"
                   "cells of a phase are spread evenly, drawn from --seed")
        ->type_name("NAME:FRACTION,...");
    app.add_option("--orientations", options.orientations,
                   "each cell gets an orientation: Bunge's angles phi1, Phi, phi2; random:\n"
                   "without a texture, drawn from --seed; else three angles a line, one line\n"
                   "a site, # comments, in degrees, or with rad:FILE in radians; deg:FILE\n"
                   "takes as degrees what looks like radians")
        ->type_name("random|FILE|deg:FILE|rad:FILE");
    app.add_option(
           "--material", options.materials,
           "of .inp with --job elastic, and of .vti: the elastic constants of a phase, E,NU,\n"
           "or C11,C12,C44 of cubic crystals, or C11,C12,C13,C33,C44 of hexagonal ones\n"
           "(axis z), in the unit of your choice; repeatable, once for each phase; same: all\n"
           "phases are the same steel, or with --orientations iron, in MPa")
        ->type_name("NAME:E,NU|same")
        ->allow_extra_args(false);
}

ElasticChoices elastic_choices(const MaterialOptions& options) {
    std::string all;
    for (const std::string& material : options.materials) all += material + "\n";
    if (options.materials.empty()) return {};
    try {
        return parse_elastic_choices(all);
    } catch (const InvalidInput& error) {
        throw InvalidInput(std::string("--material ") + error.what());
    }
}

MaterialChoices material_choices(const CLI::App& app, const MaterialOptions& options,
                                 std::vector<std::string>& inputs) {
    MaterialChoices choices;
    if (app.count("--phases") > 0) {
        try {
            choices.phases = parse_phases(options.phases);
        } catch (const InvalidInput& error) {
            throw InvalidInput("--phases " + in_quotes(options.phases) + ": " + error.what());
        }
    }
    if (app.count("--orientations") == 0) return choices;
    choices.draws_orientations = options.orientations == "random";
    if (choices.draws_orientations) return choices;
    const auto& [path, unit] = orientation_file(options.orientations);
    choices.orientations = read_orientations(path, unit);
    inputs.push_back(path);
    return choices;
}

}  // namespace pcvt::cli
