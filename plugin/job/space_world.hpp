#pragma once

#include <vector>

#include "mesher/space/cvt/minimum.hpp"
#include "mesher/space/tessellation/tessellation.hpp"
#include "plugin/job/job_files.hpp"
#include "plugin/job/job_staging.hpp"
#include "plugin/job/run_job.hpp"
#include "plugin/job/space_tiles.hpp"
#include "plugin/job/stopwatch.hpp"

namespace pcvt {

/// What run_job() needs of space; members as those of PlaneWorld.
struct SpaceWorld {
    using Cells = space::Tessellation;
    using Tiles = ProvedSpaceTile;

    static void check_files(const Job& job, const std::vector<JobFile>& files,
                            const std::vector<std::string>& phases);
    static Computation<SpaceWorld> compute(const Job& job, JobMonitor& monitor, Stopwatch& watch);
    /// Refuses no memory.
    static Tiles build_tiles(const Job& job, const std::vector<JobFile>& files,
                             const Computation<SpaceWorld>& computation, JobMonitor& monitor);
    static FileContent content(const Job& job, const std::vector<JobFile>& files,
                               const Computation<SpaceWorld>& computation,
                               const TileSource<SpaceWorld>& tiles, JobMonitor& monitor,
                               RunSummary& summary);
};

}  // namespace pcvt
