#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "io/forms/triangle_elements.hpp"
#include "io/solvers/inp_reader.hpp"
#include "io/solvers/inp_writer.hpp"
#include "mesher/plane/tile/build_tile.hpp"
#include "tests/support/damaged_text.hpp"
#include "tests/support/example_lattices.hpp"
#include "tests/support/grid_tile.hpp"
#include "tests/support/mutation.hpp"
#include "tests/support/solver_tiles.hpp"
#include "tests/support/tile_equality.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;
using testing::kSquare;
using ::testing::StartsWith;

std::string inp_triangles() {
    return encode_inp(testing::triangle_grid_tile(kSquare, 1, 1), {}, "t.inp")[0].bytes;
}

TileFile read_inp(const std::string& text, const std::optional<plane::Lattice>& lattice = {}) {
    return decode_inp({{"t.inp", text}}, lattice);
}

std::string inp_fault(const std::string& text) {
    return testing::fault_in([&] { read_inp(text); });
}

/// Returns the fault of the two triangles with `piece` of their text replaced by `other`.
std::string inp_fault_with(const std::string& piece, const std::string& other) {
    return inp_fault(testing::exchanged(inp_triangles(), piece, other));
}

TEST(Inp, TilesReadBackExactlyWithTheirVertexPairs) {
    const std::vector<plane::Lattice> fitting = {plane::Lattice({1, 0}, {0, 1}),
                                                 plane::Lattice({2, 0}, {0.25, 0.875}),
                                                 plane::Lattice({0, 1}, {1, 0})};
    for (const plane::Tile& tile : testing::solver_tiles(fitting)) {
        const auto files = encode_inp(tile, {}, "dir/t.inp");
        ASSERT_EQ(files.size(), 1U);
        EXPECT_EQ(files[0].path, "dir/t.inp");
        const TileFile file = decode_inp(files, std::nullopt);
        EXPECT_FALSE(file.has_edge_pairs);
        testing::expect_read_back(file, tile);
    }
}

TEST(Inp, EachTiedNodeHasOneEquationPerDirection) {
    const std::string text =
        encode_inp(testing::triangle_grid_tile(plane::Lattice({2, 0}, {1, 3}), 2, 1), {},
                   "t.inp")[0]
            .bytes;
    EXPECT_THAT(text, HasSubstr("*ELEMENT,TYPE=CPE3,ELSET=EALL\n1,1,2,5\n2,1,5,4\n"));
    EXPECT_THAT(text, HasSubstr("*NODE,NSET=CONTROL_1\n7,"));
    EXPECT_THAT(text, HasSubstr("*NSET,NSET=seam_1_0\n1,4\n"));
    // Node 6 lies at node 1 + a + b = node 1 + (3, 3).
    EXPECT_THAT(text,
                HasSubstr("\n4\n6,1,1,1,1,-1,7,1,-3,7,2,-3\n4\n6,2,1,1,2,-1,7,2,-3,8,2,-3\n"));
}

TEST(Inp, ALineHoldsAtMostEightIdsAndANumberTwentyCharacters) {
    const plane::Lattice lattice({1, 0}, {1.0 / 3, 2.0 / 3});
    plane::Tile tile = testing::triangle_grid_tile(lattice, 30, 30);
    const std::string text = encode_inp(tile, {}, "t.inp")[0].bytes;
    std::size_t n_fields = 0;
    std::size_t length = 0;
    for (const char c : text.substr(text.find("*NODE"))) {
        const bool ends = c == ',' || c == '\n';
        length = ends || c == '*' ? 0 : length + 1;
        n_fields = c == '\n' ? 0 : n_fields + (c == ',' ? 1 : 0);
        EXPECT_LE(length, 20U);
        EXPECT_LE(n_fields, 11U);
    }
    EXPECT_NO_THROW(prove_tile(read_inp(text).tile, plane::Precision::kDouble));
}

TEST(Inp, NumbersBeyondTwentyCharactersAreRefusedOrRoundedWithinTheTolerance) {
    for (const plane::Lattice& lattice : testing::awkward_lattices()) {
        const plane::Tile tile = testing::triangle_grid_tile(lattice, 7, 7);
        if (lattice.a().norm() < 0.1) {
            EXPECT_THROW(encode_inp(tile, {}, "t.inp"), InvalidInput);
            continue;
        }
        const TileFile file = decode_inp(encode_inp(tile, {}, "t.inp"), std::nullopt);
        EXPECT_NO_THROW(compare_vertex_pairs(file.tile, prove_tile(file.tile, file.precision)));
    }
}

TEST(Inp, EachDelaunayCellHasElements) {
    constexpr int kSites = 60;
    const plane::Sites sites(kSquare, uniform_points(kSquare, kSites, 5));
    const plane::Tile tile =
        build_tile(plane::PeriodicDelaunay(sites), {.kind = plane::MeshKind::kDelaunay}).tile;
    const std::vector<SiteId> owners = element_cells(tile);
    const std::string text = encode_inp(tile, {}, "t.inp")[0].bytes;
    for (SiteId s = 0; s < kSites; ++s) {
        const std::string set = "\n*ELSET,ELSET=CELL_" + std::to_string(s) + "\n";
        ASSERT_THAT(text, HasSubstr(set));
        const auto element = std::stoul(text.substr(text.find(set) + set.size()));
        const auto corners = tile.faces[static_cast<int>(element) - 1];
        EXPECT_TRUE(std::any_of(corners.begin(), corners.end(),
                                [&](int v) { return tile.vertex_site[v] == s; }));
    }
    EXPECT_LT(std::set<SiteId>(owners.begin(), owners.end()).size(), std::size_t{kSites});
    EXPECT_NO_THROW(prove_tile(read_inp(text).tile, plane::Precision::kDouble));
}

TEST(Inp, CellsMeetAtTheNodesOfTheirSets) {
    plane::Tile tile = testing::grain_grid_tile(kSquare, 2, 2);
    const auto sets = [&] {
        const std::string text = encode_inp(tile, {}, "t.inp")[0].bytes;
        const std::size_t begin = text.find("*NSET,NSET=GRAIN_BOUNDARY\n");
        return text.substr(begin, text.find("*NSET,NSET=seam") - begin);
    };
    // Four cells meet at each of the nine nodes.
    const std::string all = "1,2,3,4,5,6,7,8\n9\n";
    EXPECT_EQ(sets(), "*NSET,NSET=GRAIN_BOUNDARY\n" + all + "*NSET,NSET=TRIPLE_POINTS\n" + all);
    // A whole cell meets its images at the seam, and three of them at its corners.
    for (SiteId& site : tile.face_site) site = 0;
    tile.grain_site_points.assign(8, {0.5, 0.5});
    EXPECT_EQ(sets(),
              "*NSET,NSET=GRAIN_BOUNDARY\n1,2,3,4,6,7,8,9\n*NSET,NSET=TRIPLE_POINTS\n1,3,7,9\n");
    // The lower and the upper row are parts of two images, which the seam at the bottom only cuts.
    for (int f = 0; f < 8; ++f) tile.grain_site_points[f] = {0.5, f < 4 ? 0 : 1};
    EXPECT_EQ(sets(), "*NSET,NSET=GRAIN_BOUNDARY\n1,3,4,5,6,7,9\n*NSET,NSET=TRIPLE_POINTS\n4,6\n");
}

TEST(Inp, ElementsAreForPlaneStressOnRequest) {
    plane::Tile tile = testing::triangle_grid_tile(kSquare, 1, 1);
    EXPECT_THAT(encode_inp(tile, {.element = PlaneElement::kStress}, "t.inp")[0].bytes,
                HasSubstr("TYPE=CPS3,ELSET=EALL"));
    tile.order = 2;
    const auto files = encode_inp(tile, {.element = PlaneElement::kStress}, "t.inp");
    EXPECT_THAT(files[0].bytes, HasSubstr("TYPE=CPS6,ELSET=EALL"));
    EXPECT_NO_THROW(prove_tile(decode_inp(files, std::nullopt).tile, plane::Precision::kDouble));
}

TEST(Inp, PolygonsAreRefusedWithARemedy) {
    try {
        encode_inp(testing::grid_tile(kSquare, 2, 2), {}, "t.inp");
        FAIL();
    } catch (const InvalidInput& fault) {
        EXPECT_STREQ(fault.what(),
                     "t.inp: the format has no polygons; take the mesh delaunay or grains");
    }
}

TEST(Inp, MeshesOfOtherProgramsAreRead) {
    const TileFile file = read_inp(
        "*Heading\r\n a mesh\r\n** made by hand\r\n*Node\r\n 10, 0., 0.\r\n20, 1, 0, 0.\r\n"
        "30, 1., 1.\n40, 0., 1.\n*Element, type = CPS3, elset=Skin\n1, 10, 20, 30\n2,10,30,40,\n"
        "*Elset, elset=Half\n1\n*Nset, nset=All, generate\n10, 40, "
        "10\n*Equation\n2\n10,1,1.,20,1,-1.\n"
        "*Material, name=Steel\n*Elastic\n210000., 0.3\n",
        kSquare);
    EXPECT_THAT(file.tile.faces.corners, ::testing::ElementsAre(0, 1, 2, 0, 2, 3));
    EXPECT_FALSE(file.has_vertex_pairs || file.has_edge_pairs);
    EXPECT_NO_THROW(prove_tile(file.tile, file.precision));
}

TEST(Inp, FaultsNameTheirLine) {
    EXPECT_THAT(inp_fault(""), StartsWith("t.inp: there is no vertex; "));
    EXPECT_THAT(inp_fault_with("kind triangles", "kind x"),
                StartsWith("t.inp:5: the kind is unclear"));
    EXPECT_THAT(inp_fault_with("pcvt kind", "pcvt king"),
                StartsWith("t.inp:5: pcvt does not know 'k"));
    EXPECT_THAT(inp_fault_with("sites 0 0 0 0", "sites 0 0"),
                StartsWith("t.inp: there are 2 sites for"));
    EXPECT_THAT(inp_fault_with("\n2,1,0,0\n", "\n2,1,0,1\n"), StartsWith("t.inp:10: z is not 0; "));
    EXPECT_THAT(inp_fault_with("\n2,1,0,0\n", "\n2,1,x,0\n"),
                StartsWith("t.inp:10: 'X' is not a num"));
    EXPECT_THAT(inp_fault_with("\n2,1,0,0\n", "\n2,1\n"),
                StartsWith("t.inp:10: the line has 2 fields"));
    EXPECT_THAT(inp_fault_with("\n2,1,0,0\n", "\n1,1,0,0\n"),
                StartsWith("t.inp:10: node 1 is given tw"));
    EXPECT_THAT(inp_fault_with("CPE3", "CPE4"),
                HasSubstr(": elements of type 'CPE4' are not plane tri"));
    EXPECT_THAT(inp_fault_with("\n1,1,2,4\n", "\n1,1,2,9\n"),
                HasSubstr(": node 9 does not exist; "));
    EXPECT_THAT(inp_fault_with("2,1,1,1,1,-1", "2,1,1,1,1,1"),
                HasSubstr(": the equation does not tie a node"));
    EXPECT_THAT(inp_fault_with("5,1,-1,5,2,0", "5,1,-1,6,2,0"),
                HasSubstr(": the equation does not tie a node"));
    EXPECT_THAT(inp_fault_with("5,1,-1,5,2,0", "5,1,-1,5,2"), HasSubstr(": a term is a node, "));
    EXPECT_THAT(inp_fault_with("\n2,2,1,1,2,-1", "\n3,2,1,1,2,-1"),
                HasSubstr(": node 3 is tied twice "));
    EXPECT_THAT(inp_fault_with("5,2,-1,6,2,0", "5,2,-2,6,2,0"),
                HasSubstr("not tied alike in both"));
    EXPECT_THAT(inp_fault_with("\n4\n4,1,1,1,1,-1,5,1,-1,5,2,-1", "\n4\n4,1,1,2,1,-1,5,1,0,5,2,-1"),
                HasSubstr("not tied alike in both directions; "));
    EXPECT_THAT(inp_fault_with("\n4\n2,1,1", "\n3\n2,1,1"), HasSubstr(" too many terms; "));
    EXPECT_THAT(inp_fault(inp_triangles() + "4\n"),
                HasSubstr(": the last equation is not whole; "));
    EXPECT_THAT(inp_fault(inp_triangles() + "4\n*STEP\n"),
                HasSubstr("before this card is not whole"));
    EXPECT_THAT(inp_fault(inp_triangles() + '\0'), HasSubstr("appears to be a binary file; "));
}

TEST(Inp, AMasterThatIsTiedItselfIsRefused) {
    std::string text = inp_triangles();
    for (const auto& [direct, chained] :
         {std::pair("4,1,1,1,1,-1,5,1,-1,5,2,-1", "4,1,1,2,1,-1,5,1,0,5,2,-1"),
          std::pair("4,2,1,1,2,-1,5,2,-1,6,2,-1", "4,2,1,2,2,-1,5,2,0,6,2,-1")}) {
        ASSERT_THAT(text, HasSubstr(direct));
        text.replace(text.find(direct), std::string(direct).size(), chained);
    }
    EXPECT_THAT(inp_fault(text), HasSubstr(": the master node 2 is tied itself; "));
}

TEST(Inp, AWrongTranslationIsRefuted) {
    std::string text = inp_triangles();
    for (const auto& [right, wrong] : {std::pair("2,1,1,1,1,-1,5,1,-1,", "2,1,1,1,1,-1,5,1,-2,"),
                                       std::pair("2,2,1,1,2,-1,5,2,-1,", "2,2,1,1,2,-1,5,2,-2,")}) {
        ASSERT_THAT(text, HasSubstr(right));
        text.replace(text.find(right), std::string(right).size(), wrong);
    }
    const TileFile file = read_inp(text);
    EXPECT_THROW(compare_vertex_pairs(file.tile, prove_tile(file.tile, file.precision)), NotATile);
}

TEST(Inp, DamagedFilesGiveATileOrAFaultAndNothingElse) {
    std::mt19937_64 random(3);
    for (const plane::Tile& tile : testing::solver_tiles({kSquare})) {
        const std::string bytes = encode_inp(tile, {}, "t.inp")[0].bytes;
        int n_refused = 0;
        for (int k = 0; k < 300; ++k) {
            const std::string fault = inp_fault(testing::mutated(bytes, random));
            if (fault.empty()) continue;
            ++n_refused;
            EXPECT_THAT(fault, StartsWith("t.inp"));
            EXPECT_THAT(fault, HasSubstr("; "));
        }
        EXPECT_GT(n_refused, 100);
    }
}

}  // namespace
}  // namespace pcvt
