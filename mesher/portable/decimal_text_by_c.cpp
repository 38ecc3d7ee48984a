#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "mesher/portable/decimal_text.hpp"
#include "mesher/portable/wide_double.hpp"

namespace pcvt::by_c {
namespace {

/// The powers of ten that doubles hold exactly.
constexpr std::array<double, 23> kPowers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                         1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                         1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr int kMostPower = 22;

/// The double that is nearest to digits * 10^power, where that takes only a few operations.
std::optional<double> nearest_number(std::uint64_t digits, int power) {
    if (std::abs(power) > kMostPower) return {};
    const auto upper = static_cast<double>(digits >> 32U) * 0x1p32;
    const auto lower = static_cast<double>(digits & 0xffffffffU);
    const WideDouble whole = WideDouble(upper) + lower;
    const double scale = kPowers[static_cast<std::size_t>(std::abs(power))];
    const WideDouble number = power < 0 ? whole / scale : whole * scale;
    // The next number may be as near where the rest is about half of a unit in the last place.
    constexpr double kMore = 1 + 0x1p-30;
    const auto nearest = static_cast<double>(number);
    const auto rest = static_cast<double>(number - nearest);
    if (nearest + kMore * rest != nearest) return {};
    return nearest;
}

/// The significant digits of a positive number, without zeros at the end: d[0].d[1]d[2]... times
/// 10^exponent.
struct Digits {
    std::string_view text() const { return {digits.data(), n}; }

    std::array<char, 24> digits{};
    std::size_t n = 0;
    int exponent = 0;
};

/// Takes the digits out of a text such as "1.25e+10".
Digits digits_of(std::string_view text) {
    Digits found;
    const std::size_t e = text.find('e');
    for (const char c : text.substr(0, e)) {
        if (c != '.') found.digits[found.n++] = c;
    }
    while (found.n > 1 && found.digits[found.n - 1] == '0') --found.n;
    found.exponent = std::atoi(text.data() + e + 1);
    return found;
}

/// The same of a whole number and a power of ten.
Digits digits_of(std::uint64_t whole, int power) {
    Digits found;
    while (whole % 10 == 0) {
        whole /= 10;
        ++power;
    }
    const auto end = std::to_chars(found.digits.begin(), found.digits.end(), whole).ptr;
    found.n = static_cast<std::size_t>(end - found.digits.data());
    found.exponent = power + static_cast<int>(found.n) - 1;
    return found;
}

template <class Number>
Number read_back(const char* text) {
    if constexpr (sizeof(Number) == sizeof(float)) return std::strtof(text, nullptr);
    return static_cast<Number>(std::strtod(text, nullptr));
}

/// Rounds a text of `n` digits up by one unit of its last digit.
void add_unit(std::array<char, 40>& text) {
    std::size_t k = std::string_view(text.data()).find('e');
    while (k-- > 0) {
        if (text[k] == '.') continue;
        if (text[k] != '9') {
            ++text[k];
            return;
        }
        text[k] = '0';
    }
}

/// Whether digits * 10^power reads back as `value`, where that takes only a few operations.
std::optional<bool> reads_back(std::uint64_t digits, int power, double value) {
    const std::optional<double> number = nearest_number(digits, power);
    if (!number) return {};
    return *number == value;
}

std::optional<bool> reads_back(std::uint64_t digits, int power, float value) {
    const std::optional<double> number = nearest_number(digits, power);
    if (!number) return {};
    // A double in the middle of two floats is a rounded one.
    const auto below = static_cast<float>(*number);
    for (const float next : {std::nextafter(below, 0.0F), std::nextafter(below, 2 * below)}) {
        if (*number == (double(below) + double(next)) / 2) return {};
    }
    return below == value;
}

/// As shortest(), for most numbers near one in a few operations.
template <class Number>
std::optional<Digits> soon_shortest(Number value) {
    constexpr double kTie = 1e-9;  // more than the error of 17 digits by WideDouble
    using Limits = std::numeric_limits<Number>;
    int bits = 0;
    if (std::frexp(value, &bits) == Number(0.5)) return {};
    int exponent = static_cast<int>(std::floor(bits * 0.30103));
    for (int n = Limits::digits10; n <= Limits::max_digits10; ++n) {
        // Round to n digits.
        int power = n - 1 - exponent;
        if (power < 0 || power >= kMostPower) return {};
        WideDouble scaled = WideDouble(value) * kPowers[static_cast<std::size_t>(power)];
        if (double(scaled) < kPowers[static_cast<std::size_t>(n - 1)]) {
            --exponent;
            scaled = WideDouble(value) * kPowers[static_cast<std::size_t>(++power)];
        }
        const double floor = std::floor(double(scaled));
        const auto rest = double(scaled - floor);
        const double fraction = rest - std::floor(rest);
        if (std::abs(fraction - 0.5) < kTie) return {};
        const auto digits =
            static_cast<std::uint64_t>(static_cast<std::int64_t>(floor) + std::llround(rest));
        // Look whether they suffice.
        const std::optional<bool> suffices = reads_back(digits, -power, value);
        if (!suffices) return {};
        if (*suffices) return digits_of(digits, -power);
    }
    return {};
}

/// The fewest digits that read back as `value`, and of these the nearest ones.
///
/// Every decimal number with digits10 digits survives the way to a normal number and back, so
/// fewer digits need no trial there. Below a power of two the numbers are denser than above it;
/// then a text with one unit more may read back where the nearest one does not.
template <class Number>
Digits shortest(Number value) {
    using Limits = std::numeric_limits<Number>;
    if (const std::optional<Digits> soon = soon_shortest(value)) return *soon;
    std::array<char, 40> text;
    int fraction = 0;
    const int first = value < Limits::min() ? 1 : Limits::digits10;
    for (int n = first; n <= Limits::max_digits10; ++n) {
        std::snprintf(text.data(), text.size(), "%.*e", n - 1, static_cast<double>(value));
        if (read_back<Number>(text.data()) == value) break;
        if (std::frexp(value, &fraction) != Number(0.5)) continue;
        add_unit(text);
        if (read_back<Number>(text.data()) == value) break;
    }
    return digits_of(text.data());
}

char* append(char* end, std::string_view text) { return std::copy(text.begin(), text.end(), end); }

char* append_scientific(char* end, const Digits& d) {
    *end++ = d.digits[0];
    if (d.n > 1) {
        *end++ = '.';
        end = append(end, d.text().substr(1));
    }
    std::array<char, 16> exponent;
    std::snprintf(exponent.data(), exponent.size(), "e%c%02d", d.exponent < 0 ? '-' : '+',
                  std::abs(d.exponent));
    return append(end, exponent.data());
}

char* append_fixed(char* end, const Digits& d, double value) {
    const int n = static_cast<int>(d.n);
    if (d.exponent >= n) {
        // An integer with more digits than needed: all of them are exact.
        std::array<char, 400> text;
        std::snprintf(text.data(), text.size(), "%.0f", value);
        return append(end, text.data());
    }
    if (d.exponent < 0) {
        end = append(end, "0.");
        end = std::fill_n(end, -d.exponent - 1, '0');
        return append(end, d.text());
    }
    const std::size_t whole = static_cast<std::size_t>(d.exponent) + 1;
    end = append(end, d.text().substr(0, whole));
    if (whole == d.n) return end;
    *end++ = '.';
    return append(end, d.text().substr(whole));
}

/// Whether fixed notation takes at most as many characters as scientific notation.
bool is_plain(const Digits& d) {
    const int n = static_cast<int>(d.n);
    const int last = d.exponent - n + 1;
    const int tight = n == 1 ? 1 : 0;
    return last >= -(n + 3) + tight && last <= 5 - tight;
}

template <class Number>
char* write(char* begin, Number value, std::chars_format format) {
    if (std::signbit(value)) *begin++ = '-';
    const Number size = std::abs(value);
    if (!std::isfinite(value)) return append(begin, std::isnan(value) ? "nan" : "inf");
    if (size == 0) return append(begin, format == std::chars_format::scientific ? "0e+00" : "0");
    const Digits digits = shortest(size);
    const bool plain =
        format == std::chars_format() ? is_plain(digits) : format == std::chars_format::fixed;
    return plain ? append_fixed(begin, digits, static_cast<double>(size))
                 : append_scientific(begin, digits);
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

const char* skip_digits(const char* at, const char* end) {
    return std::find_if_not(at, end, is_digit);
}

/// The end of the decimal number at `begin`, or `begin`.
const char* end_of_number(const char* begin, const char* end) {
    const char* at = begin;
    if (at != end && *at == '-') ++at;
    const char* const whole = at;
    at = skip_digits(at, end);
    std::ptrdiff_t n = at - whole;
    if (at != end && *at == '.') {
        const char* const stop = skip_digits(at + 1, end);
        n += stop - at - 1;
        if (n > 0) at = stop;
    }
    if (n == 0) return begin;
    if (at == end || (*at != 'e' && *at != 'E')) return at;
    const char* exponent = at + 1;
    if (exponent != end && (*exponent == '+' || *exponent == '-')) ++exponent;
    const char* const stop = skip_digits(exponent, end);
    return stop == exponent ? at : stop;
}

/// The number of a text without signs and exponent, where it takes only a few operations.
std::optional<double> soon_read(std::string_view text) {
    constexpr int kMostDigits = 19;
    std::uint64_t digits = 0;
    int n = 0;
    int power = 0;
    bool has_point = false;
    for (const char c : text) {
        if (c == '.') {
            has_point = true;
            continue;
        }
        if (!is_digit(c) || n == kMostDigits) return {};
        digits = 10 * digits + static_cast<std::uint64_t>(c - '0');
        n += digits > 0 ? 1 : 0;
        power -= has_point ? 1 : 0;
    }
    return nearest_number(digits, power);
}

}  // namespace

char* write_decimal(char* begin, char* /*end*/, double value) {
    return write(begin, value, std::chars_format());
}

char* write_decimal(char* begin, char* /*end*/, float value) {
    return write(begin, value, std::chars_format());
}

char* write_decimal(char* begin, char* /*end*/, double value, std::chars_format format) {
    return write(begin, value, format);
}

char* write_decimal(char* begin, char* end, double value, std::chars_format format, int precision) {
    const char* const pattern = format == std::chars_format::fixed        ? "%.*f"
                                : format == std::chars_format::scientific ? "%.*e"
                                                                          : "%.*g";
    std::array<char, 512> text;
    const int n = std::snprintf(text.data(), text.size(), pattern, precision, value);
    const auto room = static_cast<std::size_t>(end - begin);
    return append(begin, {text.data(), std::min(room, static_cast<std::size_t>(n))});
}

std::from_chars_result read_decimal(const char* begin, const char* end, double& value) {
    const char* const stop = end_of_number(begin, end);
    if (stop == begin) return {begin, std::errc::invalid_argument};
    const std::string text(begin, stop);
    const bool is_negative = *begin == '-';
    if (const auto soon = soon_read(std::string_view(text).substr(is_negative ? 1 : 0))) {
        value = is_negative ? -*soon : *soon;
        return {stop, std::errc()};
    }
    const double number = std::strtod(text.c_str(), nullptr);
    const bool is_zero =
        text.substr(0, text.find_first_of("eE")).find_first_of("123456789") == std::string::npos;
    if (std::isinf(number) || (number == 0 && !is_zero)) {
        return {stop, std::errc::result_out_of_range};
    }
    value = number;
    return {stop, std::errc()};
}

}  // namespace pcvt::by_c
