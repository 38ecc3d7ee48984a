#include "mesher/plane/cvt/walled_cvt.hpp"

#include <optional>
#include <utility>

#include "mesher/plane/symmetry/folded_density.hpp"
#include "mesher/plane/symmetry/walled_sites.hpp"

namespace pcvt::plane {

WalledCvt compute_walled_cvt(const Lattice& lattice, Walls walls, WallCells cells, Points points,
                             const CvtOptions& options) {
    if (options.numbering == Numbering::kByColumns) points = sorted_by_columns(lattice, points);
    const WalledDomain domain{walls, lattice, static_cast<int>(points.cols())};
    return compute_walled_cvt(domain, cells, std::move(points), options,
                              [](const SymmetricSites& sites, const CvtOptions& of_torus) {
                                  return compute_cvt(sites, of_torus);
                              });
}

WalledCvt compute_walled_cvt(const WalledDomain& start, WallCells cells, Points points,
                             const CvtOptions& options, const SymmetricRun& run) {
    CvtOptions of_torus = options;
    of_torus.numbering = Numbering::kAsGiven;
    if (options.density) of_torus.density = mirrored_density(*options.density, start.walls);
    std::optional<CvtResult> torus;
    const WallRound round = [&](const SymmetricSites& sites,
                                const RunStatistics& before) -> WallRoundResult {
        of_torus.run.progress = progress_between_walls(options.run.progress, start, before);
        torus.emplace(run(sites, of_torus));
        return {torus->delaunay, torus->run};
    };
    const WalledDomain domain = run_wall_rounds(start, cells, std::move(points), round);
    torus->energy_bound /= domain.n_images();
    if (torus->density) {
        torus->density->mass /= domain.n_images();
        torus->density->expected_energy /= domain.n_images();
    }
    return {std::move(*torus), domain};
}

}  // namespace pcvt::plane
