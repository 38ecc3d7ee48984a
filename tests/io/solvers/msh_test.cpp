#include <gmock/gmock.h>

#include <cmath>

#include "io/formats/formats.hpp"
#include "io/solvers/msh_reader.hpp"
#include "io/solvers/msh_writer.hpp"
#include "tests/support/damaged_text.hpp"
#include "tests/support/example_lattices.hpp"
#include "tests/support/grid_tile.hpp"
#include "tests/support/holed_tiles.hpp"
#include "tests/support/msh_links.hpp"
#include "tests/support/mutation.hpp"
#include "tests/support/solver_tiles.hpp"
#include "tests/support/tile_equality.hpp"
#include "tests/support/walled_tiles.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;
using testing::kSquare;
using ::testing::StartsWith;

/// Two triangles on four nodes, each of which is an end of a seam segment.
std::string msh_triangles() {
    return encode_msh(entity_mesh(testing::triangle_grid_tile(kSquare, 1, 1)), "t.msh")[0].bytes;
}

TileFile read_msh(const std::string& text, const std::optional<plane::Lattice>& lattice = {}) {
    return decode_msh({{"t.msh", text}}, lattice);
}

std::string msh_fault(const std::string& text) {
    return testing::fault_in([&] { read_msh(text); });
}

/// Returns the fault of the two triangles with `piece` of their text replaced by `other`.
std::string msh_fault_with(const std::string& piece, const std::string& other) {
    return msh_fault(testing::exchanged(msh_triangles(), piece, other));
}

TEST(Msh, TilesReadBackExactlyWithTheirPairs) {
    for (const plane::Tile& tile : testing::solver_tiles(testing::awkward_lattices())) {
        const auto files = encode_msh(entity_mesh(tile), "dir/t.msh");
        ASSERT_EQ(files.size(), 1U);
        EXPECT_EQ(files[0].path, "dir/t.msh");
        const TileFile file = decode_msh(files, std::nullopt);
        EXPECT_TRUE(file.has_edge_pairs);
        testing::expect_read_back(file, tile);
    }
}

TEST(Msh, CellsBecomeSurfacesAndTheirBoundariesCurves) {
    const std::string text =
        encode_msh(entity_mesh(testing::triangle_grid_tile(plane::Lattice({2, 0}, {1, 3}), 2, 1)),
                   "t.msh")[0]
            .bytes;
    EXPECT_THAT(text, HasSubstr("$PhysicalNames\n7\n1 3 \"seam_-1_0\"\n1 4 \"seam_0_-1\"\n"
                                "1 5 \"seam_0_1\"\n1 6 \"seam_1_0\"\n1 7 \"grain_boundary\"\n"
                                "2 1 \"cell_0\"\n2 2 \"cell_1\"\n$End"));
    EXPECT_THAT(text, HasSubstr("$Entities\n6 9 2 0\n1 0 0 0 0\n"));
    // The curve from point 1 to point 2 belongs to seam_0_1 and lies on the left of its cell.
    EXPECT_THAT(text, HasSubstr("\n1 0 0 0 1 0 0 1 5 2 1 -2\n"));
    // Three curves lie between cells: the first one from point 1 to point 5.
    EXPECT_THAT(text, HasSubstr("\n7 0 0 0 2 3 0 1 7 2 1 -5\n"));
    EXPECT_THAT(text, HasSubstr("\n1 0 0 0 3 3 0 1 1 6 2 3 5 6 7 -9\n"));
    // Four points are images of others; three curves are slaves.
    EXPECT_THAT(text,
                HasSubstr("$Periodic\n7\n0 3 1\n16 1 0 0 2 0 1 0 0 0 0 1 0 0 0 0 1\n1\n3 1\n"));
    EXPECT_THAT(text, HasSubstr("\n1 4 2\n16 1 0 0 1 0 1 0 3 0 0 1 0 0 0 0 1\n2\n6 3\n5 2\n"));
    // Values are in the order of the elements: nine lines, then triangles cell by cell.
    EXPECT_THAT(text, HasSubstr("$ElementData\n1\n\"cell_id\"\n1\n0\n3\n0\n1\n13\n5 -1\n6 -1\n"));
    EXPECT_THAT(text, HasSubstr("\n13 -1\n2 0\n3 0\n1 1\n4 1\n"));
    EXPECT_THAT(text, HasSubstr("$NodeData\n1\n\"cell_id\"\n1\n0\n3\n0\n1\n6\n1 0\n2 1\n"));
}

TEST(Msh, MidsideNodesHaveNoSite) {
    plane::Tile tile = testing::triangle_grid_tile(plane::Lattice::rectangle(1, 1), 2, 1);
    tile.order = 2;
    const std::string text = encode_msh(entity_mesh(tile), "t.msh")[0].bytes;
    // Six vertices and nine edges; vertices with points come first, midside nodes of curves after.
    EXPECT_THAT(text, HasSubstr("$NodeData\n1\n\"cell_id\"\n1\n0\n3\n0\n1\n15\n1 0\n2 1\n3 0\n"
                                "4 0\n5 1\n6 0\n7 -1\n"));
}

/// Random sites on square and oblique lattices, as triangles and grains of both outlines and
/// orders.
std::vector<plane::Tile> random_tiles() {
    std::vector<plane::Tile> tiles;
    for (int k = 0; k < 40; ++k) {
        const plane::Lattice lattice = k % 2 == 0 ? plane::Lattice::rectangle(1, 1)
                                                  : plane::Lattice({1, 0.3}, {0.1 * k - 2, 1});
        const int n = 1 + k * k / 30;
        plane::TileOptions options{.kind = k % 4 < 2 ? plane::MeshKind::kDelaunay
                                                     : plane::MeshKind::kGrains};
        if (k % 4 == 3) options.outline = plane::Outline::kBox;
        if (options.kind == plane::MeshKind::kGrains) options.order = 1 + k / 4 % 2;
        const plane::Sites sites(lattice,
                                 uniform_points(lattice, n, static_cast<std::uint64_t>(k)));
        tiles.push_back(build_tile(plane::PeriodicDelaunay(sites), options).tile);
    }
    for (const Walls walls : {Walls::kX, Walls::kY, Walls::kXY}) {
        for (plane::Tile& tile : testing::walled_tiles(walls)) tiles.push_back(std::move(tile));
    }
    for (const plane::Outline outline : {plane::Outline::kWhole, plane::Outline::kBox}) {
        tiles.push_back(
            testing::holed_tile({.kind = plane::MeshKind::kGrains, .outline = outline}));
    }
    tiles.push_back(testing::holed_tile({.kind = plane::MeshKind::kDelaunay}));
    return tiles;
}

TEST(Msh, TiesEachNodeByAnyOfItsLinksAndByCurvesAlone) {
    for (const plane::Tile& tile : random_tiles()) {
        SCOPED_TRACE(mesh_kind_row(tile.kind).word + std::string(", nodes: ") +
                     std::to_string(tile.n_vertices()));
        const SolverNodes nodes = solver_nodes(tile);
        const int n_orbits = nodes.n_nodes() - static_cast<int>(nodes.pairs.size());
        testing::expect_orbits(encode_msh(entity_mesh(tile), "t.msh")[0].bytes, n_orbits);
    }
}

TEST(Msh, PolygonsAreRefusedWithARemedy) {
    try {
        encode_tile(*find_format("t.msh"), testing::grid_tile(kSquare, 2, 2), "t.msh");
        FAIL();
    } catch (const InvalidInput& fault) {
        EXPECT_STREQ(fault.what(),
                     "t.msh: the format has no polygons; take the mesh delaunay or grains");
    }
}

TEST(Msh, MeshesOfOtherProgramsAreRead) {
    const TileFile file = read_msh(
        "$MeshFormat\r\n4.1 0 8\r\n$EndMeshFormat\r\n$Entities\r\n0 0 1 0\r\n$EndEntities\r\n"
        "$Nodes\n2 4 7 40\n2 1 0 3\n20\n7\n9\n1 0 0\n0 0 0\n1 1 0\n2 2 0 1\n40\n0 1 0\n$EndNodes\n"
        "$Elements\n2 3 1 9\n0 1 15 1\n1 7\n2 1 2 2\n9 7 20 9\n4 7 9 40\n$EndElements\n"
        "$ElementData\n1\n\"stress\"\n1\n0\n3\n0\n1\n1\n9 0.5\n$EndElementData\n",
        kSquare);
    EXPECT_EQ(file.tile.kind, plane::MeshKind::kDelaunay);
    EXPECT_THAT(file.tile.faces.corners, ::testing::ElementsAre(0, 1, 3, 0, 2, 1));
    EXPECT_EQ(file.tile.points[2], plane::Vec2(1, 0));
    EXPECT_FALSE(file.has_vertex_pairs || file.has_edge_pairs);
    EXPECT_NO_THROW(prove_tile(file.tile, file.precision));
}

TEST(Msh, FaultsNameTheirLine) {
    EXPECT_THAT(msh_fault(""), StartsWith("t.msh: does not begin with $MeshFormat; "));
    EXPECT_THAT(msh_fault_with("4.1 0 8", "2.2 0 8"),
                StartsWith("t.msh:2: the version is '2.2'; "));
    EXPECT_THAT(msh_fault_with("4.1 0 8", "4.1 1 8"), StartsWith("t.msh:2: the file is binary; "));
    EXPECT_THAT(msh_fault_with("kind triangles", "kind x"),
                StartsWith("t.msh:6: the kind is unclear"));
    EXPECT_THAT(msh_fault_with("lattice 1 0 0", "lattice 0 0 0"), StartsWith("t.msh:7: "));
    EXPECT_THAT(msh_fault_with("pcvt kind", "pcvt king"),
                StartsWith("t.msh:6: pcvt does not know 'k"));
    EXPECT_THAT(msh_fault_with("$EndComments", ""),
                StartsWith("t.msh: ends inside of a section; "));
    EXPECT_THAT(msh_fault_with("$EndNodes", "7\n$EndNodes"),
                HasSubstr(": the section has more lines than its count; "));
    EXPECT_THAT(msh_fault_with("\n1 0 0\n", "\n1 0 0.5\n"), HasSubstr(": z is not 0; "));
    EXPECT_THAT(msh_fault_with("\n1 0 0\n", "\n1 x 0\n"), HasSubstr(": 'x' is not a number; "));
    EXPECT_THAT(msh_fault_with("\n1 0 0\n", "\n1 0\n"),
                HasSubstr(": the line has 2 words where 3 "));
    EXPECT_THAT(msh_fault_with("2 1 2 2\n", "2 1 3 2\n"),
                HasSubstr(": elements of type 3 are not tri"));
    EXPECT_THAT(msh_fault_with("2 1 2 2\n", "2 1 2 -2\n"), HasSubstr(": a count is negative; "));
    EXPECT_THAT(msh_fault_with("\n1 1 2 4\n", "\n1 1 2 5\n"),
                HasSubstr(": node 5 does not exist; "));
    EXPECT_THAT(msh_fault_with("\n1 1 2 4\n", "\n1 1 2 2\n"),
                HasSubstr(": vertex 2 is a corner twice"));
    EXPECT_THAT(msh_fault_with("\n1 1 2 4\n", "\n2 1 2 4\n"),
                HasSubstr(": element 2 is given twice; "));
    EXPECT_THAT(msh_fault_with("\n16 1 0 0 1 0", "\n16 1 0 0.1 1 0"),
                HasSubstr("is not a translation"));
    EXPECT_THAT(msh_fault_with("\n16 1 0 0 1 0", "\n16 1 0 0 0.5 0"),
                HasSubstr("not a lattice vector"));
    EXPECT_THAT(msh_fault(msh_triangles() + '\0'), HasSubstr("appears to be a binary file; "));
    EXPECT_THAT(msh_fault(msh_triangles() + "1\n"), HasSubstr(": '1' does not begin a section; "));
}

TEST(Msh, AWrongLinkIsRefuted) {
    std::string text = msh_triangles();
    // Node 4 lies at node 1 + a + b.
    const std::string link = "16 1 0 0 1 0 1 0 1 0 0 1 0 0 0 0 1\n1\n4 1\n";
    ASSERT_THAT(text, HasSubstr(link));
    text.replace(text.find(link), link.size(), "16 1 0 0 1 0 1 0 0 0 0 1 0 0 0 0 1\n1\n4 1\n");
    const TileFile file = read_msh(text);
    EXPECT_THROW(compare_vertex_pairs(file.tile, prove_tile(file.tile, file.precision)), NotATile);
}

TEST(Msh, AWrongLineOfTheSeamIsRefuted) {
    const std::string text =
        encode_msh(entity_mesh(testing::triangle_grid_tile(kSquare, 2, 2)), "t.msh")[0].bytes;
    const TileFile file = read_msh(testing::exchanged(text, "\n13 9 8\n", "\n13 8 9\n"));
    EXPECT_THROW(compare_edge_pairs(file.tile, prove_tile(file.tile, file.precision)), NotATile);
    EXPECT_THAT(msh_fault(testing::exchanged(text, "\n13 9 8\n", "\n13 8 7\n")),
                HasSubstr(": $Periodic has no master for an end of this line; "));
}

TEST(Msh, GroupsThatDoNotFitTheCellsAreRefused) {
    const std::string text =
        encode_msh(entity_mesh(testing::grain_grid_tile(kSquare, 2, 2)), "t.msh")[0].bytes;
    const auto fault = [&](const std::string& piece, const std::string& other) {
        return msh_fault(testing::exchanged(text, piece, other));
    };
    EXPECT_EQ(msh_fault(text), "");
    EXPECT_THAT(
        fault("2 3 \"cell_2\"", "2 3 \"cell_9\""),
        HasSubstr(": the triangle is in the physical group 'cell_9', but its cell_id is 2"));
    EXPECT_THAT(
        fault("\n1 0\n2 0\n", "\n1 1\n2 0\n"),
        HasSubstr(": the triangle is in the physical group 'cell_0', but its cell_id is 1"));
    // A line between two cells becomes one between a node and another cell's node.
    EXPECT_THAT(fault("\n17 2 5\n", "\n17 2 4\n"),
                HasSubstr(": the line of grain_boundary is not between two triangles; "));
    EXPECT_THAT(fault("1 9 \"grain_boundary\"", "1 9 \"walls\""),
                HasSubstr(": the edge from node 2 to node 5 lies between two cells, but not in"));
    EXPECT_THAT(fault("\"cell_0\"", "cell_0"), HasSubstr(": the name of the group is not in quot"));
}

TEST(Msh, NonFiniteCoordinatesAreInternalErrors) {
    plane::Tile tile = testing::triangle_grid_tile(kSquare, 1, 1);
    tile.points[0].x() = std::nan("");
    EXPECT_THROW(encode_msh(entity_mesh(tile), "t.msh"), InternalError);
}

TEST(Msh, DamagedFilesGiveATileOrAFaultAndNothingElse) {
    std::mt19937_64 random(3);
    for (const plane::Tile& tile : testing::solver_tiles({kSquare})) {
        const std::string bytes = encode_msh(entity_mesh(tile), "t.msh")[0].bytes;
        int n_refused = 0;
        for (int k = 0; k < 300; ++k) {
            const std::string fault = msh_fault(testing::mutated(bytes, random));
            if (fault.empty()) continue;
            ++n_refused;
            EXPECT_THAT(fault, StartsWith("t.msh"));
            EXPECT_THAT(fault, HasSubstr("; "));
        }
        EXPECT_GT(n_refused, 150);
    }
}

}  // namespace
}  // namespace pcvt
