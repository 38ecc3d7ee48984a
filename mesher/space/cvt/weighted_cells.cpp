#include "mesher/space/cvt/weighted_cells.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mesher/base/error.hpp"
#include "mesher/cvt/residuals.hpp"
#include "mesher/space/cvt/distinct_sites.hpp"
#include "mesher/space/power/power_diagram.hpp"

namespace pcvt::space {
namespace {

void require_weights(const Eigen::VectorXd& weights, Eigen::Index n_sites) {
    if (weights.size() != n_sites) {
        throw InvalidInput("there are " + std::to_string(weights.size()) + " weights for " +
                           std::to_string(n_sites) + " sites; give one for each site");
    }
    if (!weights.allFinite()) throw InvalidInput("a weight is not finite; correct it");
}

/// Weights this far below the largest one, in squares of MovingTetrahedra::unit(), hide their
/// sites.
constexpr double kLowest = -1e300;

/// The weights of sites in the order and the unit of their tetrahedra, less the largest one, so
/// that a common summand is of no effect.
Eigen::VectorXd ordered_weights(const MovingTetrahedra& moving, const Eigen::VectorXd& weights) {
    const double largest = weights.maxCoeff();
    const double unit = moving.unit();
    Eigen::VectorXd ordered(weights.size());
    for (SiteId s = 0; s < moving.n_sites(); ++s) {
        ordered[s] = std::max((weights[moving.original_id(s)] - largest) / unit / unit, kLowest);
    }
    return ordered;
}

/// A site without a cell.
std::optional<SiteId> hidden_site(const Sites& sites, const Eigen::VectorXd& weights,
                                  Workers& workers) {
    const MovingTetrahedra moving(sites);
    PowerDiagram diagram(moving, workers);
    diagram.start();
    if (diagram.set_weights(ordered_weights(moving, weights))) return std::nullopt;
    const auto hidden = diagram.hidden_site();
    if (!hidden) throw InternalError("no flip leads to the power diagram of the weights");
    return moving.original_id(*hidden);
}

/// Sites without cells, at most EmptyCells::kMostNamed: a hidden site that is left out changes no
/// cell, so that the next one is found among the others.
std::vector<SiteId> hidden_sites(const Sites& sites, const Eigen::VectorXd& weights,
                                 Workers& workers) {
    std::vector<SiteId> kept(static_cast<std::size_t>(sites.n_sites()));
    std::iota(kept.begin(), kept.end(), 0);
    std::vector<SiteId> hidden;
    while (hidden.size() < EmptyCells::kMostNamed) {
        Eigen::VectorXd of_kept(std::ssize(kept));
        for (Eigen::Index k = 0; k < of_kept.size(); ++k) of_kept[k] = weights[kept[k]];
        const auto next = hidden_site(some_of(sites, kept), of_kept, workers);
        if (!next) break;
        hidden.push_back(kept[*next]);
        kept.erase(kept.begin() + *next);
    }
    std::sort(hidden.begin(), hidden.end());
    return hidden;
}

}  // namespace

WeightedCells weighted_cells(const Lattice& lattice, const Points& points,
                             const Eigen::VectorXd& weights, const RunOptions& run) {
    require_weights(weights, points.cols());
    const Sites sites = distinct_sites(lattice, points);
    MovingTetrahedra moving(sites);
    Workers workers(run.n_threads);
    PowerDiagram diagram(moving, workers);
    diagram.start();
    if (!diagram.set_weights(ordered_weights(moving, weights))) {
        throw EmptyCells(hidden_sites(sites, weights, workers));
    }
    Energy cells;
    measure_cells(diagram.regular(), workers, cells);
    const auto [largest, rms] = residuals(cells.gradient, cells.mass, moving.spacing(), workers);
    const RunStatistics measured{
        .stop = largest <= run.tolerance ? Stop::kConverged : Stop::kIterationLimit,
        .evaluations = 1,
        .energy = cells.value * std::pow(moving.unit(), 5),
        .residual = largest,
        .rms_residual = rms};
    Eigen::VectorXd volumes(weights.size());
    for (SiteId s = 0; s < moving.n_sites(); ++s) {
        volumes[moving.original_id(s)] = cells.mass[s] * std::pow(moving.unit(), 3);
    }
    PeriodicDelaunay delaunay = weighted_delaunay(moving, diagram);
    delaunay.weights = weights;
    return {std::move(delaunay), std::move(volumes), measured};
}

}  // namespace pcvt::space
