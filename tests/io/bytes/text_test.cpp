#include "io/bytes/text.hpp"

#include <gmock/gmock.h>
#include <rapidcheck.h>

#include <bit>
#include <cmath>
#include <limits>

namespace pcvt {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

template <class Number>
std::string written(Number number) {
    std::string text;
    append_number(text, number);
    return text;
}

template <class Number>
std::string number_fault(std::string_view word, Number parse(std::string_view)) {
    try {
        parse(word);
    } catch (const InvalidInput& fault) {
        return fault.what();
    }
    return "";
}

std::string number_fault(std::string_view word) { return number_fault(word, parse_number); }

/// Returns number and words of each line, separated by bars.
std::vector<std::string> lines_of(std::string_view text) {
    LineScanner scanner("t", text);
    std::vector<std::string> lines;
    while (scanner.next()) {
        std::string line = std::to_string(scanner.line());
        for (const std::string_view word : scanner.words()) line += "|" + std::string(word);
        lines.push_back(line);
    }
    return lines;
}

TEST(Text, EveryFiniteDoubleReadsBackAsItself) {
    rc::check([](std::uint64_t bits) {
        const double value = std::bit_cast<double>(bits);
        RC_PRE(std::isfinite(value));
        RC_ASSERT(parse_number(written(value)) == value);
    });
    for (const double value : {0.1, 1e-320, 5e-324, 1.7976931348623157e308, 1.0 / 3, 1e6}) {
        EXPECT_EQ(parse_number(written(value)), value);
    }
}

TEST(Text, NumbersAreShortAndZeroHasNoSign) {
    EXPECT_EQ(written(0.1), "0.1");
    EXPECT_EQ(written(-0.0), "0");
    EXPECT_EQ(written(-7), "-7");
    EXPECT_THROW(written(std::nan("")), InternalError);
    EXPECT_THROW(written(std::numeric_limits<double>::infinity()), InternalError);
}

TEST(Text, DecimalsInEveryUsualSpellingAreParsed) {
    EXPECT_EQ(parse_number("+1.5"), 1.5);
    EXPECT_EQ(parse_number("-.5"), -0.5);
    EXPECT_EQ(parse_number("5."), 5);
    EXPECT_EQ(parse_number("1E+3"), 1000);
    EXPECT_TRUE(std::signbit(parse_number("-0.0")));
    EXPECT_EQ(parse_integer("+12"), 12);
    EXPECT_EQ(parse_integer("-2147483648"), std::numeric_limits<int>::min());
}

TEST(Text, WordsThatAreNotNumbersAreRefusedWithAReason) {
    EXPECT_THAT(number_fault("1,5"), HasSubstr("decimal point"));
    for (const char* word : {"nan", "-NaN", "inf", "-Infinity", "+INF"}) {
        EXPECT_THAT(number_fault(word), HasSubstr("not a finite number")) << word;
    }
    for (const char* word : {"1e999", "-1e999", "1e-999"}) {
        EXPECT_THAT(number_fault(word), HasSubstr("beyond the range")) << word;
    }
    for (const char* word :
         {"", "+", "-", "+-1", "--1", "++1", "0x1p3", "1.5.2", "1d5", "1e", "x"}) {
        EXPECT_THAT(number_fault(word), HasSubstr("not a number")) << word;
    }
    EXPECT_THROW(parse_integer("2147483648"), InvalidInput);
    EXPECT_THROW(parse_integer("0x10"), InvalidInput);
}

TEST(Text, DecimalsAreNoWholeNumbers) {
    for (const std::string word : {"1.0", "-0.75", "1e3"}) {
        EXPECT_THAT(number_fault(word, parse_integer),
                    StartsWith("'" + word + "' is not a whole number; "));
    }
    EXPECT_THAT(number_fault("1.x", parse_integer), HasSubstr("not a number"));
}

TEST(Text, QuotedWordsArePrintableAndShort) {
    const auto unprintable = [](std::size_t n) { return "'" + std::string(n, '?') + "'"; };
    EXPECT_EQ(in_quotes("a\x1b[31m\xff"), "'a?[31m?'");
    EXPECT_EQ(in_quotes("Gr\u00f6\u00dfe \u03c6 \u7c92 \U0001F600"),
              "'Gr\u00f6\u00dfe \u03c6 \u7c92 \U0001F600'");
    // Cut characters, overlong ones, surrogates, C1 controls and marks of direction.
    EXPECT_EQ(in_quotes("\xc3"), "'?'");
    EXPECT_EQ(in_quotes("\xc0\xaf"), unprintable(2));
    EXPECT_EQ(in_quotes("\xe0\x80\xaf"), unprintable(3));
    EXPECT_EQ(in_quotes("\xed\xa0\x80"), unprintable(3));
    EXPECT_EQ(in_quotes("\xc2\x9b"
                        "1m"),
              "'?"
              "?1m'");
    EXPECT_EQ(in_quotes("\u202e"
                        "a"),
              "'??"
              "?a'");
    EXPECT_EQ(in_quotes("\xf4\x90\x80\x80"), unprintable(4));
    EXPECT_EQ(in_quotes(std::string(41, 'x')), "'" + std::string(40, 'x') + "...'");
}

TEST(Text, LinesAreCountedForEveryKindOfLineEnd) {
    EXPECT_THAT(lines_of("a b\nc\n"), ElementsAre("1|a|b", "2|c"));
    EXPECT_THAT(lines_of("a\r\n\r\nb"), ElementsAre("1|a", "2", "3|b"));
    EXPECT_THAT(lines_of("a\rb\n\rc"), ElementsAre("1|a", "2|b", "3", "4|c"));
    EXPECT_THAT(lines_of("\xEF\xBB\xBF\ta \t b "), ElementsAre("1|a|b"));
    EXPECT_THAT(lines_of(""), IsEmpty());
    EXPECT_THAT(lines_of("\xEF\xBB\xBF"), IsEmpty());
}

TEST(Text, FaultsNameFileAndLine) {
    LineScanner scanner("a.txt", "1\n1,5\n");
    scanner.next();
    scanner.next();
    try {
        scanner.number(scanner.words()[0]);
        FAIL();
    } catch (const BadFile& fault) {
        EXPECT_THAT(fault.what(),
                    StartsWith("a.txt:2: '1,5' is not a number; use a decimal point"));
    }
}

}  // namespace
}  // namespace pcvt
