#pragma once

#include <optional>

#include "mesher/cvt/cvt.hpp"
#include "mesher/search/lattice_pattern.hpp"

namespace pcvt {

/// A site that lies further from its place, in units of h, is not on the lattice. At a lattice that
/// is no degenerate critical point a CVT this near can only be that lattice, not yet converged.
inline constexpr double kOffLattice = 1e-3;

/// The lattice that the sites of a result form, up to one common translation and kOffLattice h; or
/// nothing where they form none. Whether the cells have six sides does not matter (a rectangular
/// lattice has four).
std::optional<LatticePattern> as_lattice(const CvtResult& result);

}  // namespace pcvt
