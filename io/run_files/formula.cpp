#include "io/run_files/formula.hpp"

#include <muParser.h>

#include <algorithm>
#include <numbers>
#include <string_view>
#include <vector>

#include "mesher/base/error.hpp"
#include "mesher/formula/block_angles.hpp"
#include "mesher/formula/block_arithmetic.hpp"
#include "mesher/formula/block_exponentials.hpp"
#include "mesher/formula/block_hyperbolics.hpp"

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

enum class Form { kOfOne, kOfTwo, kOfMany, kMeanOfMany };

/// A function by its name. That of many numbers takes them in pairs, from left to right.
struct NamedFunction {
    const char* name;
    Form form;
    BlockFunction* one;
    BlockFunction2* two;
};

constexpr NamedFunction of_one(const char* name, BlockFunction* function) {
    return {name, Form::kOfOne, function, nullptr};
}
constexpr NamedFunction of_many(const char* name, BlockFunction2* function) {
    return {name, Form::kOfMany, nullptr, function};
}
constexpr NamedFunction kFunctions[] = {
    of_one("sin", block_sin),     of_one("cos", block_cos),
    of_one("tan", block_tan),     of_one("asin", block_asin),
    of_one("acos", block_acos),   of_one("atan", block_atan),
    of_one("sinh", block_sinh),   of_one("cosh", block_cosh),
    of_one("tanh", block_tanh),   of_one("asinh", block_asinh),
    of_one("acosh", block_acosh), of_one("atanh", block_atanh),
    of_one("log2", block_log2),   of_one("log10", block_log10),
    of_one("log", block_log),     of_one("ln", block_log),
    of_one("exp", block_exp),     of_one("sqrt", block_sqrt),
    of_one("abs", block_abs),     of_one("sign", block_sign),
    of_one("rint", block_round),  {"atan2", Form::kOfTwo, nullptr, block_atan2},
    of_many("min", block_min),    of_many("max", block_max),
    of_many("sum", block_add),    {"avg", Form::kMeanOfMany, nullptr, block_add},
};

struct Operator {
    mu::ECmdCode code;
    BlockFunction2* function;
    /// Whether the second operand comes first.
    bool is_swapped = false;
};
constexpr Operator kOperators[] = {
    {mu::cmADD, block_add},          {mu::cmSUB, block_subtract},
    {mu::cmMUL, block_multiply},     {mu::cmDIV, block_divide},
    {mu::cmLT, block_less},          {mu::cmGT, block_less, true},
    {mu::cmLE, block_less_or_equal}, {mu::cmGE, block_less_or_equal, true},
    {mu::cmEQ, block_equal},         {mu::cmNEQ, block_differ},
    {mu::cmLAND, block_and},         {mu::cmLOR, block_or},
};

// muParser only parses: these functions are never evaluated for their values.
double value_of_one(void* /*function*/, double /*x*/) { return 0; }
double value_of_two(void* /*function*/, double /*x*/, double /*y*/) { return 0; }
double value_of_many(void* /*function*/, const double* /*x*/, int /*n*/) { return 0; }

/// "x, y and z".
std::string listed(std::span<const std::string> names) {
    std::string text = names.front();
    for (std::size_t k = 1; k < names.size(); ++k) {
        text += (k + 1 < names.size() ? ", " : " and ") + names[k];
    }
    return text;
}

/// A parsed formula.
class ParsedFormula {
   public:
    ParsedFormula(const std::string& text, std::span<const std::string> variables)
        : variables_(variables.size(), 0.5) {
        try {
            define(variables);
            parser_.SetExpr(text);
            // The first evaluation parses the formula.
            parser_.Eval();
        } catch (const mu::ParserError& error) {
            const int place = error.GetPos();
            const std::size_t at = place < 0 ? text.size() : static_cast<std::size_t>(place);
            throw_bad_formula(std::min(at, text.size()) + 1,
                              complaint(error) + "; write a formula in " + listed(variables));
        }
        // A comma outside of a function separates formulas.
        if (parser_.GetNumResults() != 1) {
            throw_bad_formula(text.find(',') + 1,
                              "several formulas; write one, with a decimal point");
        }
    }
    ParsedFormula(const ParsedFormula&) = delete;
    ParsedFormula& operator=(const ParsedFormula&) = delete;

    FormulaProgram program() const {
        FormulaProgram program(static_cast<int>(variables_.size()));
        for (const mu::SToken* token = parser_.GetByteCode().GetBase(); token->Cmd != mu::cmEND;
             ++token) {
            if (!append(*token, program)) throw_bad_formula(1, "no formula; write one number");
        }
        if (program.n_values() != 1) throw_bad_formula(1, "no formula; write one number");
        return program;
    }

   private:
    void define(std::span<const std::string> variables) {
        // The program has the operations of the text in their order.
        parser_.EnableOptimizer(false);
        parser_.DefineConst("pi", std::numbers::pi);
        for (const NamedFunction& function : kFunctions) {
            void* const data = const_cast<NamedFunction*>(&function);
            if (function.form == Form::kOfOne) {
                parser_.DefineFunUserData(function.name, value_of_one, data);
            } else if (function.form == Form::kOfTwo) {
                parser_.DefineFunUserData(function.name, value_of_two, data);
            } else {
                parser_.DefineFunUserData(function.name, value_of_many, data);
            }
        }
        for (std::size_t k = 0; k < variables.size(); ++k) {
            parser_.DefineVar(variables[k], &variables_[k]);
        }
    }
    /// Appends an operation of muParser's program; returns whether it is one of a formula.
    bool append(const mu::SToken& token, FormulaProgram& program) const {
        switch (token.Cmd) {
            case mu::cmVAR:
                program.push_variable(static_cast<int>(token.Val.ptr - variables_.data()));
                return true;
            case mu::cmVAL:
                program.push_number(token.Val.data2);
                return true;
            case mu::cmIF:
            case mu::cmELSE:
                return true;
            case mu::cmENDIF:
                if (program.n_values() < 3) return false;
                program.apply_choice();
                return true;
            case mu::cmFUNC:
                return append_function(token, program);
            default:
                return append_operator(token.Cmd, program);
        }
    }

    static bool append_operator(mu::ECmdCode code, FormulaProgram& program) {
        if (program.n_values() < 2) return false;
        if (code == mu::cmPOW) {
            program.apply_power();
            return true;
        }
        for (const Operator& one : kOperators) {
            if (one.code != code) continue;
            if (one.is_swapped) program.swap();
            program.apply(one.function);
            return true;
        }
        return false;
    }

    static bool append_function(const mu::SToken& token, FormulaProgram& program) {
        const int n = std::abs(token.Fun.argc);
        if (n == 0 || program.n_values() < n) return false;
        const auto* const function = static_cast<const NamedFunction*>(token.Fun.cb._pUserData);
        if (function == nullptr) {
            // A sign.
            const bool is_minus = token.Fun.cb.call_fun<1>(1.0) < 0;
            if (is_minus) program.apply(block_negative);
            return true;
        }
        if (function->form == Form::kOfOne) {
            program.apply(function->one);
            return true;
        }
        program.fold(function->two, n);
        if (function->form == Form::kMeanOfMany) {
            program.push_number(n);
            program.apply(block_divide);
        }
        return true;
    }

    mu::Parser parser_;
    std::vector<double> variables_;
};

}  // namespace

FormulaProgram read_formula(const std::string& text, std::span<const std::string> variables) {
    refuse_foreign_characters(text);
    refuse_assignment(text);
    refuse_double_asterisk(text);
    return ParsedFormula(text, variables).program();
}

}  // namespace pcvt
