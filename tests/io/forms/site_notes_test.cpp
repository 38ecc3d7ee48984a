#include "io/forms/site_notes.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <set>

#include "io/bytes/text.hpp"
#include "io/forms/file_tile_builder.hpp"
#include "tests/support/example_lattices.hpp"
#include "tests/support/power_tiles.hpp"

namespace pcvt {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::kOblique;

std::string comments(const plane::Tile& tile) {
    std::string text;
    append_note_comments(text, "", tile, 0);
    return text;
}

TEST(SiteNotes, EachQuantityHasNamesOfItsOwn) {
    std::set<std::string_view> members;
    std::set<std::string_view> arrays;
    std::set<std::string_view> parts;
    for (const SiteNote& note : site_notes()) {
        members.insert(note.member);
        arrays.insert(note.array);
        parts.insert(note.parts);
    }
    EXPECT_EQ(members.size(), site_notes().size());
    EXPECT_EQ(arrays.size(), site_notes().size());
    EXPECT_EQ(parts.size(), site_notes().size());
    EXPECT_THAT(site_parts(), ElementsAre("x", "y", "weight"));
}

TEST(SiteNotes, CommentsGiveTheNumbersBackBitForBit) {
    for (const testing::CellShape& shape : testing::cell_shapes()) {
        for (const plane::TileOptions& options : testing::tile_kinds()) {
            const plane::Tile tile = testing::power_tile(kOblique, 7, 1, shape, options);
            const std::string text = comments(tile);
            LineScanner scanner("notes", text);
            FileTileBuilder builder{.name = "notes", .index_base = 0, .notes = {.short_edges = 0}};
            while (scanner.next()) {
                const std::vector<std::string_view>& words = scanner.words();
                const std::vector<std::string_view> values(words.begin() + 1, words.end());
                EXPECT_TRUE(builder.take_comment(scanner, words[0], values));
            }
            plane::Tile back{.lattice = kOblique, .kind = tile.kind};
            std::move(builder.notes).give_to(back);
            EXPECT_TRUE(same_site_notes(back, tile)) << text;
            back.site_positions[3].x() = std::nextafter(back.site_positions[3].x(), 10);
            EXPECT_FALSE(same_site_notes(back, tile));
        }
    }
}

TEST(SiteNotes, UsualNumbersAreNotStated) {
    const plane::Tile tile = testing::power_tile(kOblique, 2, 1, {"voronoi", ""});
    const auto n_lines = [](const std::string& text) {
        return std::count(text.begin(), text.end(), '\n');
    };
    EXPECT_EQ(n_lines(comments(tile)), 2);
    EXPECT_EQ(stated_notes(tile).size(), 1U);
    EXPECT_EQ(stated_notes(tile, true).size(), 3U);
    plane::Tile unplaced = tile;
    unplaced.site_points.clear();
    EXPECT_EQ(comments(unplaced), "");
    EXPECT_TRUE(stated_notes(unplaced, true).empty());
}

TEST(SiteNotes, NumbersOutOfRangeAreRefused) {
    const auto fault = [](const char* comment, const std::vector<double>& numbers) -> std::string {
        SiteNotes notes;
        try {
            take_note(*find_site_note(comment), numbers, notes);
            return "";
        } catch (const InvalidInput& complaint) {
            return complaint.what();
        }
    };
    EXPECT_EQ(fault("periods", {2, 3}), "");
    EXPECT_THAT(fault("periods", {2, 0}), HasSubstr("not from 1 to"));
    EXPECT_THAT(fault("periods", {2, 1.5}), HasSubstr("write its integers: columns rows"));
    EXPECT_THAT(fault("periods", {2}), HasSubstr("the note periods is unclear"));
    EXPECT_THAT(fault("short_edges", {1.5}), HasSubstr("not from 0 to 1"));
    EXPECT_THAT(fault("metric", {3}), HasSubstr("write its numbers: ratio degrees"));
    EXPECT_THAT(fault("metric", {-3, 0}), HasSubstr("aspect ratio"));
    SiteNotes notes;
    EXPECT_THROW(take_site_note(std::array{1.0}, notes), InvalidInput);
    EXPECT_THROW(take_site_note(std::array{1.0, 2.0, 3.0, 4.0}, notes), InvalidInput);
    EXPECT_THROW(take_site_note({}, notes), InvalidInput);
}

}  // namespace
}  // namespace pcvt
