#include "plugin/job/version.hpp"

namespace pcvt {

const char* version() { return PCVT_VERSION; }

}  // namespace pcvt
