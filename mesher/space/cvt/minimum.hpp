#pragma once

#include "mesher/optimize/minimum.hpp"
#include "mesher/space/cvt/cvt.hpp"
#include "mesher/space/delaunay/periodic_delaunay.hpp"

namespace pcvt::space {

/// The number of sites up to which the answer `kYes` takes some seconds.
inline constexpr int kMostSitesForMinimum = 2000;

/// Decides whether stationary sites of space are a minimum of F, from the exact Hessian
/// (hessian.hpp). One site is always a minimum, since it has a single state modulo
/// translations.
///
/// Example usage:
///
///     const Minimum minimum = decided_minimum(result.delaunay);
///     std::cout << "minimum: " << minimum_name(minimum) << '\n';
///
/// Cost: sparse factorisations, of order n^2.
Minimum decided_minimum(const PeriodicDelaunay& delaunay);

/// The same of a run; `nullopt` if it did not converge, or has more than kMostSitesForMinimum
/// sites.
std::optional<Minimum> minimum_of(const CvtResult& result);

}  // namespace pcvt::space
