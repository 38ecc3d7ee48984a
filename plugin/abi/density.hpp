#pragma once

#include "plugin/abi/guard.hpp"
#include "plugin/job/job.hpp"

namespace pcvt::abi {

/// Sets the job's density, if the options have one. A callback runs on one thread only, so the job
/// then has one thread.
/// @param options  must live as long as the job's density, which calls its callback.
/// @param host     the floating-point environment for the callback.
/// @throws InvalidInput for a callback together with a source, a range without a picture, and as
///         source_density does. The density itself throws CallbackFault if the callback throws or
///         returns anything but 0.
void set_density(const pcvt_options& options, const std::fenv_t& host, Job& job);

}  // namespace pcvt::abi
