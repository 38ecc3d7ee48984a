#include "mesher/space/cvt/cvt.hpp"

#include "mesher/cvt/cvt_objective.hpp"
#include "mesher/portable/portable_functions.hpp"
#include "mesher/space/cvt/distinct_sites.hpp"
#include "mesher/space/energy/energy_pass.hpp"

namespace pcvt::space {
CvtResult compute_cvt(const Lattice& lattice, const Points& points, const CvtOptions& options) {
    MovingTetrahedra moving(distinct_sites(lattice, points));
    Workers workers(options.run.n_threads);
    const SiteConstraints<MovingTetrahedra> none;
    CvtObjective<EnergyPass> objective(moving, workers, none);
    const RunStatistics run =
        minimize_energy(moving, objective, solver_row(options.run.solver).minimize,
                        optimizer_options(moving, options.run), workers);
    objective.reject();
    const int n_rebuilds = moving.n_rebuilds();
    return {moving.release(), run, n_rebuilds};
}

double body_centred_energy(double volume, int n_sites) {
    const double n = n_sites;
    const double root = portable_cbrt(volume);
    return 3 * 19.0 / (192.0 * portable_cbrt(2.0)) * (volume * root * root) / portable_cbrt(n * n);
}

}  // namespace pcvt::space
