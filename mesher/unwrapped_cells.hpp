#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesher/cell_batch.hpp"
#include "mesher/moving_delaunay.hpp"
#include "mesher/workers.hpp"

namespace pcvt {

/// Cells one after the other.
struct CellList {
    std::vector<CellCorner> corners;
    /// For each corner the halfedge that leaves the cell's site in the triangle whose centre it is:
    /// the side that ends in the corner belongs to that halfedge.
    std::vector<int> halfedges;
    /// Of the corners, and at the end their number.
    std::vector<int> begin;

    CellView operator[](std::size_t k) const {
        return {corners.data() + begin[k], std::size_t(begin[k + 1] - begin[k])};
    }
};

/// The Voronoi cells of sites that move, each unwrapped round its site: in the frame and the unit
/// of the triangulation, and in lattice coordinates of the user's basis.
class UnwrappedCells {
   public:
    /// Both must outlive this object.
    UnwrappedCells(const MovingDelaunay& delaunay, Workers& workers, const Lattice& lattice);

    /// Looks where the cells are now; the triangulation must be restored.
    void locate();

    /// Lattice coordinates of the user's basis, not wrapped.
    Vec2 site(SiteId site) const { return from_reduced_ * delaunay_.coordinates().col(site); }
    /// Makes `cells` those of the sites.
    void unwrap(std::span<const SiteId> sites, CellList& cells) const;
    /// From the site that h leaves to the image that it leads to; frame, units.
    Vec2 edge(int h) const { return centre_[h] - centre_[TorusTriangulation::next(h)]; }

   private:
    void locate_centre(int triangle);

    const MovingDelaunay& delaunay_;
    Workers& workers_;
    /// Lattice coordinates of the user's basis by those of the reduced one, and by the frame.
    Eigen::Matrix2d from_reduced_;
    Eigen::Matrix2d from_frame_;
    /// For each site a halfedge that leaves it, found after so many flips and rebuilds.
    std::vector<int> leaving_;
    std::int64_t n_flips_ = -1;
    int n_rebuilds_ = -1;
    /// For each halfedge the circumcentre of its triangle relative to the site that it leaves;
    /// frame, units.
    std::vector<Vec2> centre_;
};

}  // namespace pcvt
