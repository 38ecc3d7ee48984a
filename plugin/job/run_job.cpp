#include "plugin/job/run_job.hpp"

#include <utility>

#include "mesher/base/checkpoint.hpp"
#include "plugin/job/job_checks.hpp"
#include "plugin/job/job_files.hpp"
#include "plugin/job/job_memory.hpp"
#include "plugin/job/job_report.hpp"
#include "plugin/job/job_staging.hpp"
#include "plugin/job/job_tessellation.hpp"
#include "plugin/job/plane_world.hpp"
#include "plugin/job/space_world.hpp"
#include "plugin/job/stopwatch.hpp"

namespace pcvt {
namespace {

/// The figures that follow from the cells of every run.
template <class World>
RunSummary summarize(const Job& job, const Computation<World>& computation) {
    RunSummary summary;
    summary.run = computation.cells.run;
    if (job.stability) summary.minimum = minimum_of(computation.cells);
    summary.phases = computation.phases;
    const std::vector<BungeAngles>& orientations = computation.materials.site_orientation;
    if (!orientations.empty()) {
        summary.angles = angle_range(orientations);
        summary.misorientations = misorientations(computation.cells.table(), computation.materials);
    }
    summary.start = computation.start;
    return summary;
}

/// Stages every file that its format can hold, and the report.
void stage(const Job& job, const std::vector<JobFile>& files, const FileContent& content,
           JobMonitor& monitor, Stopwatch& watch, RunSummary& summary, OutputSet& outputs) {
    const std::vector<std::string> refused = stage_files(job, files, content, monitor, outputs);
    for (std::size_t k = 0; k < files.size(); ++k) {
        const JobFile& file = files[k];
        if (!refused[k].empty()) {
            summary.refused.push_back({file.path(), refused[k]});
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

/// Makes the tiles and the files of a computed job. The commit of the files cannot be cancelled.
template <class World>
RunSummary finish(const Job& job, const std::vector<JobFile>& files,
                  const Computation<World>& computation, const TileSource<World>& tiles,
                  JobMonitor& monitor, Stopwatch& watch) {
    OutputSet outputs;
    RunSummary summary;
    monitor.watch([&] {
        summary = summarize(job, computation);
        const FileContent content =
            World::content(job, files, computation, tiles, monitor, summary);
        watch.stop(&JobSeconds::build);
        stage(job, files, content, monitor, watch, summary, outputs);
        summary.recovered = wait_for_turn(outputs, monitor);
    });
    // Nothing may fail after the files appear.
    const ClientScope no_client(nullptr);
    outputs.commit(job.force);
    watch.stop(&JobSeconds::write);
    summary.seconds = watch.seconds();
    return summary;
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

template <class World>
RunSummary run_once(const Job& job, const std::vector<JobFile>& files, const JobCallback& callback,
                    Stopwatch& watch) {
    JobMonitor monitor(callback, job);
    const Computation<World> computation = World::compute(job, monitor, watch);
    std::optional<typename World::Tiles> tiles;
    const TileSource<World> build = [&](JobMonitor&) -> const typename World::Tiles& {
        return tiles.emplace(World::build_tiles(job, files, computation, monitor));
    };
    return finish<World>(job, files, computation, build, monitor, watch);
}

/// Repeats the run with the next seeds where outputs refuse the cells.
template <class World>
RunSummary run(const Job& job, const std::vector<JobFile>& files, const JobCallback& callback) {
    Stopwatch watch;
    Job next = job;
    for (int k = 0;; ++k, ++next.seed) {
        try {
            RunSummary summary = run_once<World>(next, files, callback, watch);
            summary.retries = k;
            return summary;
        } catch (const Cancelled&) {
            return {};
        } catch (const UnsuitableCells& error) {
            if (k == job.retries) throw UnsuitableCells(error.what() + remedy_with_retries(job));
        }
    }
}

}  // namespace

double energy_bound(const Job& job) {
    const int n = job.n_wanted();
    return job.is_in_space() ? space::body_centred_energy(job.in_space().lattice.volume(), n)
                             : plane::hexagonal_bound(job.in_plane().lattice.area(), n);
}

template <class World>
std::optional<Computation<World>> compute_job(const Job& job, const JobCallback& callback) {
    check_job(job);
    require_memory(job, {});
    Stopwatch watch;
    JobMonitor monitor(callback, job);
    try {
        return World::compute(job, monitor, watch);
    } catch (const Cancelled&) {
        return std::nullopt;
    }
}

template <class World>
RunSummary write_job(const Job& job, const Computation<World>& computation,
                     const TileSource<World>& tiles, const JobCallback& callback) {
    const std::vector<JobFile> files = plan_files(job);
    World::check_files(job, files, computation.materials.phase_names);
    require_all_writable(job, files);
    require_memory_to_write(job, files);
    Stopwatch watch(computation.seconds);
    JobMonitor monitor(callback, job);
    try {
        return finish<World>(job, files, computation, tiles, monitor, watch);
    } catch (const Cancelled&) {
        return {};
    } catch (const UnsuitableCells& error) {
        throw UnsuitableCells(error.what() + remedy(job, ""));
    }
}

template std::optional<Computation<PlaneWorld>> compute_job(const Job&, const JobCallback&);
template std::optional<Computation<SpaceWorld>> compute_job(const Job&, const JobCallback&);
template RunSummary write_job(const Job&, const Computation<PlaneWorld>&,
                              const TileSource<PlaneWorld>&, const JobCallback&);
template RunSummary write_job(const Job&, const Computation<SpaceWorld>&,
                              const TileSource<SpaceWorld>&, const JobCallback&);

RunSummary run_job(const Job& job, const JobCallback& callback) {
    check_job(job);
    const std::vector<std::string> phases = file_phases(job);
    const std::vector<JobFile> files = plan_files(job);
    const auto check_files = job.is_in_space() ? SpaceWorld::check_files : PlaneWorld::check_files;
    check_files(job, files, phases);
    check_retries(job, files);
    require_memory(job, files);
    const std::vector<std::string> recovered = require_all_writable(job, files);
    RunSummary summary = job.is_in_space() ? run<SpaceWorld>(job, files, callback)
                                           : run<PlaneWorld>(job, files, callback);
    summary.recovered.insert(summary.recovered.begin(), recovered.begin(), recovered.end());
    return summary;
}

}  // namespace pcvt
