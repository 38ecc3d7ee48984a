#include "mesher/space/cvt/cvt.hpp"

#include <cmath>

#include "mesher/optimize/lbfgs.hpp"
#include "mesher/optimize/lloyd.hpp"
#include "mesher/portable/portable_functions.hpp"
#include "mesher/space/energy/energy_pass.hpp"
#include "mesher/torus/coincident_sites.hpp"

namespace pcvt::space {
namespace {

constexpr int kNumbers = MovingTetrahedra::kNumbersPerSite;
/// The longest move of a site in one step, in units of h. Beyond it a site leaves its
/// neighbourhood, where the optimiser's quadratic model holds.
constexpr double kLargestMove = 0.5;

/// The energy as a function of moving sites, in the frame and the unit of the tetrahedra.
class EnergyObjective final : public Objective {
   public:
    EnergyObjective(MovingTetrahedra& moving, Workers& workers)
        : moving_(moving), pass_(moving, workers) {}

    Eigen::Index n_variables() const override { return kNumbers * Eigen::Index{moving_.n_sites()}; }

    bool evaluate(const Eigen::VectorXf& direction, double t, Evaluation& evaluation) override {
        reject();
        if (t != 0 && !moving_.step(direction, t)) return false;
        if (!pass_.evaluate(energy_)) return false;
        evaluation.value = energy_.value;
        // The number of each site that is not used stays zero.
        if (evaluation.gradient.size() != n_variables()) evaluation.gradient.setZero(n_variables());
        double largest = 0;
        double sum = 0;
        for (Eigen::Index s = 0; s < moving_.n_sites(); ++s) {
            const Vec3 gradient = energy_.gradient.segment<3>(3 * s);
            evaluation.gradient.segment<3>(kNumbers * s) = gradient;
            const double square = (gradient / (2 * energy_.volume[s])).squaredNorm();
            largest = std::max(largest, square);
            sum += square;
        }
        evaluation.residual = std::sqrt(largest) / moving_.spacing();
        evaluation.rms_residual = std::sqrt(sum / moving_.n_sites()) / moving_.spacing();
        return true;
    }

    void accept() override { moving_.settle(); }
    void reject() override {
        if (!moving_.settled()) moving_.step_back();
    }

    void lloyd_step(const Evaluation& evaluation, Eigen::VectorXf& direction) const override {
        direction.setZero(n_variables());
        for (Eigen::Index s = 0; s < moving_.n_sites(); ++s) {
            const Vec3 gradient = evaluation.gradient.segment<3>(kNumbers * s);
            direction.segment<3>(kNumbers * s) =
                (gradient / (-2 * energy_.volume[s])).cast<float>();
        }
    }

   private:
    MovingTetrahedra& moving_;
    EnergyPass pass_;
    Energy energy_;
};

Sites distinct_sites(const Lattice& lattice, const Points& points) {
    Sites sites(lattice, points);
    Eigen::Matrix3d periods;
    for (int k = 0; k < 3; ++k) periods.col(k) = sites.reduction().reduced.periods()[k];
    auto pairs = coincident_sites(sites.coordinates(), periods, kCoincident * sites.spacing());
    if (!pairs.empty()) throw DuplicateSites(std::move(pairs));
    return sites;
}

}  // namespace

CvtResult compute_cvt(const Lattice& lattice, const Points& points, const CvtOptions& options) {
    MovingTetrahedra moving(distinct_sites(lattice, points));
    Workers workers(options.n_threads);
    EnergyObjective objective(moving, workers);
    const double value_unit = std::pow(moving.unit(), 5);
    // A site is two pairs of variables, (x, y) and z, so its move is at most sqrt(2) that of a
    // pair.
    const OptimizerOptions optimizer{.tolerance = options.tolerance,
                                     .max_iterations = options.max_iterations,
                                     .max_move = std::sqrt(0.5) * kLargestMove * moving.spacing(),
                                     .progress = [&](Progress progress) {
                                         progress.value *= value_unit;
                                         return !options.progress || options.progress(progress);
                                     }};
    RunStatistics run = options.solver == Solver::kLloyd
                            ? minimize_lloyd(objective, optimizer).run
                            : minimize_lbfgs(objective, optimizer, workers).run;
    objective.reject();
    run.energy *= value_unit;
    const int n_rebuilds = moving.n_rebuilds();
    return {moving.release(), run, n_rebuilds};
}

double body_centred_energy(double volume, int n_sites) {
    const double n = n_sites;
    const double root = portable_cbrt(volume);
    return 3 * 19.0 / (192.0 * portable_cbrt(2.0)) * (volume * root * root) / portable_cbrt(n * n);
}

}  // namespace pcvt::space
