#pragma once

#include <array>
#include <string>
#include <vector>

#include "plugin/cli/cell_options.hpp"
#include "plugin/cli/options/file_choices.hpp"
#include "plugin/cli/options/material_options.hpp"
#include "plugin/cli/options/number_texts.hpp"
#include "plugin/job/job.hpp"

namespace CLI {
class App;
}

namespace pcvt::cli {

/// The outlines as the other choices: a word and PCVT_WHOLE or PCVT_BOX of pcvt.h.
struct OutlineRow {
    plane::Outline outline;
    const char* word;
    int abi_value;
};
inline constexpr std::array kOutlines{OutlineRow{plane::Outline::kWhole, "whole", 0},
                                      OutlineRow{plane::Outline::kBox, "box", 1}};

/// The options of `pcvt mesh` as the user typed them; empty if not given.
struct MeshOptions {
    /// The options that need no reading: paths and flags of the job itself.
    Job job;
    std::string sites;
    std::string seed;
    std::string retry;
    std::string input;
    std::string duplicates;
    std::string period;
    std::string lattice;
    std::string symmetry;
    CellOptions cells;
    std::string start;
    std::string budget;
    std::string solver;
    std::vector<std::string> meshes;
    std::string outline;
    std::string order;
    std::string repeat;
    std::string origin;
    MaterialOptions materials;
    FileChoices files;
    NumberTexts numbers;
    std::string table;
    std::string threads;
    bool strict = false;
    bool quiet = false;
};

/// The table of the sites, or of the centroids in their place; empty without one.
inline const std::string& point_table(const MeshOptions& options) {
    return options.cells.centroids.empty() ? options.input : options.cells.centroids;
}

/// Adds the options and the examples to `app`; parsing fills `options`.
///
///   add_mesh_options(app, options);
///   app.parse(argc, argv);
///   const Job job = make_job(app, options);  // mesh_job.hpp
void add_mesh_options(CLI::App& app, MeshOptions& options);

}  // namespace pcvt::cli
