#include "mesher/plane/cvt/weighted_cells.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "mesher/cvt/residuals.hpp"
#include "mesher/plane/power/power_diagram.hpp"
#include "mesher/plane/power/power_flips.hpp"

namespace pcvt::plane {
namespace {

constexpr std::size_t kMostNamed = EmptyCells::kMostNamed;
/// In squares of MovingDelaunay::unit(); products of weights below this do not overflow.
constexpr double kLargestWeight = 1e150;

/// The weights of sites in the order and the unit of their triangulation.
Eigen::VectorXd ordered_weights(const MovingDelaunay& delaunay, const Eigen::VectorXd& weights) {
    const double unit = delaunay.unit();
    Eigen::VectorXd ordered(weights.size());
    for (SiteId s = 0; s < delaunay.n_sites(); ++s) {
        ordered[s] = weights[delaunay.original_id(s)] / (unit * unit);
    }
    return ordered;
}

/// A site without a cell, which flips name one at a time.
std::optional<SiteId> hidden_site(const MovingDelaunay& delaunay, const Eigen::VectorXd& weights) {
    TorusTriangulation regular = delaunay.triangulation();
    const double to_gram = delaunay.unit() / delaunay.gram_unit();
    const Eigen::VectorXd gram_weights = ordered_weights(delaunay, weights) * (to_gram * to_gram);
    const auto hidden =
        PowerFlips(regular, delaunay.coordinates(), delaunay.gram(), gram_weights).run();
    return hidden ? std::optional(delaunay.original_id(*hidden)) : std::nullopt;
}

/// Sites without cells, at most kMostNamed: a hidden site that is left out changes no cell, so that
/// the next one is found among the others.
std::vector<SiteId> hidden_sites(const Sites& sites, const Eigen::VectorXd& weights) {
    std::vector<SiteId> kept(static_cast<std::size_t>(sites.n_sites()));
    std::iota(kept.begin(), kept.end(), 0);
    std::vector<SiteId> hidden;
    while (hidden.size() < kMostNamed) {
        Points points(2, std::ssize(kept));
        Eigen::VectorXd of_kept(points.cols());
        for (Eigen::Index k = 0; k < points.cols(); ++k) {
            points.col(k) = sites.position(kept[k]);
            of_kept[k] = weights[kept[k]];
        }
        const auto next = hidden_site(MovingDelaunay(Sites(sites.lattice(), points)), of_kept);
        if (!next) break;
        hidden.push_back(kept[*next]);
        kept.erase(kept.begin() + *next);
    }
    std::sort(hidden.begin(), hidden.end());
    return hidden;
}

/// The energy and the residuals of the cells of a diagram.
RunStatistics measured_run(const MovingDelaunay& delaunay, const PowerDiagram& diagram,
                           double tolerance, Workers& workers) {
    Energy cells;
    measure_cells(diagram.regular(), diagram.heights(), workers, cells);
    const auto [largest, rms] = residuals(cells.gradient, cells.mass, delaunay.spacing(), workers);
    return {.stop = largest <= tolerance ? Stop::kConverged : Stop::kIterationLimit,
            .evaluations = 1,
            .energy = cells.value * std::pow(delaunay.unit(), 4),
            .residual = largest,
            .rms_residual = rms};
}

CvtResult cells_of(const Sites& sites, const Eigen::VectorXd& weights, const RunOptions& run) {
    MovingDelaunay delaunay(sites);
    require_distinct(delaunay);
    const Eigen::VectorXd ordered = ordered_weights(delaunay, weights);
    if (!(ordered.cwiseAbs().maxCoeff() < kLargestWeight)) {
        throw InvalidInput("the weights are too large for the periods; scale them");
    }
    Workers workers(run.n_threads);
    PowerDiagram diagram(delaunay, workers);
    diagram.start();
    if (!diagram.set_weights(ordered)) throw EmptyCells(hidden_sites(sites, weights));
    const RunStatistics measured = measured_run(delaunay, diagram, run.tolerance, workers);
    const DelaunayCounts counts = delaunay.counts();
    return {.delaunay = weighted_delaunay(delaunay.release(), weights),
            .run = measured,
            .energy_bound = hexagonal_bound(sites.lattice().area(), sites.n_sites()),
            .counts = counts};
}

/// The points of which sites are images, each once.
std::vector<SiteId> points_of(std::vector<SiteId> sites, const std::vector<int>& orbit) {
    for (SiteId& s : sites) s = orbit[s];
    std::sort(sites.begin(), sites.end());
    sites.erase(std::unique(sites.begin(), sites.end()), sites.end());
    return sites;
}

void require_weights(const Eigen::VectorXd& weights, Eigen::Index n_sites) {
    if (weights.size() != n_sites) {
        throw InvalidInput("there are " + std::to_string(weights.size()) + " weights for " +
                           std::to_string(n_sites) + " sites; give one for each site");
    }
    if (!weights.allFinite()) throw InvalidInput("a weight is not finite; correct it");
}

}  // namespace

CvtResult weighted_cells(const Lattice& lattice, const Points& points,
                         const Eigen::VectorXd& weights, const RunOptions& run) {
    require_weights(weights, points.cols());
    return cells_of(Sites(lattice, points), weights, run);
}

WalledCvt walled_weighted_cells(const Lattice& lattice, Walls walls, const Points& points,
                                const Eigen::VectorXd& weights, const RunOptions& run) {
    require_weights(weights, points.cols());
    const WalledDomain domain{walls, lattice, static_cast<int>(points.cols())};
    const auto mirrored_run = [&](const SymmetricSites& sites, const CvtOptions& options) {
        Eigen::VectorXd of_images(sites.sites.n_sites());
        for (SiteId s = 0; s < sites.sites.n_sites(); ++s) of_images[s] = weights[sites.orbit[s]];
        try {
            return cells_of(sites.sites, of_images, options.run);
        } catch (const EmptyCells& error) {
            throw EmptyCells(points_of(error.sites(), sites.orbit));
        }
    };
    return compute_walled_cvt(domain, WallCells::kWhole, points, {.run = run}, mirrored_run);
}

}  // namespace pcvt::plane
