#pragma once

#include <array>
#include <memory>
#include <vector>

#include "mesher/plane/density/quadrature_batch.hpp"

namespace pcvt::plane {

/// Integrates a density over cells.
///
/// A cell that no break line crosses is the fan of triangles between its site and its sides; each
/// triangle gets the conical rule of q x q points that collapses at the site. A cell that break
/// lines cross is first cut along them. Each piece is then a fan of its own or, where it is a whole
/// parallelogram between break lines, a product of two Gauss rules. The density of a picture needs
/// no rules: its integrals over cut cells are exact (pixel_quadrature.hpp).
///
/// Example usage:
///
///     DensityProbe probe(lattice, density.make_function());
///     const Moments m = CellQuadrature(density)(cell, site, 4, probe);
///     const Vec2 centroid = m.first / m.mass;  // relative to the site
///
/// Laws, tested by number:
///   (1) Exact to rounding for densities that are polynomials of degree 2 q - 3 on each piece.
///   (2) A cell and its translates by lattice vectors have the same moments.
class CellQuadrature {
   public:
    explicit CellQuadrature(const Density& density);

    /// Adds a cell to a batch.
    /// @param site      lattice coordinates of the site, whose plane coordinates are (0, 0).
    /// @param q         see triangle_rule.
    void add(CellView cell, const Vec2& site, int q, QuadratureBatch& batch) const;

    /// The moments of one cell, whose plane coordinates are lengths along x and y.
    /// @throws BadDensity as the probe does.
    Moments operator()(CellView cell, const Vec2& site, int q, DensityProbe& probe) const;

    /// The picture whose density this is, or null. PixelQuadrature has the moments of its cut
    /// cells, and add() is not for them.
    const PixelGrid* pixels() const { return pixels_.get(); }
    /// The least order that cells need.
    int least_order() const;

    /// Computes where break lines and the seam cut the segment between two points: fractions of the
    /// segment in [0, 1], ascending, including 0 and 1.
    void cut_way(const Vec2& from, const Vec2& to, std::vector<double>& shares) const;

    /// Whether a break line or the seam crosses a cell with this box.
    /// @param box  translated so that the site lies in [0, 1).
    bool is_cut(const LatticeBox& box) const {
        return box.low.x() < 0 || box.low.y() < 0 || box.high.x() > 1 || box.high.y() > 1 ||
               (has_breaks_ && is_cut_inside(box));
    }

   private:
    bool is_cut_inside(const LatticeBox& box) const;

    /// Coordinates in [0, 1), ascending, including 0.
    std::array<std::vector<double>, 2> breaks_;
    /// Whether there are breaks other than 0.
    bool has_breaks_;
    std::shared_ptr<const PixelGrid> pixels_;
};

}  // namespace pcvt::plane
