#pragma once

#include <span>
#include <vector>

#include "mesher/density/quadrature_batch.hpp"
#include "mesher/density/site_rings.hpp"

namespace pcvt {

/// Cells one after the other; each array holds a number for every corner. Side c of a cell ends in
/// its corner c, and corners go counter-clockwise.
struct CellList {
    /// The neighbour across the side.
    std::vector<SiteId> neighbours;
    /// It and the next one round the site, relative to the site; reduced basis. The corner is the
    /// centre of the three.
    std::vector<double> to_u, to_v, next_u, next_v;
    /// The corner relative to the site; frame, units.
    std::vector<double> x, y;
    /// The same in lattice coordinates of the user's basis.
    std::vector<double> u, v;
    /// Positive where the three sites make no thin triangle.
    std::vector<double> thick;
    /// The first corner of each cell, and at the end the number of corners.
    std::vector<int> begin;

    /// The box round cell k whose site is at `site`, grown by a margin; lattice coordinates.
    LatticeBox box(std::size_t k, const Vec2& site, double margin) const;
    /// Makes `polygon` cell k whose site is at `site`.
    void copy(std::size_t k, const Vec2& site, CellPolygon& polygon) const;
    /// With room for kLanes more.
    void make_room(int n_corners);
};

/// The Voronoi cells of sites that move, each unwrapped round its site: in the frame and the unit
/// of the triangulation, and in lattice coordinates of the user's basis.
class UnwrappedCells {
   public:
    /// Both must outlive this object.
    UnwrappedCells(const MovingDelaunay& delaunay, Workers& workers, const Lattice& lattice);

    /// Follows the triangulation, which must be restored.
    void locate() { rings_.update(); }

    /// Lattice coordinates of the user's basis, not wrapped.
    Vec2 site(SiteId site) const { return from_reduced_ * delaunay_.coordinates().col(site); }
    /// Makes `cells` those of the sites.
    void unwrap(std::span<const SiteId> sites, CellList& cells) const;
    /// From the site to its neighbour across the side that ends in a corner; frame, units.
    Vec2 to_neighbour(const CellList& cells, std::size_t corner) const {
        return delaunay_.frame().to_plane({cells.to_u[corner], cells.to_v[corner]});
    }
    /// Lattice coordinates of the user's basis by those of the frame.
    const Eigen::Matrix2d& from_frame() const { return from_frame_; }

   private:
    void find_near_neighbours(SiteId site, int begin, CellList& cells) const;
    int find_neighbours(SiteId site, int begin, CellList& cells) const;
    void find_neighbours(std::span<const SiteId> sites, CellList& cells) const;
    void find_corners(std::span<const SiteId> sites, CellList& cells) const;
    Vec2 thin_centre(int h) const;

    const MovingDelaunay& delaunay_;
    SiteRings rings_;
    /// Lattice coordinates of the user's basis by those of the reduced one, and by the frame.
    Eigen::Matrix2d from_reduced_;
    Eigen::Matrix2d from_frame_;
};

}  // namespace pcvt
