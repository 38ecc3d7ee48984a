#pragma once

#include <vector>

#include "mesher/base/site_id.hpp"

namespace pcvt {

/// The adjacency of the cells. Entries row_begin[i] ... row_begin[i + 1] - 1 belong to the edges of
/// cell i; a neighbour may occur more than once, and edges between images of one site are left out.
struct CellGraph {
    std::vector<int> row_begin;
    std::vector<SiteId> neighbour;
    /// -dm_i / dw_j, how much of its mass cell i loses to cell j for each unit of the weight of j:
    /// the length or area of their common side over twice the distance of the two sites. Never
    /// negative; the same bits in both rows.
    std::vector<double> conductance;

    int n_rows() const { return static_cast<int>(row_begin.size()) - 1; }
};

}  // namespace pcvt
