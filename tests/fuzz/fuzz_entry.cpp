#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/fuzz_targets.hpp"

/// netCDF and CGAL cope with a refused allocation; the limit itself is an option of libFuzzer.
extern "C" const char* __asan_default_options() { return "allocator_may_return_null=1"; }

/// The entry of libFuzzer into the target PCVT_FUZZ_TARGET; a violation is a crash.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const pcvt::testing::FuzzTarget& target =
        *pcvt::testing::find_fuzz_target(PCVT_FUZZ_TARGET);
    const std::string bytes(reinterpret_cast<const char*>(data), size);
    const std::string violation = pcvt::testing::run_fuzz_input(target, bytes);
    if (!violation.empty()) {
        std::fprintf(stderr, "%s\n", violation.c_str());
        std::abort();
    }
    return 0;
}
