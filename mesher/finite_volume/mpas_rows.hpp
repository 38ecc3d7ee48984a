#pragma once

#include <cmath>
#include <vector>

#include "mesher/finite_volume/mpas_grid.hpp"

namespace pcvt {

/// Access to the rows of the tables of a grid and to the nearest images of its points.
///
/// Example usage:
///     const MpasRows rows(grid);
///     const Vec2 along = rows.between(rows.vertex(v), rows.vertex(w));
class MpasRows {
   public:
    explicit MpasRows(const MpasGrid& grid) : g_(grid) {}

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
    plane::Vec2 cell(int i) const { return {g_.x_cell[i], g_.y_cell[i]}; }
    plane::Vec2 edge(int e) const { return {g_.x_edge[e], g_.y_edge[e]}; }
    plane::Vec2 vertex(int v) const { return {g_.x_vertex[v], g_.y_vertex[v]}; }
    /// Returns to - from for the nearest image of `to`.
    plane::Vec2 between(const plane::Vec2& from, const plane::Vec2& to) const {
        const plane::Vec2 d = to - from;
        return {d.x() - std::round(d.x() / g_.x_period) * g_.x_period,
                d.y() - std::round(d.y() / g_.y_period) * g_.y_period};
    }

   private:
    const MpasGrid& g_;
};

}  // namespace pcvt
