#include "io/solvers/inp_wedges.hpp"

#include <gmock/gmock.h>

#include <array>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

#include "io/formats/file_proof.hpp"
#include "io/solvers/inp_reader.hpp"
#include "io/solvers/inp_writer.hpp"
#include "mesher/plane/tile/build_tile.hpp"
#include "tests/support/damaged_text.hpp"
#include "tests/support/example_lattices.hpp"
#include "tests/support/grid_tile.hpp"
#include "tests/support/mutation.hpp"
#include "tests/support/solver_tiles.hpp"
#include "tests/support/walled_tiles.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

FileOptions wedge_options(const plane::Tile& tile, double thickness = 0.3) {
    return {.element = wedge_element(tile.order), .thickness = thickness};
}

std::string wedges(const plane::Tile& tile, double thickness = 0.3) {
    return encode_inp(tile, wedge_options(tile, thickness), "t.inp")[0].bytes;
}

TileFile read_wedges(const std::string& text) {
    return decode_inp({{"t.inp", text}}, std::nullopt);
}

/// The numbers in the data lines of the cards that begin with `card`, one vector a line.
std::vector<std::vector<double>> rows_of_card(const std::string& text, const std::string& card) {
    std::vector<std::vector<double>> rows;
    std::istringstream lines(text);
    std::string line;
    bool is_inside = false;
    while (std::getline(lines, line)) {
        if (line.starts_with('*')) {
            is_inside = line.starts_with(card);
            continue;
        }
        if (!is_inside) continue;
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream words(line);
        rows.emplace_back(std::istream_iterator<double>(words), std::istream_iterator<double>());
    }
    return rows;
}

/// The members of a set or of the elements of a surface.
std::set<int> members_of(const std::string& text, const std::string& card) {
    std::set<int> found;
    for (const auto& row : rows_of_card(text, card)) found.insert(row.begin(), row.end());
    return found;
}

TEST(InpWedges, TilesReadBackExactlyWithTheirThicknessAndTheirPairs) {
    const std::vector<plane::Lattice> fitting = {plane::Lattice({1, 0}, {0, 1}),
                                                 plane::Lattice({2, 0}, {0.25, 0.875}),
                                                 plane::Lattice({0, 1}, {1, 0})};
    for (const plane::Tile& tile : testing::solver_tiles(fitting)) {
        for (const double thickness : {0.3, 1.0 / 3, 0.0}) {
            const TileFile file = read_wedges(wedges(tile, thickness));
            testing::expect_read_back(file, tile);
            EXPECT_EQ(file.thickness,
                      thickness > 0 ? thickness : std::sqrt(tile.lattice.area() / tile.n_faces()));
        }
    }
}

/// One equation: its nodes, directions and coefficients, term by term.
std::vector<std::vector<std::array<double, 3>>> equations_of(const std::string& text) {
    std::vector<std::vector<std::array<double, 3>>> equations;
    std::size_t n_pending = 0;
    for (const std::vector<double>& row : rows_of_card(text, "*EQUATION")) {
        if (n_pending == 0) {
            n_pending = static_cast<std::size_t>(row.at(0));
            equations.emplace_back();
            continue;
        }
        for (std::size_t k = 0; k < row.size(); k += 3) {
            equations.back().push_back({row.at(k), row.at(k + 1), row.at(k + 2)});
            --n_pending;
        }
    }
    return equations;
}

TEST(InpWedges, EquationsHoldForEveryLinearDisplacementAndTieEachNodeOnce) {
    Eigen::Matrix3d strain;
    strain << 0.3, 0.7, -0.2, 0.7, -1.1, 0.4, -0.2, 0.4, 0.9;
    for (const plane::Tile& tile : testing::solver_tiles({testing::kSquare})) {
        const std::string text = wedges(tile);
        std::map<int, Eigen::Vector3d> displacement;
        for (const auto& row : rows_of_card(text, "*NODE,NSET=NALL")) {
            displacement[static_cast<int>(row[0])] =
                strain * Eigen::Vector3d(row[1], row[2], row[3]);
        }
        const int n = static_cast<int>(displacement.size());
        for (int k = 0; k < 3; ++k) displacement[n + 1 + k] = strain.col(k);
        std::set<std::pair<int, int>> dependent;
        std::set<std::pair<int, int>> independent;
        for (const auto& equation : equations_of(text)) {
            ASSERT_EQ(equation.size(), 5U);
            double sum = 0;
            for (const auto& [node, i, coefficient] : equation) {
                sum += coefficient * displacement.at(int(node))[int(i) - 1];
                independent.emplace(int(node), int(i));
            }
            EXPECT_NEAR(sum, 0, 1e-13);
            const std::pair first{int(equation[0][0]), int(equation[0][1])};
            EXPECT_TRUE(dependent.insert(first).second);
            independent.erase(first);
        }
        // No chain: a representative depends on nothing, nor does the node that holds the tile.
        for (const auto& [node, i] : dependent) EXPECT_FALSE(independent.contains({node, i}));
        EXPECT_FALSE(dependent.contains({1, 1}) || dependent.contains({1, 3}));
        // One node of each orbit is left: as many as the torus has, and the middles along z.
        const auto nodes = solver_nodes(tile);
        const auto n_free = std::size_t(nodes.n_nodes()) - nodes.pairs.size() +
                            (tile.order == 2 ? tile.n_vertices() - tile.vertex_pairs.size() : 0);
        EXPECT_EQ(dependent.size(), 3 * (n - n_free));
    }
}

TEST(InpWedges, SetsOfNodesHoldTheNodesAboveTheirs) {
    plane::Tile tile = testing::grain_grid_tile(testing::kSquare, 2, 2);
    const std::string flat = encode_inp(tile, {}, "t.inp")[0].bytes;
    const std::string text = wedges(tile);
    for (const auto& [set, other] :
         {std::pair("GRAIN_BOUNDARY", "GRAIN_BOUNDARY"), std::pair("TRIPLE_LINES", "TRIPLE_POINTS"),
          std::pair("seam_1_0_0", "seam_1_0")}) {
        std::set<int> raised;
        for (const int v : members_of(flat, std::string("*NSET,NSET=") + other + "")) {
            raised.insert(v);
            raised.insert(v + 9);
        }
        EXPECT_FALSE(raised.empty());
        EXPECT_EQ(members_of(text, std::string("*NSET,NSET=") + set), raised) << set;
    }
    EXPECT_EQ(members_of(text, "*NSET,NSET=seam_0_0_1").size(), 9U);
    EXPECT_EQ(*members_of(text, "*NSET,NSET=seam_0_0_-1").begin(), 10);
    EXPECT_EQ(members_of(text, "*NSET,NSET=side_0_0_1"), std::set<int>{5});
    EXPECT_EQ(members_of(text, "*NSET,NSET=corner_1_1_1"), std::set<int>{1});
}

TEST(InpWedges, SurfacesLieBetweenCellsAndBetweenPhases) {
    const plane::Tile tile = testing::grain_grid_tile(testing::kSquare, 2, 2);
    const CellMaterials materials{.phase_names = {"a", "b"}, .site_phase = {0, 1, 1, 1}};
    FileOptions options = wedge_options(tile);
    options.materials = &materials;
    const std::string text = encode_inp(tile, options, "t.inp")[0].bytes;
    const auto surface = [&](const std::string& name) {
        const std::string card = "*SURFACE,NAME=" + name + ",TYPE=ELEMENT\n";
        const std::size_t begin = text.find(card) + card.size();
        return text.substr(begin, text.find('*', begin) - begin);
    };
    // Cell 0 has the elements 1 (nodes 1, 2, 5) and 2 (1, 5, 4); S3 stands on the first edge.
    EXPECT_EQ(surface("PHASE_a_TO_b"), "1,S3\n1,S4\n2,S4\n2,S5\n");
    EXPECT_EQ(surface("PHASE_b_TO_a").size(), surface("PHASE_a_TO_b").size());
    EXPECT_EQ(surface("GRAIN_BOUNDARY_SIDES").size(), 2 * surface("PHASE_a_TO_b").size());
}

/// The nodes of each side of a wedge, as Abaqus numbers them.
constexpr std::array<std::array<int, 4>, 3> kSideNodes{{{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}};

TEST(InpWedges, SidesOnWallsStandAboveTheEdgesOfWalls) {
    for (const plane::Tile& tile : testing::walled_tiles(Walls::kY)) {
        if (tile.kind == plane::MeshKind::kVoronoi) continue;
        const std::string text = wedges(tile);
        std::map<int, std::vector<double>> nodes;
        for (const auto& row : rows_of_card(text, "*NODE,")) nodes[static_cast<int>(row[0])] = row;
        std::map<int, std::vector<double>> elements;
        for (const auto& row : rows_of_card(text, "*ELEMENT,")) {
            elements[static_cast<int>(row[0])] = row;
        }
        const std::string card = "*SURFACE,NAME=WALL_BOTTOM_SIDES,TYPE=ELEMENT\n";
        ASSERT_THAT(text, HasSubstr(card));
        std::istringstream sides(text.substr(text.find(card) + card.size()));
        int element = 0;
        char comma = 0;
        char letter = 0;
        int side = 0;
        int n_sides = 0;
        while (sides >> element >> comma >> letter >> side) {
            ++n_sides;
            ASSERT_TRUE(side >= 3 && side <= 5);
            for (const int k : kSideNodes[side - 3]) {
                EXPECT_EQ(nodes[static_cast<int>(elements[element][k + 1])][2], 0);
            }
        }
        EXPECT_GT(n_sides, 0);
    }
}

std::string fault_with(const std::string& piece, const std::string& other, int order = 1) {
    plane::Tile tile = testing::triangle_grid_tile(testing::kSquare, 1, 1);
    tile.order = order;
    const std::string text = testing::exchanged(wedges(tile, 0.5), piece, other);
    return testing::fault_in([&] { read_wedges(text); });
}

TEST(InpWedges, FaultsNameTheirLine) {
    EXPECT_EQ(fault_with("written by pcvt", "written by pcvt"), "");
    EXPECT_THAT(fault_with("lattice 1 0 0 0 1 0 0 0 0.5", "lattice 1 0 0 1"),
                HasSubstr("has not one layer of wedges"));
    EXPECT_THAT(fault_with("1 0 0 0 1 0 0 0 0.5", "1 0 0 0 1 0 0 1 0.5"),
                HasSubstr("not that of a layer along z; "));
    EXPECT_THAT(fault_with("1 0 0 0 1 0 0 0 0.5", "1 0 0 0 1 0 0 0 -0.5"),
                HasSubstr("the thickness is not above 0; "));
    EXPECT_THAT(fault_with("1 0 0 0 1 0 0 0 0.5", "1 0 0 0 1 0 0 0 0.6"),
                HasSubstr(": node 5 does not lie above its node at the bottom; "));
    EXPECT_THAT(fault_with("\n6,1,0,0.5\n", "\n6,1,0.1,0.5\n"),
                StartsWith("t.inp:15: node 6 does not lie above its node"));
    EXPECT_THAT(fault_with("TYPE=C3D6", "TYPE=CPE6"), HasSubstr("has the lattice of wedges"));
    EXPECT_THAT(fault_with("\n1,1,2,4,5,6,8\n", "\n1,1,2,4,5,6,7\n"),
                HasSubstr("wedge 1 does not stand on a triangle"));
    EXPECT_THAT(fault_with("\n1,1,2,4,5,6,8\n", "\n1,1,2,4,1,6,8\n"),
                HasSubstr("the wedges are not one layer"));
    EXPECT_THAT(fault_with("\n5\n5,3,1,1,3,-1,", "\n5\n5,3,1,2,3,-1,"),
                HasSubstr("node 5 is not tied alike in all directions; "));
    EXPECT_THAT(fault_with("5,1,1,1,1,-1,9,1,0,9,2,0\n9,3,-0.5", "5,1,1,1,1,-1,9,1,0,9,2,0\n9,2,0"),
                HasSubstr("the equation does not tie a node"));
    EXPECT_THAT(fault_with("\n5,0,0,0.5\n", "\n4,0,0,0.5\n"),
                StartsWith("t.inp:14: the nodes are not numbered 1, 2, ..., each once; "));
    // Nodes 19 to 22 lie in the middle of the edges along z.
    EXPECT_EQ(fault_with(",19,20,22\n", ",19,20,22\n", 2), "");
    EXPECT_THAT(fault_with(",19,20,22\n", ",19,20,21\n", 2),
                HasSubstr("wedge 1 does not stand on a triangle"));
}

TEST(InpWedges, NodesThatAreNotTiedAsThoseBelowAreRefused) {
    plane::Tile tile = testing::triangle_grid_tile(testing::kSquare, 1, 1);
    std::string text = wedges(tile, 0.5);
    // Node 6 lies above node 2, whose representative is node 1.
    for (const char* const i : {"1", "2", "3"}) {
        const std::string direction(i);
        text = testing::exchanged(text, "\n6," + direction + ",1,1," + direction,
                                  "\n6," + direction + ",1,3," + direction);
    }
    EXPECT_THAT(testing::fault_in([&] { read_wedges(text); }), HasSubstr("t.inp:"));
    // The equations of node 5 are missing.
    text = wedges(tile, 0.5);
    for (const char* const i : {"1", "2", "3"}) {
        const std::size_t begin = text.find("\n5\n5," + std::string(i) + ",1,") + 1;
        std::size_t end = begin;
        for (int line = 0; line < 3; ++line) end = text.find('\n', end) + 1;
        text.erase(begin, end - begin);
    }
    EXPECT_THAT(testing::fault_in([&] { read_wedges(text); }),
                HasSubstr("node 5 is not tied as the node below it; "));
}

TEST(InpWedges, DamagedFilesGiveATileOrAFaultAndNothingElse) {
    std::mt19937_64 random(5);
    for (const plane::Tile& tile : testing::solver_tiles({testing::kSquare})) {
        const std::string bytes = wedges(tile);
        int n_refused = 0;
        for (int k = 0; k < 100; ++k) {
            const std::string damaged = testing::mutated(bytes, random);
            const std::string fault = testing::fault_in([&] { read_wedges(damaged); });
            if (fault.empty()) continue;
            ++n_refused;
            EXPECT_THAT(fault, StartsWith("t.inp"));
            EXPECT_THAT(fault, HasSubstr("; "));
        }
        EXPECT_GT(n_refused, 30);
    }
}

TEST(InpWedges, EachFieldOfAFileIsProved) {
    const plane::Sites sites(testing::kSquare, uniform_points(testing::kSquare, 5, 3));
    const Format& format = *find_format("t.inp");
    for (const int order : {1, 2}) {
        const plane::Tile tile = build_tile(plane::PeriodicDelaunay(sites),
                                            {.kind = plane::MeshKind::kGrains, .order = order})
                                     .tile;
        const CellMaterials materials{.phase_names = {"a", "b"}, .site_phase = {0, 1, 0, 1, 1}};
        FileOptions options = wedge_options(tile);
        options.materials = &materials;
        const std::string text = encode_inp(tile, options, "t.inp")[0].bytes;
        const auto fault = [&](const std::string& piece, const std::string& other) {
            const std::vector<EncodedFile> files{{"t.inp", testing::exchanged(text, piece, other)}};
            return testing::fault_in(
                [&] { prove_file(format, files, decode_inp(files, std::nullopt)); });
        };
        EXPECT_EQ(fault("written by pcvt", "written by pcvt"), "");
        EXPECT_THAT(fault("NSET=TRIPLE_LINES", "NSET=TRIPLE_LINE"), HasSubstr("TRIPLE_LINES"));
        EXPECT_THAT(fault("NAME=PHASE_a_TO_b", "NAME=PHASE_a_TO_a"), HasSubstr("PHASE_A_TO_"));
        EXPECT_THAT(fault("NSET=seam_0_0_1\n1,", "NSET=seam_0_0_1\n"), HasSubstr("SEAM_0_0_1"));
        EXPECT_THAT(fault("_SIDES,TYPE=ELEMENT\n", "_SIDES,TYPE=ELEMENT\n1,S1\n"),
                    HasSubstr("GRAIN_BOUNDARY_SIDES"));
        EXPECT_THAT(fault("NSET=FIXED\n1\n", "NSET=FIXED\n2\n"), HasSubstr("FIXED"));
    }
}

}  // namespace
}  // namespace pcvt
