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

}  // namespace pcvt
