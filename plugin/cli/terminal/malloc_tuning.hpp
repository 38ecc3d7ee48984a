#pragma once

namespace pcvt::cli {

/// Makes the allocator keep freed memory for the next array. Each file and each proof takes tens of
/// megabytes and frees them, and fresh pages from the kernel cost more time than filling them. Call
/// it once, at the beginning of main().
void keep_freed_memory();

}  // namespace pcvt::cli
