#pragma once

namespace pcvt {

// Elementary functions from only additions, multiplications, divisions and square roots, which IEEE
// 754 rounds correctly: the same bits on every machine, unlike those of the system's library.
// Zeros, infinities and values out of the domain give the results of the standard functions.
//
// Example usage:
//
//     const double lognormal = portable_exp(sigma * normal);

/// The exponential function; the relative error is below 4e-15 for |x| <= 300.
double portable_exp(double x);

/// The natural logarithm; the relative error is below 4e-15.
double portable_log(double x);

/// The logarithms to the bases 2 and 10; the relative error is below 4e-15. That to the base 2 is
/// exact for powers of 2.
double portable_log2(double x);
double portable_log10(double x);

/// The cube root; the relative error is below 3e-16. It is exact for cubes of integers.
double portable_cbrt(double x);

}  // namespace pcvt
