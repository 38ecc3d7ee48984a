#include "mesher/formula/formula_program.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "mesher/formula/block_arithmetic.hpp"
#include "mesher/formula/block_exponentials.hpp"

namespace pcvt {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

double value_of(const FormulaProgram& program, double x, double y) {
    FormulaEvaluator evaluate(program);
    evaluate.variable(0)[0] = x;
    evaluate.variable(1)[0] = y;
    return evaluate(1)[0];
}

TEST(FormulaProgram, UsesItsValuesInOrder) {
    FormulaProgram program(2);
    program.push_variable(0);
    program.push_number(2);
    program.apply(block_divide);
    program.push_variable(1);
    program.apply(block_subtract);
    EXPECT_EQ(program.n_values(), 1);
    EXPECT_EQ(value_of(program, 3, 5), 1.5 - 5);
    program.push_variable(0);
    program.swap();
    program.apply(block_subtract);
    EXPECT_EQ(value_of(program, 3, 5), 3 - (1.5 - 5));
}

TEST(FormulaProgram, NumbersAreComputedAtOnce) {
    FormulaProgram program(1);
    program.push_number(2);
    program.push_number(10);
    program.apply_power();
    program.push_number(1);
    program.apply(block_less);
    program.push_variable(0);
    program.push_number(7);
    program.apply(block_exp);
    program.apply_choice();
    EXPECT_FALSE(program.uses(0));
    EXPECT_EQ(FormulaEvaluator(program)(1)[0], one_of_block(block_exp, 7));
}

TEST(FormulaProgram, FoldsFromLeftToRight) {
    FormulaProgram program(2);
    for (const double number : {64.0, 4.0, 2.0}) program.push_number(number);
    program.push_variable(1);
    program.fold(block_divide, 4);
    EXPECT_EQ(program.n_values(), 1);
    EXPECT_EQ(value_of(program, 0, 4), 2);
}

TEST(FormulaProgram, ChoosesPointByPoint) {
    FormulaProgram program(2);
    program.push_variable(0);
    program.push_variable(0);
    program.push_variable(1);
    program.apply(block_add);
    program.push_variable(1);
    program.apply(block_exp);
    program.apply_choice();
    EXPECT_EQ(value_of(program, 3, 5), 8);
    EXPECT_EQ(value_of(program, 0, 1), one_of_block(block_exp, 1));
    EXPECT_TRUE(std::isnan(value_of(program, kNan, 5)));  // NaN is not 0
}

TEST(FormulaProgram, BlocksAgreeWithSinglePoints) {
    // Results take the rows of values that are used up.
    FormulaProgram program(2);
    program.push_variable(0);
    program.apply(block_exp);
    program.push_variable(1);
    program.apply(block_exp);
    program.apply(block_add);
    program.push_number(4);
    program.apply_power();
    program.push_variable(0);
    program.apply(block_multiply);
    FormulaEvaluator evaluate(program);
    std::vector<double> expected;
    for (int k = 0; k < evaluate.block(); ++k) expected.push_back(value_of(program, k, -k));
    for (int n = 1; n <= evaluate.block(); n += 9) {
        for (int k = 0; k < n; ++k) {
            evaluate.variable(0)[k] = k;
            evaluate.variable(1)[k] = -k;
        }
        const double* const values = evaluate(n);
        for (int k = 0; k < n; ++k) ASSERT_EQ(values[k], expected[k]);
    }
}

/// (x - 0.1)^2.
void push_square(FormulaProgram& program) {
    program.push_variable(0);
    program.push_number(0.1);
    program.apply(block_subtract);
    program.push_number(2);
    program.apply_power();
}

// Pairs of operators that become one operation, with rows that are used before and afterwards.
TEST(FormulaProgram, PairsOfOperatorsKeepTheirBits) {
    FormulaProgram square(2);  // y + (x - 0.1)^2
    square.push_variable(1);
    push_square(square);
    square.apply(block_add);
    FormulaProgram squares(2);  // ((x - 0.1)^2 + (x - 0.1)^2) + exp(y)
    push_square(squares);
    push_square(squares);
    squares.apply(block_add);
    squares.push_variable(1);
    squares.apply(block_exp);
    squares.apply(block_add);
    FormulaProgram product(2);  // (x y + 7) / (y + y x)
    product.push_variable(0);
    product.push_variable(1);
    product.apply(block_multiply);
    product.push_number(7);
    product.apply(block_add);
    product.push_variable(1);
    product.push_variable(1);
    product.push_variable(0);
    product.apply(block_multiply);
    product.apply(block_add);
    product.apply(block_divide);
    FormulaProgram quotient(2);  // -x / 3 + -y / x
    quotient.push_variable(0);
    quotient.apply(block_negative);
    quotient.push_number(3);
    quotient.apply(block_divide);
    quotient.push_variable(1);
    quotient.apply(block_negative);
    quotient.push_variable(0);
    quotient.apply(block_divide);
    quotient.apply(block_add);
    std::mt19937_64 random(5);
    for (int k = 0; k < 1000; ++k) {
        const double x = 4e-19 * static_cast<double>(random());
        const double y = 3e-19 * static_cast<double>(random()) - 2;
        const double s = (x - 0.1) * (x - 0.1);
        ASSERT_EQ(value_of(square, x, y), y + s);
        ASSERT_EQ(value_of(squares, x, y), (s + s) + one_of_block(block_exp, y));
        ASSERT_EQ(value_of(product, x, y), (x * y + 7) / (y + y * x));
        ASSERT_EQ(value_of(quotient, x, y), -x / 3 + -y / x);
    }
}

TEST(BlockArithmetic, ConditionsAreNumbers) {
    EXPECT_EQ(one_of_block(block_less, 1, 2), 1);
    EXPECT_EQ(one_of_block(block_less, 2, 2), 0);
    EXPECT_EQ(one_of_block(block_less_or_equal, 2, 2), 1);
    EXPECT_EQ(one_of_block(block_equal, kNan, kNan), 0);
    EXPECT_EQ(one_of_block(block_differ, kNan, kNan), 1);
    EXPECT_EQ(one_of_block(block_and, 0.5, -3), 1);
    EXPECT_EQ(one_of_block(block_and, 0.5, -0.0), 0);
    EXPECT_EQ(one_of_block(block_or, 0, 0), 0);
    EXPECT_EQ(one_of_block(block_or, 0, 0.1), 1);
}

TEST(BlockArithmetic, RoundsAndSigns) {
    for (const double x : {0.49999999999999994, 0.5, 1.5, 2.5, -0.5, -1.5, -2.5, 1e300, -1e300,
                           0x1p52 + 1, 0x1p51 + 0.5, -0x1p51 - 0.5, 0.0}) {
        EXPECT_EQ(one_of_block(block_round, x), std::floor(x + 0.5)) << x;
    }
    EXPECT_EQ(one_of_block(block_sign, -1e-320), -1);
    EXPECT_EQ(one_of_block(block_sign, 7), 1);
    EXPECT_EQ(one_of_block(block_sign, -0.0), 0);
    EXPECT_EQ(one_of_block(block_sign, kNan), 0);
    EXPECT_EQ(one_of_block(block_min, 3, kNan), 3);
    EXPECT_EQ(one_of_block(block_max, 3, 4), 4);
    EXPECT_EQ(one_of_block(block_abs, -3), 3);
}

}  // namespace
}  // namespace pcvt
