#include "mesher/cells/elastic_choices.hpp"

#include <gmock/gmock.h>

#include <functional>

#include "mesher/base/error.hpp"

namespace pcvt {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string fault_of_choices(const std::function<void()>& call) {
    try {
        call();
    } catch (const InvalidInput& fault) {
        return fault.what();
    }
    return {};
}

TEST(ElasticChoices, MaterialsAreSeparatedByBlanksOrLines) {
    const ElasticChoices choices =
        parse_elastic_choices("matrix:3.5,0.35\n fibre:24,9.7,6.7,11.6,7 ");
    EXPECT_THAT(choices.materials, ElementsAre(NamedConstants{"matrix", {{3.5, 0.35}}},
                                               NamedConstants{"fibre", {{24, 9.7, 6.7, 11.6, 7}}}));
    EXPECT_FALSE(choices.are_same);
    EXPECT_TRUE(parse_elastic_choices("same").are_same);
}

TEST(ElasticChoices, BlanksMaySurroundColonsAndCommas) {
    for (const char* text :
         {"a : 1, 0.3 b:2 ,0.25", "a: 1 ,\t0.3\n b :2,0.25", " a:1,0.3\nb :  2  ,  0.25 "}) {
        EXPECT_THAT(parse_elastic_choices(text).materials,
                    ElementsAre(NamedConstants{"a", {{1, 0.3}}}, NamedConstants{"b", {{2, 0.25}}}))
            << text;
    }
    // The end of a line ends a material.
    EXPECT_THAT(fault_of_choices([] { parse_elastic_choices("a:1,0.3,\nb:2,0.25"); }),
                HasSubstr("'a:1,0.3,': not the constants"));
    EXPECT_THAT(fault_of_choices([] { parse_elastic_choices("a : 1 0.3"); }),
                HasSubstr("'a:1': a material has 2, 3 or 5"));
}

TEST(ElasticChoices, OtherTextsAreRefusedWithTheEntry) {
    for (const auto& [text, words] : std::vector<std::pair<std::string, std::string>>{
             {"", "no material"},
             {"steel", "'steel': no material"},
             {"a:1,x", "'a:1,x': not the constants"},
             {"a:1,0.3,", "not the constants"},
             {"a:1", "has 2, 3 or 5 elastic constants, not 1"},
             {"a:1,0.5", "nu between -1 and 0.5"},
             {":1,0.3", "is not the name of a phase"},
             {"a:1,0.3 A:2,0.3", "given twice"},
             {"same a:1,0.3", "exclude each other"},
             {"a\x01:1,0.3", "'a?' is not the name of a phase"}}) {
        const std::string& given = text;
        EXPECT_THAT(fault_of_choices([&] { parse_elastic_choices(given); }), HasSubstr(words))
            << given;
    }
}

TEST(ElasticChoices, EachPhaseHasAMaterialAndEachMaterialAPhase) {
    const ElasticChoices choices = parse_elastic_choices("Soft:1,0.3 hard:10,0.3");
    const auto refusal = [&](const std::vector<std::string>& phases) {
        return fault_of_choices([&] { require_materials_of(choices, phases); });
    };
    EXPECT_EQ(refusal({"soft", "hard"}), "");
    EXPECT_THAT(refusal({"soft"}), HasSubstr("--material hard: no material of the files has"));
    EXPECT_THAT(refusal({"soft", "hard", "void"}), HasSubstr("the phase void has no"));
    EXPECT_THAT(refusal({}), HasSubstr("take one of GRAINS"));
    EXPECT_EQ(
        fault_of_choices([] { require_materials_of(parse_elastic_choices("grains:1,0.3"), {}); }),
        "");
}

TEST(ElasticChoices, SeveralPhasesNeedAChoice) {
    EXPECT_EQ(fault_of_choices([] { require_choice({}, {}); }), "");
    EXPECT_EQ(fault_of_choices([] { require_choice({}, {"a"}); }), "");
    EXPECT_THAT(fault_of_choices([] {
                    require_choice({}, {"a", "b"});
                }),
                HasSubstr("would give the phases a, b the same elastic constants; add --material"));
    EXPECT_EQ(fault_of_choices([] { require_choice({.are_same = true}, {"a", "b"}); }), "");
}

TEST(ElasticChoices, MaterialsFollowTheOrderOfThePhases) {
    const ElasticChoices choices = parse_elastic_choices("HARD:10,0.3 soft:1,0.3");
    EXPECT_THAT(
        chosen_materials(choices, {.phase_names = {"soft", "hard"}}, {}),
        ElementsAre(NamedConstants{"soft", {{1, 0.3}}}, NamedConstants{"hard", {{10, 0.3}}}));
    EXPECT_THAT(chosen_materials({}, {}, {{2, 0.25}}),
                ElementsAre(NamedConstants{"GRAINS", {{2, 0.25}}}));
}

}  // namespace
}  // namespace pcvt
