#include "mesher/plane/cvt/active_sites.hpp"

#include <memory>

#include "mesher/cvt/cvt_objective.hpp"
#include "mesher/optimize/lbfgs.hpp"
#include "mesher/plane/energy/patch_energy.hpp"

namespace pcvt::plane {
namespace {

/// Below these numbers of sites and this tolerance rounds gain nothing: with 1e-5, two thirds of
/// the sites would be active.
constexpr int kFewestSites = 20'000;
constexpr double kLeastTolerance = 1e-4;
/// The number of iterations with all sites before the first round. Sooner, the run ends with a
/// higher energy: long waves, and sites with small residuals, relax only with all sites.
constexpr int kIterationsBefore = 100;
/// Residuals above this share of the tolerance make sites active, if these are few enough.
constexpr double kActiveShare = 0.8;
constexpr double kMostActiveShare = 0.01;
/// The number of iterations after which large residuals are counted again, if they were too many.
constexpr int kIterationsBetween = 5;
/// Rings of neighbours that move with an active site. With three rings, residuals come back from
/// the edge of the patch in 40 rounds without an end; with 14, a round costs more than it saves.
constexpr int kRings = 10;
/// Where a minimiser of a patch ends.
constexpr double kPatchTolerance = 0.15;
constexpr int kMostPatchIterations = 60;
/// Runs at n = 10^5 and 10^6 need 5 to 20 rounds. After this number, rounds do not help.
constexpr int kMostRounds = 40;

/// A patch with its minimised energy.
std::unique_ptr<DelaunayPatch> minimized_patch(const MovingDelaunay& whole, const PatchPlans& plans,
                                               int number, double tolerance) {
    auto patch = std::make_unique<DelaunayPatch>(whole, plans, number);
    Workers this_thread(1);
    const SiteConstraints<DelaunayPatch> none;
    CvtObjective<PatchPass> objective(*patch, this_thread, none);
    minimize_lbfgs(objective,
                   {.tolerance = tolerance,
                    .max_iterations = kMostPatchIterations,
                    .max_move = longest_move(*patch)},
                   this_thread);
    objective.reject();
    return patch;
}

}  // namespace

std::vector<SiteId> ActiveSites::sites_above(double residual, const Eigen::VectorXd& gradient,
                                             const Eigen::VectorXd& mass) const {
    std::vector<SiteId> sites;
    const double per_mass = 2 * residual * delaunay_.spacing();
    for (SiteId s = 0; s < delaunay_.n_sites(); ++s) {
        const double x = gradient[2 * s];
        const double y = gradient[2 * s + 1];
        const double largest = per_mass * mass[s];
        if (x * x + y * y > largest * largest) sites.push_back(s);
    }
    return sites;
}

void ActiveSites::run_round(const std::vector<SiteId>& first, double tolerance) {
    const PatchPlans plans(delaunay_.triangulation(), first, fixed_.is_fixed(), kRings);
    std::vector<std::unique_ptr<DelaunayPatch>> patches(
        static_cast<std::size_t>(plans.n_patches()));
    workers_.for_each(plans.n_patches(), [&](int k) {
        patches[k] = minimized_patch(delaunay_, plans, k, kPatchTolerance * tolerance);
    });
    for (const auto& patch : patches) {
        delaunay_.adopt(patch->moving(), patch->coordinates(), patch->flips());
    }
}

bool ActiveSites::relax(const Eigen::VectorXd& gradient, const Eigen::VectorXd& mass,
                        double tolerance) {
    const int n_sites = delaunay_.n_sites();
    if (n_sites < kFewestSites || tolerance < kLeastTolerance || n_rounds_ == kMostRounds) {
        return false;
    }
    if (n_calls_++ < kIterationsBefore) return false;
    const std::vector<SiteId> first = sites_above(kActiveShare * tolerance, gradient, mass);
    if (double(first.size()) > kMostActiveShare * n_sites) {
        n_calls_ = kIterationsBefore - kIterationsBetween + 1;
        return false;
    }
    run_round(first, tolerance);
    ++n_rounds_;
    return true;
}

}  // namespace pcvt::plane
