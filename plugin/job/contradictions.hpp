#pragma once

#include "plugin/job/job.hpp"

namespace pcvt {

/// Requires that no two features of a job (features.hpp) contradict each other, and that it has
/// those on which others depend.
///
/// Example usage:
///   require_compatible(job);
///
/// @throws InvalidInput with the remedy.
void require_compatible(const Job& job);

}  // namespace pcvt
