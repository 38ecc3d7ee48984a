#include "io/mpas/mpas_graph.hpp"

namespace pcvt {

std::string encode_mpas_graph(const MpasGrid& grid) {
    std::string text = std::to_string(grid.n_cells) + " " + std::to_string(grid.n_edges) + "\n";
    for (int cell = 0; cell < grid.n_cells; ++cell) {
        const int begin = cell * grid.max_edges;
        for (int k = begin; k < begin + grid.n_edges_on_cell[cell]; ++k) {
            if (k > begin) text += " ";
            text += std::to_string(grid.cells_on_cell[k] + 1);
        }
        text += "\n";
    }
    return text;
}

}  // namespace pcvt
