#include <gmock/gmock.h>

#include <array>
#include <cmath>

#include "io/solvers/vtu_reader.hpp"
#include "io/solvers/vtu_writer.hpp"
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

std::string one_cell() {
    return encode_vtu(vtu_grid(testing::grid_tile(kSquare, 1, 1)), "t.vtu")[0].bytes;
}

TileFile read_vtu(const std::string& text, const std::optional<plane::Lattice>& lattice = {}) {
    return decode_vtu({{"t.vtu", text}}, lattice);
}

std::string vtu_fault(const std::string& text) {
    return testing::fault_in([&] { read_vtu(text); });
}

/// Returns the fault of one cell with `piece` of its text replaced by `other`.
std::string vtu_fault_with(const std::string& piece, const std::string& other) {
    return vtu_fault(testing::exchanged(one_cell(), piece, other));
}

TEST(Vtu, TilesReadBackExactlyWithTheirVertexPairs) {
    std::vector<plane::Tile> tiles = testing::solver_tiles(testing::awkward_lattices());
    for (const plane::Lattice& lattice : testing::awkward_lattices()) {
        tiles.push_back(testing::grid_tile(lattice, 3, 2));
        tiles.push_back(testing::grid_tile(lattice, 1, 1));
    }
    for (const plane::Tile& tile : tiles) {
        const auto files = encode_vtu(vtu_grid(tile), "dir/t.vtu");
        ASSERT_EQ(files.size(), 1U);
        EXPECT_EQ(files[0].path, "dir/t.vtu");
        const TileFile file = decode_vtu(files, std::nullopt);
        EXPECT_FALSE(file.has_edge_pairs);
        testing::expect_read_back(file, tile);
    }
}

TEST(Vtu, CellsThatAreTrianglesStayPolygons) {
    plane::Tile tile = testing::triangle_grid_tile(kSquare, 2, 2);
    tile.kind = plane::MeshKind::kVoronoi;
    tile.vertex_site.clear();
    for (int f = 0; f < tile.n_faces(); ++f) tile.face_site.push_back(f);
    testing::expect_read_back(decode_vtu(encode_vtu(vtu_grid(tile), "t.vtu"), {}), tile);
}

TEST(Vtu, GridsOfOtherProgramsAreRead) {
    const TileFile file = read_vtu(
        "<?xml version='1.0'?>\r\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\">\r\n"
        " <UnstructuredGrid>\r\n  <Piece NumberOfPoints='4' NumberOfCells='2'>\r\n"
        "   <PointData/><CellData Scalars=\"p\">\n<DataArray type=\"Float32\" Name=\"p\" "
        "format=\"binary\">AAAA</DataArray></CellData><Points><DataArray type=\"Float32\" "
        "NumberOfComponents=\"3\"> 0 0 0 1 0 0\n1 1 0 0 1 0<InformationKey>7</InformationKey>\n"
        "</DataArray></Points>\n<Cells><!-- two triangles --><DataArray type=\"Int32\" "
        "Name=\"connectivity\" format=\"ascii\">0 1 2 0 2 3</DataArray><DataArray type=\"Int32\" "
        "Name=\"offsets\">3 6</DataArray><DataArray type=\"UInt8\" Name=\"types\">5 5</DataArray>"
        "</Cells></Piece></UnstructuredGrid></VTKFile>\n",
        kSquare);
    EXPECT_EQ(file.tile.kind, plane::MeshKind::kDelaunay);
    EXPECT_EQ(file.precision, plane::Precision::kSingle);
    EXPECT_THAT(file.tile.faces.corners, ::testing::ElementsAre(0, 1, 2, 0, 2, 3));
    EXPECT_FALSE(file.has_vertex_pairs);
    EXPECT_NO_THROW(prove_tile(file.tile, file.precision));
}

TEST(Vtu, FaultsOfTheXmlNameTheirLine) {
    EXPECT_THAT(vtu_fault(""), StartsWith("t.vtu: is not a VTKFile with an UnstructuredGrid; "));
    EXPECT_THAT(vtu_fault("solid\n"), StartsWith("t.vtu:1: the text does not end; "));
    EXPECT_THAT(vtu_fault_with("<Points>", "<Points"),
                HasSubstr("an attribute of 'Points' is not of"));
    EXPECT_THAT(vtu_fault_with("</Points>\n", ""), HasSubstr(": 'Piece' ends, but is not open; "));
    EXPECT_THAT(vtu_fault_with("</VTKFile>\n", ""), HasSubstr(": 'VTKFile' does not end; "));
    EXPECT_THAT(vtu_fault_with("version=\"0.1\"", "version=0.1"),
                StartsWith("t.vtu:3: an attribute of"));
    EXPECT_THAT(vtu_fault_with("0 0 0\n", "0 0<!-- --> 0\n"),
                HasSubstr(": a comment interrupts a "));
    EXPECT_THAT(vtu_fault_with(" -->", ""), StartsWith("t.vtu:2: a comment does not end; "));
    EXPECT_THAT(vtu_fault(one_cell() + '\0'), HasSubstr("appears to be a binary file; "));
}

TEST(Vtu, FaultsOfTheGridNameTheirLine) {
    EXPECT_THAT(vtu_fault_with("UnstructuredGrid", "PolyData"),
                HasSubstr("is not a VTKFile with an Unst"));
    EXPECT_THAT(vtu_fault_with("NumberOfCells=", "Cells="),
                StartsWith("t.vtu:11: the Piece lacks Num"));
    EXPECT_THAT(vtu_fault_with("NumberOfPoints=\"4\"", "NumberOfPoints=\"-4\""),
                StartsWith("t.vtu:11: a count is negative; "));
    EXPECT_THAT(vtu_fault_with("NumberOfPoints=\"4\"", "NumberOfPoints=\"5\""),
                HasSubstr(": the array Points/Points has not the size or type of its kind; "));
    EXPECT_THAT(vtu_fault_with("1 0\n0 1\n", "1 0\n0 x\n"),
                StartsWith("t.vtu:8: 'x' is not a number; "));
    EXPECT_THAT(vtu_fault_with("1 0\n0 1\n", "1 0\n1 0\n"), StartsWith("t.vtu:6: "));
    EXPECT_THAT(vtu_fault_with("format=\"ascii\"", "format=\"appended\""),
                StartsWith("t.vtu:6: the array FieldData/PeriodicLattice is binary; "));
    EXPECT_THAT(vtu_fault_with("1 0 0\n", "1 0 0.5\n"), HasSubstr(": z is not 0; "));
    EXPECT_THAT(vtu_fault_with("0 1 3 2\n", "0 1 3 7\n"), HasSubstr(": vertex 7 does not exist; "));
    EXPECT_THAT(vtu_fault_with("\n4\n</DataArray>", "\n5\n</DataArray>"),
                HasSubstr("the offsets do not"));
    EXPECT_THAT(vtu_fault_with("\n4\n</DataArray>", "\n3\n</DataArray>"),
                HasSubstr("has entries after its la"));
    EXPECT_THAT(vtu_fault_with("\n7\n</DataArray>", "\n9\n</DataArray>"),
                HasSubstr("not all polygons (7)"));
    EXPECT_THAT(vtu_fault_with("\n7\n</DataArray>", "\n5\n</DataArray>"),
                HasSubstr("a triangle here has 3"));
    EXPECT_THAT(vtu_fault_with("Name=\"offsets\"", "Name=\"ends\""),
                HasSubstr("lacks the array Cells/o"));
    EXPECT_THAT(vtu_fault_with("PeriodicOffset", "Offset"),
                HasSubstr("lacks the array PointData/Period"));
    EXPECT_THAT(vtu_fault_with("0\n0\n0\n0\n", "0\n9\n0\n0\n"),
                HasSubstr(": point 9 does not exist; "));
    EXPECT_THAT(vtu_fault_with("0 0\n1 0\n0 1\n1 1\n", "1 0\n1 0\n0 1\n1 1\n"),
                HasSubstr(": a point has an offset to itself; "));
}

/// Two orbits of the four sites of a grid.
std::string with_orbits(const plane::Tile& tile) {
    return encode_vtu(vtu_grid(tile, nullptr, std::array{0, 1, 1, 0}), "t.vtu")[0].bytes;
}

TEST(Vtu, OrbitsReadBackFromCellsAndTriangles) {
    for (const plane::Tile& tile :
         {testing::grid_tile(kSquare, 2, 2), testing::grain_grid_tile(kSquare, 2, 2)}) {
        EXPECT_EQ(read_vtu(with_orbits(tile)).site_orbits, (std::vector{0, 1, 1, 0}));
    }
    const plane::Tile triangles = testing::triangle_grid_tile(kSquare, 2, 2);
    const std::vector<int> found = read_vtu(with_orbits(triangles)).site_orbits;
    ASSERT_FALSE(found.empty());
    for (std::size_t s = 0; s < found.size(); ++s) {
        EXPECT_THAT(found[s], ::testing::AnyOf(-1, s == 0 || s == 3 ? 0 : 1));
    }
    EXPECT_TRUE(read_vtu(one_cell()).site_orbits.empty());
}

std::string with_phases(const plane::Tile& tile) {
    const CellMaterials materials{.phase_names = {"soft", "2nd"}, .site_phase = {0, 1, 1, 0}};
    return encode_vtu(vtu_grid(tile, &materials), "t.vtu")[0].bytes;
}

TEST(Vtu, PhasesReadBackFromCellsAndGrains) {
    for (const plane::Tile& tile :
         {testing::grid_tile(kSquare, 2, 2), testing::grain_grid_tile(kSquare, 2, 2)}) {
        const CellMaterials found = read_vtu(with_phases(tile)).materials;
        EXPECT_THAT(found.phase_names, ::testing::ElementsAre("soft", "2nd"));
        EXPECT_THAT(found.site_phase, ::testing::ElementsAre(0, 1, 1, 0));
    }
    EXPECT_TRUE(read_vtu(one_cell()).materials.empty());
}

TEST(Vtu, PhasesThatAreNoneAreRefused) {
    const std::string cells = with_phases(testing::grid_tile(kSquare, 2, 2));
    const auto fault = [&](const std::string& piece, const std::string& other) {
        return vtu_fault(testing::exchanged(cells, piece, other));
    };
    const std::string phases = "SitePhases\" NumberOfTuples=\"4\" format=\"ascii\">\n0\n1\n1\n0\n";
    EXPECT_THAT(fault(phases, testing::exchanged(phases, "\n0\n1", "\n0\n2")),
                HasSubstr("without a name"));
    EXPECT_THAT(fault(phases, testing::exchanged(phases, "1\n0\n", "1\n")), HasSubstr("phases"));
    EXPECT_THAT(fault("115 111 102 116 0", "33 111 102 116 0"),
                HasSubstr("is not the name of a phase"));
    EXPECT_THAT(fault("50 110 100 0", "50 110 100"), HasSubstr("does not end with 0"));
    EXPECT_THAT(fault("50 110 100 0", "50 110 10 0"), HasSubstr("a character that is none"));
    EXPECT_THAT(fault("PhaseNames", "Names"), HasSubstr("lacks the array FieldData/PhaseNames"));
}

TEST(Vtu, OrbitsThatAreNoneAreRefused) {
    const std::string cells = with_orbits(testing::grid_tile(kSquare, 2, 2));
    const std::string orbits = "\n0\n1\n1\n0\n</DataArray>\n</CellData>";
    const auto fault = [&](const std::string& other) {
        return vtu_fault(
            testing::exchanged(cells, orbits, "\n" + other + "\n</DataArray>\n</CellData>"));
    };
    EXPECT_THAT(fault("0\n1\n1"), HasSubstr("CellData/Orbit has not the size"));
    EXPECT_THAT(fault("0\n1\n1\n0\n0"), HasSubstr("CellData/Orbit has not the size"));
    EXPECT_THAT(fault("0\n1\n1.5\n0"), HasSubstr("1.5"));
    EXPECT_THAT(fault("0\n1\n1\n-1"), HasSubstr("cell 3 has not one orbit"));
    EXPECT_THAT(fault("0\n2\n1\n0"), HasSubstr("not counted in the order"));
    EXPECT_THAT(
        vtu_fault(testing::exchanged(cells, R"(Int32" Name="Orbit")", R"(Float64" Name="Orbit")")),
        HasSubstr("CellData/Orbit has not the size or type"));
    // Two triangles of one grain.
    std::string grains = with_orbits(testing::grain_grid_tile(kSquare, 2, 2));
    const std::size_t last = grains.rfind("0\n</DataArray>\n</CellData>");
    ASSERT_NE(last, std::string::npos);
    grains[last] = '1';
    EXPECT_THAT(vtu_fault(grains), HasSubstr("cell 3 has not one orbit"));
}

TEST(Vtu, AWrongPairIsRefuted) {
    std::string text = one_cell();
    const std::string offsets = "0 0\n1 0\n0 1\n1 1\n";
    text.replace(text.find(offsets), offsets.size(), "0 0\n1 0\n0 1\n1 0\n");
    const TileFile file = read_vtu(text);
    EXPECT_THROW(compare_vertex_pairs(file.tile, prove_tile(file.tile, file.precision)), NotATile);
}

TEST(Vtu, NonFiniteCoordinatesAreInternalErrors) {
    plane::Tile tile = testing::grid_tile(kSquare, 1, 1);
    tile.points[0].x() = std::nan("");
    EXPECT_THROW(encode_vtu(vtu_grid(tile), "t.vtu"), InternalError);
}

TEST(Vtu, DamagedFilesGiveATileOrAFaultAndNothingElse) {
    std::mt19937_64 random(3);
    std::vector<plane::Tile> tiles = testing::solver_tiles({kSquare});
    tiles.push_back(testing::grid_tile(kSquare, 2, 2));
    for (const plane::Tile& tile : tiles) {
        const std::string bytes = encode_vtu(vtu_grid(tile), "t.vtu")[0].bytes;
        int n_refused = 0;
        for (int k = 0; k < 300; ++k) {
            const std::string fault = vtu_fault(testing::mutated(bytes, random));
            if (fault.empty()) continue;
            ++n_refused;
            EXPECT_THAT(fault, StartsWith("t.vtu"));
            EXPECT_THAT(fault, HasSubstr("; "));
        }
        EXPECT_GT(n_refused, 150);
    }
}

}  // namespace
}  // namespace pcvt
