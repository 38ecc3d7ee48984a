#pragma once

#include <span>
#include <string>

#include "mesher/formula/formula_program.hpp"

namespace pcvt {

/// Reads a formula in variables with these names.
///
/// Constants pi, _pi and _e; operators + - * / ^, comparisons, && || and `if ? then : else`;
/// functions sin cos tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh exp ln log (both
/// natural) log2 log10 sqrt abs sign rint min max sum avg. Numbers have a decimal point in every
/// locale. Blanks, tabs and line ends separate; other control characters and all that is not ASCII
/// are refused.
///
/// Example usage:
///     const std::vector<std::string> names{"x", "y"};
///     FormulaEvaluator evaluate(read_formula("x^2 + exp(-y)", names));
///
/// @param variables  one letter each; their places are the numbers of the program's variables.
/// @throws InvalidInput `character 7: problem; remedy`, with characters counted from 1.
FormulaProgram read_formula(const std::string& text, std::span<const std::string> variables);

}  // namespace pcvt
