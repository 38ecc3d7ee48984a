#include "plugin/job.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "io/site_writer.hpp"
#include "io/svg_writer.hpp"
#include "mesher/density_survey.hpp"
#include "mesher/outline.hpp"
#include "mesher/quality.hpp"
#include "mesher/voronoi.hpp"
#include "plugin/job_files.hpp"
#include "plugin/job_proof.hpp"
#include "plugin/job_report.hpp"

namespace pcvt {
namespace {

/// Offsets of a tile stay below this, so that their sums and differences fit an int.
constexpr double kLargestOffset = 1 << 28;

/// Coordinates of the origin are rounded by this many ulps at most on their way into a file.
constexpr double kUlps = 4;

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
    void between_stages() const {
        if (callback_ && !callback_(last_)) throw Cancelled{};
    }

   private:
    const JobCallback& callback_;
    Stopwatch& watch_;
    Progress last_;
    bool built_ = false;
};

Reduction reduce_repeated(const Job& job) {
    reduce(job.lattice);
    try {
        return reduce(job.lattice.repeated(job.columns, job.rows));
    } catch (const InvalidInput& error) {
        throw InvalidInput("repeated " + std::to_string(job.columns) + " x " +
                           std::to_string(job.rows) + ": " + error.what());
    }
}

/// The origin must leave the offsets in their integers, and vertices that differ must stay apart.
void check_origin(const Job& job, const Reduction& repeated, double n_sites) {
    const Vec2 periods = repeated.reduced.to_lattice(job.origin);
    double largest = 1;
    for (const int entry : repeated.m) largest = std::max(largest, std::abs(double(entry)));
    const double rounding =
        kUlps * std::numeric_limits<double>::epsilon() * job.origin.cwiseAbs().maxCoeff();
    const double h = std::sqrt(job.lattice.area() / n_sites);
    if (!(periods.cwiseAbs().maxCoeff() * largest < kLargestOffset) ||
        !(rounding <= kSameVertex * h)) {
        throw InvalidInput(
            "the origin is so far away that the tile would lose its digits; give a nearer one");
    }
}

void check_job(const Job& job) {
    const double n = job.points.cols() > 0 ? static_cast<double>(job.points.cols()) : job.n_sites;
    if (n < 1) throw InvalidInput("no sites; give at least one");
    if (job.n_threads < 1) throw InvalidInput("the number of threads is below 1; take 1");
    if (job.columns < 1 || job.rows < 1) throw InvalidInput("a repetition is below 1; take 1 x 1");
    if (job.meshes.empty()) throw InvalidInput("no mesh is asked for; take voronoi or delaunay");
    if (n * job.columns * job.rows > kMostSites) {
        throw LimitExceeded("more than " + std::to_string(kMostSites) +
                            " cells in one tile; take fewer sites or repeat less often");
    }
    check_origin(job, reduce_repeated(job), n);
}

/// The sites before they are optimised.
Points first_sites(const Job& job) {
    if (job.points.cols() > 0) return job.points;
    if (!job.density) return uniform_points(job.lattice, job.n_sites, job.seed);
    return graded_points(job.lattice, *job.density, job.n_sites, job.seed);
}

CvtResult tessellate(const Job& job, Monitor& monitor) {
    Points points = first_sites(job);
    CvtOptions options;
    options.solver = job.solver;
    options.tolerance = job.tolerance;
    options.max_iterations = job.max_iterations;
    options.n_threads = job.n_threads;
    options.density = job.density;
    options.progress = [&monitor](const Progress& progress) { return monitor.iteration(progress); };
    return compute_cvt(job.lattice, std::move(points), options);
}

ProvedTile build_tile(const Job& job, const CvtResult& result, TileKind kind) {
    const PeriodicMesh mesh = repeated(periodic_mesh(result, kind), job.columns, job.rows);
    AnyTile tile = make_tile(mesh, whole_outline(mesh, job.origin));
    const TileProof proof = prove_own_tile(tile);
    return {std::move(tile),
            {kind, proof.n_boundary_edges, static_cast<int>(proof.edge_pairs.size())}};
}

JobOutcome describe(const CvtResult& result, std::span<const ProvedTile> tiles) {
    JobOutcome outcome;
    outcome.stop = result.stop;
    outcome.n_sites = result.delaunay.sites().n_sites();
    outcome.iterations = result.iterations;
    outcome.evaluations = result.evaluations;
    outcome.energy = result.energy;
    if (!result.density) outcome.energy_bound = result.energy_bound;
    outcome.density = result.density;
    outcome.residual = result.residual;
    outcome.rms_residual = result.rms_residual;
    outcome.n_mirrors = result.counts.n_mirrors;
    outcome.valences = histogram(cell_sides(periodic_mesh(result, TileKind::kCells)));
    const auto hexagons = outcome.valences.find(6);
    outcome.n_hexagons = hexagons == outcome.valences.end() ? 0 : hexagons->second;
    for (const ProvedTile& tile : tiles) outcome.seams.push_back(tile.seam);
    return outcome;
}

/// Pictures of a graded mesh show the sizes of its cells.
std::vector<EncodedFile> encode(const Job& job, const JobFile& file, const AnyTile& tile) {
    if (job.density && file.format->extension == ".svg") {
        return encode_graded_svg(tile, file.paths.front());
    }
    return file.format->encode(tile, file.paths.front());
}

/// Encodes a tile, lets it reach the disk under a hidden name and proves what stands there.
void stage_tile(const Job& job, const JobFile& file, const AnyTile& tile, OutputSet& outputs) {
    const std::vector<EncodedFile> encoded = encode(job, file, tile);
    for (const EncodedFile& part : encoded) outputs.stage(part.path, part.bytes);
    const std::vector<EncodedFile> written = read_back(outputs, encoded);
    if (file.format->decode != nullptr) prove_files(*file.format, written, tile, job.origin);
}

void stage_sites(const std::string& path, const CvtResult& result, OutputSet& outputs) {
    const EncodedFile encoded{path, encode_sites(wrapped_sites(result))};
    outputs.stage(path, encoded.bytes);
    read_back(outputs, {encoded});
}

void require_all_writable(const Job& job, const std::vector<JobFile>& files) {
    for (const JobFile& file : files) {
        for (const std::string& path : file.paths) OutputSet::require_writable(path, job.force);
    }
    if (!job.report.empty()) OutputSet::require_writable(job.report, job.force);
}

std::vector<ProvedTile> build_tiles(const Job& job, const CvtResult& result,
                                    const Monitor& monitor) {
    std::vector<ProvedTile> tiles;
    tiles.reserve(job.meshes.size());
    for (const TileKind kind : job.meshes) {
        tiles.push_back(build_tile(job, result, kind));
        monitor.between_stages();
    }
    return tiles;
}

/// Stages every file and then, last, commits them all: the one moment that cannot be cancelled.
void write(const Job& job, const std::vector<JobFile>& files, const CvtResult& result,
           std::span<const ProvedTile> tiles, const Monitor& monitor, Stopwatch& watch,
           JobOutcome& outcome) {
    OutputSet outputs;
    for (const JobFile& file : files) {
        if (file.format == nullptr) {
            stage_sites(file.paths.front(), result, outputs);
        } else {
            stage_tile(job, file, tiles[static_cast<std::size_t>(file.mesh)].tile, outputs);
        }
        outcome.files.insert(outcome.files.end(), file.paths.begin(), file.paths.end());
        monitor.between_stages();
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

JobOutcome run(const Job& job, const std::vector<JobFile>& files, const JobCallback& callback) {
    Stopwatch watch;
    Monitor monitor(callback, watch);
    const CvtResult result = tessellate(job, monitor);
    watch.stop(&JobSeconds::optimize);
    if (result.stop == Stop::kCancelled) throw Cancelled{};
    const std::vector<ProvedTile> tiles = build_tiles(job, result, monitor);
    JobOutcome outcome = describe(result, tiles);
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

JobResult compute_job(const Job& job, const JobCallback& callback) {
    check_job(job);
    Stopwatch watch;
    Monitor monitor(callback, watch);
    CvtResult cvt = tessellate(job, monitor);
    watch.stop(&JobSeconds::optimize);
    return {std::move(cvt), watch.seconds()};
}

Points wrapped_sites(const CvtResult& result) {
    const Sites& sites = result.delaunay.sites();
    Points points(2, sites.n_sites());
    for (SiteId s = 0; s < sites.n_sites(); ++s) points.col(s) = sites.position(s);
    return points;
}

ProvedTile make_job_tile(const Job& job, const CvtResult& result, TileKind kind) {
    return build_tile(job, result, kind);
}

JobOutcome write_job(const Job& job, const JobResult& result, std::span<const ProvedTile> tiles) {
    const std::vector<JobFile> files = plan_files(job);
    require_all_writable(job, files);
    Stopwatch watch(result.seconds);
    const JobCallback no_callback;
    JobOutcome outcome = describe(result.cvt, tiles);
    write(job, files, result.cvt, tiles, Monitor(no_callback, watch), watch, outcome);
    outcome.seconds = watch.seconds();
    return outcome;
}

JobOutcome run_job(const Job& job, const JobCallback& callback) {
    check_job(job);
    const std::vector<JobFile> files = plan_files(job);
    require_all_writable(job, files);
    try {
        return run(job, files, callback);
    } catch (const Cancelled&) {
        return {};
    }
}

}  // namespace pcvt
