#include "io/run_files/density_expression.hpp"

#include <muParser.h>

#include <algorithm>
#include <memory>
#include <numbers>
#include <string_view>

#include "mesher/portable/portable_angles.hpp"
#include "mesher/portable/portable_functions.hpp"

namespace pcvt {
namespace {

[[noreturn]] void throw_bad_formula(std::size_t character, const std::string& what) {
    throw InvalidInput("character " + std::to_string(character) + ": " + what);
}

/// Returns muParser's message without its position, which counts from 0.
std::string complaint(const mu::ParserError& error) {
    std::string text = error.GetMsg();
    for (const char* before : {" found at position", " at expression position", " at position"}) {
        text = text.substr(0, text.find(before));
    }
    while (!text.empty() && text.back() == '.') text.pop_back();
    return text;
}

/// Refuses control characters, which muParser skips, and characters that it reads in pieces.
void refuse_foreign_characters(const std::string& text) {
    for (std::size_t k = 0; k < text.size(); ++k) {
        const bool is_blank = std::string_view("\t\r\n").find(text[k]) != std::string_view::npos;
        if ((text[k] >= ' ' && text[k] <= '~') || is_blank) continue;
        const bool is_ascii = static_cast<unsigned char>(text[k]) <= 0x7F;
        throw_bad_formula(k + 1, is_ascii
                                     ? "a control character; remove it"
                                     : "not a character of a formula; write - for a minus sign, "
                                       "* for a product, ^2 for a square, pi");
    }
}

/// Refuses assignments, which muParser accepts in a formula: x = 3 would change later results.
void refuse_assignment(const std::string& text) {
    for (std::size_t k = 0; k < text.size(); ++k) {
        if (text[k] != '=') continue;
        const bool compares = k > 0 && std::string("<>!").find(text[k - 1]) != std::string::npos;
        if (!compares && text[k + 1] != '=') {
            throw_bad_formula(k + 1, "an assignment; write == to compare");
        }
        if (!compares) ++k;
    }
}

/// Refuses the power operator of other languages.
void refuse_double_asterisk(const std::string& text) {
    const std::size_t place = text.find("**");
    if (place == std::string::npos) return;
    throw_bad_formula(place + 1, "** is not an operator; write ^ for a power");
}

struct NamedFunction {
    const char* name;
    double (*function)(double);
};

/// The functions that formulas call in place of muParser's, which are those of the system's
/// library: their last digits differ between machines.
constexpr NamedFunction kFunctions[] = {
    {"sin", portable_sin},     {"cos", portable_cos},     {"tan", portable_tan},
    {"asin", portable_asin},   {"acos", portable_acos},   {"atan", portable_atan},
    {"sinh", portable_sinh},   {"cosh", portable_cosh},   {"tanh", portable_tanh},
    {"asinh", portable_asinh}, {"acosh", portable_acosh}, {"atanh", portable_atanh},
    {"log2", portable_log2},   {"log10", portable_log10}, {"log", portable_log},
    {"ln", portable_log},      {"exp", portable_exp},
};

/// A formula that one thread evaluates.
class Formula {
   public:
    explicit Formula(const std::string& text) {
        refuse_foreign_characters(text);
        refuse_assignment(text);
        refuse_double_asterisk(text);
        try {
            parser_.DefineConst("pi", std::numbers::pi);
            for (const auto& [name, function] : kFunctions) parser_.DefineFun(name, function);
            parser_.DefineFun("atan2", portable_atan2);
            parser_.DefineVar("x", &point_.x);
            parser_.DefineVar("y", &point_.y);
            parser_.DefineVar("u", &point_.u);
            parser_.DefineVar("v", &point_.v);
            parser_.SetExpr(text);
            // The first evaluation parses the formula.
            parser_.Eval();
        } catch (const mu::ParserError& error) {
            const int place = error.GetPos();
            const std::size_t at = place < 0 ? text.size() : static_cast<std::size_t>(place);
            throw_bad_formula(std::min(at, text.size()) + 1,
                              complaint(error) + "; write a formula in x, y, u and v");
        }
        // A comma outside of a function separates formulas.
        if (parser_.GetNumResults() != 1) {
            throw_bad_formula(text.find(',') + 1,
                              "several formulas; write one, with a decimal point");
        }
    }
    Formula(const Formula&) = delete;
    Formula& operator=(const Formula&) = delete;

    double operator()(const plane::DensityPoint& point) {
        point_ = point;
        return parser_.Eval();
    }

   private:
    plane::DensityPoint point_{0.5, 0.5, 0.5, 0.5};
    mu::Parser parser_;
};

}  // namespace

plane::Density expression_density(const std::string& expression) {
    const Formula once(expression);
    return {[expression]() -> plane::DensityFunction {
        const auto formula = std::make_shared<Formula>(expression);
        return plane::pointwise(
            [formula](const plane::DensityPoint& point) { return (*formula)(point); });
    }};
}

}  // namespace pcvt
