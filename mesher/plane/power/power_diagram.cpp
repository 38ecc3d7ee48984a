#include "mesher/plane/power/power_diagram.hpp"

#include <utility>

#include "mesher/plane/power/power_flips.hpp"

namespace pcvt::plane {

bool PowerDiagram::set_weights(Eigen::VectorXd weights) {
    weights_ = std::move(weights);
    const double to_gram = delaunay_->unit() / delaunay_->gram_unit();
    const Eigen::VectorXd gram_weights = weights_ * (to_gram * to_gram);
    if (!gram_weights.allFinite()) return false;
    PowerFlips flips(regular_, delaunay_->coordinates(), delaunay_->gram(), gram_weights);
    if (flips.run()) return false;
    measure_masses(regular(), *workers_, heights_, areas_);
    return true;
}

CellGraph PowerDiagram::graph() const {
    CellGraph cells;
    assemble_cell_graph(regular(), heights_, *workers_, cells);
    return cells;
}

PeriodicDelaunay weighted_delaunay(std::pair<Sites, TorusTriangulation> released,
                                   Eigen::VectorXd weights) {
    auto& [sites, triangulation] = released;
    const Lattice& reduced = sites.reduction().reduced;
    const double unit = gram_unit(reduced);
    const Eigen::VectorXd gram_weights = weights / (unit * unit);
    PowerFlips(triangulation, sites.coordinates(), gram_of(reduced), gram_weights).run();
    return {std::move(sites), std::move(triangulation), std::move(weights)};
}

}  // namespace pcvt::plane
