#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesher/cell_batch.hpp"
#include "mesher/moving_delaunay.hpp"
#include "mesher/workers.hpp"

namespace pcvt {

/// Cells one after the other, and of each corner of theirs one number in each array.
struct CellList {
    /// The neighbour across the side that ends in the corner.
    std::vector<SiteId> neighbours;
    /// It and the next one round the site; coordinates of the reduced basis, relative to the site.
    std::vector<double> to_u, to_v, next_u, next_v;
    /// The corner, relative to the site; frame, units.
    std::vector<double> x, y;
    /// The same in lattice coordinates of the user's basis.
    std::vector<double> u, v;
    /// How far the triangle is from being thin: the centres of others are computed in more digits.
    std::vector<double> thick;
    /// Of the corners, and at the end their number.
    std::vector<int> begin;

    /// The box round cell k whose site is at `site`, grown by a margin; lattice coordinates.
    LatticeBox box(std::size_t k, const Vec2& site, double margin) const;
    /// Makes `polygon` cell k, whose site is at `site`.
    void copy(std::size_t k, const Vec2& site, CellPolygon& polygon) const;

   private:
    friend class UnwrappedCells;
    void make_room(std::size_t n_corners);
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
    /// The neighbour of a cell across the side that ends in a corner, relative to the site; frame,
    /// units.
    Vec2 neighbour(const CellList& cells, std::size_t corner) const {
        return delaunay_.frame().to_plane({cells.to_u[corner], cells.to_v[corner]});
    }
    /// Lattice coordinates of the user's basis by those of the frame.
    const Eigen::Matrix2d& from_frame() const { return from_frame_; }

   private:
    static constexpr int kRingLength = 8;
    struct Ring {
        std::array<SiteId, kRingLength> neighbours{};
    };
    void find_ring(int leaving);
    template <class Take>
    void go_round(SiteId site, const Take& take) const;
    int find_far_neighbours(SiteId site, int begin, CellList& cells) const;
    void find_neighbours(std::span<const SiteId> sites, CellList& cells) const;
    void find_corners(std::span<const SiteId> sites, CellList& cells) const;
    Vec2 thin_centre(int h) const;

    const MovingDelaunay& delaunay_;
    Workers& workers_;
    /// Lattice coordinates of the user's basis by those of the reduced one, and by the frame.
    Eigen::Matrix2d from_reduced_;
    Eigen::Matrix2d from_frame_;
    /// For each site a halfedge that leaves it, found after so many flips and rebuilds.
    std::vector<int> leaving_;
    std::vector<Ring> rings_;
    std::vector<std::uint8_t> ring_length_;
    std::int64_t log_number_ = -1;
    std::size_t n_logged_ = 0;
};

}  // namespace pcvt
