#include "io/bytes/json_writer.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mesher/base/error.hpp"

namespace pcvt {
namespace {

/// The JSON that `append` writes.
template <class Append>
std::string written(const JsonLayout& layout, const Append& append) {
    std::string text;
    JsonWriter json(text, layout);
    append(json);
    return text;
}

void append_example(JsonWriter& json) {
    json.begin_object();
    json.member("n", 3);
    json.member("x", 0.25);
    json.member("word", "a\"b");
    json.member("yes", true);
    json.member("nothing", std::optional<double>());
    json.member("pairs", std::vector{std::array{1, 2}, std::array{3, 4}});
    json.object("empty", [] {});
    json.end();
}

TEST(JsonWriter, TheLayoutSeparatesEntries) {
    EXPECT_EQ(written(kCompactJson, append_example),
              R"({"n":3,"x":0.25,"word":"a\"b","yes":true,"nothing":null,)"
              R"("pairs":[[1,2],[3,4]],"empty":{}})");
    EXPECT_EQ(written(kSpacedJson, append_example),
              R"({"n": 3, "x": 0.25, "word": "a\"b", "yes": true, "nothing": null, )"
              R"("pairs": [[1, 2], [3, 4]], "empty": {}})");
}

TEST(JsonWriter, EveryLayoutReadsBackAsTheSameValues) {
    const auto expected = nlohmann::json::parse(written(kCompactJson, append_example));
    EXPECT_EQ(nlohmann::json::parse(written(kSpacedJson, append_example)), expected);
    EXPECT_EQ(nlohmann::json::parse(written(kJsonLines, append_example)), expected);
}

TEST(JsonWriter, LongListsBreakAfterEachLine) {
    std::string text;
    JsonWriter json(text);
    json.values(std::array{1, 2, 3, 4, 5}, {.per_line = 2, .line_break = ",\n"});
    EXPECT_EQ(text, "[1, 2,\n3, 4,\n5]");
}

TEST(JsonWriter, TheLayoutChangesWithinAnObject) {
    std::string text;
    JsonWriter json(text);
    json.begin_object();
    json.member("a", 1);
    json.member("b", 2);
    json.set_layout({.between = ",\n"});
    json.member("c", 3);
    json.end();
    EXPECT_EQ(text, "{\"a\": 1, \"b\": 2,\n\"c\": 3}");
}

TEST(JsonWriter, PagesHoldNoMarksOfHtml) {
    std::string text;
    JsonWriter json(text, kSpacedJson, JsonEscapes::kInPage);
    json.value("</script>\n&\\");
    EXPECT_EQ(text.find_first_of("<>&\n"), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(text).get<std::string>(), "</script>\n&\\");
}

TEST(JsonWriter, NumbersThatAreNotFiniteAreRefused) {
    std::string text;
    JsonWriter json(text);
    EXPECT_THROW(json.value(std::nan("")), InternalError);
}

}  // namespace
}  // namespace pcvt
