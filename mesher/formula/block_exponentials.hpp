#pragma once

#include "mesher/formula/block_function.hpp"

namespace pcvt {

// Exponentials, logarithms, powers and roots of blocks of numbers, vectorised. Only additions,
// multiplications, divisions and square roots occur, which IEEE 754 rounds correctly, in an order
// that does not depend on the vector unit: every machine gives the same bits. The same holds for
// block_hyperbolics.hpp and block_angles.hpp.
//
// Laws of these three files, tested by number:
//   (1) Errors are at most 2 units in the last place, also for the largest and the least arguments;
//       at most 1 for powers.
//   (2) Zeros, infinities, NaN and values out of the domain give the results of <cmath>.
//   (3) Cube roots, logarithms to the bases 2 and 10, and powers, are exact where the result has at
//       most 40 bits.

BlockFunction block_exp;
BlockFunction block_log;
BlockFunction block_log2;
BlockFunction block_log10;
/// Powers as std::pow defines them.
BlockFunction2 block_pow;
BlockFunction block_sqrt;
BlockFunction block_cbrt;

}  // namespace pcvt
