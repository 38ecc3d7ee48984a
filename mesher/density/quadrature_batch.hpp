#pragma once

#include <span>
#include <vector>

#include "mesher/density/density.hpp"
#include "mesher/density/quadrature.hpp"

namespace pcvt {

/// Integrals over a cell, about its site: of rho, of rho (p - x_i), and of rho |p - x_i|^2.
struct Moments {
    double mass = 0;
    Vec2 first = Vec2::Zero();
    double second = 0;

    Moments& operator+=(const Moments& other);
};

/// A place told twice: in a plane, relative to the site, and in lattice coordinates of the user's
/// basis, not wrapped. The one is an affine image of the other.
struct CellCorner {
    Vec2 plane;
    Vec2 lattice;
};
/// The corners of a cell that holds its site, counter-clockwise in the plane.
using CellPolygon = std::vector<CellCorner>;
using CellView = std::span<const CellCorner>;

/// Lattice coordinates.
struct LatticeBox {
    Vec2 low;
    Vec2 high;
};

/// Many cells in pieces, whose density is asked at once: a function that is called from another
/// language, or that knows arrays, is so asked in much less time.
class QuadratureBatch {
   public:
    /// @param probe  with no points waiting; used by nobody else while this object lives.
    explicit QuadratureBatch(DensityProbe& probe) : probe_(probe) {}

    /// Adds to the cell the fan of the triangles between `apex` and the sides of a polygon round
    /// it, each with the conical rule of q x q points that collapses at the apex.
    /// @param period  brings lattice coordinates of the polygon into [0, 1].
    void add_fan(CellView polygon, const CellCorner& apex, const Vec2& period, int q);
    /// Adds a parallelogram along the lattice directions, by its corner and the two beside it, with
    /// the product of two Gauss rules.
    void add_parallelogram(const CellCorner& corner, const CellCorner& along, const CellCorner& up,
                           const Vec2& period, int q);
    /// What is added from here on belongs to the next cell.
    void end_cell() { end_.push_back(pieces_.size()); }

    /// Asks the density and empties the batch.
    /// @returns the moments of the cells in order, until the next call.
    /// @throws BadDensity as the probe does.
    const std::vector<Moments>& collect() { return take(probe_.evaluate_reserved()); }
    /// The same where the caller has asked.
    /// @param rho  what the probe gave for all the points that waited.
    const std::vector<Moments>& take(std::span<const double> rho);

   private:
    struct Piece {
        bool is_fan;
        bool is_about_site;
        int q;
        int n_corners;
        Vec2 place;
        /// The number of points that waited before.
        std::size_t first_point;
    };

    Moments take_fan(const Piece& piece, const double* rho);
    Moments take_parallelogram(const Piece& piece, const double* rho);

    DensityProbe& probe_;
    std::vector<Piece> pieces_;
    /// One after the other the corners of the pieces, plane coordinates relative to their places.
    std::vector<Vec2> corners_;
    /// The number of pieces at the end of each cell.
    std::vector<std::size_t> end_;
    std::vector<Moments> moments_;
    /// What is left of the corners while moments are taken.
    const Vec2* corner_ = nullptr;
};

}  // namespace pcvt
