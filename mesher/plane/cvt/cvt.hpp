#pragma once

#include "mesher/cvt/run_options.hpp"
#include "mesher/plane/cvt/density_cvt.hpp"
#include "mesher/plane/delaunay/moving_delaunay.hpp"
#include "mesher/plane/delaunay/periodic_delaunay.hpp"
#include "mesher/plane/symmetry/symmetric_sites.hpp"

namespace pcvt::plane {

struct CvtOptions {
    RunOptions run;
    /// L-BFGS preconditions long waves (long_waves.hpp) once the RMS residual is below this; 0:
    /// never. With a much larger value random sites end in higher minima.
    double precondition_below = 3e-4;
    /// Whether the run may end with rounds of active sites (active_sites.hpp). For sites after a
    /// coarse start; from random sites such a run ends with a higher energy, by 1e-4.
    bool relaxes_active_sites = false;
    /// The numbers of the result's sites. By columns, neighbours have numbers near to each other,
    /// which suits meshes and the matrices of solvers.
    Numbering numbering = Numbering::kAsGiven;
    /// `nullopt`: rho = 1.
    std::optional<Density> density = {};
    /// Ids of sites that stay where they are, to the last bit; residuals and the tolerance are
    /// those of the others. In any order; repetitions count once.
    std::vector<SiteId> fixed = {};
    /// nullptr: all positions are admitted. Must outlive the run.
    SiteGuard<MovingDelaunay>* guard = nullptr;
};

/// A periodic tessellation and the figures of the run that computed it.
struct CvtResult {
    PeriodicDelaunay delaunay;
    /// The energy is F of Eq. 3.
    RunStatistics run;
    /// 5 A^2 / (18 sqrt(3) n), the hexagonal lower bound for rho = 1, length^4.
    double energy_bound;
    DelaunayCounts counts;
    /// Set for runs with a density.
    std::optional<DensityFigures> density = {};
};

/// Moves the sites to a periodic CVT.
///
/// Example usage:
///   const Lattice unit = Lattice::rectangle(1, 1);
///   const CvtResult result = compute_cvt(unit, uniform_points(unit, 1000, 1), {});
///   const PeriodicMesh cells = cell_mesh(result.delaunay);
///
/// @param points  2 x n, length units; need not be wrapped.
/// @throws InvalidInput  an id of a fixed site is none, or the numbering with fixed sites is not
///         as given.
/// @throws BadDensity as minimize_density_energy does.
/// @throws InvalidInput and DuplicateSites as Sites does; DuplicateSites also if two sites are
///         nearer to each other than kSameVertex h (sites.hpp).
CvtResult compute_cvt(const Lattice& lattice, Points points, const CvtOptions& options);
/// The same from sites with exact coordinates.
CvtResult compute_cvt(const Sites& start, const CvtOptions& options);

/// Moves sites to a periodic CVT with the symmetry of their plane group: orbits remain orbits to
/// the last bit, sites on mirrors stay there, and so do sites at centres of rotation. The result is
/// a minimum among the symmetric arrangements; of all arrangements it is often a saddle.
///
/// Example usage:
///   const PlaneGroup group(PlaneGroupName::kP4m, Lattice::rectangle(1, 1));
///   const OrbitPlan plan = distribute(group, special_positions(group), 240);
///   const CvtResult result = compute_cvt(random_sites(group, plan, 1), {});
///
/// @param options  the numbering is that of the sites; without fixed sites; a density is folded
/// (folded_density.hpp).
/// @throws as the function above does.
CvtResult compute_cvt(const SymmetricSites& start, const CvtOptions& options);

/// Returns 5 area^2 / (18 sqrt(3) n), the energy of n regular hexagons (paper, Table I, for any
/// area).
double hexagonal_bound(double area, int n_sites);

}  // namespace pcvt::plane
