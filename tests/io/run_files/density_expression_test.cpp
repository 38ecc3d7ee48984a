#include "io/run_files/density_expression.hpp"

#include <gmock/gmock.h>

#include <clocale>
#include <cmath>
#include <locale>
#include <numbers>
#include <thread>

#include "mesher/formula/block_angles.hpp"
#include "mesher/formula/block_exponentials.hpp"
#include "mesher/formula/block_hyperbolics.hpp"
#include "tests/support/densities.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

double value(const std::string& expression, const plane::DensityPoint& point) {
    return testing::value_at(expression_density(expression).make_function(), point);
}

TEST(DensityExpression, KnowsItsVariablesFunctionsAndConstants) {
    const plane::DensityPoint p{3, 5, 0.25, 0.75};
    EXPECT_EQ(value("1000*x + 100*y + 10*u + v", p), 3000 + 500 + 2.5 + 0.75);
    EXPECT_DOUBLE_EQ(value("exp(sin(2*pi*u) + cos(2*pi*v))", p),
                     std::exp(1 + std::cos(1.5 * std::numbers::pi)));
    EXPECT_EQ(value("u < 0.5 && v >= 0.5 ? 100 : 1", p), 100);
    EXPECT_EQ(value("max(x, y)^2 - abs(-1)", p), 24);
    EXPECT_EQ(value("x == 3", p), 1);
    EXPECT_EQ(value("x != 3 || y <= 5", p), 1);
}

TEST(DensityExpression, CallsTheBlockFunctions) {
    // Some of the 400 values of a function differ in the last digit from those of another library.
    const auto expect = [](const std::string& name, BlockFunction* function, double low) {
        for (int k = 0; k < 400; ++k) {
            const double x = low + k / 450.0;
            EXPECT_EQ(value(name + "(x)", {x, 0, 0, 0}), one_of_block(function, x))
                << name << " " << x;
        }
    };
    expect("sin", block_sin, 0.1);
    expect("cos", block_cos, 0.1);
    expect("tan", block_tan, 0.1);
    expect("asin", block_asin, 0.1);
    expect("acos", block_acos, 0.1);
    expect("atan", block_atan, 0.1);
    expect("sinh", block_sinh, 0.1);
    expect("cosh", block_cosh, 0.1);
    expect("tanh", block_tanh, 0.1);
    expect("asinh", block_asinh, 0.1);
    expect("acosh", block_acosh, 1.1);
    expect("atanh", block_atanh, 0.1);
    expect("exp", block_exp, 0.1);
    expect("log", block_log, 1.1);
    expect("ln", block_log, 1.1);
    expect("log2", block_log2, 1.1);
    expect("log10", block_log10, 1.1);
    EXPECT_EQ(value("atan2(x, y)", {0.3, -0.7, 0, 0}), one_of_block(block_atan2, 0.3, -0.7));
}

TEST(DensityExpression, HasNoMemory) {
    const plane::DensityFunction f = expression_density("1 + u").make_function();
    EXPECT_EQ(testing::value_at(f, {0, 0, 0.5, 0}), 1.5);
    EXPECT_EQ(testing::value_at(f, {0, 0, 0.25, 0}), 1.25);
    EXPECT_EQ(testing::value_at(f, {0, 0, 0.5, 0}), 1.5);
}

std::string expression_refusal(const std::string& expression) {
    try {
        expression_density(expression);
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "accepted";
}

TEST(DensityExpression, FaultsNameTheirCharacter) {
    EXPECT_THAT(expression_refusal("1 + foo"),
                StartsWith("character 5: Unexpected token \"foo\"; "));
    EXPECT_THAT(expression_refusal("u )"), StartsWith("character 3: "));
    EXPECT_THAT(expression_refusal("(1 + u"), StartsWith("character 7: Missing parenthesis; "));
    EXPECT_THAT(expression_refusal("1 +"),
                StartsWith("character 4: Unexpected end of expression; "));
    EXPECT_THAT(expression_refusal("sin(1, 2)"),
                HasSubstr("Too many parameters for function \"sin\"; "));
    EXPECT_THAT(expression_refusal("1 + 2,5"), StartsWith("character 6: several formulas"));
    EXPECT_THAT(expression_refusal("u = 3"), StartsWith("character 3: an assignment"));
    EXPECT_THAT(expression_refusal("1 + (v = 3)"), StartsWith("character 8: an assignment"));
    EXPECT_THAT(expression_refusal("2 + u**2"),
                StartsWith("character 6: ** is not an operator; write ^"));
    EXPECT_THAT(expression_refusal("u > 1 ? 2"), StartsWith("character 10: "));
    for (const char* bad : {"", " ", "1 2", "\"text\"", "1e400", "0x10", "u'", "@", "=", "u="}) {
        EXPECT_THAT(expression_refusal(bad), StartsWith("character ")) << bad;
    }
    EXPECT_THAT(expression_refusal(std::string(100000, '(')), StartsWith("character "));
    EXPECT_THAT(expression_refusal("1" + std::string(1000000, '+') + "1"),
                StartsWith("character "));
}

TEST(DensityExpression, RefusesCharactersThatNoFormulaHolds) {
    for (const char control : {'\0', '\a', '\b', '\v', '\f', '\x1b', '\x7f'}) {
        EXPECT_EQ(expression_refusal(std::string("1 +") + control + "u"),
                  "character 4: a control character; remove it");
    }
    EXPECT_EQ(value("1 +\t2\r\n+ 3", {}), 6);
    for (const char* foreign : {"1 \xE2\x88\x92 u", "2 \xC3\x97 u", "u \xC2\xB2", "2 \xFF"}) {
        EXPECT_THAT(expression_refusal(foreign),
                    StartsWith("character 3: not a character of a formula; "));
    }
}

/// A locale facet that writes a comma for the decimal point.
struct CommaPoint : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

TEST(DensityExpression, NumbersHaveAPointInEveryLocale) {
    const std::locale before = std::locale::global(std::locale(std::locale(), new CommaPoint));
    const double found = value("1234.5 + max(0.25, u)", {0, 0, 0.125, 0});
    std::locale::global(before);
    EXPECT_EQ(found, 1234.75);
}

TEST(DensityExpression, FunctionsOfOneDensityDoNotDisturbEachOther) {
    const plane::Density density = expression_density("u + 0 * sin(v)");
    std::vector<std::thread> team;
    std::vector<int> wrong(4, 0);
    for (int t = 0; t < 4; ++t) {
        team.emplace_back([&, t] {
            const plane::DensityFunction f = density.make_function();
            for (int k = 1; k < 5000; ++k)
                wrong[t] += testing::value_at(f, {0, 0, k * 1e-4 + t, 0}) != k * 1e-4 + t;
        });
    }
    for (std::thread& thread : team) thread.join();
    EXPECT_THAT(wrong, ::testing::Each(0));
}

}  // namespace
}  // namespace pcvt
