#include "plugin/cli/mesh_options.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <optional>
#include <thread>

#include "plugin/cli/help_command.hpp"
#include "plugin/cli/option_list.hpp"
#include "plugin/cli/options/command_words.hpp"
#include "plugin/cli/options/mesh_examples.hpp"
#include "plugin/cli/options/option_values.hpp"
#include "plugin/cli/options/site_source.hpp"
#include "plugin/job/features.hpp"
#include "plugin/job/job_checks.hpp"
#include "plugin/job/job_files.hpp"
#include "plugin/job/job_start.hpp"

namespace pcvt::cli {
namespace {

void add(CLI::App& app, const char* name, std::string& value, const std::string& form,
         const std::string& description) {
    app.add_option(name, value, description)->type_name(form);
}

/// Breaks words into lines of the width of a description.
std::string wrapped(std::string words) {
    constexpr std::size_t kWidth = 68;
    for (std::size_t begin = 0; words.size() - begin > kWidth;) {
        begin = words.rfind(' ', begin + kWidth);
        words[begin++] = '\n';
    }
    return words;
}

/// The words of a table as the form of an option: "whole|box".
template <class Table>
std::string form_of(const Table& table) {
    return listed_words(table, "|", "|");
}

std::string start_help() {
    std::string text = "where the sites of --sites begin";
    for (const StartRow& row : start_rows()) {
        if (*row.help != '\0') text += std::string("; ") + row.word + ": " + row.help;
    }
    return text + " [coarse from N = 1000 on,\nwith --symmetry from 1000 orbits on, else random]";
}

std::string solver_help() {
    std::string text = "the method";
    for (const SolverRow& row : kSolvers) {
        if (*row.help != '\0') text += std::string("; ") + row.help;
    }
    return text + " [" + solver_row(Job().run.solver).word + "]";
}

/// The words of the plane groups on two lines.
std::string plane_group_words() {
    std::string text = listed_words(plane::kPlaneGroups, ", ", " or ");
    text[text.rfind(' ', text.size() / 2)] = '\n';
    return text;
}

/// The suffixes of file names: "-voronoi, -delaunay, -grains".
std::string mesh_suffixes() { return "-" + listed_words(plane::kMeshKinds, ", -", ", -"); }

void add_site_options(CLI::App& app, MeshOptions& options) {
    app.option_defaults()->group("Sites and lattice");
    add(app, "--sites", options.sites, "N", "N sites, 1 to 268435456, placed by --start");
    add(app, "--seed", options.seed, "S", "the seed of the random numbers [0]");
    add(app, "--retry", options.retry, "K",
        "take the next seed, at most K times, while an output refuses the cells\n(.nc: obtuse "
        "triangles) [0]");
    add(app, "--input", options.input, "FILE[:X,Y]",
        "read the sites, \"x y\" a line (in space \"x y z\"), # comments, from a\n"
        "regular file of at most 16 GiB; - is standard input, at most 1 GiB;\n"
        "a table with a header gives its columns x, y, or X,Y names them");
    add(app, "--duplicates", options.duplicates, form_of(kDuplicates),
        "sites of a file within 1e-9 h of an earlier one: refuse names all of\n"
        "their lines, drop leaves them out [refuse]");
    add(app, "--period", options.period, "W,H|auto",
        "the sides of a rectangle [1,1]; W,H,D: of a box in space; auto: a square\n"
        "of the sum of the areas of --areas FILE, or 1,H with the aspect of\n"
        "--density FILE.png");
    add(app, "--lattice", options.lattice, "AX,AY,BX,BY",
        "two independent period vectors; nine numbers: three, in space");
    add(app, "--symmetry", options.symmetry, "GROUP",
        "drawn sites with the symmetry of a plane group, which they keep:\n" + plane_group_words() +
            ";\n--sites counts those of one period; without a lattice the unit square,\nor "
            "1,0,0.5,0.866 for p3 to p6m");
    add(app, "--origin", options.origin, "X,Y|auto",
        "corner of the domain, in space X,Y,Z; auto: the box outline is cut\n"
        "where the shortest edge of the cut is longest, in space where the cut\n"
        "makes the fewest narrow angles [0,0]");
    add_cell_options(app, options.cells, options.job);
}

void add_solver_options(CLI::App& app, MeshOptions& options) {
    app.option_defaults()->group("Optimisation");
    add(app, "--start", options.start, form_of(start_rows()), start_help());
    add(app, "--budget", options.budget, "E",
        "evaluations that --start best may spend [the least of 2000 N, 2e5\nand 8e7 / N]");
    add(app, "--solver", options.solver, form_of(kSolvers), solver_help());
    add_number(app, "--tolerance", options.numbers);
    add_number(app, "--max-iterations", options.numbers);
    app.add_flag("--strict", options.strict,
                 "write the files, but exit with 5 if the run did not converge");
    app.add_flag("--stability", options.job.stability,
                 "answer whether the sites end at a minimum of the energy: up to\n"
                 "10000 sites (2000 in space), without a density; takes up to three times the\n"
                 "optimisation");
    add(app, "--threads", options.threads, "N",
        "the number of threads, on which the result does not depend\n[all cores]");
}

void add_output_options(CLI::App& app, MeshOptions& options) {
    app.option_defaults()->group("Output");
    app.add_option("--mesh", options.meshes,
                   "the faces, repeatable [voronoi]; grains: triangles inside of cells, in\n"
                   "space tetrahedra (.msh, .inp, .vtu, .foam; .stl: surfaces);\n"
                   "in space delaunay: tetrahedra, which .msh and .inp hold without --mesh too;\n"
                   "with several, " +
                       mesh_suffixes() + " precede the extension")
        ->type_name("KIND")
        ->option_text(form_of(plane::kMeshKinds))
        ->allow_extra_args(false);
    add(app, "--outline", options.outline, form_of(kOutlines),
        "the boundary of the tile; whole: no cell is cut; box: cut along the\n"
        "period vectors at --origin [whole]");
    add_number(app, "--size", options.numbers);
    add_number(app, "--per-edge", options.numbers);
    add(app, "--order", options.order, "1|2",
        "2: grains with nodes in the middle of edges, in formats that hold them [1]");
    add_number(app, "--short-edges", options.numbers);
    add(app, "--repeat", options.repeat, "IxJ[xK]",
        "a tile of I x J domains, in space of I x J x K [1x1]");
    app.add_option("-o", options.job.outputs,
                   "an output, repeatable; none: only the summary; the extension decides:\n" +
                       wrapped(output_extensions()) +
                       "\n(.txt: the sites, in the order of the input)")
        ->type_name("FILE")
        ->option_text("FILE")
        ->allow_extra_args(false);
    add_file_choices(app, options.files, options.numbers);
    add(app, "--cells", options.table, "FILE.csv",
        "a table of the cells: position, area, diameter, sides, circularity\n"
        "and neighbours of each site");
    add(app, "--report", options.job.report, "FILE.json", "figures of the run");
    app.add_flag("--force", options.job.force, "replace existing files");
    app.add_flag("--quiet", options.quiet, "no summary and no progress");
}

}  // namespace

void add_mesh_options(CLI::App& app, MeshOptions& options) {
    add_site_options(app, options);
    add_solver_options(app, options);
    add_material_options(app, options.materials);
    add_output_options(app, options);
    add_other_numbers(app, options.numbers);
    mark_dimensions(app);
    app.footer(kMeshExamples);
}

}  // namespace pcvt::cli
