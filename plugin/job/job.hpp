#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "io/bytes/output_error.hpp"
#include "io/formats/space_format.hpp"
#include "io/run_files/inclusion_reader.hpp"
#include "io/tiles/file_options.hpp"
#include "mesher/base/error.hpp"
#include "mesher/cells/material_choices.hpp"
#include "mesher/cells/orientations.hpp"
#include "mesher/cells/target_areas.hpp"
#include "mesher/cvt/run_options.hpp"
#include "mesher/plane/cvt/cvt.hpp"
#include "mesher/plane/search/lattice_stability.hpp"
#include "mesher/plane/symmetry/plane_group.hpp"
#include "mesher/plane/tessellation/tessellation.hpp"
#include "mesher/plane/tile/build_tile.hpp"
#include "mesher/space/geometry/lattice.hpp"
#include "mesher/torus/coincident_sites.hpp"
#include "mesher/torus/walls.hpp"
#include "plugin/job/job_progress.hpp"

namespace pcvt {

/// Where the sites begin when none are given: at random, from coarse to fine, at the best exact
/// lattice for their number, at the best state of a global search. job_start.hpp has their table.
enum class Start { kRandom, kCoarse, kLattice, kBest };

/// The wished areas of the cells: drawn from a law, or given.
struct WishedAreas {
    AreaLaw law = {};
    /// One positive number a site, in any unit: scaled to the area of the domain. Empty: `law`.
    Eigen::VectorXd given = {};
    /// The law or the file, for the report.
    std::string name;

    bool is_drawn() const { return given.size() == 0 && law.kind != AreaLaw::Kind::kEqual; }
};

/// Elongated cells: as Metric.
struct Aspect {
    double ratio = 1;
    double degrees = 0;
};

/// The largest Job::short_edges: an edge of a regular hexagon has 0.62 h.
inline constexpr double kLongestShortEdge = 0.5;

/// The periods of a job and its sites, in the plane or in space.
template <class Lattice>
struct JobDomain {
    Lattice lattice;
    /// The sites, one a column, length units. If there are none, Job::n_sites sites begin at
    /// Job::start.
    typename Lattice::Points points = {};
    /// Sites that stay where they are, length units; they are the first of the Job::n_sites, and
    /// the others are drawn.
    typename Lattice::Points fixed = {};
};
using PlaneDomain = JobDomain<plane::Lattice>;
using SpaceDomain = JobDomain<space::Lattice>;

/// The description of one run. The command's options and the options of the C interface both become
/// a Job.
///
///   Job job;
///   job.n_sites = 300;
///   job.outputs = {"tile.obj"};
///   const RunSummary summary = run_job(job, {});
struct Job {
    std::variant<PlaneDomain, SpaceDomain> domain = PlaneDomain{plane::Lattice::rectangle(1, 1)};
    bool is_in_space() const { return std::holds_alternative<SpaceDomain>(domain); }
    /// @pre the job is in the plane, or in space.
    const PlaneDomain& in_plane() const { return std::get<PlaneDomain>(domain); }
    PlaneDomain& in_plane() { return std::get<PlaneDomain>(domain); }
    const SpaceDomain& in_space() const { return std::get<SpaceDomain>(domain); }
    SpaceDomain& in_space() { return std::get<SpaceDomain>(domain); }

    int n_sites = 0;
    int n_given() const {
        return std::visit([](const auto& d) { return static_cast<int>(d.points.cols()); }, domain);
    }
    int n_fixed() const {
        return std::visit([](const auto& d) { return static_cast<int>(d.fixed.cols()); }, domain);
    }
    /// The number of sites, given or wanted.
    int n_wanted() const { return n_given() > 0 ? n_given() : n_sites; }
    /// `nullopt`: coarse for 1000 sites or more, with a symmetry 1000 for each asymmetric unit,
    /// that are optimised without a density, else random.
    std::optional<Start> start;
    /// The most evaluations of the global search; 0: default_search_budget(n_sites).
    int budget = 0;
    std::uint64_t seed = 0;
    /// If an output refuses the cells (UnsuitableCells), the run is repeated with the next seed, at
    /// most so often. For drawn sites and outputs that can refuse.
    int retries = 0;

    /// With `areas`, max_iterations is the number of steps that move each site to the centroid of
    /// its cell. run_job() sets progress.
    RunOptions run;
    /// Whether the summary answers if the result is a minimum, which costs up to three times the
    /// optimisation: minimum_of(). For at most kMostSitesForStability sites without a density.
    bool stability = false;
    /// `nullopt`: rho = 1. Random sites are drawn from rho^(1/2).
    std::optional<plane::Density> density;
    /// Its formula or file, for the report.
    std::string density_name;
    /// Cells of prescribed areas: power cells. Excludes a density, and starts and solvers of cells
    /// that are all alike.
    std::optional<WishedAreas> areas;
    /// The cells are Voronoi cells, or with `areas` power cells, in this metric.
    std::optional<Aspect> aspect;
    /// The sites are drawn, and remain, with the symmetry of this plane group; the lattice must fit
    /// it. Excludes given sites, areas, and starts that are not random.
    std::optional<plane::PlaneGroupName> symmetry;
    /// The sides of the domain that are walls: it is then an upright rectangle with `origin` on
    /// them. Excludes aspect, symmetry, the stability, starts at a lattice, and copies
    /// across walls.
    Walls walls = Walls::kNone;
    WallCells wall_cells = WallCells::kWhole;
    /// What settle_duplicates() does with sites of `points`, or of `fixed`, that coincide with
    /// earlier ones.
    Duplicates duplicates = Duplicates::kRefuse;
    /// The line of each of these sites in their file; empty without one.
    std::vector<int> lines;
    /// The sites that settle_duplicates() left out.
    DroppedSites dropped;
    /// In space: the number of Delaunay tetrahedra of given sites to expect, which
    /// settle_duplicates() sets; 0: as many as sites that are spread evenly have.
    double n_tetrahedra = 0;
    /// Inclusions, of which each cell lies inside or outside; their tags are the phases of the
    /// cells. Some of the sites are placed in pairs along the outlines. Between walls they lie off
    /// these. Excludes given sites, other phases, areas, aspect, symmetry, the stability, and
    /// starts that are not random.
    std::optional<InclusionFile> inclusions;
    /// Circular inclusions of the tag `fibre` in random places, drawn by `seed`; in place of
    /// `inclusions`, with the same exclusions.
    std::optional<plane::RandomCircles> fibres;

    /// Tags of inclusions whose cells are left out: the tile has holes there, with walls of these
    /// names. The sites of these cells are in no file and in no view, and the others are numbered
    /// from 0 again, in their order.
    std::vector<std::string> holes;

    bool has_inclusions() const { return inclusions || fibres; }

    /// At least one, each at most once. If there are several, the word of the kind precedes the
    /// extension: tile-voronoi.obj. Not every kind has a box outline (mesh_kind.hpp).
    std::vector<plane::MeshKind> meshes = {plane::MeshKind::kVoronoi};
    /// How each of them becomes a tile. The tessellation supplies its elongation, walls, tags and
    /// holes.
    plane::TileOptions tile;

    /// Phases are spread and orientations drawn by `seed`; given orientations are those of the
    /// sites in their order.
    MaterialChoices materials;

    /// The options of the command without paths, and without those that change no result, for files
    /// that state their history; empty for other hosts.
    std::string command;
    /// The forms of files, for the formats that have several; without densities and materials.
    FileOptions file_options;
    /// The same in space.
    SpaceFileOptions space_files;
    /// Files to write. The extension selects the format; `.txt` files hold the sites.
    std::vector<std::string> outputs;
    /// Empty: no report.
    std::string report;
    /// Files that the run reads; no output may replace them.
    std::vector<std::string> inputs;
    bool force = false;
};

/// Seconds of each stage.
struct JobSeconds {
    double build = 0;
    double optimize = 0;
    double write = 0;
    double total = 0;
};

/// The best exact lattice for the number of sites.
template <class Pattern>
struct PatternOutcome {
    Pattern lattice;
    LatticeStability stability;
};

/// What is known of a start, besides the sites.
struct StartFigures {
    /// Of the starts that look for it.
    std::optional<PatternOutcome<plane::LatticePattern>> pattern;
    /// How the global search found its best state, in words; else empty.
    std::string found;
};

/// The tessellation of a job, from which its tiles and files are made.
struct Computation {
    /// Its evaluations include those of a global search, but not those of the coarser problems of a
    /// coarse start.
    plane::Tessellation cells;
    StartFigures start;
    /// rho at each site outside of holes; empty without a density.
    std::vector<double> site_densities;
    /// Of the sites outside of holes; empty without materials.
    CellMaterials materials = {};
    std::vector<PhaseFigures> phases = {};
    /// Of the computation alone.
    JobSeconds seconds = {};
};

/// The summary of a run, besides its files.
struct RunSummary {
    /// As in Computation::cells. kCancelled: no file was written, and no other member is set.
    RunStatistics run = {.stop = Stop::kCancelled};
    int n_sites = 0;
    /// The seed that was used, which follows Job::seed where outputs refused the seeds before it.
    std::uint64_t seed = 0;
    /// length^4; `nullopt` with a density.
    std::optional<double> energy_bound;
    /// As minimum_of() returns it, of jobs that ask for the stability.
    std::optional<Minimum> minimum;
    /// `nullopt` if the triangulation was built without mirrors.
    std::optional<int> n_mirrors;
    /// Cells by their number of sides, on the unrepeated torus; edges under 1e-5 h do not count.
    std::map<int, int> valences;
    int n_hexagons = 0;
    /// Of jobs with a density.
    std::optional<plane::DensityFigures> density;
    /// Of jobs with areas.
    std::optional<plane::AreaSummary> areas;
    /// Of jobs with a symmetry: the number of orbits of sites. Else 0.
    int n_orbits = 0;
    /// Of jobs with walls: the sites that lie on them.
    int n_on_walls = 0;
    /// Of jobs with inclusions.
    std::optional<plane::InterfaceFigures> interfaces;
    /// Of jobs with phases, one entry each.
    std::vector<PhaseFigures> phases;
    /// Of jobs with orientations.
    std::optional<AngleRange> angles;
    /// The materials whose elastic constants the files state.
    std::vector<NamedConstants> constants;
    /// One entry for each mesh of the job.
    std::vector<plane::TileFigures> tiles;
    /// The files and folders that were written, in the order of the outputs, without the report.
    std::vector<std::string> files;
    /// The outputs that were not written, in their order.
    std::vector<RefusedFile> refused;
    /// One line for each set of an earlier run that was finished before this one.
    std::vector<std::string> recovered;
    StartFigures start;
    JobSeconds seconds;
};

/// Sites -> optimised periodic tessellation -> proved tiles -> files that are read back and proved
/// again. Prints nothing. Either all files appear, together at the end, or none; only files whose
/// single precision does not hold the tile are left out (RunSummary::refused).
///
/// @throws InvalidInput   the job is wrong. Thrown before any computation, except for coincident
///                        sites (DuplicateSites names the ids).
/// @throws UnsuitableCells  an output refuses the cells, also after all retries.
/// @throws OutputError    a file cannot be written, or exists and `force` is not set.
/// @throws LimitExceeded  too many sites or faces.
/// @throws InternalError  a tile breaks its laws: a fault of pcvt.
RunSummary run_job(const Job& job, const JobCallback& callback);

/// Checks everything in a job except its outputs.
/// @throws InvalidInput, LimitExceeded as run_job does before any computation.
void check_job(const Job& job);

// The steps of run_job one by one, for a host that keeps the result in memory; errors as there.

/// Computes the tessellation; `nullopt` after a cancelled run.
std::optional<Computation> compute_job(const Job& job, const JobCallback& callback);
/// Makes the tiles of a job, proved, one for each of job.meshes; they must outlive the call. May be
/// empty if no output is a tile.
using TileSource = std::function<std::span<const plane::BuiltTile>(JobMonitor&)>;
/// Writes job.outputs and job.report. The summary of a cancelled call has Stop::kCancelled.
RunSummary write_job(const Job& job, const Computation& result, const TileSource& tiles,
                     const JobCallback& callback);

/// The stop as contract words: "converged", "iteration-limit", "stalled", "cancelled".
const char* stop_name(Stop stop);

}  // namespace pcvt
