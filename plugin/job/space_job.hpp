#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/bytes/output_error.hpp"
#include "io/formats/space_format.hpp"
#include "mesher/cvt/run_options.hpp"
#include "mesher/space/cvt/cvt.hpp"
#include "mesher/space/cvt/minimum.hpp"
#include "mesher/space/mesh/short_edges.hpp"
#include "mesher/space/proof/polyhedral_proof.hpp"
#include "mesher/space/search/lattice_stability.hpp"
#include "mesher/torus/coincident_sites.hpp"
#include "plugin/job/job.hpp"

namespace pcvt {

/// The optimised sites of a job, from which its tile and its files are made.
struct SpaceComputation {
    space::CvtResult cvt;
    /// Of a run that began at a lattice.
    std::optional<PatternOutcome<space::LatticePattern>> pattern = {};
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
    std::optional<PatternOutcome<space::LatticePattern>> pattern = {};
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
SpaceSummary run_space_job(const Job& job, const JobCallback& callback);

// The steps of run_space_job one by one, for a host that keeps the result in memory; errors as
// there.

/// The energy of as many truncated octahedra as the job has sites, length^5.
double energy_bound(const Job& job);

/// Whether the sites are a minimum of the energy; nothing if the run did not converge, or for more
/// than space::kMostSitesForMinimum sites.
std::optional<Minimum> minimum_of(const SpaceComputation& computation);

/// Optimises the sites; `nullopt` after a cancelled run.
std::optional<SpaceComputation> compute_space_job(const Job& job, const JobCallback& callback);

/// Lays out the cells as one tile, without their short edges, and proves it. Refuses no memory.
ProvedSpaceTile prove_space_tile(const Job& job, const SpaceComputation& computation,
                                 JobMonitor& monitor);

/// Returns the tile of a job, which must outlive the call.
using SpaceTileSource = std::function<const ProvedSpaceTile&(JobMonitor&)>;

/// Writes job.outputs. The summary of a cancelled call has Stop::kCancelled.
SpaceSummary write_space_job(const Job& job, const SpaceComputation& computation,
                             const SpaceTileSource& tile, const JobCallback& callback);

/// Returns the positions of the sites in the domain, as files hold them: 3 x n, length units.
space::Points wrapped_sites(const SpaceComputation& computation);

}  // namespace pcvt
