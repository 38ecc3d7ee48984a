#pragma once

#include "mesher/space/geometry/sites.hpp"

namespace pcvt::space {

/// Wraps points into the domain.
/// @throws InvalidInput as Sites does, and DuplicateSites with all sites that are nearer than
///         1e-9 h to an earlier one.
Sites distinct_sites(const Lattice& lattice, const Points& points);

}  // namespace pcvt::space
