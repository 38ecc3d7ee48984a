#pragma once

#include <vector>

#include "plugin/job/job_files.hpp"
#include "plugin/job/job_staging.hpp"
#include "plugin/job/run_job.hpp"
#include "plugin/job/stopwatch.hpp"

namespace pcvt {

/// What run_job() needs of the plane.
///
/// Example usage:
///   const std::optional<Computation<PlaneWorld>> computed = compute_job<PlaneWorld>(job, {});
struct PlaneWorld {
    using Cells = plane::Tessellation;
    using Tiles = std::vector<plane::BuiltTile>;

    /// Requires that the files take the choices of the job.
    /// @param phases  the names of the phases of its cells.
    static void check_files(const Job& job, const std::vector<JobFile>& files,
                            const std::vector<std::string>& phases);
    static Computation<PlaneWorld> compute(const Job& job, JobMonitor& monitor, Stopwatch& watch);
    /// The tiles of a job, proved; none if it needs none.
    static Tiles build_tiles(const Job& job, const std::vector<JobFile>& files,
                             const Computation<PlaneWorld>& computation, JobMonitor& monitor);
    /// The content of the files; adds the figures of cells and tiles to `summary`.
    static FileContent content(const Job& job, const std::vector<JobFile>& files,
                               const Computation<PlaneWorld>& computation,
                               const TileSource<PlaneWorld>& tiles, JobMonitor& monitor,
                               RunSummary& summary);
};

}  // namespace pcvt
