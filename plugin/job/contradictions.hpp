#pragma once

#include "mesher/base/error.hpp"
#include "plugin/job/job.hpp"

namespace pcvt {

/// Options of a job exclude each other. The message names them as the command does, all at once.
class ContradictoryOptions : public InvalidInput {
   public:
    using InvalidInput::InvalidInput;
};

/// Requires that no two features of a job (features.hpp) contradict each other, and that it has
/// those on which others depend.
///
/// Example usage:
///   require_compatible(job);
///
/// @throws ContradictoryOptions with all contradictions and their remedies.
void require_compatible(const Job& job);

}  // namespace pcvt
