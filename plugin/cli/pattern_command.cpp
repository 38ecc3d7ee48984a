#include "plugin/cli/pattern_command.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "plugin/cli/mesh_job.hpp"

namespace pcvt::cli {
namespace {

constexpr const char* kPatternExamples =
    "Examples:\n"
    "  pcvt pattern --sites 56 -o pattern.svg\n"
    "      the lattice of 56 cells with the lowest energy on the unit square\n"
    "  pcvt pattern --sites 30 --lattice 1,0,0.37,0.81 --mesh delaunay -o pattern.obj\n"
    "      its dual on an oblique period lattice\n"
    "  pcvt pattern --sites 10\n"
    "      only the summary: basis, energy, and whether the lattice is a minimum\n"
    "  pcvt pattern --sites 54 --period 1,1,1 -o pattern.vtu\n"
    "      54 truncated octahedra in space\n";

/// Options of `pcvt mesh` that do not apply, because pattern computes the sites, does not move them
/// and gives all cells one area and one form.
constexpr const char* kForeign[] = {
    "--seed",           "--input",      "--start",   "--solver",     "--tolerance",
    "--max-iterations", "--strict",     "--budget",  "--density",    "--density-range",
    "--areas",          "--volumes",    "--retry",   "--stability",  "--symmetry",
    "--walls",          "--wall-cells", "--fixed",   "--inclusions", "--fibres",
    "--hole",           "--duplicates", "--weights", "--centroids"};

void require_pattern_options(const CLI::App& app) {
    for (const char* name : kForeign) {
        if (app.count(name) > 0) {
            throw InvalidInput(std::string(name) +
                               " is not for pattern, which computes the sites; leave it out");
        }
    }
    if (app.count("--sites") == 0) throw InvalidInput("no sites; give --sites N");
    if (app.count("--period") > 0 && app["--period"]->as<std::string>() == "auto") {
        throw InvalidInput("--period auto is not for pattern, whose cells are all alike; give W,H");
    }
}

}  // namespace

void add_pattern_options(CLI::App& app, MeshOptions& options) {
    add_mesh_options(app, options);
    app.get_option("--sites")->description("the number of cells, 1 to 268435456");
    app.get_option("--period")
        ->type_name("W,H")
        ->description("a rectangle [1,1]; W,H,D: a box in space");
    app.get_option("--lattice")
        ->description("any two independent period vectors; nine numbers: three, in space");
    app.get_option("--threads")->group("Output");
    for (const char* name : kForeign) app.get_option(name)->group("");
    app.footer(kPatternExamples);
}

Job make_pattern_job(const CLI::App& app, const MeshOptions& options) {
    require_pattern_options(app);
    Job job = make_job(app, options);
    job.start = Start::kLattice;
    job.run.max_iterations = 0;
    return job;
}

}  // namespace pcvt::cli
