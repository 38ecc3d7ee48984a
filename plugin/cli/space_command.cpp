#include "plugin/cli/space_command.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <thread>

#include "io/run_files/site_reader.hpp"
#include "plugin/cli/mesh_command.hpp"
#include "plugin/cli/options/option_values.hpp"
#include "plugin/cli/options/site_source.hpp"
#include "plugin/cli/summary.hpp"
#include "plugin/cli/terminal/cancel_signal.hpp"
#include "plugin/cli/terminal/console.hpp"
#include "plugin/cli/terminal/progress_display.hpp"
#include "plugin/job/available_memory.hpp"
#include "plugin/job/features.hpp"
#include "plugin/job/job_memory.hpp"
#include "plugin/job/job_start.hpp"
#include "plugin/job/space_memory.hpp"

namespace pcvt::cli {
namespace {

template <class Table>
const auto& space_row(const char* option, const std::string& word, const Table& table) {
    if (const auto* row = find_word(table, word); row != nullptr && row->in_space) return *row;
    throw InvalidInput(std::string(option) + " " + word + ": not for three dimensions; take " +
                       listed_words(rows_in_space(table), ", ", " or "));
}

std::ptrdiff_t count_commas(const std::string& text) {
    return std::count(text.begin(), text.end(), ',');
}

void refuse_foreign_options(const CLI::App& app) {
    for (const CLI::Option* option : app.get_options()) {
        const std::string name = option->get_name();
        const FeatureRow* const feature = find_option(name);
        if (option->count() == 0 || feature == nullptr || feature->in_space) continue;
        throw InvalidInput(name +
                           " is not for three dimensions; leave it out, or give two period "
                           "vectors");
    }
}

space::Lattice chosen_lattice(const CLI::App& app, const MeshOptions& options) {
    require_one_lattice(app);
    return app.count("--period") > 0 ? box_lattice("--period", options.period)
                                     : space_lattice("--lattice", options.lattice);
}

void read_sites_options(const CLI::App& app, const MeshOptions& options, Job& job) {
    require_one_site_source(app, options.input);
    refuse_beside_input(app, {"--seed", "--start"});
    if (app.count("--sites") > 0) {
        job.n_sites = whole_number("--sites", options.sites, 1, space::kMostSites);
    }
    if (app.count("--seed") > 0) job.seed = seed_number("--seed", options.seed);
    if (app.count("--start") > 0)
        job.start = space_row("--start", options.start, start_rows()).start;
    if (app.count("--input") > 0 && options.input != "-") job.inputs.push_back(options.input);
    job.duplicates = chosen_duplicates(app, options.duplicates);
}

void read_solver_options(const CLI::App& app, const MeshOptions& options, Job& job) {
    if (app.count("--solver") > 0) {
        job.run.solver = space_row("--solver", options.solver, kSolvers).solver;
    }
    if (app.count("--tolerance") > 0) {
        job.run.tolerance = positive_number("--tolerance", options.tolerance);
    }
    if (app.count("--max-iterations") > 0) {
        job.run.max_iterations =
            whole_number("--max-iterations", options.max_iterations, 0, kMostIterations);
    }
    job.run.n_threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    if (app.count("--threads") > 0) {
        job.run.n_threads = whole_number("--threads", options.threads, 1, kMostThreads);
    }
}

/// From this number of sites on, the estimate of the memory is printed when the run begins.
constexpr int kFewestAnnouncedInSpace = 200'000;

/// Runs the job under the signals and the progress display.
SpaceSummary run_watched(const Job& job, bool quiet) {
    const std::optional<double> available = available_memory();
    const int n = job.n_wanted();
    ProgressDisplay display(space::body_centred_energy(job.in_space().lattice.volume(), n),
                            job.run.tolerance, !quiet);
    catch_cancel_signals();
    // The first progress follows the checks of the job, so that a refusal is one line.
    bool announces = n >= kFewestAnnouncedInSpace && !quiet;
    return run_space_job(job, [&](const JobProgress& progress) {
        if (std::exchange(announces, false)) {
            announce_memory(estimated_memory(job, plan_files(job)), available);
        }
        display.show(progress);
        return cancel_signal() == 0;
    });
}

void read_short_edges(const CLI::App& app, const MeshOptions& options, Job& job) {
    if (app.count("--short-edges") == 0) return;
    job.tile.short_edges = positive_number("--short-edges", options.short_edges);
    if (job.tile.short_edges <= space::kLongestShortEdge) return;
    throw InvalidInput("--short-edges " + options.short_edges +
                       ": such edges are not short in space; take at most 0.1");
}

/// Requires that no file holds another mesh than the one that --mesh names.
void read_mesh(const CLI::App& app, const MeshOptions& options, Job& job) {
    if (app.count("--mesh") == 0) return;
    if (options.meshes.size() > 1) {
        throw InvalidInput("--mesh: one mesh a run in three dimensions; remove one");
    }
    job.space_files.mesh = space_row("--mesh", options.meshes.front(), kSpaceMeshes).mesh;
    if (job.space_files.mesh == SpaceMesh::kDelaunay) return;
    for (const JobFile& file : plan_files(job)) {
        if (!file.format->space->shows_tetrahedra(job.space_files)) continue;
        throw InvalidInput("-o " + file.path() + ": the format holds the tetrahedra of --mesh " +
                           "delaunay; leave --mesh out");
    }
}

void read_file_options(const CLI::App& app, const MeshOptions& options, Job& job) {
    if (app.count("--surface") == 0) return;
    job.space_files.surfaces = chosen_row("--surface", options.files.surface, kSurfaceForms).form;
    const auto has_surfaces = [](const std::string& path) {
        const Format* const format = find_format(path);
        return format != nullptr && format->space &&
               format->space->surfaces == FormatSurfaces::kChosen;
    };
    if (std::any_of(job.outputs.begin(), job.outputs.end(), has_surfaces)) return;
    throw InvalidInput("--surface is for " + surface_extensions() + "; add such a file with -o");
}

std::string vector_text(const space::Vec3& v) {
    // Adding 0 turns -0 into 0.
    return "(" + figure(v.x() + 0.0) + ", " + figure(v.y() + 0.0) + ", " + figure(v.z() + 0.0) +
           ")";
}

/// The best exact lattice, its energy and its stability.
std::string pattern_lines(const PatternOutcome<space::LatticePattern>& pattern, double bound) {
    const space::LatticePattern& lattice = pattern.lattice;
    std::string basis;
    for (int k = 0; k < 3; ++k) {
        basis += (k == 0 ? "" : " ") + vector_text(lattice.basis.col(k));
    }
    return summary_line("pattern", basis + ", energy " + figure(lattice.energy) + ", " +
                                       figure(lattice.energy / bound) + " of truncated octahedra") +
           stability_line(pattern.stability);
}

std::string face_text(const SpaceSummary& summary) {
    double sum = 0;
    std::string counts;
    for (const auto& [faces, count] : summary.face_counts) {
        sum += double(faces) * count;
        counts += " " + std::to_string(faces) + ":" + std::to_string(count);
    }
    return figure(sum / summary.n_sites) + " a cell; cells with" + counts;
}

std::string seam_text(const space::PolyhedralProof& proof) {
    return std::to_string(2 * proof.n_boundary_pairs) + " boundary faces in " +
           std::to_string(proof.n_boundary_pairs) + " pairs by " +
           counted(proof.n_translations, "translation") +
           (proof.boundary_is_manifold ? "" : "; the boundary touches itself");
}

Eigen::ArrayXXd lattice_coordinates(const space::Lattice& lattice, const space::Points& points) {
    Eigen::ArrayXXd coordinates(3, points.cols());
    for (Eigen::Index s = 0; s < points.cols(); ++s) {
        coordinates.col(s) = lattice.to_lattice(points.col(s));
    }
    return coordinates;
}

}  // namespace

bool means_space(const MeshOptions& options) {
    return count_commas(options.lattice) == 8 || count_commas(options.period) == 2;
}

Job make_space_job(const CLI::App& app, const MeshOptions& options) {
    refuse_foreign_options(app);
    Job job;
    job.domain = SpaceDomain{chosen_lattice(app, options)};
    read_sites_options(app, options, job);
    read_solver_options(app, options, job);
    job.outputs = options.outputs;
    job.force = options.force;
    job.report = report_file(options.report);
    job.stability = options.stability;
    read_short_edges(app, options, job);
    read_mesh(app, options, job);
    plan_files(job);
    read_file_options(app, options, job);
    return job;
}

std::string space_summary_text(const Job& job, const SpaceSummary& summary) {
    const Eigen::ArrayXXd given =
        lattice_coordinates(job.in_space().lattice, job.in_space().points);
    const Eigen::ArrayXXd reduced =
        lattice_coordinates(reduce(job.in_space().lattice).reduced, job.in_space().points);
    std::string text =
        summary_line("sites", std::to_string(summary.n_sites) +
                                  domain_note(job.in_space().points.array(), given, reduced));
    if (job.duplicates == Duplicates::kDrop)
        text += duplicates_line(job.dropped, job.in_space().points.cols());
    text += summary_line("lattice", vector_text(job.in_space().lattice.a()) + " " +
                                        vector_text(job.in_space().lattice.b()) + " " +
                                        vector_text(job.in_space().lattice.c()));
    if (summary.pattern) text += pattern_lines(*summary.pattern, summary.energy_bound);
    text += summary_line("stop", std::string(stop_name(summary.run.stop)) + " after " +
                                     counted(summary.run.iterations, "iteration") + ", " +
                                     counted(summary.run.evaluations, "evaluation"));
    text += summary_line("energy", figure(summary.run.energy) + ", " +
                                       figure(summary.run.energy / summary.energy_bound) +
                                       " of truncated octahedra");
    text += summary_line("residual", figure(summary.run.residual));
    if (job.stability) text += minimum_line(summary.minimum);
    text += summary_line("faces", face_text(summary));
    if (job.tile.short_edges > 0) {
        text += summary_line("edges", std::to_string(summary.n_removed_edges) + " under " +
                                          figure(job.tile.short_edges) + " h removed");
    }
    text += summary_line("seam", seam_text(summary.proof));
    for (const std::string& words : summary.recovered) text += summary_line("recovered", words);
    for (const std::string& file : summary.files) text += summary_line("file", file);
    if (!job.report.empty()) text += summary_line("report", job.report);
    text += summary_line("seconds", figure(summary.seconds));
    if (const std::optional<double> peak = peak_memory()) {
        const double estimate = estimated_memory(job, plan_files(job));
        text += summary_line(
            "memory", memory_text(*peak) + " at the peak, " + memory_text(estimate) + " estimated");
    }
    return text;
}

ExitCode run_space_mesh(Job job, const MeshOptions& options) {
    SpaceSummary summary;
    if (options.input.empty()) {
        summary = run_watched(job, options.quiet);
    } else {
        const SpaceSiteFile file = read_sites<3>(options.input);
        job.in_space().points = file.points;
        job.lines = file.lines;
        try {
            settle_duplicates(job);
            summary = run_watched(job, options.quiet);
        } catch (const DuplicateSites& duplicate) {
            if (!job.dropped.sites.empty()) throw;
            throw duplicate_lines(file, duplicate);
        }
    }
    if (summary.run.stop == Stop::kCancelled) return report_cancelled();
    if (!options.quiet) {
        const auto text = [&] { return space_summary_text(job, summary); };
        if (summary.files.empty() && job.report.empty()) {
            print(text());
        } else {
            print_after_files(text);
        }
    }
    if (!summary.refused.empty()) {
        return report_refused(summary.refused, summary.files.size() + (job.report.empty() ? 0 : 1));
    }
    if (options.strict && summary.run.stop != Stop::kConverged) {
        return report_not_converged(summary.run, job.run.tolerance);
    }
    return ExitCode::kDone;
}

}  // namespace pcvt::cli
