#pragma once

#include <random>
#include <string>

namespace pcvt::testing {

/// `bytes` with one to four faults: a byte changed, a range removed or doubled, a number exchanged
/// for an extreme one. The same for the same state of `random` on every machine.
std::string mutated(std::string bytes, std::mt19937_64& random);

}  // namespace pcvt::testing
