#include "mesher/cells/phase_fractions.hpp"

#include <gmock/gmock.h>

#include "mesher/base/error.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

void expect_refusal(const std::string& text, const std::string& words) {
    EXPECT_THAT([&] { parse_phases(text); }, ThrowsMessage<InvalidInput>(HasSubstr(words))) << text;
}

TEST(PhaseFractions, ReadsNamesAndFractions) {
    const auto phases = parse_phases("alpha-Fe:0.25,M_2:.5,3:2.5e-1");
    ASSERT_EQ(phases.size(), 3u);
    EXPECT_EQ(phases[0], (PhaseFraction{"alpha-Fe", 0.25}));
    EXPECT_EQ(phases[1], (PhaseFraction{"M_2", 0.5}));
    EXPECT_EQ(phases[2], (PhaseFraction{"3", 0.25}));
    EXPECT_EQ(parse_phases("only:1").size(), 1u);
}

TEST(PhaseFractions, SumsThatMissOneByRoundingAreScaled) {
    for (const PhaseFraction& phase : parse_phases("a:0.333,b:0.333,c:0.333")) {
        EXPECT_EQ(phase.fraction, 1.0 / 3);
    }
    expect_refusal("a:0.3,b:0.69", "sum to 0.99; make the sum 1");
    expect_refusal("a:3,b:7", "sum to 10; make the sum 1");
}

TEST(PhaseFractions, RefusalsSayWhatToWrite) {
    for (const char* text : {"", "a", "a:", ":", "a:x", "a:0.5,", "a:1 ", "a:0,3", "a:1:2"}) {
        expect_refusal(text, "; ");
    }
    expect_refusal("a:0.5,b", "'b' is not a phase; write NAME:FRACTION");
    expect_refusal(":1", "not the name of a phase");
    expect_refusal("two words:1", "not the name of a phase");
    expect_refusal("\xc3\xa4:1", "not the name of a phase");
    expect_refusal(std::string(61, 'a') + ":1", "1 to 60 letters");
    expect_refusal("a:-0.5,b:1.5", "the fraction of a is -0.5; give a number above 0");
    expect_refusal("a:0,b:1", "above 0");
    expect_refusal("a:nan", "above 0");
    expect_refusal("a:inf", "above 0");
    expect_refusal("a:1e999", "is not a phase");
    expect_refusal("ferrite:0.5,Ferrite:0.5", "given twice");
}

}  // namespace
}  // namespace pcvt
