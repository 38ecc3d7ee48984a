#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "mesher/density/quadrature_batch.hpp"
#include "mesher/density/unwrapped_cells.hpp"

namespace pcvt {

/// Many cells that no break line crosses, each as the fan of the triangles between its site and its
/// sides, whose density is asked at once. The rules and, but for rounding, the moments are those of
/// CellQuadrature; here the work goes side by side through the cells of one order, and every
/// operation is done for many corners at once.
class FanBatch {
   public:
    /// @param probe       outlives this object; its points that wait are asked by the caller.
    /// @param from_frame  lattice coordinates by those in which corners are told.
    FanBatch(DensityProbe& probe, const Eigen::Matrix2d& from_frame);

    /// Cells added from here on have rules of q x q points.
    void begin_order(int q) { groups_.push_back({q, n_corners_, cells_.size(), 0}); }
    /// Adds cell k of the list.
    /// @param site    its site, lattice coordinates in [0, 1).
    /// @param number  under which its moments are wanted.
    void add(const CellList& cells, std::size_t k, const Vec2& site, int number);
    /// Has the points of all cells of this order wait in the probe.
    void end_order();
    /// Sets the moments of the cells and empties the batch.
    /// @param rho  what the probe gave for all the points that waited.
    void take(std::span<const double> rho, std::vector<Moments>& moments);

   private:
    /// Cells of one order.
    struct Group {
        int q;
        int first_corner;
        std::size_t first_cell;
        std::size_t first_point;
    };
    struct Cell {
        int n_corners;
        int number;
        /// The site, as a point.
        DensityPoint origin;
    };

    void make_room(int n_corners);

    DensityProbe& probe_;
    /// The vectors of the frame as changes of a density's point.
    DensityPoint along_x_;
    DensityPoint along_y_;
    std::vector<Group> groups_;
    std::vector<Cell> cells_;
    int n_corners_ = 0;
    /// For each corner the one before it and itself, relative to the site; and what the triangle
    /// between them gives. Some numbers are left over at the end.
    std::vector<double> from_x_, from_y_, to_x_, to_y_;
    std::vector<double> mass_, first_x_, first_y_, second_;
};

}  // namespace pcvt
