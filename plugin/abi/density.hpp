#pragma once

#include "plugin/abi/guard.hpp"
#include "plugin/job/job.hpp"

namespace pcvt::abi {

/// Gives the job the density of the options, if they have one. A callback is asked on one thread
/// only, so the job then runs on one.
/// @param options  its callback is asked as long as the job's density lives.
/// @param host     the floating-point environment that it is called in.
/// @throws InvalidInput for a callback and a source at once, a range without a picture, and what
///         source_density throws. The density itself throws CallbackFault where the callback does,
///         or returns anything but 0.
void set_density(const pcvt_options& options, const std::fenv_t& host, Job& job);

}  // namespace pcvt::abi
