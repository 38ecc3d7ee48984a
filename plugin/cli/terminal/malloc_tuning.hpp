#pragma once

namespace pcvt::cli {

/// From now on freed memory stays with the process for its next array, where the system's allocator
/// can be told so: each file and each proof takes tens of megabytes and gives them back, and pages
/// that the kernel hands out anew cost more than what is written on them.
void keep_freed_memory();

}  // namespace pcvt::cli
