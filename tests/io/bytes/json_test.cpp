#include "io/bytes/json.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <type_traits>

namespace pcvt {
namespace {

using Twin = nlohmann::json;

std::optional<Json> parsed(const std::string& text) {
    try {
        return Json::parse(text);
    } catch (const JsonFault&) {
        return std::nullopt;
    }
}

JsonFault json_fault(const std::string& text) {
    try {
        Json::parse(text);
    } catch (const JsonFault& fault) {
        return fault;
    }
    ADD_FAILURE() << text;
    return {JsonFault::Kind::kSyntax, 0};
}

bool same(const Json& ours, const Twin& theirs) {
    if (theirs.is_string()) return ours == theirs.get<std::string>();
    if (theirs.is_number_unsigned()) return ours == theirs.get<std::uint64_t>();
    if (theirs.is_number_integer()) {
        return ours.is_number_integer() && ours.get<std::int64_t>() == theirs.get<std::int64_t>();
    }
    if (theirs.is_number()) return ours.is_number() && ours.get<double>() == theirs.get<double>();
    if (theirs.is_null()) return ours.is_null();
    if (theirs.is_boolean()) return !ours.is_null() && !ours.is_number() && ours.size() == 0;
    if (theirs.is_array()) {
        if (!ours.is_array() || ours.size() != theirs.size()) return false;
        for (std::size_t k = 0; k < theirs.size(); ++k) {
            if (!same(ours[k], theirs[k])) return false;
        }
        return true;
    }
    if (!ours.is_object()) return false;
    for (const auto& [key, value] : theirs.items()) {
        const Json* found = ours.find(key);
        if (found == nullptr || !same(*found, value)) return false;
    }
    return true;
}

const std::vector<std::string> kTexts{
    R"({"asset": {"version": "2.0"}, "nodes": [{"mesh": 0, "name": "cell_1"}], "x": [1, -2, 3.5e-2]})",
    R"(["\u00e4\ud83d\ude00\n\t\"\\\/", "äß€😀", "", null, true, false, 0, -0, 1e5, -1.25E+3])",
    R"({"a":{"b":{"c":[[],{},[[18446744073709551615,-9223372036854775808,1e-400]]]}},"a":2})",
    "\xEF\xBB\xBF [1]"};

TEST(Json, AcceptsAndReadsAsItsTwinDoes) {
    std::mt19937 random(1);
    const std::string bytes = "\"\\{}[],:0123456789eE+-.utfn x\x01\x7f\x80\xC3\xA4\xE2\xED\xF0\xF5";
    int n_valid = 0;
    for (int k = 0; k < 40000; ++k) {
        std::string text = kTexts[random() % kTexts.size()];
        for (unsigned edits = random() % 4; edits > 0; --edits) {
            text[random() % text.size()] = bytes[random() % bytes.size()];
        }
        const Twin theirs = Twin::parse(text, nullptr, false);
        const std::optional<Json> ours = parsed(text);
        ASSERT_EQ(ours.has_value(), !theirs.is_discarded()) << text;
        if (!ours) continue;
        ++n_valid;
        ASSERT_TRUE(same(*ours, theirs)) << text;
    }
    EXPECT_GT(n_valid, 10000);
}

TEST(Json, IsTheSameInAnyOrderOfMembers) {
    const auto same = [](const char* s, const char* t) {
        return Json::parse(s).same(Json::parse(t));
    };
    EXPECT_TRUE(same(R"({"a":[1,-2,true,null],"b":"c"})", R"({"b":"c", "a":[1.0,-2,true,null]})"));
    for (const char* other :
         {"{}", R"({"a":1,"c":2})", R"({"a":2,"b":2})", R"({"a":1,"b":2,"c":3})",
          R"({"a":1,"b":true})", R"({"a":[1],"b":2})", R"({"a":1,"b":"2"})"}) {
        EXPECT_FALSE(same(R"({"a":1,"b":2})", other)) << other;
        EXPECT_FALSE(same(other, R"({"a":1,"b":2})")) << other;
    }
    EXPECT_FALSE(same("[true]", "[false]"));
    EXPECT_FALSE(same("[1,2]", "[2,1]"));
}

TEST(Json, EveryPrefixIsRefusedAtItsEnd) {
    for (const std::string& text : kTexts) {
        for (std::size_t n = 0; n < text.size(); ++n) {
            // A character may begin up to three bytes before the end.
            const std::size_t byte = json_fault(text.substr(0, n)).byte();
            EXPECT_LE(byte, n) << text.substr(0, n);
            EXPECT_GE(byte + 3, n) << text.substr(0, n);
        }
    }
}

TEST(Json, FaultsNameTheByteAndTheKind) {
    EXPECT_EQ(json_fault("[1,\n x]").byte(), 6U);
    EXPECT_EQ(json_fault("[1e999]").kind(), JsonFault::Kind::kNumberTooLarge);
    EXPECT_EQ(json_fault(std::string(300000, '[')).kind(), JsonFault::Kind::kTooDeep);
    const std::string deepest =
        std::string(Json::kMaxDepth, '[') + std::string(Json::kMaxDepth, ']');
    EXPECT_TRUE(parsed(deepest).has_value());
    EXPECT_FALSE(parsed("[" + deepest + "]").has_value());
}

TEST(Json, StringsAreWrittenAsItsTwinDoes) {
    std::mt19937 random(2);
    for (int k = 0; k < 20000; ++k) {
        std::string text;
        for (unsigned n = random() % 8; n > 0; --n) text += static_cast<char>(random());
        std::string json;
        append_json_string(json, text);
        ASSERT_EQ(json, Twin(text).dump(-1, ' ', false, Twin::error_handler_t::replace));
    }
}

TEST(Json, MovesCannotFail) {
    static_assert(std::is_nothrow_move_constructible_v<Json>);
    static_assert(std::is_nothrow_move_assignable_v<Json>);
}

}  // namespace
}  // namespace pcvt
