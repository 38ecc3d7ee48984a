#include "mesher/finite_volume/mpas_grid_proof.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <string>

#include "mesher/lattice/polygon.hpp"
#include "mesher/proof/law_violation.hpp"

namespace pcvt {
namespace {

using std::to_string;

const char* const kTables = "(1) of C-grids, tables";
const char* const kGeometry = "(2) of C-grids, geometry";
const char* const kAreas = "(3) of C-grids, areas";
const char* const kTrisk = "(4) of C-grids, TRiSK";

constexpr double kTolerance = 1e-12;
constexpr double kGeometryTolerance = 1e-10;
/// Bounds the rounding errors of a coordinate that is wrapped, halved and subtracted, in ulps.
constexpr double kUlps = 16;

/// Access to the rows of the tables and to the nearest images of the points.
class Rows {
   public:
    explicit Rows(const MpasGrid& grid) : g_(grid) {}

    int entry(const std::vector<int>& table, int row, int width, int column) const {
        return table[static_cast<std::size_t>(row) * width + column];
    }
    int cell_of_edge(int e, int k) const { return g_.cells_on_edge[2 * std::size_t(e) + k]; }
    int vertex_of_edge(int e, int k) const { return g_.vertices_on_edge[2 * std::size_t(e) + k]; }
    /// Returns edge j of cell i; j counts cyclically around the cell.
    int edge_of_cell(int i, int j) const {
        return entry(g_.edges_on_cell, i, g_.max_edges, j % g_.n_edges_on_cell[i]);
    }
    int column_of_edge(int i, int e) const {
        int j = 0;
        while (j < g_.n_edges_on_cell[i] && edge_of_cell(i, j) != e) ++j;
        return j;
    }
    Vec2 cell(int i) const { return {g_.x_cell[i], g_.y_cell[i]}; }
    Vec2 edge(int e) const { return {g_.x_edge[e], g_.y_edge[e]}; }
    Vec2 vertex(int v) const { return {g_.x_vertex[v], g_.y_vertex[v]}; }
    /// Returns to - from for the nearest image of `to`.
    Vec2 between(const Vec2& from, const Vec2& to) const {
        const Vec2 d = to - from;
        return {d.x() - std::round(d.x() / g_.x_period) * g_.x_period,
                d.y() - std::round(d.y() / g_.y_period) * g_.y_period};
    }

   private:
    const MpasGrid& g_;
};

void require_range(const std::vector<int>& table, int size, const char* name) {
    for (const int index : table) {
        if (index >= -1 && index < size) continue;
        throw_violation(kTables, std::string(name) + " holds " + to_string(index + 1) +
                                     ", counted from 1; there are " + to_string(size));
    }
}

void require_finite_numbers(const MpasGrid& g) {
    for (const auto* table :
         {&g.x_cell, &g.y_cell, &g.x_edge, &g.y_edge, &g.x_vertex, &g.y_vertex, &g.weights_on_edge,
          &g.kite_areas_on_vertex, &g.area_cell, &g.area_triangle, &g.dc_edge, &g.dv_edge,
          &g.angle_edge, &g.mesh_density}) {
        for (const double number : *table) {
            if (!std::isfinite(number)) throw_violation(kGeometry, "a number is not finite");
        }
    }
    if (!(g.x_period > 0 && g.y_period > 0 && std::isfinite(g.x_period * g.y_period))) {
        throw_violation(kGeometry, "a period is not positive");
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
void require_cells(const MpasGrid& g, const Rows& rows) {
    for (int i = 0; i < g.n_cells; ++i) {
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
void require_edges(const MpasGrid& g, const Rows& rows) {
    std::int64_t sum = 0;
    for (const int n : g.n_edges_on_cell) sum += n;
    if (sum != 2 * std::int64_t{g.n_edges}) {
        throw_violation(kTables, "the cells have " + to_string(sum) + " sides, not two per edge");
    }
    for (int e = 0; e < g.n_edges; ++e) {
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

void require_vertices(const MpasGrid& g, const Rows& rows) {
    for (int v = 0; v < g.n_vertices; ++v) {
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

void require_edges_on_edges(const MpasGrid& g, const Rows& rows) {
    const int width = 2 * g.max_edges;
    for (int e = 0; e < g.n_edges; ++e) {
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
        if (agree && column == g.n_edges_on_edge[e]) continue;
        throw_violation(kTables,
                        "the edges on edge " + to_string(e) + " do not run around its two cells");
    }
}

double angle_between(double a, double b) {
    return std::abs(std::remainder(a - b, 2 * std::numbers::pi));
}

/// Returns the largest deviation of the stored geometry of edge e from its cells and vertices, a
/// length.
double edge_deviation(const MpasGrid& g, const Rows& rows, int e) {
    const Vec2 here = rows.cell(rows.cell_of_edge(e, 0));
    const Vec2 normal = rows.between(here, rows.cell(rows.cell_of_edge(e, 1)));
    const Vec2 start = rows.vertex(rows.vertex_of_edge(e, 0));
    const Vec2 tangent = rows.between(start, rows.vertex(rows.vertex_of_edge(e, 1)));
    const Vec2 unit = normal.normalized();
    const double turned = cross(unit, tangent);
    return std::max(
        {std::abs(normal.norm() - g.dc_edge[e]), std::abs(turned - g.dv_edge[e]),
         std::abs(unit.dot(tangent)),
         angle_between(std::atan2(normal.y(), normal.x()), g.angle_edge[e]) * normal.norm(),
         rows.between(Vec2(here + normal / 2), rows.edge(e)).norm(),
         std::abs(unit.dot(rows.between(rows.edge(e), start)))});
}

double require_geometry(const MpasGrid& g, const Rows& rows, double h) {
    double largest = std::max(g.x_period, g.y_period);
    for (const auto* points : {&g.x_cell, &g.y_cell, &g.x_vertex, &g.y_vertex}) {
        for (const double x : *points) largest = std::max(largest, std::abs(x));
    }
    const double allowed =
        kGeometryTolerance + kUlps * std::numeric_limits<double>::epsilon() * largest / h;
    double worst = 0;
    for (int e = 0; e < g.n_edges; ++e) {
        const double deviation = edge_deviation(g, rows, e) / h;
        if (!(deviation <= allowed)) {
            throw_violation(kGeometry, "edge " + to_string(e) + " is off by " +
                                           in_words(deviation) + " h from its cells and vertices");
        }
        worst = std::max(worst, deviation);
    }
    return worst;
}

double require_areas(const MpasGrid& g, const Rows& rows, double h) {
    std::vector<double> cells(g.area_cell.size(), 0);
    double worst = 0;
    double total = 0;
    const auto compare = [&](double found, double stated, double unit, const std::string& what) {
        const double deviation = std::abs(found - stated) / unit;
        if (!(deviation <= kTolerance)) {
            throw_violation(
                kAreas, "the kites of " + what + " differ from its area by " + in_words(deviation));
        }
        worst = std::max(worst, deviation);
    };
    // Compare the kites of each vertex with its triangle, and sum them over the cells.
    for (int v = 0; v < g.n_vertices; ++v) {
        double sum = 0;
        for (int k = 0; k < 3; ++k) {
            const double kite = g.kite_areas_on_vertex[3 * std::size_t(v) + k];
            if (!(kite > 0))
                throw_violation(kAreas, "a kite of vertex " + to_string(v) + " is not positive");
            sum += kite;
            cells[rows.entry(g.cells_on_vertex, v, 3, k)] += kite;
        }
        compare(sum, g.area_triangle[v], h * h, "vertex " + to_string(v));
    }
    // Compare the sums with the areas of the cells and of the domain.
    for (int i = 0; i < g.n_cells; ++i) {
        compare(cells[i], g.area_cell[i], h * h, "cell " + to_string(i));
        total += cells[i];
    }
    compare(total, g.x_period * g.y_period, g.x_period * g.y_period, "all cells");
    return worst;
}

/// Returns random normal velocities between -1 and 1, equal on every machine.
std::vector<double> random_velocities(int n) {
    std::mt19937 random(1);
    std::vector<double> u(static_cast<std::size_t>(n));
    for (double& speed : u) speed = static_cast<double>(random()) * 0x1p-31 - 1;
    return u;
}

double require_trisk(const MpasGrid& g, const Rows& rows, double h) {
    // Sum the divergence of u in the cells and the outflow of v from the triangles.
    const std::vector<double> u = random_velocities(g.n_edges);
    std::vector<double> divergence(static_cast<std::size_t>(g.n_cells), 0);
    std::vector<double> outflow(static_cast<std::size_t>(g.n_vertices), 0);
    for (int e = 0; e < g.n_edges; ++e) {
        divergence[rows.cell_of_edge(e, 0)] += g.dv_edge[e] * u[e];
        divergence[rows.cell_of_edge(e, 1)] -= g.dv_edge[e] * u[e];
        double v = 0;
        const std::size_t row = 2 * static_cast<std::size_t>(g.max_edges) * e;
        for (int k = 0; k < g.n_edges_on_edge[e]; ++k) {
            v += g.weights_on_edge[row + k] * u[g.edges_on_edge[row + k]];
        }
        outflow[rows.vertex_of_edge(e, 0)] += g.dc_edge[e] * v;
        outflow[rows.vertex_of_edge(e, 1)] -= g.dc_edge[e] * v;
    }
    // Compare both sides of the identity at each vertex.
    double worst = 0;
    for (int v = 0; v < g.n_vertices; ++v) {
        double wanted = 0;
        for (int k = 0; k < 3; ++k) {
            const int i = rows.entry(g.cells_on_vertex, v, 3, k);
            wanted +=
                g.kite_areas_on_vertex[3 * std::size_t(v) + k] / g.area_cell[i] * divergence[i];
        }
        const double deviation = std::abs(outflow[v] - wanted) / h;
        if (!(deviation <= kTolerance)) {
            throw_violation(kTrisk, "at vertex " + to_string(v) + " the identity fails by " +
                                        in_words(deviation));
        }
        worst = std::max(worst, deviation);
    }
    return worst;
}

}  // namespace

MpasGridProof prove_mpas_grid(const MpasGrid& grid) {
    const Rows rows(grid);
    require_finite_numbers(grid);
    require_counts(grid);
    require_cells(grid, rows);
    require_edges(grid, rows);
    require_vertices(grid, rows);
    require_edges_on_edges(grid, rows);
    const double h = std::sqrt(grid.x_period * grid.y_period / grid.n_cells);
    MpasGridProof proof{};
    proof.geometry = require_geometry(grid, rows, h);
    proof.areas = require_areas(grid, rows, h);
    proof.trisk = require_trisk(grid, rows, h);
    return proof;
}

}  // namespace pcvt
