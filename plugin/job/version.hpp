#pragma once

namespace pcvt {

/// "major.minor.patch".
const char* version();

}  // namespace pcvt
