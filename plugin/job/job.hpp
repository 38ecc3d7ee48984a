#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "io/forms/file_options.hpp"
#include "io/run_files/inclusion_reader.hpp"
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
#include "mesher/space/geometry/metric.hpp"
#include "mesher/torus/coincident_sites.hpp"
#include "mesher/torus/walls.hpp"
#include "plugin/job/job_progress.hpp"

namespace pcvt {

/// Where the sites begin when none are given: at random, from coarse to fine, at the best exact
/// lattice for their number, at the best state of a global search. job_start.hpp has their table.
enum class Start { kRandom, kCoarse, kLattice, kBest };

/// The target areas of the cells, in space their volumes: drawn from a law, or given.
struct TargetSizes {
    AreaLaw law = {};
    /// One positive number a site, in any unit: scaled to the area of the domain. Empty: `law`.
    Eigen::VectorXd given = {};
    /// The law or the file, for the report.
    std::string name;

    bool is_drawn() const { return given.size() == 0 && law.is_random(); }
};

/// Weights of given sites, whose cells are power cells.
struct GivenWeights {
    /// One a site, length^2.
    Eigen::VectorXd values;
    /// Their file, for the report.
    std::string name;
};

/// Elongated cells: as plane::Metric, in space as space::Metric.
struct Aspect {
    double ratio = 1;
    /// In the plane.
    double degrees = 0;
    /// In space.
    space::Vec3 axis = space::Vec3::UnitX();
};

/// The largest Job::short_edges: an edge of a regular hexagon has 0.62 h.
inline constexpr double kLongestShortEdge = 0.5;

/// The periods of a job and its sites, in the plane or in space.
template <class Lattice>
struct JobDomain {
    Lattice lattice;
    /// The corner of the domain in which tiles and sites are placed, length units.
    typename Lattice::Point origin = Lattice::Point::Zero();
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

    /// With `sizes`, max_iterations is the number of steps that move each site to the centroid of
    /// its cell. run_job() sets progress.
    RunOptions run;
    /// Whether the summary answers if the result is a minimum, which costs up to three times the
    /// optimisation: minimum_of(). For at most kMostSitesForStability sites without a density.
    bool stability = false;
    /// `nullopt`: rho = 1. Random sites are drawn from rho^(1/2).
    std::optional<plane::Density> density;
    /// Its formula or file, for the report.
    std::string density_name;
    /// Cells of prescribed areas, in space of volumes: power cells. Excludes a density, and starts
    /// and solvers of cells that are all alike.
    std::optional<TargetSizes> sizes;
    /// The power cells of given sites that stay where they are, with max_iterations 0. Excludes a
    /// density, areas, and the stability.
    std::optional<GivenWeights> weights;
    /// The points are not sites, but the centroids of measured grains, whose sizes `sizes` gives:
    /// the sites are found. The name of their table, for the report. Excludes drawn sizes, walls
    /// and aspect.
    std::optional<std::string> centroids;
    /// Whether the cells are power cells.
    bool has_weights() const { return sizes.has_value() || weights.has_value(); }
    /// The cells are Voronoi cells, or power cells, in this metric.
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
    /// The unit of these sites that their file states, such as um; empty without one.
    std::string site_unit = {};
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

    /// At least one, each at most once; in space one. If there are several, the word of the kind
    /// precedes the extension: tile-voronoi.obj. Not every kind has a box outline (mesh_kind.hpp).
    std::vector<plane::MeshKind> meshes = {plane::MeshKind::kVoronoi};
    /// How each of them becomes a tile. The tessellation supplies its elongation, walls, tags and
    /// holes, and the domain its origin: tile_options().
    plane::TileOptions tile;

    /// Phases are spread and orientations drawn by `seed`; given orientations are those of the
    /// sites in their order.
    MaterialChoices materials;

    /// The options of the command without paths, and without those that change no result, for files
    /// that state their history; empty for other hosts.
    std::string command;
    /// The forms of files, for the formats that have several; without densities and materials.
    FileOptions file_options;
    /// Files to write. The extension selects the format; `.txt` files hold the sites.
    std::vector<std::string> outputs;
    /// Empty: no report.
    std::string report;
    /// Files that the run reads; no output may replace them.
    std::vector<std::string> inputs;
    bool force = false;
};

/// Checks everything in a job except its outputs.
/// @throws InvalidInput, LimitExceeded as run_job does before any computation.
void check_job(const Job& job);

}  // namespace pcvt
