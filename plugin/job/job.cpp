#include "plugin/job/job.hpp"

#include <chrono>

#include "mesher/mesh/valence.hpp"
#include "mesher/mesh/voronoi.hpp"
#include "plugin/job/job_checks.hpp"
#include "plugin/job/job_files.hpp"
#include "plugin/job/job_report.hpp"
#include "plugin/job/job_staging.hpp"
#include "plugin/job/job_start.hpp"
#include "plugin/job/job_tiles.hpp"

namespace pcvt {
namespace {

struct Cancelled {};

/// Adds up the seconds of each stage.
class Stopwatch {
   public:
    explicit Stopwatch(const JobSeconds& before = {}) : seconds_(before) {}

    /// The time since the last stop belongs to `stage`.
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

/// Stands between the optimiser and the callback; remembers the last progress.
class Monitor {
   public:
    Monitor(const JobCallback& callback, Stopwatch& watch) : callback_(callback), watch_(watch) {}

    bool iteration(const Progress& progress) {
        // The first call comes when the first triangulation stands and is evaluated.
        if (!built_) watch_.stop(&JobSeconds::build);
        built_ = true;
        last_ = progress;
        return !callback_ || callback_(last_);
    }
    const JobCallback& callback() const { return callback_; }
    void between_stages() const {
        if (callback_ && !callback_(last_)) throw Cancelled{};
    }

   private:
    const JobCallback& callback_;
    Stopwatch& watch_;
    Progress last_;
    bool built_ = false;
};

CvtResult tessellate(const Job& job, JobStart& start, Monitor& monitor) {
    CvtOptions options;
    options.precondition_below = start.precondition_below;
    options.solver = job.solver;
    options.tolerance = job.tolerance;
    options.max_iterations = job.max_iterations;
    options.n_threads = job.n_threads;
    options.density = job.density;
    options.progress = [&monitor](const Progress& progress) { return monitor.iteration(progress); };
    return compute_cvt(job.lattice, std::move(start.points), options);
}

std::optional<Minimum> minimum_of(const CvtResult& result) {
    const Sites& sites = result.delaunay.sites();
    const bool few = sites.n_sites() <= kMostSitesForStability;
    if (result.stop != Stop::kConverged || result.density || !few) return {};
    return stability(sites);
}

RunSummary describe(const Computation& job_result, std::span<const BuiltTile> tiles) {
    const CvtResult& result = job_result.cvt;
    RunSummary outcome;
    outcome.stop = result.stop;
    outcome.n_sites = result.delaunay.sites().n_sites();
    outcome.iterations = result.iterations;
    outcome.evaluations = job_result.evaluations;
    outcome.pattern = job_result.pattern;
    outcome.found = job_result.found;
    outcome.hessians = result.hessians;
    outcome.cg_products = result.cg_products;
    outcome.energy = result.energy;
    if (!result.density) outcome.energy_bound = result.energy_bound;
    outcome.density = result.density;
    outcome.residual = result.residual;
    outcome.rms_residual = result.rms_residual;
    outcome.minimum = minimum_of(result);
    outcome.n_mirrors = result.counts.n_mirrors;
    outcome.valences = histogram(cell_sides(periodic_mesh(result.delaunay, MeshKind::kVoronoi)));
    const auto hexagons = outcome.valences.find(6);
    outcome.n_hexagons = hexagons == outcome.valences.end() ? 0 : hexagons->second;
    for (const BuiltTile& tile : tiles) outcome.tiles.push_back(tile.figures);
    return outcome;
}

void require_all_writable(const Job& job, const std::vector<JobFile>& files) {
    for (const JobFile& file : files) {
        if (!file.folder.empty()) {
            OutputSet::require_writable_folder(file.folder, file.paths, job.force);
            continue;
        }
        for (const std::string& path : file.paths) OutputSet::require_writable(path, job.force);
    }
    if (!job.report.empty()) OutputSet::require_writable(job.report, job.force);
}

std::vector<BuiltTile> build_tiles(const Job& job, const CvtResult& result,
                                   const Monitor& monitor) {
    std::vector<BuiltTile> tiles;
    tiles.reserve(job.meshes.size());
    for (const MeshKind kind : job.meshes) {
        tiles.push_back(proved_tile(job, result, kind));
        monitor.between_stages();
    }
    return tiles;
}

/// Stages every file and then, last, commits them all: the one moment that cannot be cancelled.
void write(const Job& job, const std::vector<JobFile>& files, const Computation& result,
           std::span<const BuiltTile> tiles, const Monitor& monitor, Stopwatch& watch,
           RunSummary& outcome) {
    OutputSet outputs;
    stage_files(
        job, files, result, tiles, [&] { monitor.between_stages(); }, outputs);
    for (const JobFile& file : files) {
        if (file.folder.empty()) {
            outcome.files.insert(outcome.files.end(), file.paths.begin(), file.paths.end());
        } else {
            outcome.files.push_back(file.folder);
        }
    }
    watch.stop(&JobSeconds::write);
    if (!job.report.empty()) {
        outcome.seconds = watch.seconds();
        outputs.stage(job.report, encode_job_report(job, outcome));
    }
    monitor.between_stages();
    outputs.commit(job.force);
    watch.stop(&JobSeconds::write);
}

/// Asked here and not when a file is written: a host's density is gone by then.
std::vector<double> site_densities(const Job& job, const CvtResult& result) {
    if (!job.density) return {};
    return densities_at(*job.density, job.lattice, wrapped_sites(result));
}

Computation compute(const Job& job, Monitor& monitor, Stopwatch& watch) {
    JobStart start = job_start(job, monitor.callback());
    if (start.cancelled) throw Cancelled{};
    watch.stop(&JobSeconds::optimize);
    CvtResult cvt = tessellate(job, start, monitor);
    watch.stop(&JobSeconds::optimize);
    if (cvt.stop == Stop::kCancelled) throw Cancelled{};
    const int evaluations = start.evaluations + cvt.evaluations;
    std::vector<double> densities = site_densities(job, cvt);
    return {std::move(cvt),           std::move(densities),   evaluations,
            std::move(start.pattern), std::move(start.found), watch.seconds()};
}

RunSummary run(const Job& job, const std::vector<JobFile>& files, const JobCallback& callback) {
    Stopwatch watch;
    Monitor monitor(callback, watch);
    const Computation result = compute(job, monitor, watch);
    const std::vector<BuiltTile> tiles = build_tiles(job, result.cvt, monitor);
    RunSummary outcome = describe(result, tiles);
    watch.stop(&JobSeconds::build);
    write(job, files, result, tiles, monitor, watch, outcome);
    outcome.seconds = watch.seconds();
    return outcome;
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
    Stopwatch watch;
    Monitor monitor(callback, watch);
    try {
        return compute(job, monitor, watch);
    } catch (const Cancelled&) {
        return std::nullopt;
    }
}

Points wrapped_sites(const CvtResult& result) {
    const Sites& sites = result.delaunay.sites();
    Points points(2, sites.n_sites());
    for (SiteId s = 0; s < sites.n_sites(); ++s) points.col(s) = sites.position(s);
    return points;
}

RunSummary write_job(const Job& job, const Computation& result, std::span<const BuiltTile> tiles) {
    const std::vector<JobFile> files = plan_files(job);
    check_order(job, files);
    require_all_writable(job, files);
    Stopwatch watch(result.seconds);
    const JobCallback no_callback;
    RunSummary outcome = describe(result, tiles);
    write(job, files, result, tiles, Monitor(no_callback, watch), watch, outcome);
    outcome.seconds = watch.seconds();
    return outcome;
}

RunSummary run_job(const Job& job, const JobCallback& callback) {
    check_job(job);
    const std::vector<JobFile> files = plan_files(job);
    check_order(job, files);
    require_all_writable(job, files);
    try {
        return run(job, files, callback);
    } catch (const Cancelled&) {
        return {};
    }
}

}  // namespace pcvt
