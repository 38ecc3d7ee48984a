#include "mesher/finite_volume/mpas_tables_proof.hpp"

#include <algorithm>
#include <cstdint>
#include <string>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/law_violation.hpp"

namespace pcvt {
namespace {

using std::to_string;

const char* const kTables = "(1) of C-grids, tables";

void require_range(const std::vector<int>& table, int size, const char* name) {
    for (const int index : table) {
        if (index >= -1 && index < size) continue;
        throw_violation(kTables, std::string(name) + " holds " + to_string(index + 1) +
                                     ", counted from 1; there are " + to_string(size));
    }
}

void require_counts(const MpasGrid& g) {
    if (g.n_edges != 3 * std::int64_t{g.n_cells} || g.n_vertices != 2 * std::int64_t{g.n_cells}) {
        throw_violation(kTables, to_string(g.n_cells) + " cells, " + to_string(g.n_edges) +
                                     " edges and " + to_string(g.n_vertices) +
                                     " vertices are not a torus of triangles");
    }
    require_range(g.cells_on_cell, g.n_cells, "cellsOnCell");
    require_range(g.edges_on_cell, g.n_edges, "edgesOnCell");
    require_range(g.vertices_on_cell, g.n_vertices, "verticesOnCell");
    require_range(g.cells_on_edge, g.n_cells, "cellsOnEdge");
    require_range(g.vertices_on_edge, g.n_vertices, "verticesOnEdge");
    require_range(g.edges_on_edge, g.n_edges, "edgesOnEdge");
    require_range(g.cells_on_vertex, g.n_cells, "cellsOnVertex");
    require_range(g.edges_on_vertex, g.n_edges, "edgesOnVertex");
    for (const auto* full :
         {&g.cells_on_edge, &g.vertices_on_edge, &g.cells_on_vertex, &g.edges_on_vertex}) {
        if (std::find(full->begin(), full->end(), -1) != full->end()) {
            throw_violation(kTables, "a row of an edge or a vertex is not filled");
        }
    }
}

/// Checks that cell i is one cell of its edge j, that its neighbour j is the other, and that its
/// vertex j is the end of the edge.
void require_cells(const MpasGrid& g, const MpasRows& rows) {
    for (int i = 0; i < g.n_cells; ++i) {
        checkpoint_each(i);
        // Check the number of edges.
        const int n = g.n_edges_on_cell[i];
        if (n < 3 || n > g.max_edges)
            throw_violation(kTables, "cell " + to_string(i) + " lacks edges");
        // Check each entry of the row; unused entries are negative.
        for (int j = 0; j < g.max_edges; ++j) {
            const int e = rows.entry(g.edges_on_cell, i, g.max_edges, j);
            const int across = rows.entry(g.cells_on_cell, i, g.max_edges, j);
            const int end = rows.entry(g.vertices_on_cell, i, g.max_edges, j);
            if (j >= n && e < 0 && across < 0 && end < 0) continue;
            if (j < n && e >= 0) {
                const int side = rows.cell_of_edge(e, 0) == i ? 0 : 1;
                const int after = rows.edge_of_cell(i, j + 1);
                const int side_after = after >= 0 && rows.cell_of_edge(after, 0) == i ? 0 : 1;
                if (rows.cell_of_edge(e, side) == i && rows.cell_of_edge(e, 1 - side) == across &&
                    rows.vertex_of_edge(e, 1 - side) == end && after >= 0 &&
                    rows.vertex_of_edge(after, side_after) == end) {
                    continue;
                }
            }
            throw_violation(kTables, "entry " + to_string(j) + " of cell " + to_string(i) +
                                         " does not agree with its edge");
        }
    }
}

/// Checks that each edge occurs once in each of its two cells.
void require_edges(const MpasGrid& g, const MpasRows& rows) {
    std::int64_t sum = 0;
    for (const int n : g.n_edges_on_cell) sum += n;
    if (sum != 2 * std::int64_t{g.n_edges}) {
        throw_violation(kTables, "the cells have " + to_string(sum) + " sides, not two per edge");
    }
    for (int e = 0; e < g.n_edges; ++e) {
        checkpoint_each(e);
        for (const int k : {0, 1}) {
            const int i = rows.cell_of_edge(e, k);
            if (rows.column_of_edge(i, e) < g.n_edges_on_cell[i] &&
                rows.cell_of_edge(e, 0) != rows.cell_of_edge(e, 1)) {
                continue;
            }
            throw_violation(kTables,
                            "edge " + to_string(e) + " is not a side of cell " + to_string(i));
        }
    }
}

void require_vertices(const MpasGrid& g, const MpasRows& rows) {
    for (int v = 0; v < g.n_vertices; ++v) {
        checkpoint_each(v);
        for (int k = 0; k < 3; ++k) {
            const int e = rows.entry(g.edges_on_vertex, v, 3, k);
            const int after = rows.entry(g.edges_on_vertex, v, 3, (k + 1) % 3);
            const int i = rows.entry(g.cells_on_vertex, v, 3, k);
            const int side = rows.vertex_of_edge(e, 0) == v ? 0 : 1;
            const int side_after = rows.vertex_of_edge(after, 0) == v ? 0 : 1;
            if (e != after && rows.vertex_of_edge(e, side) == v &&
                rows.vertex_of_edge(after, side_after) == v && rows.cell_of_edge(e, side) == i &&
                rows.cell_of_edge(after, 1 - side_after) == i) {
                continue;
            }
            throw_violation(kTables, "entry " + to_string(k) + " of vertex " + to_string(v) +
                                         " does not agree with its edges");
        }
    }
}

void require_edges_on_edges(const MpasGrid& g, const MpasRows& rows) {
    const int width = 2 * g.max_edges;
    for (int e = 0; e < g.n_edges; ++e) {
        checkpoint_each(e);
        int column = 0;
        bool agree = true;
        for (const int k : {0, 1}) {
            const int i = rows.cell_of_edge(e, k);
            const int begin = rows.column_of_edge(i, e);
            for (int j = 1; j < g.n_edges_on_cell[i]; ++j, ++column) {
                agree = agree && rows.entry(g.edges_on_edge, e, width, column) ==
                                     rows.edge_of_cell(i, begin + j);
            }
        }
        // Unused entries are -1, their weights 0.
        for (int k = column; k < width; ++k) {
            agree = agree && rows.entry(g.edges_on_edge, e, width, k) == -1 &&
                    g.weights_on_edge[std::size_t(e) * width + k] == 0;
        }
        if (agree && column == g.n_edges_on_edge[e]) continue;
        throw_violation(kTables,
                        "the edges on edge " + to_string(e) + " do not run around its two cells");
    }
}

}  // namespace

void prove_mpas_tables(const MpasGrid& grid, const MpasRows& rows) {
    require_counts(grid);
    require_cells(grid, rows);
    require_edges(grid, rows);
    require_vertices(grid, rows);
    require_edges_on_edges(grid, rows);
}

}  // namespace pcvt
