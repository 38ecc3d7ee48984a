#pragma once

#include <array>

#include "mesher/base/simd.hpp"

namespace pcvt {

/// A function of each number of a block: writes y[k] = f(x[k]) for k < n. The arrays must not
/// overlap, and must have room for whole_lanes(n) numbers. The result of a number depends neither
/// on n nor on its place.
///
/// Example usage:
///
///     std::array<double, 64> x{}, y{};
///     block_exp(x.data(), y.data(), 64);
///     const double e = one_of_block(block_exp, 1);
using BlockFunction = void(const double* x, double* y, int n);
/// A function of each pair of numbers: y[k] = f(a[k], b[k]).
using BlockFunction2 = void(const double* a, const double* b, double* y, int n);

/// A function of three numbers.
using BlockFunction3 = void(const double* a, const double* b, const double* c, double* y, int n);

/// The function of one number, with the bits of a block.
inline double one_of_block(BlockFunction* f, double x) {
    std::array<double, kLanes> in{};
    std::array<double, kLanes> out{};
    in.fill(x);
    f(in.data(), out.data(), 1);
    return out[0];
}
inline double one_of_block(BlockFunction2* f, double a, double b) {
    std::array<double, kLanes> first{};
    std::array<double, kLanes> second{};
    std::array<double, kLanes> out{};
    first.fill(a);
    second.fill(b);
    f(first.data(), second.data(), out.data(), 1);
    return out[0];
}

}  // namespace pcvt
