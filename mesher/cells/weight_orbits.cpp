#include "mesher/cells/weight_orbits.hpp"

#include <algorithm>
#include <utility>

#include "mesher/base/checkpoint.hpp"

namespace pcvt {

WeightOrbits::WeightOrbits(std::vector<int> orbit) : orbit_(std::move(orbit)) {
    for (const int k : orbit_) n_orbits_ = std::max(n_orbits_, k + 1);
}

CellGraph WeightOrbits::merged(CellGraph cells) const {
    if (orbit_.empty()) return cells;
    // Sort the sites by orbit.
    std::vector<int> begin(static_cast<std::size_t>(n_orbits_) + 1, 0);
    for (const int k : orbit_) ++begin[k + 1];
    for (int k = 0; k < n_orbits_; ++k) begin[k + 1] += begin[k];
    std::vector<int> sites(orbit_.size());
    std::vector<int> next(begin.begin(), begin.end() - 1);
    for (std::size_t s = 0; s < orbit_.size(); ++s) sites[next[orbit_[s]]++] = static_cast<int>(s);
    // Join the rows of each orbit.
    CellGraph graph{{0}, {}, {}};
    for (int k = 0; k < n_orbits_; ++k) {
        checkpoint_each(k);
        for (int m = begin[k]; m < begin[k + 1]; ++m) {
            for (int e = cells.row_begin[sites[m]]; e < cells.row_begin[sites[m] + 1]; ++e) {
                const int neighbour = orbit_[cells.neighbour[e]];
                if (neighbour == k) continue;
                graph.neighbour.push_back(neighbour);
                graph.conductance.push_back(cells.conductance[e]);
            }
        }
        graph.row_begin.push_back(static_cast<int>(graph.neighbour.size()));
    }
    return graph;
}

Eigen::VectorXd WeightOrbits::sums(const Eigen::VectorXd& of_sites) const {
    if (orbit_.empty()) return of_sites;
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(n_orbits_);
    for (std::size_t s = 0; s < orbit_.size(); ++s) {
        sums[orbit_[s]] += of_sites[static_cast<Eigen::Index>(s)];
    }
    return sums;
}

Eigen::VectorXd WeightOrbits::spread(const Eigen::VectorXd& of_orbits) const {
    if (orbit_.empty()) return of_orbits;
    Eigen::VectorXd of_sites(static_cast<Eigen::Index>(orbit_.size()));
    for (std::size_t s = 0; s < orbit_.size(); ++s) {
        of_sites[static_cast<Eigen::Index>(s)] = of_orbits[orbit_[s]];
    }
    return of_sites;
}

}  // namespace pcvt
