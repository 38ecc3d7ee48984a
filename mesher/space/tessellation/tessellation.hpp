#pragma once

#include <memory>
#include <mutex>
#include <optional>

#include "mesher/cells/cell_table.hpp"
#include "mesher/space/cvt/cvt.hpp"
#include "mesher/space/cvt/volume_cvt.hpp"
#include "mesher/space/cvt/weighted_cells.hpp"
#include "mesher/space/mesh/cell_complex.hpp"

namespace pcvt::space {

/// The cells of a tessellation and their table, once they are made.
struct CellCache {
    std::mutex mutex;
    std::optional<CellComplex> complex;
    std::optional<CellTable> table;
};

/// A tessellation of space, the run that computed it, and its cells: Voronoi cells, or power cells
/// where `delaunay` has weights.
///
/// Example usage:
///     const Tessellation cells{compute_cvt(lattice, points, options)};
///     const double volume = cells.table().measure[0];
///     const PolyhedralMesh mesh = polyhedral_mesh(cells.delaunay.sites, cells.complex());
struct Tessellation : CvtResult {
    explicit Tessellation(CvtResult&& result) : CvtResult(std::move(result)) {}
    explicit Tessellation(VolumeCvtResult&& grains)
        : CvtResult{.delaunay = std::move(grains.delaunay),
                    .run = grains.run,
                    .n_rebuilds = grains.n_rebuilds},
          volumes(grains.volumes) {}
    explicit Tessellation(WeightedCells&& cells)
        : CvtResult{.delaunay = std::move(cells.delaunay), .run = cells.run} {}

    /// Figures of a run with prescribed volumes.
    std::optional<SizeFigures> volumes = {};

    /// The cells. The first call after table() takes the cells from which the table was made. Any
    /// number of threads may call this.
    CellComplex complex() const;
    /// Measures of the cells, made by the first call. Any number of threads may call this.
    const CellTable& table() const;

   private:
    std::unique_ptr<CellCache> cache_ = std::make_unique<CellCache>();
};

}  // namespace pcvt::space
