#include "mesher/plane/cvt/density_cvt.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>

#include "mesher/cvt/residuals.hpp"
#include "mesher/plane/density/density_survey.hpp"
#include "mesher/plane/energy/density_energy.hpp"
#include "mesher/plane/energy/gersho_scaling.hpp"
#include "mesher/plane/energy/long_waves.hpp"

namespace pcvt::plane {
namespace {

/// The target residual of the first round, and the factor from one round to the next.
constexpr double kFirstTarget = 0.1;
constexpr double kNextTarget = 0.01;
/// The ratio of the admitted quadrature error to the target residual. The gradient by quadrature
/// differs from the gradient of the quadratured F by about 20 times that error.
constexpr double kAccuracyPerTarget = 1.0 / 200;
/// Below this the difference between two rules is rounding error.
constexpr double kBestAccuracy = 1e-11;
constexpr int kMostRepetitions = 5;

/// In periods: longer cells are cut into parts of at most this length, because even a rule of the
/// highest order would not resolve the density over the whole cell.
constexpr double kLongestPart = 1.0 / 8;

/// Whether the period along a, and the period along b, is so short that cells of size h are cut
/// along it.
std::array<bool, 2> short_periods(const Lattice& lattice, double h) {
    return {h > kLongestPart * lattice.area() / lattice.b().norm(),
            h > kLongestPart * lattice.area() / lattice.a().norm()};
}

/// Adds the break lines that cut cells of size h.
Density cut_for(const Lattice& lattice, Density density, double h) {
    const auto [cut_u, cut_v] = short_periods(lattice, h);
    for (double at = kLongestPart; at < 1; at += kLongestPart) {
        if (cut_u) density.u_breaks.push_back(at);
        if (cut_v) density.v_breaks.push_back(at);
    }
    return density;
}

double accuracy_for(double residual) {
    return std::max(kAccuracyPerTarget * residual, kBestAccuracy);
}

/// The energy as a function of scaled variables z_i = scale_i x_i.
class DensityObjective final : public Objective {
   public:
    DensityObjective(MovingDelaunay& delaunay, Workers& workers, const Lattice& lattice,
                     const Density& density, double density_unit, bool has_hessian,
                     const SiteConstraints<MovingDelaunay>& constraints)
        : delaunay_(delaunay),
          workers_(workers),
          constraints_(constraints),
          pass_(delaunay, workers, lattice, density, density_unit),
          has_hessian_(has_hessian),
          scale_(Eigen::VectorXd::Ones(delaunay.n_sites())) {}

    Eigen::Index n_variables() const override { return 2 * Eigen::Index{delaunay_.n_sites()}; }
    bool evaluate(const Eigen::VectorXf& direction, double t, Evaluation& evaluation) override;
    bool precondition(Evaluation& evaluation) override;
    void accept() override { delaunay_.settle(); }
    void reject() override { undo_step(); }
    bool has_hessian() const override { return has_hessian_; }
    void hessian(BlockMatrix& hessian) const override;
    void lloyd_step(const Evaluation& evaluation, Eigen::VectorXf& direction) const override;

    /// Chooses the quadrature rules and the scales at the current point.
    void begin_round(double accuracy);
    /// Raises the order of the rules that miss the accuracy at the current point.
    RuleCheck check_rules(double accuracy);
    /// Evaluates at the current point and returns the statistics there.
    DensityFigures figures();

   private:
    /// Restores the triangulation after a trial that was not accepted.
    bool undo_step() {
        if (delaunay_.settled()) return true;
        delaunay_.step_back();
        return pass_.restore();
    }
    bool try_step(const Eigen::VectorXf& direction, double t);
    void measure(Evaluation& evaluation) const;
    void apply_long_waves(Evaluation& evaluation);

    MovingDelaunay& delaunay_;
    Workers& workers_;
    const SiteConstraints<MovingDelaunay>& constraints_;
    mutable DensityPass pass_;
    bool has_hessian_;
    Energy energy_;
    Eigen::VectorXd scale_;
    /// The mean of m_i / scale_i^2 over h^2: the stiffness relative to rho = 1.
    double stiffness_ = 1;
    std::unique_ptr<LongWaves> long_waves_;
    /// The last direction, in unscaled variables.
    Eigen::VectorXf direction_;
};

bool DensityObjective::evaluate(const Eigen::VectorXf& direction, double t,
                                Evaluation& evaluation) {
    if (!undo_step() || !try_step(direction, t)) return false;
    measure(evaluation);
    if (long_waves_) apply_long_waves(evaluation);
    return true;
}

/// In scaled variables the stiffness against long waves is uniform, as for rho = 1: for cells of
/// size l the energy is proportional to rho l^4 times the squared strain of x, hence to rho l^4 /
/// h^2 times the squared gradient of z, and rho l^4 is constant.
bool DensityObjective::precondition(Evaluation& evaluation) {
    if (delaunay_.n_sites() < kFewestForLongWaves) return false;
    long_waves_ = std::make_unique<LongWaves>(delaunay_, workers_);
    apply_long_waves(evaluation);
    return true;
}

void DensityObjective::apply_long_waves(Evaluation& evaluation) {
    long_waves_->apply(evaluation.gradient, evaluation.preconditioned);
    evaluation.preconditioned /= static_cast<float>(stiffness_);
    constraints_.fixed.clear(evaluation.preconditioned);
}

bool DensityObjective::try_step(const Eigen::VectorXf& direction, double t) {
    if (t != 0) {
        direction_.resize(n_variables());
        for (Eigen::Index s = 0; s < scale_.size(); ++s) {
            direction_.segment<2>(2 * s) =
                direction.segment<2>(2 * s) / static_cast<float>(scale_[s]);
        }
        if (!delaunay_.step(direction_, t, workers_)) return false;
        if (!constraints_.admit(delaunay_)) return false;
    }
    if (!pass_.evaluate(energy_)) return false;
    constraints_.fixed.clear(energy_.gradient);
    return true;
}

void DensityObjective::measure(Evaluation& evaluation) const {
    evaluation.gradient.resize(n_variables());
    for (Eigen::Index s = 0; s < scale_.size(); ++s) {
        evaluation.gradient.segment<2>(2 * s) = energy_.gradient.segment<2>(2 * s) / scale_[s];
    }
    const auto [largest, rms] =
        residuals(energy_.gradient, energy_.mass, delaunay_.spacing(), workers_);
    evaluation.value = energy_.value;
    evaluation.residual = largest;
    evaluation.rms_residual = constraints_.fixed.rms_factor() * rms;
}

void DensityObjective::lloyd_step(const Evaluation& evaluation, Eigen::VectorXf& direction) const {
    direction.resize(n_variables());
    for (Eigen::Index s = 0; s < scale_.size(); ++s) {
        const double per_mass = scale_[s] * scale_[s] / (-2 * energy_.mass[s]);
        direction.segment<2>(2 * s) =
            (per_mass * evaluation.gradient.segment<2>(2 * s)).cast<float>();
    }
}

void DensityObjective::hessian(BlockMatrix& hessian) const {
    pass_.hessian(energy_.mass, hessian);
    for (int i = 0; i < hessian.n_rows(); ++i) {
        for (double& number : hessian.diagonal[i]) number /= scale_[i] * scale_[i];
        for (int k = hessian.row_begin[i]; k < hessian.row_begin[i + 1]; ++k) {
            const auto factor = static_cast<float>(1 / (scale_[i] * scale_[hessian.column[k]]));
            for (float& number : hessian.block[k]) number *= factor;
        }
    }
    constraints_.fixed.restrict_hessian(hessian);
}

void DensityObjective::begin_round(double accuracy) {
    pass_.restore();
    pass_.choose_orders(accuracy, true);
    pass_.evaluate(energy_);
    // Normalise the scales so that the sum of (h / scale_i)^2 is the area of the domain.
    scale_ = (energy_.mass.array() / pass_.areas().array()).sqrt().sqrt();
    scale_ *= std::sqrt(scale_.array().square().inverse().mean());
    const double h = delaunay_.spacing();
    stiffness_ = (energy_.mass.array() / scale_.array().square()).mean() / (h * h);
    long_waves_.reset();
}

RuleCheck DensityObjective::check_rules(double accuracy) {
    pass_.restore();
    return pass_.choose_orders(accuracy, false);
}

DensityFigures DensityObjective::figures() {
    pass_.evaluate(energy_);
    const GershoScaling law = compare_with_gersho_scaling(energy_.mass, pass_.areas());
    return {.least = pass_.range().least,
            .greatest = pass_.range().greatest,
            .evaluations_per_site = pass_.evaluations_per_site(),
            .mass = energy_.mass.sum(),
            .spacing_deviation = law.median_deviation,
            .expected_energy = law.energy};
}

/// Runs the rounds, sums their counts and reports progress with the sums.
class Rounds {
   public:
    Rounds(Objective& objective, Workers& workers, const DensityCvtOptions& options,
           double value_unit)
        : objective_(objective), workers_(workers), options_(options), value_unit_(value_unit) {}

    /// @returns false if the run was cancelled or has reached its iteration limit.
    bool run(double target) {
        OptimizerOptions round = options_.optimizer;
        round.tolerance = target;
        if (round.max_iterations >= 0) round.max_iterations -= total_.iterations;
        if (round.progress) {
            round.progress = [&](const Progress& progress) { return report(progress); };
        }
        RunStatistics run = options_.minimize(objective_, round, workers_).run;
        run.add_counts(total_);
        total_ = run;
        first_ = false;
        return total_.stop == Stop::kConverged || total_.stop == Stop::kStalled;
    }
    const RunStatistics& total() const { return total_; }

   private:
    bool report(Progress progress) const {
        if (!first_ && progress.iteration == 0) return true;
        if (!first_) {
            progress.iteration += total_.iterations;
            progress.evaluations += total_.evaluations;
        }
        progress.value *= value_unit_;
        return options_.optimizer.progress(progress);
    }

    Objective& objective_;
    Workers& workers_;
    const DensityCvtOptions& options_;
    double value_unit_;
    RunStatistics total_;
    bool first_ = true;
};

/// Runs all rounds and returns the last check of the rules.
RuleCheck run_rounds(DensityObjective& objective, Rounds& rounds, const OptimizerOptions& options) {
    const double accuracy = accuracy_for(options.tolerance);
    if (options.max_iterations != 0) {
        for (double target = kFirstTarget; target > options.tolerance; target *= kNextTarget) {
            objective.begin_round(accuracy_for(target));
            if (!rounds.run(target)) return objective.check_rules(accuracy);
        }
    }
    objective.begin_round(accuracy);
    for (int repetition = 0;; ++repetition) {
        const bool done = !rounds.run(options.tolerance);
        const RuleCheck check = objective.check_rules(accuracy);
        if (done || check.n_raised == 0 || repetition == kMostRepetitions) return check;
    }
}

}  // namespace

DensityCvtResult minimize_density_energy(MovingDelaunay& delaunay, Workers& workers,
                                         const Lattice& lattice, const Density& density,
                                         const DensityCvtOptions& options) {
    const double unit = DensitySurvey(lattice, density, kSurveyResolution).unit();
    const double area_unit = delaunay.unit() * delaunay.unit() * unit;
    const double h = delaunay.spacing() * delaunay.unit();
    const Density cut = cut_for(lattice, density, h);
    const auto [cut_u, cut_v] = short_periods(lattice, h);
    DensityObjective objective(delaunay, workers, lattice, cut, unit, !cut_u && !cut_v,
                               options.constraints);
    std::optional<SymmetricObjective> symmetric;
    if (options.orbits != nullptr) symmetric.emplace(objective, *options.orbits);
    Objective& minimized = symmetric ? static_cast<Objective&>(*symmetric) : objective;
    Rounds rounds(minimized, workers, options, area_unit * delaunay.unit() * delaunay.unit());
    const RuleCheck check = run_rounds(objective, rounds, options.optimizer);
    DensityCvtResult result{rounds.total(), objective.figures()};
    result.figures.n_rough_cells = check.n_rough;
    result.figures.quadrature_error = check.largest_error;
    result.figures.mass *= area_unit;
    result.figures.mass_deviation = result.figures.mass / integral(lattice, density) - 1;
    result.figures.expected_energy *= area_unit * delaunay.unit() * delaunay.unit();
    result.run.energy *= area_unit * delaunay.unit() * delaunay.unit();
    return result;
}

}  // namespace pcvt::plane
