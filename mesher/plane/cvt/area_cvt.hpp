#pragma once

#include <Eigen/Core>

#include "mesher/cvt/run_options.hpp"
#include "mesher/plane/cvt/area_newton.hpp"
#include "mesher/plane/delaunay/periodic_delaunay.hpp"
#include "mesher/plane/symmetry/symmetric_sites.hpp"

namespace pcvt::plane {

/// |m_i - a_i| <= area_tolerance(n) a_i at the end of a run with n sites, unless rounding prevents
/// it. Two sites at a distance d divide the cells between them with an error of about 1e-17 A l /
/// d, with A the area of the domain and l the length of their edge.
inline double area_tolerance(int n_sites) {
    return n_sites <= 20'000 ? 1e-10 : (n_sites <= 200'000 ? 1e-9 : 1e-8);
}

struct AreaCvtOptions {
    /// length^2, of each site, with the sum of the domain's area (scaled_areas).
    Eigen::VectorXd areas;
    /// The numbers of the result's sites, in whose order the areas are.
    Numbering numbering = Numbering::kAsGiven;
    /// max_iterations counts the steps that move each site to the centroid of its cell, whose
    /// weight follows. 0: the sites stay. Negative: they move until each is the centroid of its
    /// cell. A limited number of steps does not end before the tolerance. The solver is L-BFGS.
    RunOptions run = {.max_iterations = 0};
    /// Called with the figures of the weights of each position, as SizeNewton::solve does.
    NewtonCallback newton_progress = {};
};

struct AreaCvtResult {
    /// The regular triangulation, with the weights, which sum to zero.
    PeriodicDelaunay delaunay;
    /// energy: the sum of the integrals of |p - x_i|^2 over the power cells, length^4. residual,
    /// rms_residual: maximum and RMS |x_i - g_i| / h. converged: the areas were reached, and the
    /// residual is at most the tolerance; stalled: the areas were not reached.
    RunStatistics run;
    /// The figures of the last areas; newton_steps, products and trials count the whole run.
    SizeFigures areas;
    DelaunayCounts counts;
};

/// @throws InvalidInput unless there is one area for each site.
void require_areas(const AreaCvtOptions& options, int n_sites);

/// Finds the power diagram whose cells have prescribed areas, and optionally moves the sites to the
/// centroids of their cells, in the same areas.
///
/// The fully centroidal run minimises E(x) = max over w of g(x, w) (size_newton.hpp), the energy of
/// the cells of prescribed areas, by L-BFGS. Its gradient is 2 a_i (x_i - g_i), because w is a
/// maximum (M. Balzer, T. Schloemer, O. Deussen 2009; F. de Goes et al. 2012).
///
/// Example usage:
///
///     const Eigen::VectorXd areas = scaled_areas(draw_areas(law, n, seed), n, lattice.area());
///     const AreaCvtResult grains =
///         compute_area_cvt(lattice, points, {.areas = areas, .run = {.max_iterations = 5}});
///     const PeriodicMesh cells = cell_mesh(grains.delaunay);
///
/// @param points  2 x n, length units; need not be wrapped.
/// @throws InvalidInput and DuplicateSites as Sites and require_distinct do, and InvalidInput if
///         there are not n areas.
AreaCvtResult compute_area_cvt(const Lattice& lattice, const Points& points,
                               const AreaCvtOptions& options);

/// The same for sites with a symmetry, which they and their weights keep to the last bit.
/// @param options  areas are those of start.sites, equal on each orbit; the numbering is that of
///                 start.sites.
AreaCvtResult compute_area_cvt(const SymmetricSites& start, const AreaCvtOptions& options);

}  // namespace pcvt::plane
