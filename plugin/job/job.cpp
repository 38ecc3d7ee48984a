#include "plugin/job/job.hpp"

#include <chrono>
#include <cmath>
#include <utility>

#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/mesh/valence.hpp"
#include "mesher/plane/symmetry/folded_density.hpp"
#include "mesher/plane/tessellation/tags.hpp"
#include "plugin/job/job_checks.hpp"
#include "plugin/job/job_files.hpp"
#include "plugin/job/job_memory.hpp"
#include "plugin/job/job_report.hpp"
#include "plugin/job/job_staging.hpp"
#include "plugin/job/job_start.hpp"
#include "plugin/job/job_tessellation.hpp"
#include "plugin/job/job_tiles.hpp"

namespace pcvt {
namespace {

/// Adds up the seconds of each stage.
class Stopwatch {
   public:
    explicit Stopwatch(const JobSeconds& before = {}) : seconds_(before) {}

    /// Adds the time since the last stop to `stage`.
    void stop(double JobSeconds::*stage) {
        const Clock::time_point now = Clock::now();
        const double lap = std::chrono::duration<double>(now - last_).count();
        seconds_.*stage += lap;
        seconds_.total += lap;
        last_ = now;
    }
    const JobSeconds& seconds() const { return seconds_; }

   private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point last_ = Clock::now();
    JobSeconds seconds_;
};

JobMonitor::Target target_of(const Job& job) {
    return {.tolerance = job.run.tolerance,
            .max_iterations = job.run.max_iterations,
            .has_areas = job.areas.has_value(),
            .note = job.retries > 0 ? ", seed " + std::to_string(job.seed) : ""};
}

/// The factor by which target_areas() multiplies given areas.
std::optional<double> area_scale(const Job& job) {
    const Eigen::VectorXd& given = job.areas->given;
    if (given.size() == 0) return std::nullopt;
    const double scale = job.in_plane().lattice.area() / given.sum();
    return std::isfinite(scale) && scale > 0 ? std::optional(scale) : std::nullopt;
}

RunSummary summarize(const Job& job, const Computation& computation,
                     std::span<const plane::BuiltTile> tiles) {
    const plane::Tessellation& cells = computation.cells;
    RunSummary summary;
    summary.run = cells.run;
    summary.n_sites = cells.n_sites();
    summary.seed = job.seed;
    if (!cells.density) {
        summary.energy_bound = energy_bound(cells);
    }
    if (job.stability) summary.minimum = minimum_of(cells);
    summary.n_mirrors = cells.counts.n_mirrors;
    summary.valences = plane::histogram(cell_sides(cells));
    const auto hexagons = summary.valences.find(6);
    summary.n_hexagons = hexagons == summary.valences.end() ? 0 : hexagons->second;
    summary.density = cells.density;
    if (cells.areas) {
        summary.areas = area_summary(cells);
        summary.areas->scale = area_scale(job);
    }
    summary.n_orbits = cells.n_orbits();
    if (cells.walled) summary.n_on_walls = cells.walled->n_on_walls;
    summary.interfaces = cells.interfaces;
    summary.phases = computation.phases;
    const std::vector<BungeAngles>& orientations = computation.materials.site_orientation;
    if (!orientations.empty()) summary.angles = angle_range(orientations);
    for (const plane::BuiltTile& tile : tiles) summary.tiles.push_back(tile.figures);
    summary.start = computation.start;
    return summary;
}

/// Stages every file that its format can hold, and the report.
void stage(const Job& job, const std::vector<JobFile>& files, const Computation& result,
           std::span<const plane::BuiltTile> tiles, JobMonitor& monitor, Stopwatch& watch,
           RunSummary& summary, OutputSet& outputs) {
    const std::vector<std::string> refused =
        stage_files(job, files, result, tiles, monitor, outputs);
    for (std::size_t k = 0; k < files.size(); ++k) {
        const JobFile& file = files[k];
        if (!refused[k].empty()) {
            summary.refused.push_back({file.paths.front(), refused[k]});
        } else if (file.folder.empty()) {
            summary.files.insert(summary.files.end(), file.paths.begin(), file.paths.end());
        } else {
            summary.files.push_back(file.folder);
        }
    }
    watch.stop(&JobSeconds::write);
    if (job.report.empty()) return;
    summary.seconds = watch.seconds();
    outputs.stage(job.report, encode_job_report(job, summary));
}

/// Evaluated before any file is written, because a host's density ends with its call.
std::vector<double> site_densities(const Job& job, const plane::Tessellation& cells) {
    if (!job.density) return {};
    if (job.symmetry) {
        const plane::Density folded =
            folded_density(*job.density, plane::PlaneGroup(*job.symmetry, job.in_plane().lattice));
        return densities_at(folded, job.in_plane().lattice, wrapped_sites(cells, job.tile.origin));
    }
    return densities_at(*job.density, job.in_plane().lattice,
                        wrapped_sites(cells, job.tile.origin));
}

void add_materials(const Job& job, Computation& computation) {
    if (job.has_inclusions()) {
        computation.materials = tag_materials(computation.cells);
        computation.phases = tag_figures(computation.cells);
        return;
    }
    const CellTable& cells = computation.cells.table();
    computation.materials = choose_materials(job.materials, cells, job.seed);
    computation.phases = phase_figures(job.materials, computation.materials, cells);
}

Computation compute(const Job& job, JobMonitor& monitor, Stopwatch& watch) {
    const plane::Metric metric = metric_of(job);
    const std::optional<Job> round =
        metric.is_round() ? std::nullopt : std::optional(in_round_space(job, metric));
    // Start, optimise, and map back.
    JobStart start = job_start(round ? *round : job, [&monitor](const Progress& progress) {
        return monitor.start_iteration(progress);
    });
    if (start.cancelled) throw Cancelled{};
    watch.stop(&JobSeconds::optimize);
    plane::Tessellation cells = tessellate(round ? *round : job, start, monitor,
                                           [&watch] { watch.stop(&JobSeconds::build); });
    watch.stop(&JobSeconds::optimize);
    if (cells.run.stop == Stop::kCancelled) throw Cancelled{};
    cells.run.evaluations += start.evaluations;
    if (round) {
        cells.elongation = plane::Elongation{metric, job.in_plane().lattice};
        if (start.figures.pattern) map_back(metric, start.figures.pattern->lattice);
    }
    std::vector<double> densities = site_densities(job, cells);
    Computation computation{.cells = std::move(cells),
                            .start = std::move(start.figures),
                            .site_densities = std::move(densities)};
    if (!job.materials.empty() || job.has_inclusions()) add_materials(job, computation);
    watch.stop(&JobSeconds::build);
    computation.seconds = watch.seconds();
    return computation;
}

/// Makes the tiles and the files of a computed job. The commit of the files cannot be cancelled.
RunSummary finish(const Job& job, const std::vector<JobFile>& files, const Computation& result,
                  const TileSource& make_tiles, JobMonitor& monitor, Stopwatch& watch) {
    OutputSet outputs;
    RunSummary summary;
    monitor.watch([&] {
        const std::span<const plane::BuiltTile> tiles = make_tiles(monitor);
        summary = summarize(job, result, tiles);
        summary.constants = stated_constants(files, job.file_options, result.materials);
        watch.stop(&JobSeconds::build);
        stage(job, files, result, tiles, monitor, watch, summary, outputs);
        summary.recovered = wait_for_turn(outputs, monitor);
    });
    const ClientScope no_client(nullptr);
    outputs.commit(job.force);
    watch.stop(&JobSeconds::write);
    summary.seconds = watch.seconds();
    return summary;
}

RunSummary run(const Job& job, const std::vector<JobFile>& files, const JobCallback& callback,
               Stopwatch& watch) {
    JobMonitor monitor(callback, target_of(job));
    const Computation result = compute(job, monitor, watch);
    std::vector<plane::BuiltTile> tiles;
    const TileSource make_tiles = [&](JobMonitor&) {
        if (needs_tiles(job, files)) tiles = proved_tiles(job, result.cells, monitor);
        return std::span<const plane::BuiltTile>(tiles);
    };
    return finish(job, files, result, make_tiles, monitor, watch);
}

/// The advice behind the message of an output that refuses the cells.
/// @param dashes  precede the names of options.
std::string remedy(const Job& job, const std::string& dashes) {
    if (job.start == Start::kLattice) return "; take another number of sites, or other periods";
    if (job.run.max_iterations == 0) {
        return "; optimise the sites: leave " + dashes + "max-iterations 0 out";
    }
    const std::string tolerance = "a smaller " + dashes + "tolerance";
    if (job.n_given() > 0) return "; try " + tolerance + ", or other sites";
    return "; try another " + dashes + "seed or " + tolerance;
}

/// The advice of the command, which can retry.
std::string remedy_with_retries(const Job& job) {
    const bool retries_help =
        job.n_given() == 0 && job.run.max_iterations != 0 && job.start != Start::kLattice;
    if (!retries_help) return remedy(job, "--");
    if (job.retries == 0) return remedy(job, "--") + ", or add --retry 20";
    return "; " + std::to_string(job.retries + 1) + " seeds from " + std::to_string(job.seed) +
           " on were tried: try a smaller --tolerance, or other --sites";
}

}  // namespace

const char* stop_name(Stop stop) {
    switch (stop) {
        case Stop::kConverged:
            return "converged";
        case Stop::kIterationLimit:
            return "iteration-limit";
        case Stop::kStalled:
            return "stalled";
        case Stop::kCancelled:
            return "cancelled";
    }
    return "";
}

std::optional<Computation> compute_job(const Job& job, const JobCallback& callback) {
    check_job(job);
    require_memory(job, {});
    Stopwatch watch;
    JobMonitor monitor(callback, target_of(job));
    try {
        return compute(job, monitor, watch);
    } catch (const Cancelled&) {
        return std::nullopt;
    }
}

RunSummary write_job(const Job& job, const Computation& result, const TileSource& tiles,
                     const JobCallback& callback) {
    const std::vector<JobFile> files = plan_files(job);
    check_order(job, files);
    check_file_options(job, files, result.materials.phase_names);
    require_all_writable(job, files);
    require_memory_to_write(job, files);
    Stopwatch watch(result.seconds);
    JobMonitor monitor(callback, target_of(job));
    try {
        return finish(job, files, result, tiles, monitor, watch);
    } catch (const Cancelled&) {
        return {};
    } catch (const UnsuitableCells& error) {
        throw UnsuitableCells(error.what() + remedy(job, ""));
    }
}

RunSummary run_job(const Job& job, const JobCallback& callback) {
    check_job(job);
    const std::vector<JobFile> files = plan_files(job);
    check_order(job, files);
    check_file_options(job, files, file_phases(job));
    const std::vector<std::string> recovered = require_all_writable(job, files);
    check_retries(job, files);
    require_memory(job, files);
    Stopwatch watch;
    Job next = job;
    for (int k = 0;; ++k, ++next.seed) {
        try {
            RunSummary summary = run(next, files, callback, watch);
            summary.recovered.insert(summary.recovered.begin(), recovered.begin(), recovered.end());
            return summary;
        } catch (const Cancelled&) {
            return {};
        } catch (const UnsuitableCells& error) {
            if (k == job.retries) throw UnsuitableCells(error.what() + remedy_with_retries(job));
        }
    }
}

}  // namespace pcvt
