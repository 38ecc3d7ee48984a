#pragma once

#include <string>
#include <vector>

#include "plugin/cli/cell_options.hpp"
#include "plugin/cli/options/file_choices.hpp"
#include "plugin/cli/options/material_options.hpp"
#include "plugin/job/job.hpp"

namespace CLI {
class App;
}

namespace pcvt::cli {

/// The options of `pcvt mesh` as the user typed them; empty if not given.
struct MeshOptions {
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
    std::string tolerance;
    std::string max_iterations;
    std::vector<std::string> meshes;
    std::string outline;
    std::string short_edges;
    std::string size;
    std::string per_edge;
    std::string order;
    std::string repeat;
    std::string origin;
    std::vector<std::string> outputs;
    MaterialOptions materials;
    FileChoices files;
    std::string report;
    std::string table;
    std::string threads;
    bool strict = false;
    bool stability = false;
    bool force = false;
    bool quiet = false;
};

/// Adds the options and the examples to `app`; parsing fills `options`.
///
///   add_mesh_options(app, options);
///   app.parse(argc, argv);
///   const Job job = make_job(app, options);
void add_mesh_options(CLI::App& app, MeshOptions& options);

/// The value of --report, which may be empty.
/// @throws InvalidInput unless it ends in .json.
std::string report_file(const std::string& path);

/// The job that the options describe, without the sites of `options.input` and the areas of a file,
/// which it does not read.
/// @param app  that of add_mesh_options, after parsing.
/// @throws InvalidInput, LimitExceeded naming the option.
Job make_job(const CLI::App& app, const MeshOptions& options);

}  // namespace pcvt::cli
