#pragma once

#include "mesher/formula/block_function.hpp"

namespace pcvt {

// Hyperbolic functions of blocks of numbers and their inverses, vectorised, with the laws of
// block_exponentials.hpp.

BlockFunction block_sinh;
BlockFunction block_cosh;
BlockFunction block_tanh;
BlockFunction block_asinh;
BlockFunction block_acosh;
BlockFunction block_atanh;

}  // namespace pcvt
