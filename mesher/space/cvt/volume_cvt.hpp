#pragma once

#include <Eigen/Core>

#include "mesher/cvt/run_options.hpp"
#include "mesher/cvt/size_newton.hpp"
#include "mesher/space/delaunay/periodic_delaunay.hpp"
#include "mesher/space/power/power_diagram.hpp"

namespace pcvt::space {

/// |V_i - v_i| <= volume_tolerance(n) V / n at the end of a run with n sites, or the rounding of
/// weights (VolumeCvtResult::rounding), whichever is larger. Nearly always the error is also below
/// volume_tolerance(n) v_i.
inline double volume_tolerance(int n_sites) {
    return n_sites <= 20'000 ? 1e-10 : (n_sites <= 200'000 ? 1e-9 : 1e-8);
}

struct VolumeCvtOptions {
    /// length^3, of each site, positive, with the sum of the domain's volume.
    Eigen::VectorXd volumes;
    /// Gives the k-th largest volume to the site with the k-th largest Voronoi cell. After five
    /// steps the cells are rounder, and the sizes of neighbours are correlated.
    bool by_rank = false;
    /// max_iterations counts the centroidal steps: each moves every site by 1.5 times the way to
    /// the centroid of its cell, whose weight follows. 0: the sites stay. Negative: steps until the
    /// largest |x_i - g_i| / h is at most the tolerance. The solver is not used.
    RunOptions run = {.max_iterations = 0};
    /// Called with the figures of the weights of each position, as SizeNewton::solve does. Before
    /// the last position volumes are exact to 0.1, in later steps to 1e-4.
    NewtonCallback newton_progress = {};
};

struct VolumeCvtResult {
    /// The regular triangulation, with the weights, which sum to zero.
    PeriodicDelaunay delaunay;
    /// The prescribed volumes by site, length^3: options.volumes, in another order with `by_rank`.
    Eigen::VectorXd targets;
    /// The measured volumes of the cells by site, length^3.
    Eigen::VectorXd cell_volumes;
    /// energy: the sum of the integrals of |p - x_i|^2 over the power cells, length^5. residual,
    /// rms_residual: maximum and RMS |x_i - g_i| / h. converged: the volumes were reached, and the
    /// residual is at most the tolerance; stalled: the volumes were not reached.
    RunStatistics run;
    /// The figures of the last volumes; newton_steps, products and trials count the whole run.
    /// converged: volume_tolerance() was reached, or the rounding.
    SizeFigures volumes;
    /// max |V_i - v_i| over the mean volume.
    double largest_error = 0;
    /// SizeNewton::rounding() over the mean volume, where largest_error is above
    /// volume_tolerance(); else 0.
    double rounding = 0;
    PowerCounts counts;
    /// Builds of the triangulation after the first one.
    int n_rebuilds = 0;
};

/// @throws InvalidInput unless there are n positive finite volumes that sum to the volume of the
///         domain, to 1e-6 of it.
void require_volumes(const Eigen::VectorXd& volumes, const Lattice& lattice, Eigen::Index n_sites);

/// Finds the power diagram whose cells have prescribed volumes, and optionally moves the sites
/// towards the centroids of their cells, in the same volumes.
///
/// Example usage (five bold steps):
///
///     const VolumeCvtResult grains = compute_volume_cvt(
///         lattice, points, {.volumes = volumes, .by_rank = true, .run = {.max_iterations = 5}});
///     const Eigen::VectorXd& weights = grains.delaunay.weights;
///
/// Laws, tested by number:
///   (1) The cells have the prescribed volumes to volume_tolerance(n) mean volumes, or to
///       VolumeCvtResult::rounding, whichever is larger.
///   (2) The weights sum to zero; equal volumes on a lattice give equal weights.
///   (3) Every bit is the same for any number of threads.
///   (4) With by_rank, volumes are a permutation of those given, in the order of the Voronoi cells.
///
/// @param points  3 x n, length units; need not be wrapped.
/// @throws InvalidInput and DuplicateSites as compute_cvt does, and InvalidInput unless there are n
///         positive finite volumes that sum to the volume of the domain, to 1e-6 of it.
VolumeCvtResult compute_volume_cvt(const Lattice& lattice, const Points& points,
                                   const VolumeCvtOptions& options);

}  // namespace pcvt::space
