#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mesher/base/error.hpp"
#include "mesher/cvt/cvt.hpp"
#include "mesher/energy/stability.hpp"
#include "mesher/search/lattice_stability.hpp"
#include "mesher/tile/build_tile.hpp"

namespace pcvt {

/// Where the sites begin when none are given: at random, from coarse to fine, at the best exact
/// lattice for their number, at the best state of a global search.
enum class Start { kRandom, kCoarse, kLattice, kBest };

/// The most that Job::short_edges can be: an edge of a regular hexagon has 0.62 h.
inline constexpr double kLongestShortEdge = 0.5;

/// One run, as a plain description: what the command's options and the C ABI's options both fill.
struct Job {
    Lattice lattice = Lattice::rectangle(1, 1);
    /// The sites, 2 x n, length units; without columns `n_sites` sites begin at `start`.
    Points points;
    int n_sites = 0;
    /// Nothing: coarse from 1000 sites on that are to be optimised without a density, else random.
    std::optional<Start> start;
    /// Evaluations that the global search may spend; 0: default_search_budget(n_sites).
    int budget = 0;
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

    /// Voronoi edges shorter than this are removed from cells and grains, units of h; 0: none, but
    /// for the shortest ones of grains (mesher/grains/grains.hpp).
    double short_edges = 0;

    /// At least one, each at most once. With several, -voronoi, -delaunay and -grains precede
    /// the extension. Delaunay triangles have no box outline.
    std::vector<MeshKind> meshes = {MeshKind::kVoronoi};
    Outline outline = Outline::kWhole;
    /// Edges of grains, length units; 0: h / 3, h = sqrt(area / number of sites).
    double grain_size = 0;
    /// Each edge of the cells is cut into so many parts, and triangles inside match; excludes
    /// grain_size. 0: no.
    int grain_per_edge = 0;
    /// 2: grains are six-node triangles, in the formats that hold them.
    int order = 1;
    /// The tile covers columns x rows domains and is a tile of that lattice.
    int columns = 1;
    int rows = 1;
    /// Corner of the domain, length units.
    Vec2 origin = Vec2::Zero();
    /// The box outline stands where its shortest edge comes out longest, and not at `origin`.
    bool finds_origin = true;

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

/// The best exact lattice for the number of sites.
struct PatternOutcome {
    LatticePattern lattice;
    LatticeStability stability;
};

/// What a job computes before it makes tiles and files.
struct Computation {
    CvtResult cvt;
    /// rho at each site; empty without a density.
    std::vector<double> site_densities;
    /// Those of a global search are counted in.
    int evaluations;
    /// Where the start looked for it.
    std::optional<PatternOutcome> pattern;
    /// How the global search found its best state, in words; empty without one.
    std::string found;
    /// Of the computing alone.
    JobSeconds seconds;
};

/// What came out, beside the files.
struct RunSummary {
    /// kCancelled: no file was written, and nothing below is filled.
    Stop stop = Stop::kCancelled;
    int n_sites = 0;
    int iterations = 0;
    /// Those of a global search are counted in, those of the coarser problems of a coarse start
    /// not.
    int evaluations = 0;
    /// Of Newton's method, not counted among the evaluations: Hessians, and products with them.
    int hessians = 0;
    int cg_products = 0;
    /// length^4, as energy_bound, which is nothing with a density.
    double energy = 0;
    std::optional<double> energy_bound;
    double residual = 0;
    double rms_residual = 0;
    /// Of a run that converged, up to kMostSitesForStability sites.
    std::optional<Minimum> minimum;
    /// Nothing where the triangulation was built without mirrors.
    std::optional<int> n_mirrors;
    /// Cells by their number of sides, on the unrepeated torus; edges under 1e-5 h do not count.
    std::map<int, int> valences;
    int n_hexagons = 0;
    /// Of jobs with a density.
    std::optional<DensityFigures> density;
    /// One entry a mesh of the job.
    std::vector<TileFigures> tiles;
    /// Every file or folder written but the report, in the order of the outputs.
    std::vector<std::string> files;
    /// Where the start looked for it.
    std::optional<PatternOutcome> pattern;
    /// How the global search found its best state, in words; empty without one.
    std::string found;
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
RunSummary run_job(const Job& job, const JobCallback& callback);

/// @throws InvalidInput, LimitExceeded as run_job does before any computing, but for the outputs.
void check_job(const Job& job);

/// The steps of run_job one by one, for a host that keeps the result in memory; errors as there.
///
/// The tessellation; nothing where the callback returned false.
std::optional<Computation> compute_job(const Job& job, const JobCallback& callback);
/// The optimised sites, 2 x n, wrapped into the reduced domain at the origin: what `.txt` files
/// hold.
Points wrapped_sites(const CvtResult& result);
/// Writes job.outputs and job.report; tiles[k], proved, is the one of job.meshes[k], and need not
/// be there where no output is a tile.
RunSummary write_job(const Job& job, const Computation& result, std::span<const BuiltTile> tiles);

/// The stop as contract words: "converged", "iteration-limit", "stalled", "cancelled".
const char* stop_name(Stop stop);

}  // namespace pcvt
