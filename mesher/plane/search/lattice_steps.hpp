#pragma once

#include <cstdint>

namespace pcvt::plane {

/// A vector in n-ths of the reduced period vectors.
struct LatticeStep {
    std::int64_t i;
    std::int64_t j;
};

/// The remainder from 0 to n - 1, also of negative values.
inline std::int64_t remainder_of(std::int64_t value, std::int64_t n) { return (value % n + n) % n; }

}  // namespace pcvt::plane
