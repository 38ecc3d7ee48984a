#pragma once

#include "mesher/optimize/objective.hpp"
#include "mesher/plane/geometry/sites.hpp"

namespace pcvt::bench {

/// The paper's method: L-BFGS from the same start as compute_cvt, until the RMS residual is at most
/// `rms`, with a new mirror diagram for each evaluation.
OptimizerResult mirror_run(const plane::Lattice& lattice, const plane::Points& points, double rms);

}  // namespace pcvt::bench
