#pragma once

#include <array>
#include <vector>

#include "mesher/density.hpp"

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

/// Integrates a density over cells.
///
/// A cell that no break line crosses is the fan of the triangles between its site and its sides,
/// and each gets the conical rule of q x q points that collapses at the site. A cell that some
/// cross is first cut along them, and then each piece is a fan of its own, or where it is a whole
/// parallelogram between break lines, a product of two Gauss rules. Laws, tested by number:
///   (1) Exact to rounding for densities that are polynomials of degree 2 q - 3 on each piece.
///   (2) A cell and its translates by lattice vectors have the same moments.
class CellQuadrature {
   public:
    explicit CellQuadrature(const Density& density);

    /// @param site      lattice coordinates of the site, whose plane coordinates are (0, 0).
    /// @param q         see triangle_rule.
    /// @throws BadDensity as the probe does.
    Moments operator()(const CellPolygon& cell, const Vec2& site, int q, DensityProbe& probe) const;

    /// Whether a break line or the seam crosses the cell.
    bool is_cut(const CellPolygon& cell, const Vec2& site) const;

   private:
    /// Coordinates in [0, 1), 0 among them, rising.
    std::array<std::vector<double>, 2> breaks_;
};

}  // namespace pcvt
