#pragma once

#include <span>
#include <vector>

#include "mesher/density/cell_quadrature.hpp"
#include "mesher/density/fan_batch.hpp"
#include "mesher/density/unwrapped_cells.hpp"

namespace pcvt {

/// A site, the order of its cell's rule, and whether a break line crosses the cell.
struct OrderedCell {
    SiteId site;
    int q;
    bool is_cut;
};

/// Moments of many cells, for one thread: the few that break lines cross through QuadratureBatch,
/// the others through FanBatch, and the density of both is asked at once.
class CellSums {
   public:
    /// All must outlive this object; the probe is used by nobody else meanwhile.
    CellSums(const UnwrappedCells& cells, const CellQuadrature& quadrature, DensityProbe& probe)
        : cells_(cells),
          quadrature_(quadrature),
          probe_(probe),
          whole_(probe, cells.from_frame()),
          cut_(probe) {}

    /// Makes moments[k] those of cell k. Each depends on its cell alone, to the last bit.
    /// @throws BadDensity as the probe does.
    void integrate(std::span<const OrderedCell> cells, std::vector<Moments>& moments);
    /// Whether a break line or the seam crosses the cell of a site.
    bool is_cut(SiteId site);

   private:
    void sort_by_order(std::span<const OrderedCell> cells);
    void add(std::span<const SiteId> sites, std::span<const int> numbers, int q);
    void finish(std::vector<Moments>& moments);

    const UnwrappedCells& cells_;
    const CellQuadrature& quadrature_;
    DensityProbe& probe_;
    FanBatch whole_;
    QuadratureBatch cut_;
    /// The numbers of the cut cells.
    std::vector<int> cut_numbers_;
    /// The cells by order, and in each order as they came.
    std::vector<SiteId> sites_;
    std::vector<int> numbers_;
    /// Where the cells of an order end.
    std::array<int, kGreatestOrder + 1> end_{};
    CellList list_;
    CellPolygon polygon_;
};

}  // namespace pcvt
