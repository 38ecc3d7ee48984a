#include "mesher/cells/elastic_constants.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "mesher/base/error.hpp"
#include "mesher/portable/decimal_text.hpp"

namespace pcvt {
namespace {

constexpr std::array<std::string_view, 2> kIsotropicNames{"E", "nu"};
constexpr std::array<std::string_view, 3> kCubicNames{"C11", "C12", "C44"};
constexpr std::array<std::string_view, 5> kHexagonalNames{"C11", "C12", "C13", "C33", "C44"};

/// Whether every strain takes energy: the stiffness is positive definite.
bool is_stable(const ElasticConstants& constants) {
    if (constants.is_isotropic()) {
        const double nu = constants.numbers[1];
        return constants.numbers[0] > 0 && nu > -1 && nu < 0.5;
    }
    const auto [c11, c12, c13, c33, c44, c66] = stiffness_of(constants);
    return c44 > 0 && c66 > 0 && c11 > std::abs(c12) && (c11 + c12) * c33 > 2 * c13 * c13;
}

}  // namespace

std::span<const std::string_view> names_of(const ElasticConstants& constants) {
    if (constants.is_isotropic()) return kIsotropicNames;
    if (constants.is_cubic()) return kCubicNames;
    return kHexagonalNames;
}

ElasticConstants checked_constants(std::vector<double> numbers) {
    const std::size_t n = numbers.size();
    if (n != kIsotropicNames.size() && n != kCubicNames.size() && n != kHexagonalNames.size()) {
        throw InvalidInput("a material has 2, 3 or 5 elastic constants, not " + std::to_string(n) +
                           "; write E,NU or C11,C12,C44 or C11,C12,C13,C33,C44");
    }
    ElasticConstants constants{std::move(numbers)};
    const bool are_finite = std::all_of(constants.numbers.begin(), constants.numbers.end(),
                                        [](double number) { return std::isfinite(number); });
    if (are_finite && is_stable(constants)) return constants;
    throw InvalidInput(
        constants.is_isotropic()
            ? "no material is stable with these constants; give E above 0, and nu between -1 and "
              "0.5"
            : "no crystal is stable with these constants; its stiffness must be positive definite");
}

std::string constants_text(const ElasticConstants& constants) {
    std::string text;
    for (std::size_t k = 0; k < constants.numbers.size(); ++k) {
        std::array<char, 32> digits{};
        char* const end =
            write_decimal(digits.data(), digits.data() + digits.size(), constants.numbers[k]);
        text += k == 0 ? "" : ", ";
        text += names_of(constants)[k];
        text += ' ';
        text.append(digits.data(), end);
    }
    return text;
}

Stiffness stiffness_of(const ElasticConstants& constants) {
    const std::vector<double>& c = constants.numbers;
    if (constants.is_isotropic()) {
        const double shear = c[0] / (2 * (1 + c[1]));
        const double lambda = c[0] * c[1] / ((1 + c[1]) * (1 - 2 * c[1]));
        const double c11 = lambda + 2 * shear;
        return {c11, lambda, lambda, c11, shear, shear};
    }
    if (constants.is_cubic()) return {c[0], c[1], c[1], c[0], c[2], c[2]};
    return {c[0], c[1], c[2], c[3], c[4], (c[0] - c[1]) / 2};
}

}  // namespace pcvt
