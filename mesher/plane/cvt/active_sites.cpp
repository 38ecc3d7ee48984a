#include "mesher/plane/cvt/active_sites.hpp"

#include <memory>

#include "mesher/cvt/cvt_objective.hpp"
#include "mesher/optimize/lbfgs.hpp"
#include "mesher/plane/energy/patch_energy.hpp"

namespace pcvt::plane {
namespace {

/// With fewer sites a run is short. With smaller tolerances two thirds of the sites would be
/// active, and with larger ones the run would end before the other sites are relaxed.
constexpr int kFewestSites = 20'000;
constexpr double kLeastTolerance = 1e-4;
constexpr double kLargestTolerance = 1.5e-3;
/// The number of iterations with all sites before the first round: for up to 10^5 sites, and for
/// each doubling of this number. After fewer, the run ends with a higher energy, by more than 2e-5.
constexpr int kIterationsBefore = 110;
constexpr int kIterationsPerDoubling = 7;
constexpr int kManySites = 100'000;
/// Residuals above this share of the tolerance make sites active, if at most the other share of all
/// sites has them.
constexpr double kActiveShare = 0.8;
constexpr double kMostActive = 0.015;
/// The number of iterations with all sites between two rounds, where those outside of patches
/// relax, and after a count that found too many.
constexpr int kIterationsBetweenRounds = 2;
constexpr int kIterationsBetweenCounts = 5;
/// Rings of neighbours that move with an active site. With three rings, residuals come back from
/// the edge of the patch in 40 rounds without an end; with 14, a round costs more than it saves.
constexpr int kRings = 10;
/// Where a minimiser of a patch ends.
constexpr double kPatchTolerance = 0.15;
constexpr int kMostPatchIterations = 60;
/// Runs at n = 10^5 and 10^6 need 3 to 12 rounds. After this number, rounds do not help.
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

int iterations_before(int n_sites) {
    int iterations = kIterationsBefore;
    for (; n_sites > kManySites; n_sites /= 2) iterations += kIterationsPerDoubling;
    return iterations;
}

}  // namespace

ActiveSites::ActiveSites(MovingDelaunay& delaunay, Workers& workers, const FixedBlocks& fixed)
    : delaunay_(delaunay),
      workers_(workers),
      fixed_(fixed),
      n_to_wait_(iterations_before(delaunay.n_sites())) {}

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
    const bool in_range = tolerance >= kLeastTolerance && tolerance <= kLargestTolerance;
    if (n_sites < kFewestSites || !in_range || n_rounds_ == kMostRounds) return false;
    if (n_waited_++ < n_to_wait_) return false;
    n_waited_ = 0;
    const std::vector<SiteId> first = sites_above(kActiveShare * tolerance, gradient, mass);
    if (double(first.size()) > kMostActive * n_sites) {
        n_to_wait_ = kIterationsBetweenCounts - 1;
        return false;
    }
    run_round(first, tolerance);
    n_to_wait_ = kIterationsBetweenRounds;
    ++n_rounds_;
    return true;
}

}  // namespace pcvt::plane
