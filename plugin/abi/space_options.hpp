#pragma once

#include "plugin/job/space_job.hpp"
#include "plugin/pcvt.h"

namespace pcvt::abi {

/// Whether the options describe a run in three dimensions.
///
///   if (means_space(options)) return compute_space_job(make_space_job(options), callback);
///
/// @throws InvalidInput for an unknown dimension, and for the period vectors of space in the plane.
bool means_space(const pcvt_options& options);

/// The job that the options describe. Copies the sites.
/// @pre the dimension is 3.
/// @throws InvalidInput naming the field, also for each field that applies to the plane alone.
Job make_space_job(const pcvt_options& options);

/// The forms that the options choose for the file `path`.
/// @throws InvalidInput naming the field, also for each field that applies to the plane alone.
SpaceFileOptions space_file_options(const std::string& path, const pcvt_write_options& options);

}  // namespace pcvt::abi
