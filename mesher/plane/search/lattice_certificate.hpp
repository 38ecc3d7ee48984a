#pragma once

#include <optional>

#include "mesher/plane/cvt/cvt.hpp"
#include "mesher/plane/search/lattice_pattern.hpp"

namespace pcvt::plane {

/// The largest distance, in units of h, between a site and its lattice point. Unless the lattice is
/// a degenerate critical point, a CVT this near to it is that lattice, not fully converged.
inline constexpr double kOffLattice = 1e-3;

/// Returns the lattice that the sites of a result form, up to one common translation and
/// kOffLattice h, or `nullopt` if they form none. The number of sides of the cells does not matter
/// (the cells of a rectangular lattice have four).
///
/// Example usage:
///   if (const auto pattern = as_lattice(compute_cvt(unit, points, {}))) {
///       std::cout << "lattice " << pattern->form.a << " " << pattern->form.b << "\n";
///   }
std::optional<LatticePattern> as_lattice(const CvtResult& result);

}  // namespace pcvt::plane
