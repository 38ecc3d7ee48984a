#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/bytes/output_error.hpp"
#include "io/space_formats.hpp"
#include "mesher/cvt/run_options.hpp"
#include "mesher/space/cvt/cvt.hpp"
#include "mesher/space/cvt/minimum.hpp"
#include "mesher/space/mesh/short_edges.hpp"
#include "mesher/space/proof/polyhedral_proof.hpp"
#include "mesher/space/search/lattice_stability.hpp"
#include "mesher/torus/coincident_sites.hpp"
#include "plugin/job/job.hpp"

namespace pcvt {

/// The description of a run in three dimensions.
///
///   SpaceJob job;
///   job.n_sites = 1000;
///   job.outputs = {"tile.vtu"};
///   const SpaceSummary summary = run_space_job(job, {});
struct SpaceJob {
    space::Lattice lattice = space::Lattice::box(1, 1, 1);
    /// The sites, 3 x n, length units. If there are no columns, `n_sites` sites begin at `start`.
    space::Points points = space::Points(3, 0);
    /// What settle_duplicates() does with points that coincide with earlier ones.
    Duplicates duplicates = Duplicates::kRefuse;
    /// The line of each point in its file; empty without one.
    std::vector<int> lines;
    /// The points that settle_duplicates() left out.
    DroppedSites dropped;
    /// The number of Delaunay tetrahedra of the points to expect, which settle_duplicates() sets;
    /// 0: as many as sites that are spread evenly have.
    double n_tetrahedra = 0;
    int n_sites = 0;
    /// None: pcvt chooses.
    std::optional<Start> start = {};
    std::uint64_t seed = 0;
    /// run_space_job() sets progress.
    RunOptions run;
    /// Files to write. The extension selects the format (io/space_formats.hpp).
    std::vector<std::string> outputs;
    SpaceFileOptions file_options = {};
    /// Edges of cells shorter than this times h are removed; 0: none. At most
    /// space::kLongestShortEdge.
    double short_edges = 0;
    /// Whether the summary and the report say if the result is a minimum. At most
    /// space::kMostSitesForMinimum sites.
    bool stability = false;
    /// A .json file with the figures of the run; empty: none.
    std::string report;
    /// Files that the run reads; no output may replace them.
    std::vector<std::string> inputs;
    bool force = false;
};

/// Refuses points that coincide with earlier ones, within 1e-9 h, or leaves them out of the job, as
/// job.duplicates says, and estimates the number of tetrahedra. A host calls it once its job is
/// complete.
/// @throws DuplicateSites with all pairs.
void settle_duplicates(SpaceJob& job);

/// The best exact lattice for the number of sites.
struct SpacePatternOutcome {
    space::LatticePattern lattice;
    LatticeStability stability;
};

/// The optimised sites of a job, from which its tile and its files are made.
struct SpaceComputation {
    space::CvtResult cvt;
    /// Of a run that began at a lattice.
    std::optional<SpacePatternOutcome> pattern = {};
    /// Of the computation alone.
    double seconds = 0;
};

/// The tile of a job, proved, and its figures.
struct ProvedSpaceTile {
    SpaceTile tile;
    space::PolyhedralProof proof = {};
    /// Cells by their number of faces.
    std::map<int, int> face_counts = {};
    int n_removed_edges = 0;
};

/// The summary of a run, besides its files.
struct SpaceSummary {
    /// kCancelled: no file was written, and no other member is set. The energy is F, length^5.
    RunStatistics run = {.stop = Stop::kCancelled};
    int n_sites = 0;
    /// The energy of as many truncated octahedra, length^5.
    double energy_bound = 0;
    /// Of jobs with `stability` that converged.
    std::optional<Minimum> minimum = {};
    /// Of a run that began at a lattice.
    std::optional<SpacePatternOutcome> pattern = {};
    /// Cells by their number of faces.
    std::map<int, int> face_counts = {};
    int n_removed_edges = 0;
    space::PolyhedralProof proof = {};
    /// The files and folders that were written, in the order of the outputs.
    std::vector<std::string> files = {};
    /// The outputs that were not written, in their order.
    std::vector<RefusedFile> refused = {};
    /// One line for each set of an earlier run that was finished before this one.
    std::vector<std::string> recovered = {};
    double seconds = 0;
};

/// Sites -> optimised periodic tessellation -> proved tile of polyhedra -> files that are read back
/// and proved again. Prints nothing. Either all files appear, together at the end, or none; only
/// files whose single precision does not hold the tile are left out (SpaceSummary::refused).
///
/// @throws InvalidInput   the job is wrong. Thrown before any computation, except for coincident
///                        sites (DuplicateSites names the ids).
/// @throws OutputError    a file cannot be written, or exists and `force` is not set.
/// @throws LimitExceeded  too many sites, or more memory than is available.
/// @throws InternalError  a tile breaks its laws: a fault of pcvt.
SpaceSummary run_space_job(const SpaceJob& job, const JobCallback& callback);

// The steps of run_space_job one by one, for a host that keeps the result in memory; errors as
// there.

/// The start of the sites that the job does not give: what it states, else coarse from 1,000 sites
/// on if they are optimised, else random.
Start chosen_start(const SpaceJob& job);

/// The energy of as many truncated octahedra as the job has sites, length^5.
double energy_bound(const SpaceJob& job);

/// Whether the sites are a minimum of the energy; nothing if the run did not converge, or for more
/// than space::kMostSitesForMinimum sites.
std::optional<Minimum> minimum_of(const SpaceComputation& computation);

/// Optimises the sites; `nullopt` after a cancelled run.
std::optional<SpaceComputation> compute_space_job(const SpaceJob& job, const JobCallback& callback);

/// Lays out the cells as one tile, without their short edges, and proves it. Refuses no memory.
ProvedSpaceTile prove_space_tile(const SpaceJob& job, const SpaceComputation& computation,
                                 JobMonitor& monitor);

/// Returns the tile of a job, which must outlive the call.
using SpaceTileSource = std::function<const ProvedSpaceTile&(JobMonitor&)>;

/// Writes job.outputs. The summary of a cancelled call has Stop::kCancelled.
SpaceSummary write_space_job(const SpaceJob& job, const SpaceComputation& computation,
                             const SpaceTileSource& tile, const JobCallback& callback);

/// Returns the positions of the sites in the domain, as files hold them: 3 x n, length units.
space::Points wrapped_sites(const SpaceComputation& computation);

}  // namespace pcvt
