#pragma once

#include <cstdint>
#include <optional>

#include "mesher/optimize/minimum.hpp"
#include "mesher/optimize/run_statistics.hpp"
#include "mesher/torus/coincident_sites.hpp"
#include "plugin/pcvt.h"

namespace pcvt::abi {

/// PCVT_STOP_...
std::int32_t stop_number(Stop stop);

/// PCVT_MINIMUM_...
std::int32_t minimum_number(const std::optional<Minimum>& minimum);

/// The status of a run that has a result; says why where it is not PCVT_OK.
pcvt_status status_of(int max_iterations, const RunStatistics& run);

/// The pairs of pcvt_statistics::dropped; nullptr for none.
const std::int32_t* dropped_pairs(const DroppedSites& dropped);

/// PCVT_CANCELLED, with its message.
pcvt_status cancelled_status();

}  // namespace pcvt::abi
