#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "mesher/plane/density/quadrature_batch.hpp"
#include "mesher/plane/density/unwrapped_cells.hpp"

namespace pcvt::plane {

/// Integrates over many cells that no break line crosses, each as the fan of triangles between its
/// site and its sides, with one evaluation of the density. Uses the rules of CellQuadrature and
/// computes the same moments up to rounding; here all cells of one order are processed together,
/// and every operation covers many corners at once.
class FanBatch {
   public:
    /// @param probe       must outlive this object; the caller evaluates its reserved points.
    /// @param from_frame  the matrix from the corners' coordinates to lattice coordinates.
    FanBatch(DensityProbe& probe, const Eigen::Matrix2d& from_frame);

    /// Begins an order: the cells added next have rules of q x q points.
    void begin_order(int q) { groups_.push_back({q, n_corners_, cells_.size(), 0, 0}); }
    /// Adds cell k of the list.
    /// @param site    its site, lattice coordinates in [0, 1).
    /// @param number  the index of its moments in the result.
    void add(const CellList& cells, std::size_t k, const Vec2& site, int number);
    /// Ends an order: reserves the points of all its cells in the probe.
    void end_order();
    /// Computes the moments of the cells and empties the batch.
    /// @param rho        the probe's result for all reserved points.
    /// @param n_columns  those of them that were reserved by columns, at the end.
    void take(std::span<const double> rho, std::size_t n_columns, std::vector<Moments>& moments);

   private:
    /// Cells of one order.
    struct Group {
        int q;
        int first_corner;
        std::size_t first_cell;
        /// Among the points that were reserved alike.
        std::size_t first_point;
        /// The number of points from the first point of the triangles to the second one.
        int stride;
    };
    struct Cell {
        int n_corners;
        int number;
        /// The site, as a point.
        DensityPoint origin;
    };

    void make_room(int n_corners);
    void place_points(Group& group, int n_corners);
    void place_columns(Group& group, int n_corners);

    DensityProbe& probe_;
    /// The unit vectors of the frame as changes of a DensityPoint.
    DensityPoint along_x_;
    DensityPoint along_y_;
    std::vector<Group> groups_;
    std::vector<Cell> cells_;
    int n_corners_ = 0;
    /// For each corner its predecessor and itself, relative to the site, and the moments of the
    /// triangle between them. The arrays are longer than the number of corners.
    std::vector<double> from_x_, from_y_, to_x_, to_y_;
    std::vector<double> mass_, first_x_, first_y_, second_;
    /// For each corner of a group one coordinate of the site.
    std::vector<double> origin_;
};

}  // namespace pcvt::plane
