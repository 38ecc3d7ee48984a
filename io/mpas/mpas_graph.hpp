#pragma once

#include <string>

#include "mesher/finite_volume/mpas_grid.hpp"

namespace pcvt {

/// Encodes the graph of the cells for METIS, which cuts it into the parts that the processes of a
/// model take: the numbers of cells and edges, and then for each cell a line of its neighbours,
/// counted from 1.
///
///   output.stage("mesh.graph.info", encode_mpas_graph(grid));   // gpmetis mesh.graph.info 16
std::string encode_mpas_graph(const MpasGrid& grid);

/// Requires that the file `path` holds this graph.
/// @pre prove_mpas_grid() accepts the grid.
/// @throws BadFile  naming the first line that differs.
void compare_mpas_graph(const MpasGrid& grid, const std::string& path, const std::string& bytes);

}  // namespace pcvt
