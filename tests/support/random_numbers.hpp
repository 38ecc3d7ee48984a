#pragma once

#include <random>

namespace pcvt::testing {

/// A number from 0, which is possible, to 1, which is not.
inline double random_number(std::mt19937_64& random) {
    return std::uniform_real_distribution<double>()(random);
}

/// An integer from `first` to `last`, both of which are possible.
inline int random_integer(std::mt19937_64& random, int first, int last) {
    return std::uniform_int_distribution(first, last)(random);
}

}  // namespace pcvt::testing
