#include "mesher/base/huge_pages.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

namespace pcvt {
namespace {

constexpr std::size_t kMillion = 1 << 20;

TEST(HugePages, LeaveTheContentsUnchanged) {
    for (const std::size_t n : {std::size_t{0}, std::size_t{1}, kMillion, 3 * kMillion + 5}) {
        std::vector<int> numbers(n);
        std::iota(numbers.begin(), numbers.end(), 7);
        prefer_huge_pages(numbers);
        for (std::size_t k = 0; k < n; ++k) ASSERT_EQ(numbers[k], 7 + static_cast<int>(k));
    }
}

/// The kernel's flags of the mapping at an address (proc(5), smaps); empty where the kernel does
/// not report them.
std::string flags_at(const void* address) {
    std::ifstream maps("/proc/self/smaps");
    bool inside = false;
    for (std::string line; std::getline(maps, line);) {
        std::uintptr_t begin = 0;
        std::uintptr_t end = 0;
        char dash = 0;
        if (std::istringstream(line) >> std::hex >> begin >> dash >> end && dash == '-') {
            const auto at = reinterpret_cast<std::uintptr_t>(address);
            inside = begin <= at && at < end;
        } else if (inside && line.starts_with("VmFlags:")) {
            return line + ' ';
        }
    }
    return "";
}

TEST(HugePages, AreAdvisedInTheMiddleOfALargeArray) {
    if (!std::filesystem::exists("/sys/kernel/mm/transparent_hugepage")) {
        GTEST_SKIP() << "this kernel has no huge pages";
    }
    const std::vector<int> advised(4 * kMillion, 1);
    const std::vector<int> other(4 * kMillion, 1);
    prefer_huge_pages(advised);
    EXPECT_NE(flags_at(&advised[2 * kMillion]).find(" hg "), std::string::npos);
    EXPECT_EQ(flags_at(&other[2 * kMillion]).find(" hg "), std::string::npos);
    EXPECT_NE(flags_at(&other[2 * kMillion]), "");
}

// Advice for less than a page would affect memory that belongs to others.
TEST(HugePages, AreNotAdvisedWhereNoneFits) {
    const std::vector<char> small(kMillion, 1);
    const std::string before = flags_at(&small[kMillion / 2]);
    prefer_huge_pages(small);
    EXPECT_EQ(flags_at(&small[kMillion / 2]), before);
}

}  // namespace
}  // namespace pcvt
