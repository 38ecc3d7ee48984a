#include "mesher/space/tessellation/repeated_cells.hpp"

#include <utility>

#include "mesher/base/checkpoint.hpp"
#include "mesher/space/cvt/weighted_cells.hpp"

namespace pcvt::space {

Lattice repeated_lattice(const Lattice& lattice, const Repetition& repeat) {
    const auto& [a, b, c] = lattice.periods();
    return {repeat.columns * a, repeat.rows * b, repeat.layers * c};
}

PeriodicDelaunay repeated_cells(const PeriodicDelaunay& delaunay, const Repetition& repeat) {
    const Points sites = delaunay.sites.positions();
    const auto& [a, b, c] = delaunay.sites.lattice().periods();
    const Lattice lattice = repeated_lattice(delaunay.sites.lattice(), repeat);
    const Eigen::Index n = sites.cols();
    const auto n_copies = static_cast<Eigen::Index>(repeat.n_copies());
    Points points(3, n * n_copies);
    Eigen::Index copy = 0;
    for (int k = 0; k < repeat.layers; ++k) {
        for (int j = 0; j < repeat.rows; ++j) {
            for (int i = 0; i < repeat.columns; ++i) {
                checkpoint();
                points.middleCols(n * copy++, n) = sites.colwise() + Vec3(i * a + j * b + k * c);
            }
        }
    }
    if (delaunay.weights.size() == 0) return periodic_delaunay(Sites(lattice, points));
    const Eigen::VectorXd weights = delaunay.weights.replicate(n_copies, 1);
    return weighted_cells(lattice, points, weights, {}).delaunay;
}

CellMaterials repeated_materials(const CellMaterials& materials, const Repetition& repeat) {
    CellMaterials all{.phase_names = materials.phase_names};
    for (int copy = 0; copy < static_cast<int>(repeat.n_copies()); ++copy) {
        all.site_phase.insert(all.site_phase.end(), materials.site_phase.begin(),
                              materials.site_phase.end());
        all.site_orientation.insert(all.site_orientation.end(), materials.site_orientation.begin(),
                                    materials.site_orientation.end());
    }
    return all;
}

Tessellation repeated_cells(const Tessellation& cells, const Repetition& repeat) {
    Tessellation all{
        CvtResult{.delaunay = repeated_cells(cells.delaunay, repeat), .run = cells.run}};
    all.box_origin = cells.box_origin;
    if (!cells.elongation) return all;
    const Metric& metric = cells.elongation->metric;
    const Lattice lattice = repeated_lattice(cells.sites().lattice(), repeat);
    all.elongation = Elongation{metric, metric.from_round(all.delaunay.sites, lattice)};
    return all;
}

}  // namespace pcvt::space
