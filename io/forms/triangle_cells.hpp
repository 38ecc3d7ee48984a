#pragma once

#include <vector>

#include "io/forms/solver_nodes.hpp"

namespace pcvt {

/// The cell of each triangle of a tile, distinguished from the images of that cell.
///
/// Example usage:
///     const TriangleCells cells(tile);
///     if (!cells.same(f, g)) boundary.push_back(edge_between(f, g));
///
/// A tile that was read from a file does not hold where the sites of its grains lie: images of a
/// grain inside of the tile count as one cell there.
class TriangleCells {
   public:
    /// @pre the faces of the tile are triangles.
    explicit TriangleCells(const plane::Tile& tile);

    /// As element_cells().
    SiteId site(int f) const { return sites_[f]; }
    const std::vector<SiteId>& sites() const { return sites_; }
    /// Where the site of the cell lies in the tile, length units.
    const plane::Vec2& site_point(int f) const { return site_points_[f]; }
    /// Whether two triangles lie in one cell.
    bool same(int f, int g) const {
        return sites_[f] == sites_[g] && same_place(site_points_[f], site_points_[g]);
    }
    /// Whether two positions of one site differ only by rounding.
    bool same_place(const plane::Vec2& p, const plane::Vec2& q) const {
        return (p - q).cwiseAbs().maxCoeff() <= rounding_;
    }

   private:
    std::vector<SiteId> sites_;
    std::vector<plane::Vec2> site_points_;
    double rounding_ = 0;
};

/// The nodes of a tile at which several cells meet, each list rising. Images of a cell count as
/// different cells. Laws, tested by number:
///   (1) The images of a node are in the same lists as the node.
///   (2) Each node of three cells is one of two cells as well.
struct CellContacts {
    std::vector<int> of_two_cells;
    std::vector<int> of_three_cells;
};

/// @param nodes  solver_nodes() of the tile.
CellContacts cell_contacts(const plane::Tile& tile, const SolverNodes& nodes,
                           const TriangleCells& cells);

}  // namespace pcvt
