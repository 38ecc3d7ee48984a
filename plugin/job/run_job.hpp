#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "mesher/cells/cell_materials.hpp"
#include "plugin/job/job.hpp"
#include "plugin/job/job_progress.hpp"
#include "plugin/job/run_summary.hpp"

namespace pcvt {

struct PlaneWorld;
struct SpaceWorld;

/// The cells of a job, from which its tiles and files are made.
/// @tparam World  PlaneWorld (plane_world.hpp) or SpaceWorld (space_world.hpp).
template <class World>
struct Computation {
    typename World::Cells cells;
    StartFigures start = {};
    /// rho at each site outside of holes; empty without a density.
    std::vector<double> site_densities = {};
    /// Materials of the sites outside of holes; empty without phases and orientations.
    CellMaterials materials = {};
    std::vector<PhaseFigures> phases = {};
    /// Seconds of the computation, without tiles and files.
    JobSeconds seconds = {};
};

/// Sites -> optimised periodic tessellation -> proved tiles -> files that are read back and proved
/// again. Prints nothing. Either all files appear, together at the end, or none; only files whose
/// single precision does not hold the tile are left out (RunSummary::refused).
///
/// Example usage:
///   Job job;
///   job.n_sites = 300;
///   job.outputs = {"tile.obj"};
///   const RunSummary summary = run_job(job, {});
///
/// @throws InvalidInput   the job is wrong. Thrown before any computation, except for coincident
///                        sites (DuplicateSites names the ids).
/// @throws UnsuitableCells  an output refuses the cells, also after all retries.
/// @throws OutputError    a file cannot be written, or exists and `force` is not set.
/// @throws LimitExceeded  too many sites or faces, or more memory than is available.
/// @throws InternalError  a tile breaks its laws: a fault of pcvt.
RunSummary run_job(const Job& job, const JobCallback& callback);

// The steps of run_job one by one, for a host that keeps the result in memory; errors as there.

/// Computes the cells; `nullopt` after a cancelled run.
template <class World>
std::optional<Computation<World>> compute_job(const Job& job, const JobCallback& callback);

/// Makes the tiles of a job, proved, one for each of job.meshes; they must outlive the call. May be
/// empty if no output is a tile.
template <class World>
using TileSource = std::function<const typename World::Tiles&(JobMonitor&)>;

/// Writes job.outputs and job.report. The summary of a cancelled call has Stop::kCancelled.
template <class World>
RunSummary write_job(const Job& job, const Computation<World>& computation,
                     const TileSource<World>& tiles, const JobCallback& callback);

/// The energy of as many regular hexagons as the job has sites, or in space of truncated octahedra.
double energy_bound(const Job& job);

}  // namespace pcvt
