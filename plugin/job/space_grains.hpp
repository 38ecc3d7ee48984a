#pragma once

#include "mesher/space/mesh/tetrahedral_mesh.hpp"
#include "mesher/space/tessellation/tessellation.hpp"
#include "plugin/job/job.hpp"
#include "plugin/job/job_progress.hpp"
#include "plugin/job/run_summary.hpp"

namespace pcvt {

/// Tetrahedra inside of the cells of a run, and their figures.
struct SpaceGrains {
    space::TetrahedralMesh tetrahedra;
    SpaceGrainFigures figures;
};

/// Fills the cells of a run with tetrahedra of the size that the job states, without the short
/// edges that it removes.
SpaceGrains build_space_grains(const Job& job, const space::Tessellation& cells,
                               JobMonitor& monitor);

}  // namespace pcvt
