#include "mesher/space/tessellation/repeated_cells.hpp"

#include <utility>

#include "mesher/base/checkpoint.hpp"
#include "mesher/space/cvt/weighted_cells.hpp"

namespace pcvt::space {

PeriodicDelaunay repeated_cells(const PeriodicDelaunay& delaunay, const Repetition& repeat) {
    const Points sites = delaunay.sites.positions();
    const auto& [a, b, c] = delaunay.sites.lattice().periods();
    const Lattice lattice(repeat.columns * a, repeat.rows * b, repeat.layers * c);
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

}  // namespace pcvt::space
