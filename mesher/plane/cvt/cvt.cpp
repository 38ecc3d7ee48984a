#include "mesher/plane/cvt/cvt.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "mesher/base/error.hpp"
#include "mesher/cvt/cvt_objective.hpp"
#include "mesher/plane/cvt/active_sites.hpp"
#include "mesher/plane/delaunay/periodic_delaunay.hpp"
#include "mesher/plane/energy/energy.hpp"
#include "mesher/plane/energy/hessian.hpp"
#include "mesher/plane/energy/long_waves.hpp"
#include "mesher/plane/symmetry/folded_density.hpp"
#include "mesher/plane/symmetry/symmetric_objective.hpp"

namespace pcvt::plane {
namespace {

constexpr int kSitesPerTask = 1 << 14;

/// The energy for rho = 1, with its Hessian, a preconditioner of long waves and rounds with active
/// sites.
class UniformObjective final : public CvtObjective<EnergyPass> {
   public:
    /// @param relaxes  whether the optimiser may run rounds with active sites.
    UniformObjective(MovingDelaunay& delaunay, Workers& workers,
                     const SiteConstraints<MovingDelaunay>& constraints, bool relaxes)
        : CvtObjective(delaunay, workers, constraints) {
        if (relaxes) active_.emplace(delaunay, workers, constraints.fixed);
    }

    bool evaluate(const Eigen::VectorXf& direction, double t, Evaluation& evaluation) override {
        if (!CvtObjective::evaluate(direction, t, evaluation)) return false;
        if (long_waves_) apply_long_waves(evaluation);
        return true;
    }

    bool precondition(Evaluation& evaluation) override {
        if (moving().n_sites() < kFewestForLongWaves) return false;
        long_waves_ = std::make_unique<LongWaves>(moving(), workers());
        apply_long_waves(evaluation);
        return true;
    }

    bool relax_parts(const Evaluation& here, double tolerance) override {
        return active_ && active_->relax(here.gradient, mass(), tolerance);
    }

    bool has_hessian() const override { return true; }
    void hessian(BlockMatrix& hessian) const override {
        assemble_hessian(moving(), workers(), hessian);
        constraints().fixed.restrict_hessian(hessian);
    }

   private:
    void apply_long_waves(Evaluation& evaluation) {
        long_waves_->apply(evaluation.gradient, evaluation.preconditioned);
        constraints().fixed.clear(evaluation.preconditioned);
    }

    std::unique_ptr<LongWaves> long_waves_;
    std::optional<ActiveSites> active_;
};

OptimizerOptions preconditioned_options(const MovingDelaunay& delaunay, const CvtOptions& options) {
    OptimizerOptions optimizer = optimizer_options(delaunay, options.run);
    if (solver_row(options.run.solver).preconditions) {
        optimizer.precondition_below = options.precondition_below;
    }
    return optimizer;
}

SiteConstraints<MovingDelaunay> constraints_of(const MovingDelaunay& delaunay,
                                               const CvtOptions& options) {
    SiteConstraints<MovingDelaunay> constraints{{}, options.guard};
    if (options.fixed.empty()) return constraints;
    if (options.numbering != Numbering::kAsGiven) {
        throw InvalidInput("fixed sites need the numbering of the input");
    }
    const auto n = static_cast<std::size_t>(delaunay.n_sites());
    std::vector<bool> is_fixed(n, false);
    for (const SiteId id : options.fixed) {
        if (id < 0 || id >= delaunay.n_sites()) {
            throw InvalidInput("site " + std::to_string(id) + " shall be fixed, but there are " +
                               std::to_string(n) + " sites");
        }
        is_fixed[id] = true;
    }
    std::vector<bool> ordered(n, false);
    for (SiteId s = 0; s < delaunay.n_sites(); ++s) ordered[s] = is_fixed[delaunay.original_id(s)];
    constraints.fixed = FixedBlocks(std::move(ordered));
    return constraints;
}

/// Minimises the energy of a density and fills in `figures`.
RunStatistics minimize(MovingDelaunay& delaunay, const Lattice& lattice, const Density& density,
                       const CvtOptions& options, const OrbitEmbedding* orbits,
                       std::optional<DensityFigures>& figures) {
    Workers workers(options.run.n_threads);
    const DensityCvtResult result =
        minimize_density_energy(delaunay, workers, lattice, density,
                                {.minimize = solver_row(options.run.solver).minimize_density,
                                 .optimizer = preconditioned_options(delaunay, options),
                                 .orbits = orbits,
                                 .constraints = constraints_of(delaunay, options)});
    figures = result.figures;
    return result.run;
}

RunStatistics minimize(MovingDelaunay& delaunay, const CvtOptions& options,
                       const OrbitEmbedding* orbits) {
    const int n_tasks = delaunay.n_sites() / kSitesPerTask + 1;
    Workers workers(std::min(options.run.n_threads, n_tasks));
    const SiteConstraints constraints = constraints_of(delaunay, options);
    // A guard needs the positions of all sites.
    const bool relaxes = options.relaxes_active_sites && options.run.solver == Solver::kLbfgs &&
                         options.guard == nullptr;
    UniformObjective all(delaunay, workers, constraints, relaxes);
    std::optional<SymmetricObjective> symmetric;
    if (orbits != nullptr) symmetric.emplace(all, *orbits);
    Objective& objective = symmetric ? static_cast<Objective&>(*symmetric) : all;
    return minimize_energy(delaunay, objective, solver_row(options.run.solver).minimize,
                           preconditioned_options(delaunay, options), workers);
}

/// Triangulates the sites and frees the points, which are not needed afterwards.
MovingDelaunay triangulate(const Lattice& lattice, Points points, Numbering numbering) {
    return MovingDelaunay(Sites(lattice, points), numbering);
}

/// @param density, orbits  nullptr: none.
CvtResult minimized(MovingDelaunay delaunay, const Lattice& lattice, const Density* density,
                    const OrbitEmbedding* orbits, const CvtOptions& options) {
    require_distinct(delaunay);
    // Minimise the energy.
    CvtOptions with_positions = options;
    const std::function<Points()> positions = [&delaunay] { return delaunay.positions(); };
    if (options.run.progress) {
        with_positions.run.progress = [&](Progress progress) {
            progress.positions = &positions;
            return options.run.progress(progress);
        };
    }
    std::optional<DensityFigures> figures;
    const RunStatistics run =
        density ? minimize(delaunay, lattice, *density, with_positions, orbits, figures)
                : minimize(delaunay, with_positions, orbits);
    // Convert the result to the caller's order and units.
    const DelaunayCounts counts = delaunay.counts();
    auto [sites, triangulation] = delaunay.release();
    const double bound = hexagonal_bound(lattice.area(), sites.n_sites());
    return {.delaunay = {std::move(sites), std::move(triangulation)},
            .run = run,
            .energy_bound = bound,
            .counts = counts,
            .density = figures};
}

}  // namespace

CvtResult compute_cvt(const Lattice& lattice, Points points, const CvtOptions& options) {
    return minimized(triangulate(lattice, std::move(points), options.numbering), lattice,
                     options.density ? &*options.density : nullptr, nullptr, options);
}

CvtResult compute_cvt(const Sites& start, const CvtOptions& options) {
    return minimized(MovingDelaunay(start, options.numbering), start.lattice(),
                     options.density ? &*options.density : nullptr, nullptr, options);
}

CvtResult compute_cvt(const SymmetricSites& start, const CvtOptions& options) {
    MovingDelaunay delaunay(start.sites);
    const OrbitEmbedding orbits = tie_orbits(start, delaunay);
    std::optional<Density> density;
    if (options.density) density = folded_density(*options.density, start.group);
    return minimized(std::move(delaunay), start.group.lattice(), density ? &*density : nullptr,
                     &orbits, options);
}

double hexagonal_bound(double area, int n_sites) {
    return 5 * area * area / (18 * std::sqrt(3.0) * n_sites);
}

}  // namespace pcvt::plane
