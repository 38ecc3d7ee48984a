#pragma once

#include "mesher/cells/cell_table.hpp"
#include "mesher/plane/cvt/cvt.hpp"
#include "plugin/job/job.hpp"

namespace pcvt {

/// Checks the fixed sites and the inclusions of a job, if it has some, alone and against its other
/// choices.
/// @throws InvalidInput naming the file and the line of a shape.
void check_constraints(const Job& job);

/// Computes cells of which each lies inside of an inclusion or outside of all, and proves that.
///
/// Example usage:
///     if (job.inclusions) return compute_cells_with_inclusions(job, options);
///
/// @param options  as compute_interface_cvt() takes them.
/// @throws InvalidInput  there are too few sites for the shapes.
/// @throws InternalError  an outline is no edge of the cells: a fault of pcvt.
Tessellation compute_cells_with_inclusions(const Job& job, const plane::CvtOptions& options);

/// The tags of a run with inclusions as the phases of its cells, in the order matrix, 1, 2, ...,
/// without those of holes; one entry a site outside of holes.
CellMaterials tag_materials(const Tessellation& tessellation);

/// The names of the phases of a job, or of its tags outside of holes, as tag_materials() has them.
std::vector<std::string> file_phases(const Job& job);

/// One entry a tag, also of holes; wanted are the areas of the shapes.
/// @param cells  of all sites.
std::vector<PhaseFigures> tag_figures(const Tessellation& tessellation, const CellTable& cells);

}  // namespace pcvt
