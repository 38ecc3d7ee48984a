#pragma once

#include <memory>
#include <mutex>
#include <optional>

#include "mesher/cells/cell_table.hpp"
#include "mesher/space/cvt/centroid_cells.hpp"
#include "mesher/space/cvt/cvt.hpp"
#include "mesher/space/cvt/volume_cvt.hpp"
#include "mesher/space/cvt/weighted_cells.hpp"
#include "mesher/space/geometry/metric.hpp"
#include "mesher/space/mesh/cell_complex.hpp"

namespace pcvt::space {

/// The cells of a tessellation and their table, once they are made.
struct CellCache {
    std::mutex mutex;
    std::optional<CellComplex> complex;
    std::optional<CellTable> table;
};

/// The metric of elongated cells, and their sites in the space of the user (Metric::from_round()).
struct Elongation {
    Metric metric;
    Sites sites;
};

/// A tessellation of space, the run that computed it, and its cells: Voronoi cells, or power cells
/// where `delaunay` has weights. With an elongation, `delaunay`, energy and residuals are those of
/// the round space of its metric, and the cells lie in the space of the user.
///
/// Example usage:
///     const Tessellation cells{compute_cvt(lattice, points, options)};
///     const double volume = cells.table().measure[0];
///     const PolyhedralMesh mesh = polyhedral_mesh(cells.sites(), cells.complex());
struct Tessellation : CvtResult {
    explicit Tessellation(CvtResult&& result) : CvtResult(std::move(result)) {}
    explicit Tessellation(VolumeCvtResult&& grains)
        : CvtResult{.delaunay = std::move(grains.delaunay),
                    .run = grains.run,
                    .n_rebuilds = grains.n_rebuilds},
          volumes(grains.volumes) {}
    explicit Tessellation(CentroidCells&& cells) : Tessellation(std::move(cells.grains)) {
        centroids = cells.centroids;
    }
    explicit Tessellation(WeightedCells&& cells)
        : CvtResult{.delaunay = std::move(cells.delaunay), .run = cells.run} {}

    /// Figures of a run with prescribed volumes.
    std::optional<SizeFigures> volumes = {};
    /// Figures of a run with prescribed centroids.
    std::optional<CentroidFigures> centroids = {};
    /// Elongated cells; set before complex() and table() are called.
    std::optional<Elongation> elongation = {};
    /// The corner of the box that best_box_origin() found for these cells, length units.
    std::optional<Vec3> box_origin = {};

    /// The sites in the space of the user.
    const Sites& sites() const { return elongation ? elongation->sites : delaunay.sites; }
    Metric metric() const { return elongation ? elongation->metric : Metric(); }

    /// The cells. The first call after table() takes the cells from which the table was made. Any
    /// number of threads may call this.
    CellComplex complex() const;
    /// Measures of the cells, made by the first call. Any number of threads may call this.
    const CellTable& table() const;

   private:
    CellComplex new_complex() const;

    std::unique_ptr<CellCache> cache_ = std::make_unique<CellCache>();
};

}  // namespace pcvt::space
