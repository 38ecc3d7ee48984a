#pragma once

#include "mesher/cvt/density_cvt.hpp"
#include "mesher/delaunay/moving_delaunay.hpp"
#include "mesher/delaunay/periodic_delaunay.hpp"
#include "mesher/optimize/objective.hpp"

namespace pcvt {

/// `kLbfgs` is finished by Newton's method where a minimum is near, `kNewton` is that method from
/// the start (relay.hpp); `kPlainLbfgs` and `kLloyd` are the paper's, without anything of this.
enum class Solver { kLbfgs, kLloyd, kNewton, kPlainLbfgs };

struct CvtOptions {
    Solver solver = Solver::kLbfgs;
    /// Largest |x_i - g_i| / h at which the run has converged, h = sqrt(area / n).
    double tolerance = 1e-6;
    /// Negative: no limit. 0: the periodic Voronoi diagram of the sites as given.
    int max_iterations = -1;
    /// L-BFGS treats long waves apart (long_waves.hpp) once the root mean square residual is below
    /// this; 0: never. Begun much earlier it leads random sites to higher minima.
    double precondition_below = 3e-4;
    /// At least 1. The result does not depend on it.
    int n_threads = 1;
    /// Nothing: rho = 1.
    std::optional<Density> density = {};
    ProgressCallback progress;
};

/// A periodic tessellation and how it was reached.
struct CvtResult {
    PeriodicDelaunay delaunay;
    Stop stop;
    int iterations;
    int evaluations;
    /// Of Newton's method, not counted among the evaluations: Hessians, and products with them.
    int hessians;
    int cg_products;
    /// F of Eq. 3, length^4, with a density times its unit.
    double energy;
    /// 5 A^2 / (18 sqrt(3) n), the hexagonal lower bound for rho = 1, length^4.
    double energy_bound;
    /// max and root mean square of |x_i - g_i| / h.
    double residual;
    double rms_residual;
    DelaunayCounts counts;
    /// Of runs with a density.
    std::optional<DensityFigures> density = {};
};

/// Optimises the sites; points are 2 x n, length units, and need not be wrapped.
/// @throws BadDensity as minimize_density_energy does; InvalidInput, DuplicateSites as Sites does;
/// DuplicateSites also for two sites nearer to
///         each other than kSameVertex h (sites.hpp).
CvtResult compute_cvt(const Lattice& lattice, Points points, const CvtOptions& options);

/// 5 area^2 / (18 sqrt(3) n) (paper, Table I, for any area).
double hexagonal_bound(double area, int n_sites);

}  // namespace pcvt
