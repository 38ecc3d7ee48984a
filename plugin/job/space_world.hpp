#pragma once

#include <map>
#include <vector>

#include "io/forms/space_tile.hpp"
#include "mesher/space/cvt/minimum.hpp"
#include "mesher/space/tessellation/tessellation.hpp"
#include "plugin/job/job_files.hpp"
#include "plugin/job/job_staging.hpp"
#include "plugin/job/run_job.hpp"
#include "plugin/job/stopwatch.hpp"

namespace pcvt {

/// The tile of a job in space, proved, and its figures.
struct ProvedSpaceTile {
    SpaceTile tile;
    PolyhedraFigures figures = {};
    /// Cells by their number of faces.
    std::map<int, int> face_counts = {};
};

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
