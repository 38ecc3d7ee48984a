#include "plugin/job.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>

#include "io/output.hpp"
#include "io/site_writer.hpp"
#include "mesher/outline.hpp"
#include "mesher/quality.hpp"
#include "mesher/tile.hpp"
#include "mesher/validate.hpp"
#include "plugin/job_files.hpp"
#include "plugin/job_report.hpp"

namespace pcvt {
namespace {

/// Beyond this the coordinates of a tile lose too many digits to keep its vertices apart.
constexpr double kFarthestOrigin = 1 << 20;

/// In units of the size of a face: with a finer rounding than this a tile of ours keeps its laws in
/// single precision.
constexpr double kCoarseRounding = 1e-4;

struct Cancelled {};

/// Adds up the seconds of each stage.
class Stopwatch {
   public:
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

struct ProvedTile {
    AnyTile tile;
    SeamSize seam;
};

void check_job(const Job& job) {
    const double n = job.points.cols() > 0 ? static_cast<double>(job.points.cols()) : job.n_sites;
    if (n < 1) throw InvalidInput("no sites; give at least one");
    if (job.columns < 1 || job.rows < 1) throw InvalidInput("a repetition is below 1; take 1 x 1");
    if (job.meshes.empty()) throw InvalidInput("no mesh is asked for; take voronoi or delaunay");
    if (n * job.columns * job.rows > kMostSites) {
        throw LimitExceeded("more than " + std::to_string(kMostSites) +
                            " cells in one tile; take fewer sites or repeat less often");
    }
    const Vec2 periods = job.lattice.to_lattice(job.origin);
    if (!(periods.cwiseAbs().maxCoeff() <= kFarthestOrigin)) {
        throw InvalidInput("the origin lies more than " + std::to_string(1 << 20) +
                           " periods away; give a nearer one");
    }
}

CvtResult tessellate(const Job& job, Monitor& monitor) {
    const Points points =
        job.points.cols() > 0 ? job.points : uniform_points(job.lattice, job.n_sites, job.seed);
    CvtOptions options;
    options.solver = job.solver;
    options.tolerance = job.tolerance;
    options.max_iterations = job.max_iterations;
    options.progress = [&monitor](const Progress& progress) { return monitor.iteration(progress); };
    return compute_cvt(job.lattice, points, options);
}

/// The rounding of the largest coordinate in single precision, in units of the size of a face.
double single_rounding(const FlatTile& tile) {
    double largest = 0;
    for (const Vec2& point : tile.points) largest = std::max(largest, point.cwiseAbs().maxCoeff());
    return largest * static_cast<double>(std::numeric_limits<float>::epsilon()) /
           std::sqrt(tile.lattice.area() / tile.n_faces());
}

/// Proves the tile and what it stores of its seam. A tile of ours that fails is our fault, unless
/// it is too fine, or too far from 0,0, for the file's precision.
TileProof prove(const FlatTile& tile, Precision precision, bool vertex_pairs, bool edge_pairs,
                const std::string& name) {
    try {
        TileProof proof = prove_tile(tile, precision);
        if (vertex_pairs) compare_vertex_pairs(tile, proof);
        if (edge_pairs) compare_edge_pairs(tile, proof);
        return proof;
    } catch (const NotATile& error) {
        if (precision == Precision::kSingle && single_rounding(tile) > kCoarseRounding) {
            throw InvalidInput(name +
                               ": the format's single precision is too coarse for this tile; " +
                               "give an --origin nearer to 0,0, or take another format");
        }
        throw InternalError(name + " breaks a law of tiles: " + error.what());
    }
}

ProvedTile build_tile(const Job& job, const CvtResult& result, TileKind kind) {
    const PeriodicMesh mesh = repeated(periodic_mesh(result, kind), job.columns, job.rows);
    AnyTile tile = make_tile(mesh, whole_outline(mesh, job.origin));
    const TileProof proof = prove(flatten(tile), Precision::kDouble, true, true, "the tile");
    return {std::move(tile),
            {kind, proof.n_boundary_edges, static_cast<int>(proof.edge_pairs.size())}};
}

JobOutcome describe(const CvtResult& result, const std::vector<ProvedTile>& tiles) {
    JobOutcome outcome;
    outcome.stop = result.stop;
    outcome.n_sites = result.delaunay.sites().n_sites();
    outcome.iterations = result.iterations;
    outcome.evaluations = result.evaluations;
    outcome.energy = result.energy;
    outcome.energy_bound = result.energy_bound;
    outcome.residual = result.residual;
    outcome.rms_residual = result.rms_residual;
    outcome.n_mirrors = result.delaunay.n_mirrors();
    outcome.valences = histogram(cell_sides(periodic_mesh(result, TileKind::kCells)));
    const auto hexagons = outcome.valences.find(6);
    outcome.n_hexagons = hexagons == outcome.valences.end() ? 0 : hexagons->second;
    for (const ProvedTile& tile : tiles) outcome.seams.push_back(tile.seam);
    return outcome;
}

Points wrapped_sites(const CvtResult& result) {
    const Sites& sites = result.delaunay.sites();
    Points points(2, sites.n_sites());
    for (SiteId s = 0; s < sites.n_sites(); ++s) points.col(s) = sites.position(s);
    return points;
}

/// What reached the disk: the bytes that were meant, and a tile where the format can be read.
void verify(const OutputSet& outputs, const TileFormat* format,
            const std::vector<EncodedFile>& encoded) {
    std::vector<EncodedFile> written;
    for (const EncodedFile& file : encoded) {
        written.push_back({file.path, outputs.read_back(file.path)});
        if (written.back().bytes != file.bytes) {
            throw OutputError(file.path + ": the disk gives back other bytes than were written");
        }
    }
    if (format == nullptr || format->decode == nullptr) return;
    try {
        const TileFile file = format->decode(written, std::nullopt);
        prove(file.tile, file.precision, file.has_vertex_pairs, file.has_edge_pairs,
              encoded.front().path);
    } catch (const BadFile& error) {
        throw InternalError(std::string("a file is not read back: ") + error.what());
    }
}

void stage(const JobFile& file, const CvtResult& result, const std::vector<ProvedTile>& tiles,
           OutputSet& outputs) {
    const std::string& path = file.paths.front();
    const std::vector<EncodedFile> encoded =
        file.format == nullptr
            ? std::vector<EncodedFile>{{path, encode_sites(wrapped_sites(result))}}
            : file.format->encode(tiles[static_cast<std::size_t>(file.mesh)].tile, path);
    for (const EncodedFile& part : encoded) outputs.stage(part.path, part.bytes);
    verify(outputs, file.format, encoded);
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
           const std::vector<ProvedTile>& tiles, const Monitor& monitor, Stopwatch& watch,
           JobOutcome& outcome) {
    OutputSet outputs;
    for (const JobFile& file : files) {
        stage(file, result, tiles, outputs);
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
