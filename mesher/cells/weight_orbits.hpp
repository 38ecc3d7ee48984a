#pragma once

#include <Eigen/Core>
#include <vector>

#include "mesher/cells/cell_graph.hpp"

namespace pcvt {

/// Sites whose weights stay equal, because a symmetry maps them to each other: sums over each orbit
/// of such sites, and the adjacency of orbits in place of cells.
///
/// Example usage:
///
///     const WeightOrbits orbits({0, 1, 0, 1});  // sites 2 and 3 are images of 0 and 1
///     LaplacianSolver solver(orbits.merged(std::move(graph)));
///     solver.solve(orbits.sums(error), 1e-8, of_orbits);
///     const Eigen::VectorXd step = orbits.spread(of_orbits);
///
/// With S the matrix that gives each site the value of its orbit, sums() is S^T, spread() is S, and
/// the Laplacian of merged() is S^T A S. Images get the same bits.
class WeightOrbits {
   public:
    /// Each site is an orbit.
    WeightOrbits() = default;
    /// @param orbit  of each site, 0 ... m - 1.
    explicit WeightOrbits(std::vector<int> orbit);

    CellGraph merged(CellGraph cells) const;
    Eigen::VectorXd sums(const Eigen::VectorXd& of_sites) const;
    Eigen::VectorXd spread(const Eigen::VectorXd& of_orbits) const;

   private:
    /// Empty: each site is an orbit.
    std::vector<int> orbit_;
    int n_orbits_ = 0;
};

}  // namespace pcvt
