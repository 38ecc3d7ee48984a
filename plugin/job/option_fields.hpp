#pragma once

#include <string_view>
#include <vector>

#include "plugin/job/features.hpp"

namespace pcvt {

/// The row of a field of pcvt.h, nullptr for one that every job can have.
///
/// Example usage:
///   if (find_field("areas")->in_space) ...
const FeatureRow* find_field(std::string_view field);

/// The fields of pcvt.h that an option of the command sets, whether every job can have it or not.
std::vector<std::string_view> option_fields(std::string_view option);

}  // namespace pcvt
