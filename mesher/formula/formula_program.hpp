#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "mesher/formula/block_function.hpp"

namespace pcvt {

/// A formula as a list of operations, each of which covers a block of points. Operations on numbers
/// are carried out at once, with the bits of a block. Some pairs of operators that follow each
/// other become one operation with the same bits, since reading and writing a block takes longer
/// than the arithmetic.
///
/// Example usage:
///
///     FormulaProgram program(2);  // of the variables 0 and 1; in reverse Polish notation
///     program.push_variable(0);
///     program.push_variable(1);
///     program.push_number(2);
///     program.apply_power();
///     program.apply(block_add);   // variable 0 + (variable 1)^2
///     FormulaEvaluator evaluate(program);
class FormulaProgram {
   public:
    explicit FormulaProgram(int n_variables) : n_variables_(n_variables) {}

    void push_variable(int variable);
    void push_number(double number);
    /// Replaces the last value by its function.
    void apply(BlockFunction* function);
    /// Replaces the last two values by their function.
    void apply(BlockFunction2* function);
    /// Replaces the last n values by their function, from left to right: f(f(a, b), c).
    void fold(BlockFunction2* function, int n);
    /// Exchanges the last two values.
    void swap() { std::swap(values_.back(), values_[values_.size() - 2]); }
    /// Replaces the last two values by a power. The powers 2, 3 and 4 are products.
    void apply_power();
    /// Replaces the last three values, a condition and two numbers, by one of the numbers. Both are
    /// computed.
    void apply_choice();

    int n_variables() const { return n_variables_; }
    /// The number of values that have been pushed and not yet used.
    int n_values() const { return static_cast<int>(values_.size()); }
    /// Whether the value depends on a variable.
    bool uses(int variable) const;

   private:
    friend class FormulaEvaluator;

    enum class Kind { kOne, kTwo, kThree };
    /// Rows are variables, then results of operations. A negative row -1 - k is number k.
    struct Operation {
        Kind kind;
        BlockFunction* one;
        BlockFunction2* two;
        BlockFunction3* three;
        int operands[3];
        int result;
    };

    bool is_number(int row) const { return row < 0; }
    double number(int row) const { return numbers_[static_cast<std::size_t>(-1 - row)]; }
    bool ends_with(BlockFunction2* function, int row) const;
    bool add_to_last(int a, int b);
    bool divide_negative(int a, int b);
    int number_row(double value);
    int pop();
    int take_row();
    void release(int row);

    int n_variables_;
    std::vector<Operation> operations_;
    /// The distinct numbers.
    std::vector<double> numbers_;
    /// The rows of the values that are not yet used.
    std::vector<int> values_;
    std::vector<int> free_rows_;
    int n_rows_ = 0;
};

/// Evaluates a program for one thread.
///
/// Example usage:
///     FormulaEvaluator evaluate(program);
///     evaluate.variable(0)[0] = 0.3;  // of the first point; each variable has block() numbers
///     const double* values = evaluate(1);
class FormulaEvaluator {
   public:
    /// @param program  with one value.
    explicit FormulaEvaluator(FormulaProgram program);

    /// The greatest number of points at once.
    int block() const { return block_; }
    /// The numbers of a variable, to be filled in for all points.
    double* variable(int k) { return row(k); }
    /// The values at n points, valid until the next call.
    /// @param n  1 ... block().
    const double* operator()(int n);
    /// Writes the values at any number of points.
    /// @param variables  the numbers of each variable; null for those that the program does not
    /// use.
    /// @param values     like the variables, with room for whole_lanes(n) numbers.
    void operator()(const double* const* variables, double* values, std::size_t n);

   private:
    double* row(int k);
    void compute(const double* const* variables, std::size_t from, double* values, int n);

    FormulaProgram program_;
    int block_;
    std::vector<double> memory_;
};

}  // namespace pcvt
