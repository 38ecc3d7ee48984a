#pragma once

#include <span>
#include <vector>

#include "mesher/plane/density/density.hpp"
#include "mesher/plane/density/quadrature.hpp"

namespace pcvt::plane {

/// Integrals over a cell about its site: of rho, rho (p - x_i), and rho |p - x_i|^2.
struct Moments {
    double mass = 0;
    Vec2 first = Vec2::Zero();
    double second = 0;

    Moments& operator+=(const Moments& other);
};
/// Converts moments about a point at `place` to moments about the site.
Moments about_site(const Moments& m, const Vec2& place);

/// A point in two coordinate systems: in a plane, relative to the site, and in lattice coordinates
/// of the user's basis, not wrapped. One is an affine image of the other.
struct CellCorner {
    Vec2 plane;
    Vec2 lattice;
};
/// The corners of a cell that contains its site, counter-clockwise in the plane.
using CellPolygon = std::vector<CellCorner>;
using CellView = std::span<const CellCorner>;

/// A bounding box in lattice coordinates.
struct LatticeBox {
    Vec2 low;
    Vec2 high;
};

/// Integrates over many cells, cut into pieces, with one evaluation of the density for all of them.
/// This saves most of the time for a function that is called from another language or that is
/// vectorised.
class QuadratureBatch {
   public:
    /// @param probe  without reserved points; must not be used otherwise while this object lives.
    explicit QuadratureBatch(DensityProbe& probe) : probe_(probe) {}

    /// Adds to the current cell the fan of triangles between `apex` and the sides of a polygon
    /// round it, each with the conical rule of q x q points that collapses at the apex.
    /// @param period  the whole periods that bring the polygon's lattice coordinates into [0, 1]
    ///                when subtracted.
    void add_fan(CellView polygon, const CellCorner& apex, const Vec2& period, int q);
    /// Adds a parallelogram along the lattice directions, given by a corner and the two adjacent
    /// corners, with the product of two Gauss rules.
    void add_parallelogram(const CellCorner& corner, const CellCorner& along, const CellCorner& up,
                           const Vec2& period, int q);
    /// Ends the current cell; later pieces belong to the next cell.
    void end_cell() { end_.push_back(pieces_.size()); }

    /// Evaluates the density and empties the batch.
    /// @returns the moments of the cells in order, valid until the next call.
    /// @throws BadDensity as the probe does.
    const std::vector<Moments>& collect() { return take(probe_.evaluate_reserved()); }
    /// The same for a density that the caller has evaluated.
    /// @param rho  the probe's result for all reserved points.
    const std::vector<Moments>& take(std::span<const double> rho);

   private:
    struct Piece {
        bool is_fan;
        bool is_about_site;
        int q;
        int n_corners;
        Vec2 place;
        /// The number of points reserved before this piece.
        std::size_t first_point;
    };

    Moments take_fan(const Piece& piece, const double* rho);
    Moments take_parallelogram(const Piece& piece, const double* rho);

    DensityProbe& probe_;
    std::vector<Piece> pieces_;
    /// The corners of all pieces in order, plane coordinates relative to the places of the pieces.
    std::vector<Vec2> corners_;
    /// The number of pieces at the end of each cell.
    std::vector<std::size_t> end_;
    std::vector<Moments> moments_;
    /// The next unused corner while moments are taken.
    const Vec2* corner_ = nullptr;
};

}  // namespace pcvt::plane
