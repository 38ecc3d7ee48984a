#pragma once

#include "mesher/cvt/run_options.hpp"
#include "mesher/space/delaunay/periodic_delaunay.hpp"

namespace pcvt::space {

struct CvtOptions {
    /// In space the objective has no Hessian, so L-BFGS runs to the end for kNewton as for kLbfgs.
    RunOptions run = {};
};

/// A periodic tessellation of space and the figures of the run that computed it.
struct CvtResult {
    PeriodicDelaunay delaunay;
    /// The energy is F, length^5.
    RunStatistics run;
    /// Builds of the triangulation after the first one.
    int n_rebuilds = 0;
};

/// Moves the sites to a periodic CVT in space.
///
/// Example usage:
///   const Lattice cube = Lattice::box(1, 1, 1);
///   const CvtResult result = compute_cvt(cube, uniform_points(cube, 1000, 1), {});
///
/// @param points  3 x n, length units; need not be wrapped.
/// @throws InvalidInput as Sites does, and DuplicateSites with all sites that are nearer than
///         1e-9 h to an earlier one.
CvtResult compute_cvt(const Lattice& lattice, const Points& points, const CvtOptions& options);

/// The energy of n cells of the body-centred cubic lattice, truncated octahedra, of the same total
/// volume: no periodic tessellation with less energy is known.
double body_centred_energy(double volume, int n_sites);

}  // namespace pcvt::space
