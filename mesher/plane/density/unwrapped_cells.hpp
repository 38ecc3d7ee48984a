#pragma once

#include <span>
#include <vector>

#include "mesher/plane/density/quadrature_batch.hpp"
#include "mesher/plane/density/site_rings.hpp"

namespace pcvt::plane {

/// A list of cells; each array holds one number per corner. Side c of a cell ends at its corner c,
/// and corners run counter-clockwise.
struct CellList {
    /// The neighbour across the side.
    std::vector<SiteId> neighbours;
    /// That neighbour and the next one round the site, relative to the site; reduced basis. The
    /// corner is the circumcentre of the three sites.
    std::vector<double> to_u, to_v, next_u, next_v;
    /// The corner relative to the site; frame, units.
    std::vector<double> x, y;
    /// The same in lattice coordinates of the user's basis.
    std::vector<double> u, v;
    /// Positive where the triangle of the three sites is not thin.
    std::vector<double> thick;
    /// The first corner of each cell, followed by the number of corners.
    std::vector<int> begin;

    /// The bounding box of cell k with its site at `site`, extended by a margin; lattice
    /// coordinates.
    LatticeBox box(std::size_t k, const Vec2& site, double margin) const;
    /// Copies cell k, with its site at `site`, to `polygon`.
    void copy(std::size_t k, const Vec2& site, CellPolygon& polygon) const;
    /// Resizes the arrays to n_corners and kLanes more.
    void make_room(int n_corners);
};

/// The Voronoi cells of moving sites, each unwrapped round its site, in the frame and unit of the
/// triangulation and in lattice coordinates of the user's basis.
///
/// Example usage:
///
///     UnwrappedCells cells(delaunay, workers, lattice);
///     cells.locate();
///     CellList list;
///     cells.unwrap(sites, list);
///     const Vec2 corner(list.x[list.begin[k]], list.y[list.begin[k]]);  // of cell k
class UnwrappedCells {
   public:
    /// Both must outlive this object.
    UnwrappedCells(const MovingDelaunay& delaunay, Workers& workers, const Lattice& lattice);

    /// Updates to the triangulation, which must be restored.
    void locate() { rings_.update(); }

    /// Lattice coordinates of the user's basis, not wrapped.
    Vec2 site(SiteId site) const { return from_reduced_ * delaunay_.coordinates().col(site); }
    /// Computes the cells of the given sites.
    void unwrap(std::span<const SiteId> sites, CellList& cells) const;
    /// The vector from the site to its neighbour across the side that ends at a corner; frame,
    /// units.
    Vec2 to_neighbour(const CellList& cells, std::size_t corner) const {
        return delaunay_.frame().to_position({cells.to_u[corner], cells.to_v[corner]});
    }
    /// The matrix from the frame to lattice coordinates of the user's basis.
    const Eigen::Matrix2d& from_frame() const { return from_frame_; }

   private:
    void find_near_neighbours(SiteId site, int begin, CellList& cells) const;
    int find_neighbours(SiteId site, int begin, CellList& cells) const;
    void find_neighbours(std::span<const SiteId> sites, CellList& cells) const;
    void find_corners(std::span<const SiteId> sites, CellList& cells) const;
    Vec2 thin_centre(int h) const;

    const MovingDelaunay& delaunay_;
    SiteRings rings_;
    /// The matrices from the reduced basis and from the frame to lattice coordinates of the user's
    /// basis.
    Eigen::Matrix2d from_reduced_;
    Eigen::Matrix2d from_frame_;
};

}  // namespace pcvt::plane
