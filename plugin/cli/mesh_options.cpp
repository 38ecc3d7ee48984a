#include "plugin/cli/mesh_options.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <array>
#include <optional>
#include <thread>

#include "io/bytes/extension.hpp"
#include "plugin/cli/help_command.hpp"
#include "plugin/cli/options/command_words.hpp"
#include "plugin/cli/options/mesh_examples.hpp"
#include "plugin/cli/options/option_values.hpp"
#include "plugin/cli/options/site_source.hpp"
#include "plugin/job/job_checks.hpp"
#include "plugin/job/job_files.hpp"
#include "plugin/job/job_start.hpp"

namespace pcvt::cli {
namespace {

constexpr int kMostPerEdge = 1000;
constexpr int kLargestBudget = 2'000'000'000;
constexpr int kMostRetries = 1'000'000;

/// The outlines as the other choices: a word and PCVT_WHOLE or PCVT_BOX of pcvt.h.
struct OutlineRow {
    plane::Outline outline;
    const char* word;
    int abi_value;
};
constexpr std::array kOutlines{OutlineRow{plane::Outline::kWhole, "whole", 0},
                               OutlineRow{plane::Outline::kBox, "box", 1}};

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
    std::string text;
    for (const SolverRow& row : kSolvers) {
        if (*row.help != '\0') text += (text.empty() ? "" : "; ") + std::string(row.help);
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
    add(app, "--seed", options.seed, "S", "of the random numbers [0]");
    add(app, "--retry", options.retry, "K",
        "take the next seed, at most K times, while an output refuses the cells\n(.nc: obtuse "
        "triangles) [0]");
    add(app, "--input", options.input, "FILE",
        "read the sites, \"x y\" a line (in space \"x y z\"), # comments, from a\n"
        "regular file of at most 16 GiB; - is standard input, at most 1 GiB");
    add(app, "--duplicates", options.duplicates, form_of(kDuplicates),
        "sites of a file within 1e-9 h of an earlier one: refuse names all of\n"
        "their lines, drop leaves them out [refuse]");
    add(app, "--period", options.period, "W,H|auto",
        "a rectangle [1,1]; W,H,D: a box in space; auto: a square of the sum of\n"
        "the areas of --areas FILE, or 1,H with the aspect of --density FILE.png");
    add(app, "--lattice", options.lattice, "AX,AY,BX,BY",
        "two independent period vectors; nine numbers: three, in space");
    add(app, "--symmetry", options.symmetry, "GROUP",
        "drawn sites with the symmetry of a plane group, which they keep:\n" + plane_group_words() +
            ";\n--sites counts those of one period; without a lattice the unit square,\nor "
            "1,0,0.5,0.866 for p3 to p6m");
    add(app, "--origin", options.origin, "X,Y|auto",
        "corner of the domain; auto: the box outline is cut where the\n"
        "shortest edge of the cut is longest [0,0]");
    add_cell_options(app, options.cells);
}

void add_solver_options(CLI::App& app, MeshOptions& options) {
    app.option_defaults()->group("Optimisation");
    add(app, "--start", options.start, form_of(start_rows()), start_help());
    add(app, "--budget", options.budget, "E",
        "evaluations that --start best may spend [the least of 2000 N, 2e5\nand 8e7 / N]");
    add(app, "--solver", options.solver, form_of(kSolvers), solver_help());
    add(app, "--tolerance", options.tolerance, "T",
        "converged once max |x_i - g_i| / h <= T; x_i: site i, g_i: centroid\nof its cell, h = "
        "sqrt(area / n) [1e-6]");
    add(app, "--max-iterations", options.max_iterations, "K",
        "0: the Voronoi diagram of the sites as given; with --areas, steps\n"
        "that move each site to the centroid of its cell: 0 keeps the sites,\n"
        "5 gives round grains [no limit]");
    app.add_flag("--strict", options.strict,
                 "write the files, but exit with 5 if the run did not converge");
    app.add_flag("--stability", options.stability,
                 "answer whether the sites end at a minimum of the energy: up to\n"
                 "10000 sites (2000 in space), without a density; takes up to three times the\n"
                 "optimisation");
    add(app, "--threads", options.threads, "N", "the result does not depend on it [all cores]");
}

void add_output_options(CLI::App& app, MeshOptions& options) {
    app.option_defaults()->group("Output");
    app.add_option("--mesh", options.meshes,
                   "repeatable [voronoi]; grains: triangles inside of cells; with\n"
                   "several, " +
                       mesh_suffixes() + " precede the extension")
        ->type_name("KIND")
        ->option_text(form_of(plane::kMeshKinds))
        ->allow_extra_args(false);
    add(app, "--outline", options.outline, form_of(kOutlines),
        "whole: no cell is cut; box: cut along the period vectors at\n"
        "--origin [whole]");
    add(app, "--size", options.size, "H", "length of the edges of grains [h / 3]");
    add(app, "--per-edge", options.per_edge, "K",
        "cut each edge of the cells into K parts, grains inside to match,\n"
        "in place of --size");
    add(app, "--order", options.order, "1|2",
        "2: grains with nodes in the middle of edges, in formats that hold them [1]");
    add(app, "--short-edges", options.short_edges, "L",
        "remove Voronoi edges under L h from the cells, for finite volumes;\nin space at most 0.1, "
        "for .vtu and .foam [0]");
    add(app, "--repeat", options.repeat, "IxJ", "a tile of I x J domains [1x1]");
    app.add_option("-o", options.outputs,
                   "repeatable; none: only the summary; the extension decides:\n" +
                       wrapped(output_extensions()) +
                       "\n(.txt: the sites, in the order of the input)")
        ->type_name("FILE")
        ->option_text("FILE")
        ->allow_extra_args(false);
    add_file_choices(app, options.files);
    add(app, "--cells", options.table, "FILE.csv",
        "a table of the cells: position, area, diameter, sides, circularity\n"
        "and neighbours of each site");
    add(app, "--report", options.report, "FILE.json", "figures of the run");
    app.add_flag("--force", options.force, "replace existing files");
    app.add_flag("--quiet", options.quiet, "no summary and no progress");
}

/// The lattice of --period or --lattice, or one that fits the symmetry, or the unit square.
plane::Lattice chosen_lattice(const CLI::App& app, const MeshOptions& options,
                              const std::optional<plane::PlaneGroupName>& symmetry) {
    require_one_lattice(app);
    if (options.period == "auto") return automatic_period(options.cells);
    if (app.count("--period") > 0) return rectangle_lattice("--period", options.period);
    if (app.count("--lattice") > 0) return vector_lattice("--lattice", options.lattice);
    if (symmetry) return example_lattice(*symmetry);
    return plane::Lattice::rectangle(1, 1);
}

void read_site_source(const CLI::App& app, const MeshOptions& options, Job& job) {
    require_one_site_source(app, options.input);
    if (app.count("--sites") > 0)
        job.n_sites = whole_number("--sites", options.sites, 1, plane::kMostSites);
    const bool draws_areas = job.areas && job.areas->is_drawn();
    if (!draws_areas) refuse_beside_input(app, {"--seed"});
    refuse_beside_input(app, {"--retry", "--start", "--symmetry"});
    if (app.count("--seed") > 0) job.seed = seed_number("--seed", options.seed);
    if (app.count("--retry") > 0) {
        job.retries = whole_number("--retry", options.retry, 0, kMostRetries);
    }
    if (app.count("--input") > 0 && options.input != "-") job.inputs.push_back(options.input);
    job.duplicates = chosen_duplicates(app, options.duplicates);
}

void read_meshes(const CLI::App& app, const MeshOptions& options, Job& job) {
    if (app.count("--mesh") == 0) return;
    job.meshes.clear();
    for (const std::string& name : options.meshes) {
        const plane::MeshKind kind = chosen_row("--mesh", name, plane::kMeshKinds).kind;
        if (std::find(job.meshes.begin(), job.meshes.end(), kind) != job.meshes.end()) {
            throw InvalidInput("--mesh " + name + " is given twice; remove one");
        }
        job.meshes.push_back(kind);
    }
}

void read_choices(const CLI::App& app, const MeshOptions& options, Job& job) {
    if (app.count("--start") > 0) {
        job.start = chosen_row("--start", options.start, start_rows()).start;
    }
    if (app.count("--solver") > 0) {
        job.run.solver = chosen_row("--solver", options.solver, kSolvers).solver;
    }
    if (app.count("--outline") > 0) {
        job.tile.outline = chosen_row("--outline", options.outline, kOutlines).outline;
    }
}

void read_grains(const CLI::App& app, const MeshOptions& options, Job& job) {
    const auto require_mesh = [&](const char* name, bool plane::MeshKindRow::*property) {
        if (app.count(name) == 0 || has_mesh(job, property)) return;
        throw InvalidInput(std::string(name) + " is for grains; add --mesh grains or leave it out");
    };
    require_mesh("--size", &plane::MeshKindRow::grain_size);
    require_mesh("--per-edge", &plane::MeshKindRow::grain_size);
    require_mesh("--order", &plane::MeshKindRow::order_2);
    if (app.count("--size") > 0) job.tile.grain_size = positive_number("--size", options.size);
    if (app.count("--per-edge") > 0) {
        job.tile.grain_per_edge = whole_number("--per-edge", options.per_edge, 1, kMostPerEdge);
        if (job.tile.grain_size > 0) {
            throw InvalidInput("--per-edge replaces --size; leave one of them out");
        }
    }
    if (app.count("--order") > 0) job.tile.order = whole_number("--order", options.order, 1, 2);
}

void read_numbers(const CLI::App& app, const MeshOptions& options, Job& job) {
    if (app.count("--tolerance") > 0) {
        job.run.tolerance = positive_number("--tolerance", options.tolerance);
    }
    if (app.count("--max-iterations") > 0) {
        job.run.max_iterations =
            whole_number("--max-iterations", options.max_iterations, 0, kMostIterations);
    }
    if (app.count("--budget") > 0) {
        if (job.start != Start::kBest) {
            throw InvalidInput("--budget is for --start best; leave it out");
        }
        job.budget = whole_number("--budget", options.budget, 1, kLargestBudget);
    }
    job.run.n_threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    if (app.count("--threads") > 0) {
        job.run.n_threads = whole_number("--threads", options.threads, 1, kMostThreads);
    }
    if (app.count("--origin") > 0) {
        job.tile.finds_origin = options.origin == "auto";
        if (!job.tile.finds_origin) job.tile.origin = point("--origin", options.origin);
        if (job.tile.finds_origin && job.tile.outline != plane::Outline::kBox) {
            throw InvalidInput("--origin auto is for --outline box; add it, or give X,Y");
        }
    }
    if (app.count("--short-edges") > 0) {
        job.tile.short_edges = positive_number("--short-edges", options.short_edges);
        if (job.tile.short_edges > kLongestShortEdge) {
            throw InvalidInput("--short-edges " + options.short_edges +
                               ": such edges are not short; take at most 0.5");
        }
        if (!has_mesh(job, &plane::MeshKindRow::short_edges)) {
            throw InvalidInput(
                "--short-edges is for cells and grains; take --mesh voronoi or leave it out");
        }
    }
    if (app.count("--repeat") > 0) {
        const Repetition times = repetition("--repeat", options.repeat);
        job.tile.columns = times.columns;
        job.tile.rows = times.rows;
    }
}

}  // namespace

void add_mesh_options(CLI::App& app, MeshOptions& options) {
    add_site_options(app, options);
    add_solver_options(app, options);
    add_material_options(app, options.materials);
    add_output_options(app, options);
    app.footer(kMeshExamples);
}

std::string report_file(const std::string& path) {
    if (path.empty() || path.ends_with(".json")) return path;
    throw InvalidInput("--report " + path + ": not a .json file; name it FILE.json");
}

Job make_job(const CLI::App& app, const MeshOptions& options) {
    Job job;
    if (app.count("--symmetry") > 0) {
        job.symmetry = chosen_row("--symmetry", options.symmetry, plane::kPlaneGroups).name;
    }
    job.lattice = chosen_lattice(app, options, job.symmetry);
    read_cell_options(app, options.cells, job);
    read_site_source(app, options, job);
    read_choices(app, options, job);
    read_meshes(app, options, job);
    read_grains(app, options, job);
    read_numbers(app, options, job);
    job.materials = material_choices(app, options.materials, job.inputs);
    job.file_options = file_options(app, options.files);
    job.file_options.elastic = elastic_choices(options.materials);
    job.command = command_words(app);
    job.outputs = options.outputs;
    if (app.count("--cells") > 0) {
        if (lower_case_extension(options.table) != ".csv") {
            throw InvalidInput("--cells " + options.table + ": not a .csv file; name it FILE.csv");
        }
        job.outputs.push_back(options.table);
    }
    job.report = report_file(options.report);
    job.stability = options.stability;
    job.force = options.force;
    return job;
}

}  // namespace pcvt::cli
