#include "mesher/plane/cvt/coarse_levels.hpp"

namespace pcvt::plane {
namespace {

/// The RMS residual below which the long waves of a coarser problem are preconditioned.
constexpr double kPreconditionBelow = 1e-3;

}  // namespace

CvtOptions level_options(CoarseLevels& levels, const CoarseStartOptions& options) {
    CvtOptions level;
    level.run = levels.run();
    // Where the density is not smooth, an RMS residual of kCoarseTolerance may be out of reach.
    if (options.density) level.run.tolerance = kCoarseTolerance;
    level.precondition_below = kPreconditionBelow;
    level.density = options.density;
    return level;
}

}  // namespace pcvt::plane
