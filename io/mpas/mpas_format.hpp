#pragma once

#include <string>
#include <vector>

#include "mesher/finite_volume/mpas_grid.hpp"

namespace pcvt {

/// The sizes of an MPAS mesh file; all but kOne are dimensions of it.
enum class MpasSize {
    kVoronoi,
    kEdges,
    kVertices,
    kMaxEdges,
    kMaxEdges2,
    kTwo,
    kVertexDegree,
    kOne
};

struct MpasDimension {
    const char* name;
    MpasSize size;
};
/// In the order in which they are defined; the unlimited `Time` is not among them.
const std::vector<MpasDimension>& mpas_dimensions();
int mpas_size(const MpasGrid& grid, MpasSize size);

/// A variable of the file and the table of MpasGrid that it holds; exactly one of `indices`,
/// `counts` and `numbers` is set. Indices count from 1 in the file, and 0 fills up.
struct MpasVariable {
    const char* name;
    MpasSize rows;
    /// kOne: the variable has one dimension.
    MpasSize columns;
    std::vector<int> MpasGrid::*indices = nullptr;
    std::vector<int> MpasGrid::*counts = nullptr;
    std::vector<double> MpasGrid::*numbers = nullptr;
};
const std::vector<MpasVariable>& mpas_variables();

}  // namespace pcvt
