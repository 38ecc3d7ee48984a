#pragma once

#include <map>
#include <optional>
#include <vector>

#include "io/forms/space_tile.hpp"
#include "mesher/space/mesh/tetrahedral_mesh.hpp"
#include "mesher/space/tessellation/tessellation.hpp"
#include "plugin/job/job.hpp"
#include "plugin/job/job_files.hpp"
#include "plugin/job/job_progress.hpp"
#include "plugin/job/run_summary.hpp"

namespace pcvt {

/// The tile of a job in space, proved, and its figures.
struct ProvedSpaceTile {
    SpaceTile tile;
    PolyhedraFigures figures = {};
    /// Cells by their number of faces.
    std::map<int, int> face_counts = {};
};

/// Builds and proves the tile of all periods of a job.
///
/// @param materials  those of the cells of one period.
/// @throws InvalidInput   measured grains whose cells doubles do not hold.
/// @throws InternalError  the tile breaks its laws: a fault of pcvt.
ProvedSpaceTile build_space_tile(const Job& job, const space::Tessellation& one_period,
                                 const CellMaterials& materials, JobMonitor& monitor);

/// Returns the tetrahedra of all periods if a file holds them or the job fills its cells, and adds
/// their figures to the summary.
/// @throws InvalidInput  a Delaunay tetrahedron is flat.
std::optional<space::TetrahedralMesh> build_tetrahedra(const Job& job,
                                                       const space::Tessellation& one_period,
                                                       const std::vector<JobFile>& files,
                                                       JobMonitor& monitor, RunSummary& summary);

}  // namespace pcvt
