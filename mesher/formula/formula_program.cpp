#include "mesher/formula/formula_program.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "mesher/formula/block_arithmetic.hpp"
#include "mesher/formula/block_exponentials.hpp"
#include "mesher/formula/number_parts.hpp"

namespace pcvt {
namespace {

/// The number of points of a block: the rows of a usual formula stay in the first-level cache, and
/// the cost of a call is negligible.
constexpr int kMostPoints = 256;
/// A formula with thousands of rows gets shorter blocks, within this many numbers.
constexpr int kMostNumbers = 1 << 16;

}  // namespace

bool FormulaProgram::uses(int variable) const {
    const auto is_it = [=](int row) { return row == variable; };
    if (std::any_of(values_.begin(), values_.end(), is_it)) return true;
    return std::any_of(operations_.begin(), operations_.end(), [&](const Operation& operation) {
        return std::any_of(std::begin(operation.operands), std::end(operation.operands), is_it);
    });
}

int FormulaProgram::number_row(double value) {
    const auto same = [=](double number) { return bits_of(number) == bits_of(value); };
    const auto place = std::find_if(numbers_.begin(), numbers_.end(), same);
    const int row = -1 - static_cast<int>(place - numbers_.begin());
    if (place == numbers_.end()) numbers_.push_back(value);
    return row;
}

void FormulaProgram::push_variable(int variable) {
    assert(variable < n_variables_);
    values_.push_back(variable);
}

void FormulaProgram::push_number(double number) { values_.push_back(number_row(number)); }

int FormulaProgram::pop() {
    assert(!values_.empty());
    const int row = values_.back();
    values_.pop_back();
    return row;
}

int FormulaProgram::take_row() {
    if (free_rows_.empty()) return n_variables_ + n_rows_++;
    const int row = free_rows_.back();
    free_rows_.pop_back();
    return row;
}

void FormulaProgram::release(int row) {
    if (row >= n_variables_) free_rows_.push_back(row);
}

void FormulaProgram::apply(BlockFunction* function) {
    const int a = pop();
    if (is_number(a)) return push_number(one_of_block(function, number(a)));
    // A result never takes the place of an operand, because they must not overlap.
    const int result = take_row();
    operations_.push_back({Kind::kOne, function, nullptr, nullptr, {a, a, a}, result});
    release(a);
    values_.push_back(result);
}

void FormulaProgram::apply(BlockFunction2* function) {
    const int b = pop();
    const int a = pop();
    if (is_number(a) && is_number(b)) {
        return push_number(one_of_block(function, number(a), number(b)));
    }
    if (function == block_add && (add_to_last(a, b) || add_to_last(b, a))) return;
    if (function == block_divide && divide_negative(a, b)) return;
    const int result = take_row();
    operations_.push_back({Kind::kTwo, nullptr, function, nullptr, {a, b, b}, result});
    release(a);
    release(b);
    values_.push_back(result);
}

/// Whether the last operation is this function, and `row` its result.
bool FormulaProgram::ends_with(BlockFunction2* function, int row) const {
    return !operations_.empty() && operations_.back().result == row &&
           operations_.back().two == function;
}

// The last operation keeps its row where it takes in a further operator: no operand has that row.

/// Adds a to b, the result of the last operation, in the same operation.
bool FormulaProgram::add_to_last(int a, int b) {
    const bool is_product = ends_with(block_multiply, b);
    if (!is_product && !ends_with(block_squared_difference, b)) return false;
    Operation& last = operations_.back();
    last.kind = Kind::kThree;
    last.two = nullptr;
    last.three = is_product ? block_add_product : block_add_squared_difference;
    last.operands[2] = a;
    release(a);
    values_.push_back(b);
    return true;
}

/// Divides a, the negative that the last operation computed, by a number: x / -b is (-x) / b.
bool FormulaProgram::divide_negative(int a, int b) {
    if (!is_number(b) || operations_.empty()) return false;
    Operation& last = operations_.back();
    if (last.result != a || last.one != block_negative) return false;
    const int divisor = number_row(-number(b));
    last = {Kind::kTwo, nullptr, block_divide, nullptr, {last.operands[0], divisor, divisor}, a};
    values_.push_back(a);
    return true;
}

void FormulaProgram::fold(BlockFunction2* function, int n) {
    // The last operation needs the first number at the bottom, so take them in order.
    const std::vector<int> rows(values_.end() - n, values_.end());
    values_.resize(values_.size() - std::size_t(n) + 1);
    for (int k = 1; k < n; ++k) {
        values_.push_back(rows[static_cast<std::size_t>(k)]);
        apply(function);
    }
}

void FormulaProgram::apply_power() {
    const int exponent = values_.back();
    const double times = is_number(exponent) ? number(exponent) : 0;
    const bool is_product = times == 2 || times == 3 || times == 4;
    if (!is_product) return apply(block_pow);
    pop();
    const int base = pop();
    if (is_number(base)) {
        double product = number(base);
        for (int k = 1; k < times; ++k) product *= number(base);
        return push_number(product);
    }
    if (times == 2 && ends_with(block_subtract, base)) {
        operations_.back().two = block_squared_difference;
        values_.push_back(base);
        return;
    }
    int product = base;
    for (int k = 1; k < times; ++k) {
        const int result = take_row();
        operations_.push_back(
            {Kind::kTwo, nullptr, block_multiply, nullptr, {product, base, base}, result});
        if (product != base) release(product);
        product = result;
    }
    release(base);
    values_.push_back(product);
}

void FormulaProgram::apply_choice() {
    const int b = pop();
    const int a = pop();
    const int condition = pop();
    if (is_number(condition)) {
        const bool is_true = number(condition) != 0;
        release(is_true ? b : a);
        values_.push_back(is_true ? a : b);
        return;
    }
    const int result = take_row();
    operations_.push_back(
        {Kind::kThree, nullptr, nullptr, block_choose, {condition, a, b}, result});
    release(condition);
    release(a);
    release(b);
    values_.push_back(result);
}

FormulaEvaluator::FormulaEvaluator(FormulaProgram program) : program_(std::move(program)) {
    assert(program_.n_values() == 1);
    const auto n_numbers = static_cast<int>(program_.numbers_.size());
    const int n_rows = program_.n_variables_ + program_.n_rows_ + n_numbers;
    block_ = std::clamp(kMostNumbers / n_rows & -kLanes, kLanes, kMostPoints);
    memory_.resize(std::size_t(n_rows) * std::size_t(block_));
    // The numbers follow the rows.
    for (int k = 0; k < n_numbers; ++k) {
        std::fill_n(row(-1 - k), block_, program_.numbers_[static_cast<std::size_t>(k)]);
    }
}

double* FormulaEvaluator::row(int k) {
    const int place = k >= 0 ? k : program_.n_variables_ + program_.n_rows_ - 1 - k;
    return memory_.data() + std::ptrdiff_t{place} * block_;
}

/// Carries out the operations. Where variables are given, their numbers from `from` on take the
/// place of the evaluator's, and the last result goes to `values`.
void FormulaEvaluator::compute(const double* const* variables, std::size_t from, double* values,
                               int n) {
    const auto operand = [&](int k) -> const double* {
        const bool is_given = variables != nullptr && k >= 0 && k < program_.n_variables_;
        return is_given ? variables[k] + from : row(k);
    };
    const std::vector<FormulaProgram::Operation>& operations = program_.operations_;
    for (const FormulaProgram::Operation& operation : operations) {
        const double* const a = operand(operation.operands[0]);
        const double* const b = operand(operation.operands[1]);
        const bool is_last = values != nullptr && &operation == &operations.back();
        double* const y = is_last ? values : row(operation.result);
        switch (operation.kind) {
            case FormulaProgram::Kind::kOne:
                operation.one(a, y, n);
                break;
            case FormulaProgram::Kind::kTwo:
                operation.two(a, b, y, n);
                break;
            case FormulaProgram::Kind::kThree:
                operation.three(a, b, operand(operation.operands[2]), y, n);
                break;
        }
    }
}

const double* FormulaEvaluator::operator()(int n) {
    assert(n >= 1 && n <= block_);
    compute(nullptr, 0, nullptr, n);
    return row(program_.values_.back());
}

void FormulaEvaluator::operator()(const double* const* variables, double* values, std::size_t n) {
    const int result = program_.values_.back();
    for (std::size_t from = 0; from < n; from += std::size_t(block_)) {
        const std::size_t n_here = std::min(n - from, std::size_t(block_));
        if (result >= program_.n_variables_) {
            compute(variables, from, values + from, static_cast<int>(n_here));
        } else {
            // A number or a variable.
            const double* const numbers = result < 0 ? row(result) : variables[result] + from;
            std::copy_n(numbers, n_here, values + from);
        }
    }
}

}  // namespace pcvt
