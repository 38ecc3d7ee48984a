#include "io/run_files/formula.hpp"

#include <gmock/gmock.h>
#include <muParser.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "mesher/base/error.hpp"
#include "mesher/formula/block_angles.hpp"
#include "mesher/formula/block_arithmetic.hpp"
#include "mesher/formula/block_exponentials.hpp"
#include "mesher/formula/block_hyperbolics.hpp"

namespace pcvt {
namespace {

using ::testing::EndsWith;
using ::testing::StartsWith;

const std::vector<std::string> kNames{"x", "y", "u", "v"};

template <BlockFunction* kFunction>
double one(double x) {
    return one_of_block(kFunction, x);
}
double angle(double y, double x) { return one_of_block(block_atan2, y, x); }

/// The same formula, evaluated by muParser point by point.
class PointByPoint {
   public:
    explicit PointByPoint(const std::string& text) {
        parser_.EnableOptimizer(false);
        parser_.DefineConst("pi", 3.14159265358979323846);
        parser_.DefineFun("sin", one<block_sin>);
        parser_.DefineFun("cos", one<block_cos>);
        parser_.DefineFun("tan", one<block_tan>);
        parser_.DefineFun("asin", one<block_asin>);
        parser_.DefineFun("acos", one<block_acos>);
        parser_.DefineFun("atan", one<block_atan>);
        parser_.DefineFun("sinh", one<block_sinh>);
        parser_.DefineFun("cosh", one<block_cosh>);
        parser_.DefineFun("tanh", one<block_tanh>);
        parser_.DefineFun("asinh", one<block_asinh>);
        parser_.DefineFun("acosh", one<block_acosh>);
        parser_.DefineFun("atanh", one<block_atanh>);
        parser_.DefineFun("log2", one<block_log2>);
        parser_.DefineFun("log10", one<block_log10>);
        parser_.DefineFun("log", one<block_log>);
        parser_.DefineFun("ln", one<block_log>);
        parser_.DefineFun("exp", one<block_exp>);
        parser_.DefineFun("atan2", angle);
        for (std::size_t k = 0; k < kNames.size(); ++k) parser_.DefineVar(kNames[k], &point_[k]);
        parser_.SetExpr(text);
        parser_.Eval();
    }
    double operator()(const std::array<double, 4>& point) {
        std::copy(point.begin(), point.end(), point_);
        return parser_.Eval();
    }
    int n_formulas() const { return parser_.GetNumResults(); }

   private:
    double point_[4] = {0.5, 0.5, 0.5, 0.5};
    mu::Parser parser_;
};

std::vector<double> values_of(const std::string& text,
                              const std::vector<std::array<double, 4>>& points) {
    FormulaEvaluator evaluate(read_formula(text, kNames));
    std::vector<double> values;
    for (std::size_t from = 0; from < points.size(); from += evaluate.block()) {
        const auto n = std::min(points.size() - from, std::size_t(evaluate.block()));
        for (std::size_t k = 0; k < n; ++k) {
            for (int i = 0; i < 4; ++i) evaluate.variable(i)[k] = points[from + k][i];
        }
        const double* const here = evaluate(static_cast<int>(n));
        values.insert(values.end(), here, here + n);
    }
    return values;
}

std::vector<std::array<double, 4>> random_points(int n) {
    std::mt19937_64 random(9);
    std::uniform_real_distribution<double> uniform(-3, 3);
    std::vector<std::array<double, 4>> points(n);
    for (auto& point : points) {
        for (double& x : point) x = std::round(uniform(random) * 8) / 8;
    }
    return points;
}

void expect_values_of_mu_parser(const std::string& text,
                                const std::vector<std::array<double, 4>>& points) {
    PointByPoint expected(text);
    const std::vector<double> found = values_of(text, points);
    for (std::size_t k = 0; k < points.size(); ++k) {
        const double value = expected(points[k]);
        ASSERT_TRUE(found[k] == value || (std::isnan(found[k]) && std::isnan(value)))
            << text << ": " << found[k] << " instead of " << value << " at point " << k;
    }
}

/// Random formulas. Powers are left out: muParser takes those of the system's library.
class RandomFormula {
   public:
    explicit RandomFormula(int seed) : random_(seed) {}
    std::string operator()(int depth) {
        if (depth == 0 || below(8) == 0) return leaf();
        const auto part = [&] { return (*this)(depth - 1); };
        switch (below(7)) {
            case 0:
                return "-(" + part() + ")";
            case 1:
                return pick(functions_) + "(" + part() + ")";
            case 2:
                return "(" + part() + ") ? " + part() + " : (" + part() + ")";
            case 3:
                return pick(lists_) + "(" + part() + "," + part() + ", " + leaf() + ")";
            case 4:
                return "atan2(" + part() + "," + part() + ")";
            default:
                return "(" + part() + " " + pick(operators_) + " " + part() + ")";
        }
    }
    /// Words of formulas in any order.
    std::string words(int n) {
        std::string text;
        for (int k = 0; k < n; ++k) text += pick(words_);
        return text;
    }

   private:
    int below(int n) { return static_cast<int>(random_() % n); }
    std::string pick(const std::vector<std::string>& list) {
        return list[static_cast<std::size_t>(below(static_cast<int>(list.size())))];
    }
    std::string leaf() {
        const std::vector<std::string> leaves{"x",  "y", "u", "v",      "pi",
                                              "_e", "2", "0", "1.5e-2", "3"};
        return pick(leaves);
    }
    std::mt19937_64 random_;
    const std::vector<std::string> functions_{
        "sin",   "cos",  "tan",   "asin", "acos", "atan", "sinh", "cosh", "tanh", "asinh", "acosh",
        "atanh", "log2", "log10", "log",  "ln",   "exp",  "sqrt", "abs",  "sign", "rint",  "+"};
    const std::vector<std::string> lists_{"min", "max", "sum", "avg"};
    const std::vector<std::string> operators_{"+",  "-",  "*",  "/",  "<",  ">",
                                              "<=", ">=", "==", "!=", "&&", "||"};
    const std::vector<std::string> words_{
        "x",    "y",      "u",  "2",   "(",  ")",    "(",   ")",  "+",  "-",    "*",
        "/",    "^",      "<",  "==",  "&&", "?",    ":",   ",",  " ",  "sin(", "min(",
        "avg(", "atan2(", "pi", "0.5", "!",  "exp(", "1e3", "_e", "||", ")"};
};

TEST(Formula, HasTheValuesOfMuParser) {
    RandomFormula random(1);
    const auto points = random_points(300);
    for (int k = 0; k < 2000; ++k) expect_values_of_mu_parser(random(1 + k % 6), points);
}

std::string refusal_of(const std::string& text) {
    try {
        read_formula(text, kNames);
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "";
}

TEST(Formula, AcceptsWhatMuParserAccepts) {
    RandomFormula random(2);
    const auto points = random_points(5);
    int n_accepted = 0;
    for (int k = 0; k < 15'000; ++k) {
        const std::string text = random.words(1 + k % 9);
        const std::string refusal = refusal_of(text);
        try {
            const PointByPoint expected(text);
            if (expected.n_formulas() > 1) {
                ASSERT_THAT(refusal, ::testing::HasSubstr("several formulas")) << text;
                continue;
            }
            ASSERT_EQ(refusal, "") << text;
            ++n_accepted;
            if (text.find('^') == std::string::npos) expect_values_of_mu_parser(text, points);
        } catch (const mu::ParserError& error) {
            ASSERT_NE(refusal, "") << text << ": " << error.GetMsg();
        }
    }
    EXPECT_GT(n_accepted, 300);
}

double value_at(const std::string& text, double x) {
    return values_of(text, {{x, 0, 0, 0}}).front();
}

TEST(Formula, SmallWholePowersAreProducts) {
    const double x = 1.1;
    EXPECT_EQ(value_at("x^2", x), x * x);
    EXPECT_EQ(value_at("(x)^3", x), x * x * x);
    EXPECT_EQ(value_at("(x + 0)^4", x), x * x * x * x);
    EXPECT_EQ(value_at("1.1^3", x), x * x * x);
    EXPECT_EQ(value_at("2^x^2", x), one_of_block(block_pow, 2, x * x));
    EXPECT_EQ(value_at("x^2.5", x), one_of_block(block_pow, x, 2.5));
    EXPECT_EQ(value_at("x^-1", x), one_of_block(block_pow, x, -1));
    EXPECT_EQ(value_at("2^0.5", x), one_of_block(block_pow, 2, 0.5));
    EXPECT_EQ(value_at("x^0 + 0^0", std::nan("")), 2);
    EXPECT_EQ(value_at("-x^2", 3), -9);
}

TEST(Formula, KeepsTheOperationsAsTheyAreWritten) {
    // muParser's optimiser would compute 12.5 x - 6.25.
    const double x = 0.5000001;
    EXPECT_EQ(value_at("(x - 0.5) / 0.08", x), (x - 0.5) / 0.08);
}

TEST(Formula, TakesAnyVariables) {
    const std::vector<std::string> names{"x", "y", "z", "u", "v", "w"};
    FormulaEvaluator evaluate(read_formula("z + 10 * w", names));
    evaluate.variable(2)[0] = 3;
    evaluate.variable(5)[0] = 5;
    EXPECT_EQ(evaluate(1)[0], 53);
    try {
        read_formula("z + t", names);
        FAIL();
    } catch (const InvalidInput& error) {
        EXPECT_THAT(error.what(), StartsWith("character 5: "));
        EXPECT_THAT(error.what(), EndsWith("; write a formula in x, y, z, u, v and w"));
    }
}

TEST(Formula, MayBeLong) {
    // The longest formula of muParser has 20,000 characters. Here each product waits for the rest.
    std::string text;
    for (int k = 0; k < 1000; ++k) text += "sin(x)*(y-" + std::to_string(k) + "*";
    text += "u" + std::string(1000, ')');
    const auto points = random_points(150);
    EXPECT_LT(FormulaEvaluator(read_formula(text, kNames)).block(), 256);
    expect_values_of_mu_parser(text, points);
    std::string sum = "0";
    for (int k = 0; k < 1500; ++k) sum += "+sin(" + std::to_string(k) + "*x)";
    expect_values_of_mu_parser(sum, points);
}

}  // namespace
}  // namespace pcvt
