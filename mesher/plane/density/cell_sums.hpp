#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mesher/plane/density/cell_quadrature.hpp"
#include "mesher/plane/density/fan_batch.hpp"
#include "mesher/plane/density/pixel_quadrature.hpp"
#include "mesher/plane/density/unwrapped_cells.hpp"

namespace pcvt::plane {

/// A site, the order of its cell's rule, and whether a break line crosses the cell.
struct OrderedCell {
    SiteId site;
    int q;
    bool is_cut;
};

/// Computes the moments of many cells on one thread. The few cells that break lines cross go
/// through QuadratureBatch, all others through FanBatch, and the density of both is evaluated at
/// once. Cells that the break lines of a picture cross are integrated exactly, one by one.
///
/// Example usage:
///
///     CellSums sums(cells, quadrature, probe);
///     std::vector<Moments> moments;
///     sums.integrate(std::vector<OrderedCell>{{0, 4, false}, {1, 4, false}}, moments);
class CellSums {
   public:
    /// All arguments must outlive this object; the probe must not be used otherwise in the
    /// meantime.
    CellSums(const UnwrappedCells& cells, const CellQuadrature& quadrature, DensityProbe& probe)
        : cells_(cells),
          quadrature_(quadrature),
          probe_(probe),
          whole_(probe, cells.from_frame()),
          cut_(probe) {
        if (quadrature.pixels() != nullptr) {
            on_pixels_.emplace(*quadrature.pixels(), cells.from_frame());
        }
    }

    const DensityProbe& probe() const { return probe_; }
    /// Computes moments[k] of cell k. Each result depends only on its cell, to the last bit.
    /// @throws BadDensity as the probe does.
    void integrate(std::span<const OrderedCell> cells, std::vector<Moments>& moments);
    /// Whether a break line or the seam crosses the cell of a site.
    bool is_cut(SiteId site);

   private:
    void sort_by_order(std::span<const OrderedCell> cells);
    void add(std::span<const SiteId> sites, std::span<const int> numbers, int q,
             std::vector<Moments>& moments);
    void finish(std::vector<Moments>& moments);

    const UnwrappedCells& cells_;
    const CellQuadrature& quadrature_;
    DensityProbe& probe_;
    FanBatch whole_;
    QuadratureBatch cut_;
    /// For cut cells in place of `cut_`, if the density is that of a picture.
    std::optional<PixelQuadrature> on_pixels_;
    /// The indices of the cut cells.
    std::vector<int> cut_numbers_;
    /// The cells by order, and within an order in the order of input.
    std::vector<SiteId> sites_;
    std::vector<int> numbers_;
    /// The end of the cells of each order.
    std::array<int, kGreatestOrder + 1> end_{};
    CellList list_;
    CellPolygon polygon_;
};

}  // namespace pcvt::plane
