#pragma once

#include <random>
#include <string>

namespace pcvt::testing {

/// Returns `bytes` with one to four faults: a byte changed, a range removed or duplicated, a number
/// replaced by an extreme one. The same state of `random` gives the same result on every machine.
std::string mutated(std::string bytes, std::mt19937_64& random);

}  // namespace pcvt::testing
