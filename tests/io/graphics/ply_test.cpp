#include <gmock/gmock.h>

#include <cmath>

#include "io/graphics/ply_reader.hpp"
#include "io/graphics/ply_writer.hpp"
#include "tests/support/damaged_text.hpp"
#include "tests/support/example_lattices.hpp"
#include "tests/support/grid_tile.hpp"
#include "tests/support/mutation.hpp"
#include "tests/support/tile_equality.hpp"

namespace pcvt {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::kSquare;
using ::testing::StartsWith;

/// One square, as a small strict program might write it.
constexpr const char* kOnePlyCell =
    "ply\n"
    "format ascii 1.0\n"
    "comment pcvt kind cells\n"
    "comment pcvt lattice 1 0 0 1\n"
    "element vertex 4\n"
    "property double x\n"
    "property double y\n"
    "property int orbit\n"
    "property int offset_i\n"
    "property int offset_j\n"
    "element face 1\n"
    "property list uchar int vertex_indices\n"
    "property int site\n"
    "end_header\n"
    "0 0 0 0 0\n"
    "1 0 0 1 0\n"
    "1 1 0 1 1\n"
    "0 1 0 0 1\n"
    "4 0 1 2 3 0\n";

TileFile read_ply(const std::string& text, const std::optional<plane::Lattice>& lattice = {}) {
    return decode_ply({{"t.ply", text}}, lattice);
}

std::string ply_fault(const std::string& text) {
    return testing::fault_in([&] { read_ply(text); });
}

/// Returns the fault of kOnePlyCell with `piece` of its text replaced by `other`.
std::string fault_with(const std::string& piece, const std::string& other) {
    return ply_fault(testing::exchanged(kOnePlyCell, piece, other));
}

TEST(Ply, TilesReadBackExactlyWithTheirVertexPairs) {
    for (const plane::Lattice& lattice : testing::awkward_lattices()) {
        for (plane::Tile tile :
             {testing::grid_tile(lattice, 3, 2), testing::grid_tile(lattice, 1, 1),
              testing::triangle_grid_tile(lattice, 2, 5),
              testing::grain_grid_tile(lattice, 2, 5)}) {
            const auto files = encode_ply(tile, {}, "dir/t.ply");
            ASSERT_EQ(files.size(), 1U);
            EXPECT_EQ(files[0].path, "dir/t.ply");
            const TileFile file = decode_ply(files, std::nullopt);
            EXPECT_TRUE(file.has_vertex_pairs);
            EXPECT_FALSE(file.has_edge_pairs);
            EXPECT_EQ(file.precision, plane::Precision::kDouble);
            tile.edge_pairs.clear();
            testing::expect_same_tile(file.tile, tile);
        }
    }
}

TEST(Ply, SinglePrecisionHoldsPiecesOfOneCell) {
    // The square cell of a single site, cut along a diagonal.
    plane::Tile tile{.lattice = plane::Lattice({1, 0}, {0, 1}), .kind = plane::MeshKind::kVoronoi};
    tile.points = {plane::Vec2(0, 0), plane::Vec2(1, 0), plane::Vec2(1, 1), plane::Vec2(0, 1)};
    tile.face_site = {0, 0};
    tile.faces.add(std::array{0, 1, 2});
    tile.faces.add(std::array{0, 2, 3});
    const auto files = encode_ply(tile, {.single_precision = true}, "t.ply");
    const plane::Tile read = decode_ply(files, std::nullopt).tile;
    ASSERT_EQ(read.n_faces(), 2);
    EXPECT_THAT(read.faces[0], ::testing::ElementsAre(0, 1, 2));
    // A fan from vertex 0 would continue that of the first piece.
    EXPECT_THAT(read.faces[1], ::testing::ElementsAre(2, 3, 0));
    EXPECT_EQ(read.face_site, tile.face_site);
}

TEST(Ply, SinglePrecisionHoldsFloatsAndTriangles) {
    for (const plane::Lattice& lattice : testing::awkward_lattices()) {
        for (const plane::Tile& tile :
             {testing::grid_tile(lattice, 3, 2), testing::grid_tile(lattice, 1, 1),
              testing::triangle_grid_tile(lattice, 2, 5),
              testing::grain_grid_tile(lattice, 2, 5)}) {
            const auto files = encode_ply(tile, {.single_precision = true}, "t.ply");
            EXPECT_THAT(files[0].bytes, HasSubstr("property float x\n"));
            EXPECT_THAT(files[0].bytes, ::testing::Not(HasSubstr("double")));
            const TileFile file = decode_ply(files, std::nullopt);
            EXPECT_EQ(file.precision, plane::Precision::kSingle);
            EXPECT_EQ(file.tile.kind, tile.kind);
            for (int f = 0; f < file.tile.n_faces(); ++f) EXPECT_EQ(file.tile.face_size(f), 3);
            for (int v = 0; v < tile.n_vertices(); ++v) {
                EXPECT_EQ(file.tile.points[v].cast<float>(), tile.points[v].cast<float>());
            }
            const plane::TileProof proof = prove_tile(file.tile, file.precision);
            EXPECT_NO_THROW(compare_vertex_pairs(file.tile, proof));
            EXPECT_NEAR(proof.area, tile.lattice.area(), 1e-5 * tile.lattice.area());
        }
    }
}

TEST(Ply, TrianglesOfACellKeepItsSiteAndColour) {
    const plane::Tile tile = testing::grid_tile(kSquare, 3, 1);
    const auto files = encode_ply(tile, {.single_precision = true}, "t.ply");
    const plane::Tile back = decode_ply(files, std::nullopt).tile;
    EXPECT_THAT(back.face_site, ElementsAre(0, 0, 1, 1, 2, 2));
    EXPECT_EQ(back.n_vertices(), tile.n_vertices());
}

TEST(Ply, RefusesTilesThatFloat32CannotHold) {
    const plane::Tile tile = testing::grid_tile(plane::Lattice::rectangle(1e60, 1e60), 2, 2);
    EXPECT_THROW(encode_ply(tile, {.single_precision = true}, "t.ply"), InvalidInput);
}

TEST(Ply, ListsBecomeWiderOnlyForFacesThatNeedIt) {
    plane::Tile tile = testing::grid_tile(kSquare, 1, 1);
    EXPECT_THAT(encode_ply(tile, {}, "")[0].bytes,
                HasSubstr("property list uchar int vertex_indices"));
    tile.points.clear();
    tile.faces.corners.clear();
    tile.vertex_pairs.clear();
    for (int v = 0; v < 256; ++v) {
        tile.points.emplace_back(std::cos(v * M_PI / 128), std::sin(v * M_PI / 128));
        tile.faces.corners.push_back(v);
    }
    tile.faces.begin = {0, 256};
    const auto files = encode_ply(tile, {}, "");
    EXPECT_THAT(files[0].bytes, HasSubstr("property list int int vertex_indices"));
    EXPECT_EQ(decode_ply(files, std::nullopt).tile.faces.corners, tile.faces.corners);
}

TEST(Ply, PlainPlyOfOtherProgramsIsRead) {
    const TileFile file = read_ply(
        "ply\r\nformat ascii 1.0\r\nobj_info by hand\r\ncomment pcvt\r\n"
        "element camera 1\r\nproperty list uint8 float32 view\r\n"
        "element vertex 3\r\nproperty uchar red\r\nproperty float32 y\r\nproperty float x\r\n"
        "property float z\r\nelement face 1\r\nproperty float quality\r\n"
        "property list uint8 uint32 vertex_index\r\nend_header\r\n"
        "2 0.5 1e3\r\n255 0 0 -0\r\n\r\n0 0 1 0\r\n0 2 0 0\r\n0.5 3 0 1 2",
        plane::Lattice({2, 0}, {0, 3}));
    EXPECT_EQ(file.tile.kind, plane::MeshKind::kDelaunay);
    EXPECT_EQ(file.tile.points[2], plane::Vec2(0, 2));
    EXPECT_THAT(file.tile.faces.corners, ElementsAre(0, 1, 2));
    EXPECT_EQ(file.precision, plane::Precision::kSingle);
    EXPECT_FALSE(file.has_vertex_pairs || file.has_edge_pairs);
}

TEST(Ply, TheUndamagedExampleIsRead) {
    const TileFile file = read_ply(kOnePlyCell);
    EXPECT_THAT(file.tile.face_site, ElementsAre(0));
    EXPECT_EQ(file.tile.vertex_pairs.size(), 3U);
}

TEST(Ply, FaultsOfTheHeaderNameTheirLine) {
    EXPECT_THAT(ply_fault(""), StartsWith("t.ply: does not begin with the line \"ply\"; "));
    EXPECT_THAT(ply_fault("ply\nformat ascii 1.0\n"),
                StartsWith("t.ply: the header does not end; "));
    EXPECT_THAT(ply_fault("ply\nend_header\n"), StartsWith("t.ply:2: the format is missing; "));
    EXPECT_THAT(fault_with("ascii", "binary_little_endian"),
                StartsWith("t.ply:2: this PLY is binary; export it as ASCII"));
    EXPECT_THAT(fault_with("ascii 1.0", "ascii 2.0"), StartsWith("t.ply:2: the format is not kn"));
    EXPECT_THAT(fault_with("kind cells", "kind x"), StartsWith("t.ply:3: the kind is unclear; "));
    EXPECT_THAT(fault_with("kind cells", "x cells"), StartsWith("t.ply:3: pcvt does not know 'x'"));
    EXPECT_THAT(fault_with("1 0 0 1", "1 0 1 0"), StartsWith("t.ply:4: "));
    EXPECT_THAT(fault_with("1 0 0 1", "1 0 0"), StartsWith("t.ply:4: the lattice is unclear; "));
    EXPECT_THAT(fault_with("vertex 4", "vertex"), StartsWith("t.ply:5: an element has a name"));
    EXPECT_THAT(fault_with("vertex 4", "vertex -4"), StartsWith("t.ply:5: a count is negative"));
    EXPECT_THAT(fault_with("element face", "element vertex"),
                StartsWith("t.ply:11: element 'vert"));
    EXPECT_THAT(fault_with("double y", "double x"),
                StartsWith("t.ply:7: property 'x' is declared"));
    EXPECT_THAT(fault_with("double y", "quad y"), StartsWith("t.ply:7: the type 'quad' is not"));
    EXPECT_THAT(fault_with("property double y", "property y"),
                StartsWith("t.ply:7: a property has"));
    EXPECT_THAT(fault_with("element vertex 4\n", ""), StartsWith("t.ply:5: a property precedes"));
    EXPECT_THAT(fault_with("end_header", "end_headers"),
                StartsWith("t.ply:14: 'end_headers' is not a header"));
}

TEST(Ply, MissingOrMistypedPropertiesAreRefused) {
    EXPECT_THAT(fault_with("double x", "double X"), HasSubstr("'vertex' lacks a proper 'x'; "));
    EXPECT_THAT(fault_with("int orbit", "double orbit"), HasSubstr("lacks a proper 'orbit'; "));
    EXPECT_THAT(fault_with("offset_j", "offset_k"), HasSubstr("lacks a proper 'offset_j'; "));
    EXPECT_THAT(fault_with("uchar int vertex", "uchar float vertex"),
                HasSubstr("'vertex_indices'"));
    EXPECT_THAT(fault_with("vertex_indices", "corners"), HasSubstr("lacks a proper 'vertex_indic"));
    EXPECT_THAT(fault_with("int site", "list uchar int site"), HasSubstr("lacks a proper 'site'"));
    EXPECT_THAT(fault_with("comment pcvt lattice 1 0 0 1", "comment"), HasSubstr("pass --lattice"));
}

TEST(Ply, FaultsOfTheBodyNameTheirLine) {
    EXPECT_THAT(fault_with("1 1 0 1 1", "1 1 0 1"),
                StartsWith("t.ply:17: the line is too short; "));
    EXPECT_THAT(fault_with("1 1 0 1 1", "1 1 0 1 1 1"),
                StartsWith("t.ply:17: the line is too lon"));
    EXPECT_THAT(fault_with("1 1 0 1 1", "1 1,5 0 1 1"), StartsWith("t.ply:17: '1,5' is not a num"));
    EXPECT_THAT(fault_with("1 1 0 1 1", "1 1 0.5 1 1"),
                StartsWith("t.ply:17: '0.5' is not a whole"));
    EXPECT_THAT(fault_with("1 1 0 1 1", "1 1 4 1 1"),
                StartsWith("t.ply:17: orbit 4 is not a vertex"));
    EXPECT_THAT(fault_with("1 1 0 1 1", "1 1 2 1 1"),
                StartsWith("t.ply:17: a vertex has an offset"));
    EXPECT_THAT(fault_with("4 0 1 2 3 0", "4 0 1 2 4 0"),
                StartsWith("t.ply:19: vertex 4 does not"));
    EXPECT_THAT(fault_with("4 0 1 2 3 0", "4 0 1 2 2 0"),
                StartsWith("t.ply:19: vertex 2 is a cor"));
    EXPECT_THAT(fault_with("4 0 1 2 3 0", "2 0 1 0"), StartsWith("t.ply:19: a face needs 3 corn"));
    EXPECT_THAT(fault_with("4 0 1 2 3 0", "-1 0"), StartsWith("t.ply:19: -1 is beyond"));
    EXPECT_THAT(fault_with("4 0 1 2 3 0", "256 0"), StartsWith("t.ply:19: 256 is beyond its decl"));
    EXPECT_THAT(fault_with("4 0 1 2 3 0", "255 0"), StartsWith("t.ply:19: the line is too short"));
    EXPECT_THAT(fault_with("4 0 1 2 3 0\n", ""),
                StartsWith("t.ply:18: the file ends before its last 'face'; "));
    EXPECT_THAT(ply_fault(std::string(kOnePlyCell) + "1\n"),
                StartsWith("t.ply:20: the file has data"));
    EXPECT_THAT(ply_fault(kOnePlyCell + std::string(1, '\0')),
                HasSubstr("appears to be a binary file; "));
}

TEST(Ply, AThirdDimensionIsRefused) {
    EXPECT_THAT(ply_fault("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                          "property float y\nproperty float z\nend_header\n0 0 1e-9\n"),
                StartsWith("t.ply:8: z is not 0; "));
}

TEST(Ply, NonFiniteCoordinatesAreInternalErrors) {
    plane::Tile tile = testing::grid_tile(kSquare, 1, 1);
    tile.points[0].x() = std::nan("");
    EXPECT_THROW(encode_ply(tile, {}, "t.ply"), InternalError);
}

TEST(Ply, DamagedFilesGiveATileOrAFaultAndNothingElse) {
    std::mt19937_64 random(3);
    const std::string bytes = encode_ply(testing::grid_tile(kSquare, 2, 2), {}, "t.ply")[0].bytes;
    int n_refused = 0;
    for (int k = 0; k < 4000; ++k) {
        const std::string fault = ply_fault(testing::mutated(bytes, random));
        if (fault.empty()) continue;
        ++n_refused;
        EXPECT_THAT(fault, StartsWith("t.ply"));
        EXPECT_THAT(fault, HasSubstr("; "));
    }
    EXPECT_GT(n_refused, 1000);
}

}  // namespace
}  // namespace pcvt
