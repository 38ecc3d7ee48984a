#include "plugin/cli/mesh_job.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <optional>
#include <thread>
#include <vector>

#include "io/formats/extension.hpp"
#include "io/run_files/table_name.hpp"
#include "plugin/cli/options/command_words.hpp"
#include "plugin/cli/options/option_values.hpp"
#include "plugin/cli/options/site_source.hpp"
#include "plugin/job/features.hpp"
#include "plugin/job/job_checks.hpp"
#include "plugin/job/job_files.hpp"
#include "plugin/job/job_start.hpp"

namespace pcvt::cli {
namespace {

constexpr int kLargestBudget = 2'000'000'000;
constexpr int kMostRetries = 1'000'000;

std::ptrdiff_t count_commas(const std::string& text) {
    return std::count(text.begin(), text.end(), ',');
}

std::string counted_as_given(std::ptrdiff_t n) {
    return std::to_string(n) + (n == 1 ? " was given" : " were given");
}

/// Whether the periods are those of space.
bool means_space(const MeshOptions& options) {
    const std::ptrdiff_t n_sides = count_commas(options.period) + 1;
    const std::ptrdiff_t n_coordinates = count_commas(options.lattice) + 1;
    if (!options.period.empty() && options.period != "auto" && n_sides != 2 && n_sides != 3) {
        throw InvalidInput("--period " + options.period +
                           ": takes two numbers W,H, or three in space W,H,D; " +
                           counted_as_given(n_sides));
    }
    if (!options.lattice.empty() && n_coordinates != 4 && n_coordinates != 9) {
        throw InvalidInput("--lattice " + options.lattice +
                           ": takes the four numbers of two period vectors, or the nine of three "
                           "in space; " +
                           counted_as_given(n_coordinates));
    }
    return n_sides == 3 || n_coordinates == 9;
}

/// Refuses the options that jobs of the other dimension have, all at once.
/// @param of_dimension  FeatureRow::in_plane or in_space.
/// @param why, remedy   of the message: "for three dimensions", "give W,H,D".
void refuse_foreign_options(const CLI::App& app, bool FeatureRow::*of_dimension,
                            const std::string& why, const std::string& remedy) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        const FeatureRow* const feature = find_option(option->get_name());
        if (option->count() == 0 || feature == nullptr || feature->*of_dimension) continue;
        names.push_back(option->get_name());
    }
    if (names.empty()) return;
    std::string text = names.front();
    for (std::size_t k = 1; k < names.size(); ++k) {
        text += (k + 1 < names.size() ? ", " : " and ") + names[k];
    }
    const bool is_one = names.size() == 1;
    throw InvalidInput(text + (is_one ? " is " : " are ") + why + "; leave " +
                       (is_one ? "it" : "them") + " out, or " + remedy);
}

/// The row of a table of choices that a word names, of those that the dimension of the job has.
template <class Table>
const auto& row_for(const Job& job, const char* option, const std::string& word,
                    const Table& table) {
    if (!job.is_in_space()) return chosen_row(option, word, table);
    if (const auto* row = find_word(table, word); row != nullptr && row->in_space) return *row;
    throw InvalidInput(std::string(option) + " " + word + ": not for three dimensions; take " +
                       listed_words(rows_in_space(table), ", ", " or "));
}

space::Lattice chosen_space_lattice(const CLI::App& app, const MeshOptions& options) {
    require_one_lattice(app);
    return app.count("--period") > 0 ? box_lattice("--period", options.period)
                                     : space_lattice("--lattice", options.lattice);
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
    require_one_site_source(app, point_table(options));
    if (app.count("--sites") > 0) {
        job.n_sites = whole_number("--sites", options.sites, 1,
                                   job.is_in_space() ? space::kMostSites : plane::kMostSites);
    }
    const bool draws_areas = job.sizes && job.sizes->is_drawn();
    if (!draws_areas) refuse_beside_input(app, {"--seed"});
    refuse_beside_input(app, {"--retry", "--start", "--symmetry"});
    if (app.count("--seed") > 0) job.seed = seed_number("--seed", options.seed);
    if (app.count("--retry") > 0) {
        job.retries = whole_number("--retry", options.retry, 0, kMostRetries);
    }
    const std::string input = parse_table_name(point_table(options)).path;
    if (app.count("--centroids") > 0) {
        job.centroids = input == "-" ? "standard input" : point_table(options);
    }
    if (app.count("--sites") == 0 && input != "-") job.inputs.push_back(input);
    job.duplicates = chosen_duplicates(app, options.duplicates);
}

void read_meshes(const CLI::App& app, const MeshOptions& options, Job& job) {
    if (app.count("--mesh") == 0) return;
    if (job.is_in_space() && options.meshes.size() > 1) {
        throw InvalidInput("--mesh: one mesh a run in three dimensions; remove one");
    }
    job.meshes.clear();
    for (const std::string& name : options.meshes) {
        const plane::MeshKind kind = row_for(job, "--mesh", name, plane::kMeshKinds).kind;
        if (std::find(job.meshes.begin(), job.meshes.end(), kind) != job.meshes.end()) {
            throw InvalidInput("--mesh " + name + " is given twice; remove one");
        }
        job.meshes.push_back(kind);
    }
}

void read_choices(const CLI::App& app, const MeshOptions& options, Job& job) {
    if (app.count("--start") > 0) {
        job.start = row_for(job, "--start", options.start, start_rows()).start;
    }
    if (app.count("--solver") > 0) {
        job.run.solver = row_for(job, "--solver", options.solver, kSolvers).solver;
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
    if (app.count("--size") > 0 && app.count("--per-edge") > 0) {
        throw InvalidInput("--per-edge replaces --size; leave one of them out");
    }
    if (app.count("--order") == 0) return;
    if (options.order != "1" && options.order != "2") {
        throw InvalidInput("--order " + options.order + ": unknown; take 1 or 2");
    }
    job.tile.order = options.order == "2" ? 2 : 1;
}

void read_run(const CLI::App& app, const MeshOptions& options, Job& job) {
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
        if (job.is_in_space() && !job.tile.finds_origin) {
            job.in_space().origin = space_point("--origin", options.origin);
        } else if (!job.tile.finds_origin) {
            job.in_plane().origin = point("--origin", options.origin);
        }
        if (job.tile.finds_origin && job.tile.outline != plane::Outline::kBox) {
            throw InvalidInput(std::string("--origin auto is for --outline box; add it, or give ") +
                               (job.is_in_space() ? "X,Y,Z" : "X,Y"));
        }
    }
    if (app.count("--repeat") > 0) {
        job.tile.repeat = repetition("--repeat", options.repeat, job.is_in_space() ? 3 : 2);
    }
}

void check_short_edges(const CLI::App& app, const MeshOptions& options, const Job& job) {
    if (app.count("--short-edges") == 0) return;
    if (job.tile.short_edges > longest_short_edge(job)) {
        throw InvalidInput(
            "--short-edges " + options.numbers.at("--short-edges") + ": such edges are not short" +
            (job.is_in_space() ? " in space; take at most 0.1" : "; take at most 0.5"));
    }
    if (job.is_in_space() || has_mesh(job, &plane::MeshKindRow::short_edges)) return;
    throw InvalidInput(
        "--short-edges is for cells and grains; take --mesh voronoi or leave it out");
}

void read_outputs(const CLI::App& app, const MeshOptions& options, Job& job) {
    if (app.count("--cells") > 0) {
        if (lower_case_extension(options.table) != ".csv") {
            throw InvalidInput("--cells " + options.table + ": not a .csv file; name it FILE.csv");
        }
        job.outputs.push_back(options.table);
    }
    if (!job.report.empty() && !job.report.ends_with(".json")) {
        throw InvalidInput("--report " + job.report + ": not a .json file; name it FILE.json");
    }
}

/// Requires that no file in space holds another mesh than the one that --mesh names, and that one
/// has the surfaces that --surface chooses.
void check_space_files(const CLI::App& app, const Job& job) {
    bool has_surfaces = false;
    for (const JobFile& file : plan_files(job)) {
        const SpaceFormat& format = *file.format->space;
        has_surfaces = has_surfaces || format.surfaces == FormatSurfaces::kChosen;
        const bool names_cells =
            app.count("--mesh") > 0 && job.meshes.front() == plane::MeshKind::kVoronoi;
        if (!names_cells || !format.shows_tetrahedra(job.meshes.front())) continue;
        throw InvalidInput("-o " + file.path() +
                           ": the format holds the tetrahedra of --mesh delaunay; leave --mesh "
                           "out");
    }
    if (app.count("--surface") == 0 || has_surfaces) return;
    throw InvalidInput("--surface is for " + surface_extensions() + "; add such a file with -o");
}

}  // namespace

Job make_job(const CLI::App& app, const MeshOptions& options) {
    Job job = options.job;
    if (means_space(options)) {
        refuse_foreign_options(app, &FeatureRow::in_space, "not for three dimensions",
                               "give two period vectors");
        job.domain = SpaceDomain{chosen_space_lattice(app, options)};
    } else {
        refuse_foreign_options(app, &FeatureRow::in_plane, "for three dimensions", "give W,H,D");
        if (app.count("--symmetry") > 0) {
            job.symmetry = chosen_row("--symmetry", options.symmetry, plane::kPlaneGroups).name;
        }
        job.in_plane().lattice = chosen_lattice(app, options, job.symmetry);
    }
    read_cell_options(app, options.cells, job);
    read_site_source(app, options, job);
    read_choices(app, options, job);
    read_meshes(app, options, job);
    read_grains(app, options, job);
    read_run(app, options, job);
    job.materials = material_choices(app, options.materials, job.inputs);
    job.file_options = file_options(app, options.files);
    // C3D15 has nodes in the middle of edges.
    if (app.count("--order") == 0)
        job.tile.order = std::max(1, plane_element_row(job.file_options.element).wedge_order);
    if (app.count("--colour") > 0) row_for(job, "--colour", options.files.colour, kColourings);
    job.file_options.elastic = elastic_choices(options.materials, job.inputs);
    read_numbers(app, options.numbers, job);
    check_short_edges(app, options, job);
    job.command = command_words(app);
    read_outputs(app, options, job);
    if (job.is_in_space()) check_space_files(app, job);
    return job;
}

}  // namespace pcvt::cli
