#include "io/mpas/mpas_graph.hpp"

#include "io/bytes/file_fields.hpp"
#include "io/bytes/text.hpp"

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

namespace {

/// The words of a graph, line by line.
FileFields graph_fields(const std::string& path, const std::string& text) {
    FileFields fields{.name = path};
    LineScanner scanner(path, text);
    while (scanner.next()) {
        std::vector<FileWord>& row = fields.parts["line " + std::to_string(scanner.line())];
        for (const std::string_view word : scanner.words()) row.push_back({word, scanner.line()});
    }
    return fields;
}

}  // namespace

void compare_mpas_graph(const MpasGrid& grid, const std::string& path, const std::string& bytes) {
    const std::string expected = encode_mpas_graph(grid);
    if (bytes == expected) return;
    compare_fields(graph_fields(path, bytes), graph_fields(path, expected));
}

}  // namespace pcvt
