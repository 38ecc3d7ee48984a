#include "io/tiles/midside_nodes.hpp"

#include <gmock/gmock.h>

#include "io/solvers/inp_reader.hpp"
#include "io/solvers/inp_writer.hpp"
#include "io/solvers/msh_reader.hpp"
#include "io/solvers/msh_writer.hpp"
#include "io/solvers/vtu_reader.hpp"
#include "io/solvers/vtu_writer.hpp"
#include "tests/support/grid_tile.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;

/// Two triangles with the corners 0 to 3 of the unit square and the middle nodes 4 to 8.
RawTile two_triangles() {
    RawTile raw{"t", 0, {}, {}, {}, {0}, {}, {}, {}, {}, {}};
    raw.lattice = Lattice::rectangle(1, 1);
    raw.points = {{0, 0},   {1, 0},     {0, 1},   {1, 1},  {0.5, 0},
                  {1, 0.5}, {0.5, 0.5}, {0.5, 1}, {0, 0.5}};
    raw.add_face({0, 1, 3, 4, 5, 6}, 10);
    raw.add_face({0, 3, 2, 6, 7, 8}, 11);
    raw.vertex_pairs = {
        {0, 1, {1, 0}}, {0, 2, {0, 1}}, {0, 3, {1, 1}}, {4, 7, {0, 1}}, {8, 5, {1, 0}}};
    return raw;
}

std::string fault_of(RawTile raw) {
    try {
        remove_midside_nodes(raw, std::nullopt, Precision::kDouble);
    } catch (const BadFile& fault) {
        return fault.what();
    }
    return "";
}

TEST(FileMidsideNodes, TheyGoAndTheTileStays) {
    RawTile raw = two_triangles();
    remove_midside_nodes(raw, std::nullopt, Precision::kDouble);
    EXPECT_EQ(raw.points.size(), 4U);
    EXPECT_THAT(raw.corners, ::testing::ElementsAre(0, 1, 3, 0, 3, 2));
    EXPECT_EQ(raw.vertex_pairs.size(), 3U);
    EXPECT_EQ(finish(raw, std::nullopt, Precision::kDouble).tile.order, 2);
}

TEST(FileMidsideNodes, FaultsNameTheirLine) {
    RawTile raw = two_triangles();
    raw.points[6].x() += 1e-14;
    EXPECT_THAT(fault_of(raw), HasSubstr("t:10: node 6 is not in the middle of its edge; "));
    raw = two_triangles();
    raw.corners[9] = 8;
    EXPECT_THAT(fault_of(raw), HasSubstr("t:11: the edge from node 0 to node 3 has two middle"));
    raw = two_triangles();
    raw.corners[3] = 2;
    EXPECT_THAT(fault_of(raw), HasSubstr("t:10: node 2 is in the middle of an edge and has a sec"));
    raw = two_triangles();
    raw.vertex_pairs.pop_back();
    EXPECT_THAT(fault_of(raw), HasSubstr(" lies on the boundary, but has no partner; "));
    raw = two_triangles();
    raw.vertex_pairs.back().offset = {1, 1};
    EXPECT_THAT(fault_of(raw), HasSubstr("node 8 and node 5 are paired, but are not translates; "));
    raw = two_triangles();
    raw.vertex_pairs.push_back({0, 6, {0, 0}});
    EXPECT_THAT(fault_of(raw), HasSubstr("node 0 and node 6 are paired, but are not translates; "));
}

/// The pieces of a text exchanged, one after the other.
std::string exchanged(std::string text, const std::string& piece, const std::string& other) {
    EXPECT_NE(text.find(piece), std::string::npos) << piece;
    return text.replace(text.find(piece), piece.size(), other);
}

TEST(FileMidsideNodes, EveryFormatRefusesAMovedOne) {
    Tile tile = testing::triangle_grid_tile(Lattice::rectangle(1, 1), 1, 1);
    tile.order = 2;
    // The middle of the diagonal is node 6 of nine.
    const std::string msh =
        exchanged(encode_msh(tile, "")[0].bytes, "\n0.5 0.5 0\n", "\n0.5 0.51 0\n");
    EXPECT_THROW(decode_msh({{"t.msh", msh}}, {}), BadFile);
    const std::string inp =
        exchanged(encode_inp(tile, "")[0].bytes, ",0.5,0.5,0\n", ",0.5,0.51,0\n");
    EXPECT_THROW(decode_inp({{"t.inp", inp}}, {}), BadFile);
    const std::string vtu =
        exchanged(encode_vtu(tile, "")[0].bytes, "\n0.5 0.5 0\n", "\n0.5 0.51 0\n");
    EXPECT_THROW(decode_vtu({{"t.vtu", vtu}}, {}), BadFile);
}

TEST(FileMidsideNodes, ALineWithTheWrongOneIsRefused) {
    Tile tile = testing::triangle_grid_tile(Lattice::rectangle(1, 1), 1, 1);
    tile.order = 2;
    const std::string text = encode_msh(tile, "")[0].bytes;
    const std::size_t line = text.find("\n5 4 3 ");
    ASSERT_NE(line, std::string::npos);
    const std::string damaged =
        std::string(text).replace(line, text.find('\n', line + 1) - line, "\n5 4 3 7");
    EXPECT_THROW(decode_msh({{"t.msh", damaged}}, {}), BadFile);
}

}  // namespace
}  // namespace pcvt
