#pragma once

#include <cstdint>

namespace pcvt {

/// Sites are numbered from 0 in the order of the input, everywhere.
///
///     for (SiteId s = 0; s < sites.n_sites(); ++s) use(sites.position(s));
using SiteId = std::int32_t;

}  // namespace pcvt
