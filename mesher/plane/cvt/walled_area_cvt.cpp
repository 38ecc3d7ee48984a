#include "mesher/plane/cvt/walled_area_cvt.hpp"

#include <optional>
#include <utility>

#include "mesher/plane/symmetry/walled_sites.hpp"

namespace pcvt::plane {
namespace {

/// The areas of whole cells on the torus, from those of their parts between the walls.
Eigen::VectorXd areas_on_torus(const SymmetricSites& sites, const Eigen::VectorXd& between,
                               int n_images) {
    Eigen::VectorXd areas(sites.sites.n_sites());
    for (SiteId s = 0; s < sites.sites.n_sites(); ++s) {
        const int k = sites.orbit[s];
        // A cell across a wall consists of the parts of several domains.
        const int n_parts = n_images / sites.orbits[k].n_sites;
        areas[s] = between[k] * n_parts;
    }
    return areas;
}

void add_counts(SizeFigures& figures, const SizeFigures& before) {
    figures.newton_steps += before.newton_steps;
    figures.products += before.products;
    figures.trials += before.trials;
}

}  // namespace

WalledAreaCvt compute_walled_area_cvt(const Lattice& lattice, Walls walls, WallCells cells,
                                      Points points, const AreaCvtOptions& options) {
    require_areas(options, static_cast<int>(points.cols()));
    if (options.numbering == Numbering::kByColumns) points = sorted_by_columns(lattice, points);
    AreaCvtOptions of_torus = options;
    of_torus.numbering = Numbering::kAsGiven;
    const WalledDomain start{walls, lattice, static_cast<int>(points.cols())};
    std::optional<AreaCvtResult> torus;
    SizeFigures figures;
    const WallRound round = [&](const SymmetricSites& sites,
                                const RunStatistics& before) -> WallRoundResult {
        of_torus.areas = areas_on_torus(sites, options.areas, start.n_images());
        of_torus.run.progress = progress_between_walls(options.run.progress, start, before);
        torus.emplace(compute_area_cvt(sites, of_torus));
        add_counts(torus->areas, figures);
        figures = torus->areas;
        return {torus->delaunay, torus->run};
    };
    const WalledDomain domain = run_wall_rounds(start, cells, std::move(points), round);
    return {std::move(*torus), domain};
}

}  // namespace pcvt::plane
