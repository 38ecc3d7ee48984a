#include "plugin/cli/mesh_command.hpp"

#include <csignal>
#include <cstdio>
#include <utility>

#include "io/run_files/site_table.hpp"
#include "mesher/cells/empty_cells.hpp"
#include "mesher/plane/density/density_survey.hpp"
#include "mesher/plane/grains/grains.hpp"
#include "plugin/cli/options/material_options.hpp"
#include "plugin/cli/summary.hpp"
#include "plugin/cli/terminal/cancel_signal.hpp"
#include "plugin/cli/terminal/console.hpp"
#include "plugin/cli/terminal/progress_display.hpp"
#include "plugin/job/available_memory.hpp"
#include "plugin/job/job_files.hpp"
#include "plugin/job/job_memory.hpp"
#include "plugin/job/job_start.hpp"
#include "plugin/job/job_tessellation.hpp"
#include "plugin/job/run_job.hpp"

namespace pcvt::cli {
namespace {

/// The energy that the display divides energies by.
double expected_energy(const Job& job) {
    if (!job.density) return energy_bound(job);
    return energy_bound(job) *
           plane::DensitySurvey(job.in_plane().lattice, *job.density, plane::kSurveyResolution)
               .mean_root_squared();
}

/// From this number of sites on, the estimate of the memory is printed when the run begins.
constexpr int kFewestAnnounced = 1'000'000;
constexpr int kFewestAnnouncedInSpace = 200'000;

/// Says on standard error how much memory a run takes, and how much there is.
/// @param estimate  bytes.
void announce_memory(double estimate, const std::optional<double>& available) {
    std::fprintf(stderr, "pcvt: takes about %s of memory%s\n", memory_text(estimate).c_str(),
                 available ? ("; " + memory_text(*available) + " are available").c_str() : "");
}

/// The peak of the memory, beside its estimate.
std::string memory_line(const Job& job) {
    const std::optional<double> peak = peak_memory();
    if (!peak) return {};
    return summary_line("memory", memory_text(*peak) + " at the peak, " +
                                      memory_text(estimated_memory(job, plan_files(job))) +
                                      " estimated");
}

/// Runs the job under the signals and the progress display.
RunSummary run_watched(const Job& job, bool quiet) {
    const std::optional<double> available = available_memory();
    const int fewest_announced = job.is_in_space() ? kFewestAnnouncedInSpace : kFewestAnnounced;
    // The first progress follows the checks of the job, so that a refusal is one line.
    bool announces = job.n_wanted() >= fewest_announced && !quiet;
    ProgressDisplay display(expected_energy(job), job.run.tolerance, !quiet);
    catch_cancel_signals();
    return run_job(job, [&](const JobProgress& progress) {
        if (std::exchange(announces, false)) {
            announce_memory(estimated_memory(job, plan_files(job)), available);
        }
        display.show(progress);
        return cancel_signal() == 0;
    });
}

/// Names the sites without a cell by their lines in the file.
BadFile empty_cell_lines(const std::string& name, const std::vector<int>& line_of,
                         const EmptyCells& empty) {
    std::string lines;
    for (const SiteId s : empty.sites()) {
        lines += (lines.empty() ? "" : ", ") + std::to_string(line_of[std::size_t(s)]);
    }
    const bool is_one = empty.sites().size() == 1;
    return BadFile(name + ":" + std::to_string(line_of[std::size_t(empty.sites().front())]) + ": " +
                   (is_one ? "the cell of this site is" : "the cells of these sites are") +
                   " empty, because the weights of others reach over " + (is_one ? "it" : "them") +
                   (is_one ? "" : ": lines " + lines) + "; remove the " +
                   (is_one ? "line" : "lines") + ", or give larger weights");
}

/// The line of a site in the file, before a message; nothing for the mirror images of sites.
std::string place_of_site(const std::string& name, const std::vector<int>& line_of, SiteId site) {
    const auto s = static_cast<std::size_t>(site);
    return s < line_of.size() ? name + ":" + std::to_string(line_of[s]) + ": " : "";
}

/// Names a site whose cell is too small by its line in the file.
BadFile tiny_cell_line(const std::string& place, const Job& job, const TinyCell& tiny) {
    if (!job.weights) return BadFile(place + tiny.what());
    return BadFile(place +
                   "the cell of this site is nearly empty, smaller than 1e-9 of the spacing, "
                   "because the weights of others reach over it; remove the line, or give a larger "
                   "weight");
}

/// Names a site of given weights, whose cell has no grains, by its line in the file.
LimitExceeded thin_cell_line(const std::string& place) {
    return LimitExceeded(place +
                         "the cell of this site is too thin to be meshed by grains; change its "
                         "weight or those of its neighbours, or take --mesh voronoi");
}

/// Runs the job, of which the file has points or fixed sites. Reports coincident sites by their
/// lines in the file.
template <class File>
RunSummary run_distinct(Job& job, const File& file, bool quiet) {
    try {
        settle_duplicates(job);
        return run_watched(job, quiet);
    } catch (const DuplicateSites& duplicate) {
        // Without the sites that were dropped, the others have other numbers.
        if (!job.dropped.sites.empty()) throw;
        throw duplicate_lines(file, duplicate);
    } catch (const EmptyCells& empty) {
        throw empty_cell_lines(file.name, job.lines, empty);
    } catch (const TinyCell& tiny) {
        const std::string place = place_of_site(file.name, job.lines, tiny.site());
        if (place.empty()) throw;
        throw tiny_cell_line(place, job, tiny);
    } catch (const plane::ThinCell& thin) {
        const std::string place = place_of_site(file.name, job.lines, thin.site());
        if (!job.weights || place.empty()) throw;
        throw thin_cell_line(place);
    }
}

/// Requires that no site is too far away.
template <class Lattice, class File>
void require_near_sites(const Lattice& lattice, const File& file) {
    const Lattice reduced = reduce(lattice).reduced;
    for (std::size_t s = 0; s < file.lines.size(); ++s) {
        const auto u = reduced.to_lattice(file.points.col(static_cast<Eigen::Index>(s)));
        if (u.cwiseAbs().maxCoeff() < kFarthestPeriod) continue;
        throw BadFile(file.name + ":" + std::to_string(file.lines[s]) +
                      ": the site lies more than 2^30 periods away; wrap it into the domain");
    }
}

/// Requires that no site is dropped whose area the period holds.
void require_all_sites(Job& job) {
    if (job.duplicates != Duplicates::kDrop) return;
    settle_duplicates(job);
    const auto n = static_cast<int>(job.dropped.sites.size());
    if (n == 0) return;
    throw InvalidInput("--period auto takes the areas of all sites, but " + std::to_string(n) +
                       (n == 1 ? " of them coincides with an earlier one; remove it from the file "
                                 "of sites, and its area"
                               : " of them coincide with earlier ones; remove them from the file "
                                 "of sites, and their areas"));
}

/// The columns of the table of the sites that count: options win over them.
SiteColumns wanted_columns(const Job& job, const MeshOptions& options) {
    return {.weights = options.cells.weights.empty() && !job.sizes,
            .phases = job.materials.phases.empty() && !job.has_inclusions(),
            .orientations = !job.materials.has_orientations() && !job.has_inclusions()};
}

/// Takes the weights of a table, unless an option of the job excludes them.
void take_weights(const WeightFile& weights, const std::string& input, Job& job) {
    const char* const fault =
        job.run.max_iterations != 0
            ? ", whose cells keep them where they are; add --max-iterations 0, or take"
        : job.density || job.stability
            ? ", which do not work with --density or --stability; leave these out, or take"
            : nullptr;
    if (fault != nullptr) {
        throw BadFile(weights.name + ": the sites have weights" + fault +
                      " only the positions, --input " + input + ":" +
                      names_of_coordinates(job.is_in_space() ? 3 : 2));
    }
    job.weights = GivenWeights{weights.weights, weights.description};
}

/// Whether the outputs of the job hold its materials.
bool are_materials_held(const Job& job) {
    try {
        check_file_options(job, plan_files(job), file_phases(job));
    } catch (const InvalidInput&) {
        return false;
    }
    return true;
}

/// Takes the quantities of each site that the table of the sites has. Nobody has chosen its phases
/// and orientations, so that outputs may lack them.
template <int kDimension>
void take_columns(const SiteTable<kDimension>& table, const std::string& input, Job& job) {
    if (table.weights) take_weights(*table.weights, input, job);
    MaterialChoices chosen = job.materials;
    if (table.phases) {
        set_phases(*table.phases, job.materials);
        if (!are_materials_held(job)) job.materials = chosen;
    }
    chosen = job.materials;
    if (table.orientations.empty()) return;
    job.materials.orientations = table.orientations;
    if (!are_materials_held(job)) job.materials = chosen;
}

/// Reads the files that the job names, and runs it.
/// @param domain  that of the job.
template <class Domain>
RunSummary run_in(Domain& domain, Job& job, const MeshOptions& options) {
    constexpr int kDimension = decltype(domain.lattice)::kDimension;
    const std::string& input = point_table(options);
    if (input.empty()) {
        read_area_file(job);
        const SiteFileOf<kDimension> fixed{parse_table_name(options.cells.fixed).path, domain.fixed,
                                           job.lines, job.site_unit};
        return domain.fixed.cols() > 0 ? run_distinct(job, fixed, options.quiet)
                                       : run_watched(job, options.quiet);
    }
    const SiteTable<kDimension> table =
        read_site_table<kDimension>(parse_table_name(input), wanted_columns(job, options));
    const SiteFileOf<kDimension>& file = table.sites;
    domain.points = file.points;
    job.lines = file.lines;
    job.site_unit = file.unit;
    take_columns(table, input, job);
    read_area_file(job);
    read_weight_file(options.cells, job);
    if (options.period == "auto" && job.sizes) require_all_sites(job);
    require_near_sites(domain.lattice, file);
    return run_distinct(job, file, options.quiet);
}

void print_summary(const Job& job, const RunSummary& summary) {
    const bool has_files = !summary.files.empty() || !job.report.empty();
    const auto text = [&] { return summary_text(job, summary) + memory_line(job); };
    if (has_files) {
        print_after_files(text);
    } else {
        print(text());
    }
}

// These report the end of a run on standard error, and return the exit code of the command.

ExitCode report_cancelled() {
    std::fputs("pcvt: cancelled; nothing was written\n", stderr);
    return cancel_signal() == SIGTERM ? ExitCode::kTerminated : ExitCode::kInterrupted;
}

ExitCode report_not_converged(const RunStatistics& run, double tolerance) {
    std::fprintf(stderr,
                 "pcvt: not converged (%s, residual %.3g, tolerance %.3g); the files are written\n",
                 stop_name(run.stop), run.residual, tolerance);
    return ExitCode::kNotConverged;
}

/// Reports the outputs that a run has left out, in one line.
/// @param n_written  the number of the other files.
/// @pre `refused` is not empty.
ExitCode report_refused(const std::vector<RefusedFile>& refused, std::size_t n_written) {
    std::string line = refused.front().reason;
    for (std::size_t k = 1; k < refused.size(); ++k) {
        line += (k == 1 ? "; so for " : ", ") + refused[k].path;
    }
    if (n_written > 0) line += "; the other files are written";
    std::fprintf(stderr, "pcvt: %s\n", line.c_str());
    return ExitCode::kBadInput;
}

}  // namespace

ExitCode run_mesh(Job job, const MeshOptions& options) {
    const RunSummary summary =
        std::visit([&](auto& domain) { return run_in(domain, job, options); }, job.domain);
    if (summary.run.stop == Stop::kCancelled) return report_cancelled();
    if (!options.quiet) print_summary(job, summary);
    if (!summary.refused.empty()) {
        return report_refused(summary.refused, summary.files.size() + (job.report.empty() ? 0 : 1));
    }
    if (options.strict && summary.run.stop != Stop::kConverged) {
        return report_not_converged(summary.run, job.run.tolerance);
    }
    return ExitCode::kDone;
}

}  // namespace pcvt::cli
