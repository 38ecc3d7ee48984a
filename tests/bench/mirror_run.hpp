#pragma once

#include "mesher/lattice/sites.hpp"
#include "mesher/optimize/objective.hpp"

namespace pcvt::bench {

/// The paper's method: L-BFGS from the same start as compute_cvt, until the RMS residual is at most
/// `rms`, with a new mirror diagram for each evaluation.
OptimizerResult mirror_run(const Lattice& lattice, const Points& points, double rms);

}  // namespace pcvt::bench
