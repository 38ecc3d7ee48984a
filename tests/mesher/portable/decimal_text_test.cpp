#include "mesher/portable/decimal_text.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace {

using Text = std::array<char, 800>;

template <class... Arguments>
std::string by_standard(Arguments... arguments) {
    Text text;
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), arguments...).ptr};
}

template <class... Arguments>
std::string by_c(Arguments... arguments) {
    Text text;
    return {text.data(),
            pcvt::by_c::write_decimal(text.data(), text.data() + text.size(), arguments...)};
}

template <class... Arguments>
std::string by_platform(Arguments... arguments) {
    Text text;
    return {text.data(), pcvt::write_decimal(text.data(), text.data() + text.size(), arguments...)};
}

/// Numbers of every exponent, short decimals, whole numbers, and the neighbours of powers of two.
std::vector<double> numbers(int n) {
    std::mt19937_64 random(7);
    std::vector<double> all{0.0,
                            -0.0,
                            5e-324,
                            std::numeric_limits<double>::min(),
                            std::numeric_limits<double>::max(),
                            9007199254740992,
                            1e22,
                            1e23};
    for (int k = -1074; k < 1024; ++k) {
        const double power = std::ldexp(1.0, k);
        for (const double x : {power, std::nextafter(power, 0.0), std::nextafter(power, 1e308)}) {
            all.push_back(x);
        }
    }
    for (int k = -30; k < 30; ++k) {
        const double power = std::strtod(("1e" + std::to_string(k)).c_str(), nullptr);
        for (const double x : {power, std::nextafter(power, 0.0), std::nextafter(power, 1e308)}) {
            all.push_back(x);
        }
    }
    while (static_cast<int>(all.size()) < n) {
        const auto bits = random();
        const auto x = Eigen::numext::bit_cast<double>(bits);
        if (std::isfinite(x)) all.push_back(x);
        all.push_back(double(bits % 2'000'001) / 1e6 - 1);
        all.push_back(std::ldexp(double(bits >> 11U), -53));
        all.push_back(double(bits % 1'000'000'007) * double(1 + bits % 4096));
    }
    return all;
}

TEST(DecimalText, ShortestTextIsThatOfTheStandardLibrary) {
    for (const double x : numbers(200'000)) {
        ASSERT_EQ(by_c(x), by_standard(x));
        ASSERT_EQ(by_platform(x), by_standard(x));
        const auto single = static_cast<float>(x);
        if (!std::isfinite(single)) continue;
        ASSERT_EQ(by_c(single), by_standard(single));
    }
}

TEST(DecimalText, TextInAFormatIsThatOfTheStandardLibrary) {
    using enum std::chars_format;
    for (const double x : numbers(40'000)) {
        for (const auto format : {fixed, scientific}) {
            ASSERT_EQ(by_c(x, format), by_standard(x, format));
            ASSERT_EQ(by_platform(x, format), by_standard(x, format));
        }
        for (const auto format : {fixed, scientific, general}) {
            ASSERT_EQ(by_c(x, format, 6), by_standard(x, format, 6));
            ASSERT_EQ(by_c(x, format, 0), by_standard(x, format, 0));
            ASSERT_EQ(by_platform(x, format, 20), by_standard(x, format, 20));
        }
    }
}

TEST(DecimalText, NumberEndAndErrorAreThoseOfTheStandardLibrary) {
    std::vector<std::string> texts{
        "",    "-",     ".",     "-.",    "+1",     " 1",     "1.",     ".5",     "-.5e",
        "1e",  "1e+",   "1e-x",  "1e400", "-1e400", "1e-400", "0e999",  "0.0e9",  "0x10",
        "1,5", "1.5.2", "1e5e5", "00012", "-0",     "1E-3",   "1e-324", "3e-324", "2e308"};
    for (const double x : numbers(100'000)) texts.push_back(by_standard(x) + "x");
    // Add the middles between numbers, with up to 20 digits, and their neighbours.
    for (const std::uint64_t x : {1ULL << 53U, 3ULL << 55U, 5ULL << 59U, 1ULL << 63U}) {
        for (std::uint64_t y = x; y < x + 3000; y += 1 + y % 7) texts.push_back(std::to_string(y));
    }
    std::mt19937_64 random(8);
    for (int k = 0; k < 20'000; ++k) {
        std::string text = std::to_string(random() >> (random() % 40));
        texts.push_back(text.insert(random() % text.size(), "."));
    }
    for (const std::string& text : texts) {
        double expected = 42;
        double found = 42;
        const char* const end = text.data() + text.size();
        const auto standard = std::from_chars(text.data(), end, expected);
        const auto ours = pcvt::by_c::read_decimal(text.data(), end, found);
        ASSERT_EQ(ours.ptr - text.data(), standard.ptr - text.data()) << text;
        ASSERT_EQ(ours.ec, standard.ec) << text;
        ASSERT_EQ(found, expected) << text;
        ASSERT_EQ(std::signbit(found), std::signbit(expected)) << text;
    }
}

}  // namespace
