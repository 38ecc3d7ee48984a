#include "mesher/base/checkpoint.hpp"

namespace pcvt::detail {

constinit thread_local Client* client_of_thread = nullptr;

}  // namespace pcvt::detail
