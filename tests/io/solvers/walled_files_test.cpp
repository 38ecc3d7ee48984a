#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "io/formats/file_proof.hpp"
#include "io/solvers/inp_writer.hpp"
#include "io/solvers/msh_writer.hpp"
#include "mesher/base/error.hpp"
#include "tests/support/damaged_text.hpp"
#include "tests/support/mutation.hpp"
#include "tests/support/tile_equality.hpp"
#include "tests/support/walled_tiles.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const Format& format_of(const std::string& path) { return *find_format(path); }

/// The complaint of `pcvt check` about a file; empty if it proves it.
std::string complaint(const std::string& path, const std::string& text) {
    try {
        const std::vector<EncodedFile> files{{path, text}};
        prove_file(format_of(path), files, decode_tile(format_of(path), files, std::nullopt));
    } catch (const InvalidInput& fault) {
        return fault.what();
    }
    return "";
}

std::string text_of(const plane::Tile& tile, const std::string& path) {
    return encode_tile(format_of(path), tile, path)[0].bytes;
}

plane::Tile channel(int order = 1) {
    const plane::TileOptions grains{
        .kind = plane::MeshKind::kGrains, .outline = plane::Outline::kBox, .order = order};
    return testing::walled_tile(Walls::kY, WallCells::kWhole, 7, grains);
}

plane::Tile box() {
    return testing::walled_tile(Walls::kXY, WallCells::kWhole, 7,
                                {.kind = plane::MeshKind::kGrains});
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find('\n', at);
        lines.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return lines;
}

/// The lines behind a header up to the next card.
std::vector<std::string> data_of(const std::string& text, const std::string& card) {
    const std::vector<std::string> lines = lines_of(text);
    auto line = std::find(lines.begin(), lines.end(), card);
    std::vector<std::string> data;
    while (line != lines.end() && ++line != lines.end() && line->front() != '*') {
        data.push_back(*line);
    }
    return data;
}

TEST(WalledFiles, TilesReadBackExactlyAndAreProved) {
    for (const Walls walls : {Walls::kX, Walls::kY, Walls::kXY}) {
        for (const plane::Tile& tile : testing::walled_tiles(walls)) {
            for (const char* path : {"t.msh", "t.inp", "t.vtu"}) {
                SCOPED_TRACE(path);
                const auto files = encode_tile(format_of(path), tile, path);
                EXPECT_NO_THROW(
                    prove_tile_files(format_of(path), files, tile, plane::Vec2::Zero()));
                const TileFile file = decode_tile(format_of(path), files, std::nullopt);
                EXPECT_EQ(file.tile.walls, walls);
                EXPECT_EQ(file.tile.wall_edges, tile.wall_edges);
                EXPECT_EQ(file.tile.order, tile.order);
                EXPECT_EQ(file.has_vertex_pairs, walls != Walls::kXY && file.has_vertex_pairs);
                EXPECT_EQ(complaint(path, files[0].bytes), "");
            }
        }
    }
}

TEST(WalledMsh, WallsAreGroupsAndTheSeamAloneIsPeriodic) {
    const std::string text = text_of(channel(), "t.msh");
    for (const char* name : {"seam_-1_0", "seam_1_0", "wall_bottom", "wall_top"}) {
        EXPECT_THAT(text, HasSubstr('"' + std::string(name) + '"'));
    }
    for (const char* name : {"seam_0_1", "seam_0_-1", "wall_left", "wall_right"}) {
        EXPECT_THAT(text, Not(HasSubstr(name)));
    }
    // Every link, whose 16 numbers follow its entities, translates by the width, to either side.
    const std::string links = text.substr(text.find("$Periodic"));
    std::size_t n_links = 0;
    for (std::size_t at = 0; (at = links.find("\n16 1 0 0 ", at) + 1) > 0; ++n_links) {
        const std::string link = links.substr(at, links.find('\n', at) - at);
        EXPECT_TRUE(link == "16 1 0 0 2 0 1 0 0 0 0 1 0 0 0 0 1" ||
                    link == "16 1 0 0 -2 0 1 0 0 0 0 1 0 0 0 0 1")
            << link;
    }
    EXPECT_GE(n_links, 3U);
}

TEST(WalledMsh, ABoxHasNoPeriodicEntities) {
    const std::string text = text_of(box(), "t.msh");
    EXPECT_THAT(text, Not(HasSubstr("$Periodic")));
    EXPECT_THAT(text, Not(HasSubstr("seam_")));
    for (const WallSideRow& row : kWallSides) EXPECT_THAT(text, HasSubstr(row.word));
}

TEST(WalledMsh, WallElementsInOtherGroupsRemovedOrDoubledAreRefused) {
    for (const int order : {1, 2}) {
        const std::string text = text_of(channel(order), "t.msh");
        ASSERT_EQ(complaint("t.msh", text), "");
        const auto lines = lines_of(text.substr(0, text.find("$EndPhysicalNames")));
        std::vector<std::string> groups;
        for (const std::string& line : lines) {
            if (line.find("\"wall_") != std::string::npos) groups.push_back(line);
        }
        ASSERT_EQ(groups.size(), 2U);
        // Exchange the names of the walls.
        EXPECT_NE(complaint("t.msh", testing::exchanged(text, "wall_top", "wall_bottoms")), "");
        EXPECT_NE(complaint("t.msh", testing::exchanged(text, "wall_top", "seam_0_1")), "");
        // The blocks of curves begin with `1 TAG TYPE NUMBER`; two of them lie on walls.
        std::size_t at = text.find("$Elements\n");
        int n_blocks = 0;
        int n_refused = 0;
        const std::string type = order == 1 ? " 1 " : " 8 ";
        while ((at = text.find("\n1 ", at + 1)) < text.find("$EndElements")) {
            const std::string head = text.substr(at + 1, text.find('\n', at + 1) - at - 1);
            if (head.find(type) == std::string::npos) continue;
            ++n_blocks;
            // Move the block to the next curve.
            std::string moved = text;
            const std::size_t tag = at + 3;
            const std::size_t n = text.find(' ', tag) - tag;
            moved.replace(tag, n, std::to_string(std::stoi(text.substr(tag, n)) % 4 + 1));
            n_refused += complaint("t.msh", moved).empty() ? 0 : 1;
            // Write its first element twice, and drop it.
            const std::size_t first = at + 1 + head.size() + 1;
            const std::string line = text.substr(first, text.find('\n', first) + 1 - first);
            EXPECT_NE(complaint("t.msh", std::string(text).insert(first, line)), "");
            EXPECT_NE(complaint("t.msh", std::string(text).erase(first, line.size())), "");
        }
        EXPECT_GT(n_blocks, 4);
        EXPECT_EQ(n_refused, n_blocks);
    }
}

TEST(WalledMsh, AWrongNoteOfWallsIsRefused) {
    const std::string text = text_of(channel(), "t.msh");
    ASSERT_THAT(text, HasSubstr("pcvt walls 0 1\n"));
    for (const char* other : {"pcvt walls 1 0\n", "pcvt walls 1 1\n", "pcvt walls 2 1\n", ""}) {
        EXPECT_NE(complaint("t.msh", testing::exchanged(text, "pcvt walls 0 1\n", other)), "")
            << other;
    }
}

TEST(WalledInp, WallsAreSetsAndSurfaces) {
    for (const int order : {1, 2}) {
        const plane::Tile tile = channel(order);
        const std::string text = text_of(tile, "t.inp");
        const auto n_on = std::count_if(
            tile.wall_edges.begin(), tile.wall_edges.end(),
            [](const plane::WallEdge& edge) { return edge.wall.side() == WallSide::kBottom; });
        const auto sides = data_of(text, "*SURFACE,NAME=WALL_BOTTOM_SIDES,TYPE=ELEMENT");
        EXPECT_EQ(static_cast<std::ptrdiff_t>(sides.size()), n_on);
        for (const std::string& side : sides) {
            // Side k + 1 of an element lies between its corners k and k + 1, here on the wall.
            const int f = std::stoi(side) - 1;
            const int k = side.back() - '1';
            EXPECT_EQ(tile.points[tile.faces[f][k]].y(), 0);
            EXPECT_EQ(tile.points[tile.faces[f][(k + 1) % 3]].y(), 0);
        }
        // The last corner is tied to the first one.
        std::size_t n_nodes = 0;
        for (const std::string& line : data_of(text, "*NSET,NSET=WALL_BOTTOM")) {
            n_nodes += 1 + static_cast<std::size_t>(std::count(line.begin(), line.end(), ','));
            if (line.back() == ',') --n_nodes;
        }
        EXPECT_EQ(static_cast<std::ptrdiff_t>(n_nodes), order * n_on);
        EXPECT_THAT(text, Not(HasSubstr("WALL_RIGHT")));
        EXPECT_THAT(text, Not(HasSubstr("seam_0_")));
    }
}

TEST(WalledInp, ABoxTiesNoNode) {
    const std::string text = text_of(box(), "t.inp");
    for (const char* card : {"*EQUATION", "CONTROL_", "FIXED", "seam_"}) {
        EXPECT_THAT(text, Not(HasSubstr(card)));
    }
    for (const char* set : {"LEFT", "RIGHT", "BOTTOM", "TOP"}) {
        EXPECT_THAT(text, HasSubstr("*NSET,NSET=WALL_" + std::string(set) + "\n"));
    }
}

TEST(WalledInp, WrongSetsAndSurfacesOfWallsAreRefused) {
    const std::string text = text_of(channel(), "t.inp");
    ASSERT_EQ(complaint("t.inp", text), "");
    const std::string nodes = data_of(text, "*NSET,NSET=WALL_TOP").front();
    const std::string sides = data_of(text, "*SURFACE,NAME=WALL_TOP_SIDES,TYPE=ELEMENT").front();
    const auto fault = [&](const std::string& card, const std::string& line,
                           const std::string& other) {
        return complaint("t.inp", testing::exchanged(text, card + line, card + other));
    };
    const std::string set = "*NSET,NSET=WALL_TOP\n";
    const std::string surface = "*SURFACE,NAME=WALL_TOP_SIDES,TYPE=ELEMENT\n";
    EXPECT_NE(fault(set, nodes + "\n", ""), "");
    EXPECT_NE(fault(set, nodes.substr(0, nodes.find(',') + 1), "1,"), "");
    EXPECT_NE(fault(surface, sides + "\n", ""), "");
    EXPECT_NE(fault(surface, sides, sides + "\n" + sides), "");
    const char other = sides.back() == '1' ? '2' : '1';
    EXPECT_NE(fault(surface, sides, sides.substr(0, sides.size() - 1) + other), "");
    EXPECT_NE(complaint("t.inp", testing::exchanged(text, "NSET=WALL_TOP", "NSET=WALL_UP")), "");
}

TEST(WalledFiles, DamagedFilesGiveATileOrAFaultAndNothingElse) {
    std::mt19937_64 random(5);
    for (const plane::Tile& tile : {channel(), channel(2), box()}) {
        for (const char* path : {"t.msh", "t.inp"}) {
            const std::string bytes = text_of(tile, path);
            for (int k = 0; k < 100; ++k) {
                const std::string fault = testing::fault_in([&] {
                    try {
                        complaint(path, testing::mutated(bytes, random));
                    } catch (const LimitExceeded&) {
                    }
                });
                EXPECT_EQ(fault, "");
            }
        }
    }
}

TEST(WalledFiles, ContentsThatNeedATorusAreRefusedBeforeAnyWork) {
    const FormatRequest channel{.lattice = plane::Lattice::rectangle(2, 1),
                                .tile = {.kind = plane::MeshKind::kGrains},
                                .walls = Walls::kY,
                                .files = {.job = SolverJob::kElastic}};
    FormatRequest torus = channel;
    torus.walls = Walls::kNone;
    for (const char* path : {"t.nc", "t.vti", "t.inp"}) {
        EXPECT_NO_THROW(format_of(path).check(torus)) << path;
        try {
            format_of(path).check(channel);
            ADD_FAILURE() << path;
        } catch (const InvalidInput& fault) {
            EXPECT_THAT(fault.what(), HasSubstr("periodic along both directions; leave ")) << path;
        }
    }
}

}  // namespace
}  // namespace pcvt
