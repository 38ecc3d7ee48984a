#pragma once

#include "mesher/formula/block_function.hpp"

namespace pcvt {

// Trigonometric functions of blocks of numbers and their inverses, in radians, vectorised, with the
// laws of block_exponentials.hpp. Numbers above a million take longer, one by one.

BlockFunction block_sin;
BlockFunction block_cos;
BlockFunction block_tan;
BlockFunction block_asin;
BlockFunction block_acos;
BlockFunction block_atan;
/// The angle of the point (b, a), as std::atan2(a, b).
BlockFunction2 block_atan2;

}  // namespace pcvt
