#pragma once

#include "plugin/job/job.hpp"
#include "plugin/pcvt.h"

namespace pcvt::abi {

pcvt_options default_options();

/// The job that the options describe. Copies the sites.
/// @throws InvalidInput, LimitExceeded naming the field, also for each one that the dimension of
/// the
///         job does not have.
Job make_job(const pcvt_options& options);

}  // namespace pcvt::abi
