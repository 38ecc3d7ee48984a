#pragma once

#include "mesher/formula/block_function.hpp"

namespace pcvt {

// The operators of formulas on blocks of numbers, vectorised. Conditions are numbers, true unless
// they are 0; comparisons and logical operators give 1 or 0.

BlockFunction2 block_add;
BlockFunction2 block_subtract;
BlockFunction2 block_multiply;
BlockFunction2 block_divide;

BlockFunction2 block_less;
BlockFunction2 block_less_or_equal;
BlockFunction2 block_equal;
BlockFunction2 block_differ;
BlockFunction2 block_and;
BlockFunction2 block_or;

/// The smaller and the larger number of a pair, as std::min and std::max.
BlockFunction2 block_min;
BlockFunction2 block_max;

BlockFunction block_negative;
/// The size of a number; that of -0 is -0.
BlockFunction block_abs;
/// -1, 0 or 1; 0 for NaN.
BlockFunction block_sign;
/// The whole number that is nearest to x; the larger of two equally near ones.
BlockFunction block_round;

/// Operators one after the other, each of which rounds as if it were alone: (a - b)^2, c + a b and
/// c + (a - b)^2. A block is read and written once.
BlockFunction2 block_squared_difference;
BlockFunction3 block_add_product;
BlockFunction3 block_add_squared_difference;

/// y[k] = a[k] is true ? b[k] : c[k].
BlockFunction3 block_choose;

}  // namespace pcvt
