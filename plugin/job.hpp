#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mesher/cvt.hpp"
#include "mesher/error.hpp"
#include "mesher/tile.hpp"

namespace pcvt {

/// One run, as a plain description: what the command's options and the C ABI's options both fill.
struct Job {
    Lattice lattice = Lattice::rectangle(1, 1);
    /// The sites, 2 x n, length units; without columns they are drawn from `n_sites` and `seed`.
    Points points;
    int n_sites = 0;
    std::uint64_t seed = 0;

    Solver solver = Solver::kLbfgs;
    double tolerance = 1e-6;
    /// Negative: no limit. 0: the periodic Voronoi diagram of the sites as given.
    int max_iterations = -1;
    /// At least 1; the result does not depend on it.
    int n_threads = 1;
    /// Nothing: rho = 1. With one, sites that are drawn are drawn from rho^(1/2).
    std::optional<Density> density;
    /// The formula or file that it came from, for the report.
    std::string density_name;

    /// At least one, each at most once. With several, -voronoi and -delaunay precede the extension.
    std::vector<TileKind> meshes = {TileKind::kCells};
    /// The tile covers columns x rows domains and is a tile of that lattice.
    int columns = 1;
    int rows = 1;
    /// Corner of the domain, length units.
    Vec2 origin = Vec2::Zero();

    /// Files to write, the format by extension; `.txt` takes the sites.
    std::vector<std::string> outputs;
    /// Empty: no report.
    std::string report;
    /// Files that are read: no output may stand in their place.
    std::vector<std::string> inputs;
    bool force = false;
};

/// Where the seconds went.
struct JobSeconds {
    double build = 0;
    double optimize = 0;
    double write = 0;
    double total = 0;
};

/// The seam of one tile.
struct SeamSize {
    TileKind kind;
    int n_boundary_edges;
    int n_edge_pairs;
};

/// A tile of a job that keeps its laws.
struct ProvedTile {
    AnyTile tile;
    SeamSize seam;
};

/// What a job computes before it makes tiles and files.
struct JobResult {
    CvtResult cvt;
    /// Of the computing alone.
    JobSeconds seconds;
};

/// What came out, beside the files.
struct JobOutcome {
    /// kCancelled: no file was written, and nothing below is filled.
    Stop stop = Stop::kCancelled;
    int n_sites = 0;
    int iterations = 0;
    int evaluations = 0;
    /// length^4, as energy_bound, which is nothing with a density.
    double energy = 0;
    std::optional<double> energy_bound;
    double residual = 0;
    double rms_residual = 0;
    /// Nothing where the triangulation was built without mirrors.
    std::optional<int> n_mirrors;
    /// Cells by their number of sides, on the unrepeated torus; edges under 1e-5 h do not count.
    std::map<int, int> valences;
    int n_hexagons = 0;
    /// Of jobs with a density.
    std::optional<DensityFigures> density;
    /// One entry a mesh of the job.
    std::vector<SeamSize> seams;
    /// Every file written but the report, in the order of the outputs.
    std::vector<std::string> files;
    JobSeconds seconds;
};

/// Called once an iteration and, with the last progress again, between the stages; on the calling
/// thread; false cancels.
using JobCallback = ProgressCallback;

/// Sites -> optimised periodic tessellation -> proved tiles -> files that are read back and proved
/// again. Prints nothing. Files appear all together at the end, or not at all.
///
/// @throws InvalidInput   the job is at fault: before any computing, but for coincident sites
///                        (DuplicateSites names the ids) and a tile too fine for a file's format.
/// @throws OutputError    a file cannot be written, or exists and `force` is not set.
/// @throws LimitExceeded  too many sites or faces.
/// @throws InternalError  a tile breaks its laws: a fault of pcvt.
JobOutcome run_job(const Job& job, const JobCallback& callback);

/// The steps of run_job one by one, for a host that keeps the result in memory; errors as there.
///
/// The tessellation; cvt.stop is kCancelled where the callback returned false.
JobResult compute_job(const Job& job, const JobCallback& callback);
/// The tile of one kind, proved.
ProvedTile make_job_tile(const Job& job, const CvtResult& result, TileKind kind);
/// The optimised sites, 2 x n, wrapped into the reduced domain at the origin: what `.txt` files
/// hold.
Points wrapped_sites(const CvtResult& result);
/// Writes job.outputs and job.report; tiles[k] is the one of job.meshes[k], and need not be there
/// where no output is a tile.
JobOutcome write_job(const Job& job, const JobResult& result, std::span<const ProvedTile> tiles);

/// The stop as contract words: "converged", "iteration-limit", "stalled", "cancelled".
const char* stop_name(Stop stop);

}  // namespace pcvt
