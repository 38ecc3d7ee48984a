#include "io/forms/midside_nodes.hpp"

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
FileTileBuilder two_triangles() {
    FileTileBuilder file{.name = "t", .index_base = 0};
    file.lattice = plane::Lattice::rectangle(1, 1);
    file.points = {{0, 0},   {1, 0},     {0, 1},   {1, 1},  {0.5, 0},
                   {1, 0.5}, {0.5, 0.5}, {0.5, 1}, {0, 0.5}};
    file.add_face({0, 1, 3, 4, 5, 6}, 10);
    file.add_face({0, 3, 2, 6, 7, 8}, 11);
    file.vertex_pairs = {
        {0, 1, {1, 0}}, {0, 2, {0, 1}}, {0, 3, {1, 1}}, {4, 7, {0, 1}}, {8, 5, {1, 0}}};
    return file;
}

std::string fault_of(FileTileBuilder file) {
    try {
        remove_midside_nodes(file, std::nullopt, plane::Precision::kDouble);
    } catch (const BadFile& fault) {
        return fault.what();
    }
    return "";
}

TEST(FileMidsideNodes, TheyGoAndTheTileStays) {
    FileTileBuilder file = two_triangles();
    remove_midside_nodes(file, std::nullopt, plane::Precision::kDouble);
    EXPECT_EQ(file.points.size(), 4U);
    EXPECT_THAT(file.faces.corners, ::testing::ElementsAre(0, 1, 3, 0, 3, 2));
    EXPECT_EQ(file.vertex_pairs.size(), 3U);
    EXPECT_EQ(finish(file, std::nullopt, plane::Precision::kDouble).tile.order, 2);
}

TEST(FileMidsideNodes, FaultsNameTheirLine) {
    FileTileBuilder file = two_triangles();
    file.points[6].x() += 1e-14;
    EXPECT_THAT(fault_of(file), HasSubstr("t:10: node 6 is not in the middle of its edge; "));
    file = two_triangles();
    file.faces.corners[9] = 8;
    EXPECT_THAT(fault_of(file), HasSubstr("t:11: the edge from node 0 to node 3 has two middle"));
    file = two_triangles();
    file.faces.corners[3] = 2;
    EXPECT_THAT(fault_of(file),
                HasSubstr("t:10: node 2 is in the middle of an edge and has a sec"));
    file = two_triangles();
    file.vertex_pairs.pop_back();
    EXPECT_THAT(fault_of(file), HasSubstr(" lies on the boundary, but has no partner; "));
    file = two_triangles();
    file.vertex_pairs.back().offset = {1, 1};
    EXPECT_THAT(fault_of(file),
                HasSubstr("node 8 and node 5 are paired, but are not translates; "));
    file = two_triangles();
    file.vertex_pairs.push_back({0, 6, {0, 0}});
    EXPECT_THAT(fault_of(file),
                HasSubstr("node 0 and node 6 are paired, but are not translates; "));
}

TEST(FileMidsideNodes, NodesOnWallsHaveNoPartner) {
    // Walls at the bottom and at the top.
    FileTileBuilder file = two_triangles();
    file.notes.walls = Walls::kY;
    EXPECT_THAT(fault_of(file), HasSubstr(" lies on a wall, but has a partner; "));
    std::erase(file.vertex_pairs, plane::VertexPair{4, 7, {0, 1}});
    EXPECT_EQ(fault_of(file), "");
    file = two_triangles();
    file.notes.walls = Walls::kX;
    EXPECT_THAT(fault_of(file), HasSubstr("node 8 lies on a wall, but has a partner; "));
}

/// The pieces of a text exchanged, one after the other.
std::string exchanged(std::string text, const std::string& piece, const std::string& other) {
    EXPECT_NE(text.find(piece), std::string::npos) << piece;
    return text.replace(text.find(piece), piece.size(), other);
}

TEST(FileMidsideNodes, EveryFormatRefusesAMovedOne) {
    plane::Tile tile = testing::triangle_grid_tile(plane::Lattice::rectangle(1, 1), 1, 1);
    tile.order = 2;
    // The middle of the diagonal is node 6 of nine.
    const std::string msh =
        exchanged(encode_msh(entity_mesh(tile), "")[0].bytes, "\n0.5 0.5 0\n", "\n0.5 0.51 0\n");
    EXPECT_THROW(decode_msh({{"t.msh", msh}}, {}), BadFile);
    const std::string inp =
        exchanged(encode_inp(tile, {}, "")[0].bytes, ",0.5,0.5,0\n", ",0.5,0.51,0\n");
    EXPECT_THROW(decode_inp({{"t.inp", inp}}, {}), BadFile);
    const std::string vtu =
        exchanged(encode_vtu(vtu_grid(tile), "")[0].bytes, "\n0.5 0.5 0\n", "\n0.5 0.51 0\n");
    EXPECT_THROW(decode_vtu({{"t.vtu", vtu}}, {}), BadFile);
}

TEST(FileMidsideNodes, ALineWithTheWrongOneIsRefused) {
    plane::Tile tile = testing::triangle_grid_tile(plane::Lattice::rectangle(1, 1), 1, 1);
    tile.order = 2;
    const std::string text = encode_msh(entity_mesh(tile), "")[0].bytes;
    const std::size_t line = text.find("\n5 4 3 ");
    ASSERT_NE(line, std::string::npos);
    const std::string damaged =
        std::string(text).replace(line, text.find('\n', line + 1) - line, "\n5 4 3 7");
    EXPECT_THROW(decode_msh({{"t.msh", damaged}}, {}), BadFile);
}

}  // namespace
}  // namespace pcvt
