#include <gmock/gmock.h>

#include <sstream>

#include "io/colours/palette.hpp"
#include "io/graphics/obj_reader.hpp"
#include "io/graphics/obj_writer.hpp"
#include "tests/support/example_lattices.hpp"
#include "tests/support/grid_tile.hpp"
#include "tests/support/mutation.hpp"
#include "tests/support/tile_equality.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;
using testing::kSquare;
using ::testing::StartsWith;

/// One square whose opposite sides are glued, as pcvt writes it.
constexpr const char* kOneObjCell =
    "# pcvt kind cells\n"
    "# pcvt lattice 1 0 0 1\n"
    "# pcvt vertex_pair 1 2 1 0\n"
    "# pcvt vertex_pair 1 3 1 1\n"
    "# pcvt vertex_pair 1 4 0 1\n"
    "# pcvt edge_pair 1 2 4 3 0 1\n"
    "# pcvt edge_pair 4 1 3 2 1 0\n"
    "# pcvt sites 0\n"
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
    "f 1 2 3 4\n";

TileFile read_obj(const std::string& text, const std::optional<plane::Lattice>& lattice = {}) {
    return decode_obj({{"t.obj", text}}, lattice);
}

std::string obj_fault(const std::vector<EncodedFile>& files) {
    try {
        decode_obj(files, std::nullopt);
    } catch (const BadFile& fault) {
        return fault.what();
    }
    return "";
}

std::string obj_fault(const std::string& text) {
    return obj_fault(std::vector<EncodedFile>{{"t.obj", text}});
}

/// Returns kOneObjCell with `piece` of its text replaced by `other`.
std::string with(const std::string& piece, const std::string& other) {
    std::string text = kOneObjCell;
    return text.replace(text.find(piece), piece.size(), other);
}

/// A row of cells with 5, 3 and 4 corners: not a tile, but a writer must sort its faces.
plane::Tile cells_to_be_sorted() {
    return {.lattice = kSquare,
            .kind = plane::MeshKind::kVoronoi,
            .points = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {2, 1}, {1, 1}, {0.5, 1.5}, {0, 1}},
            .faces = {.begin = {0, 5, 8, 12}, .corners = {0, 1, 6, 7, 8, 1, 2, 6, 2, 3, 4, 5}},
            .face_site = {7, 8, 9}};
}

TEST(Obj, TilesReadBackExactlyWithTheirSeam) {
    for (const plane::Lattice& lattice : testing::awkward_lattices()) {
        for (const plane::Tile& tile :
             {testing::grid_tile(lattice, 3, 2), testing::grid_tile(lattice, 1, 1),
              testing::triangle_grid_tile(lattice, 2, 5),
              testing::grain_grid_tile(lattice, 2, 5)}) {
            const auto files = encode_obj(tile, {}, "dir/t.obj");
            const TileFile file = decode_obj(files, std::nullopt);
            testing::expect_same_tile(file.tile, tile);
            EXPECT_TRUE(file.has_vertex_pairs && file.has_edge_pairs);
            EXPECT_EQ(file.precision, plane::Precision::kDouble);
            testing::expect_same_tile(decode_obj({files[0]}, std::nullopt).tile, tile);
        }
    }
}

TEST(Obj, CompanionsLieBesideTheFile) {
    const auto files = encode_obj(testing::grid_tile(kSquare, 1, 1), {}, "a.b/tile.v2.obj");
    ASSERT_EQ(files.size(), 3U);
    EXPECT_EQ(files[0].path, "a.b/tile.v2.obj");
    EXPECT_EQ(files[1].path, "a.b/tile.v2.mtl");
    EXPECT_EQ(files[2].path, "a.b/tile.v2.seam.json");
    EXPECT_THAT(files[0].bytes, HasSubstr("\nmtllib tile.v2.mtl\n"));
    EXPECT_EQ(obj_paths("x.OBJ"), (std::vector<std::string>{"x.OBJ", "x.mtl", "x.seam.json"}));
}

TEST(Obj, FacesAreGroupedByTheirNumberOfSides) {
    const auto files = encode_obj(cells_to_be_sorted(), {}, "t.obj");
    EXPECT_THAT(files[0].bytes, HasSubstr("usemtl sides_3\nf 2/2 3/3 7/7\n"
                                          "usemtl sides_4\nf 3/3 4/4 5/5 6/6\n"
                                          "usemtl sides_5\nf 1/1 2/2 7/7 8/8 9/9\n"));
    EXPECT_THAT(files[0].bytes, HasSubstr("# pcvt sites 8 9 7\n"));
    EXPECT_THAT(files[1].bytes, HasSubstr("newmtl sides_3\nKd "));
    EXPECT_THAT(files[1].bytes, HasSubstr("newmtl sides_5\nKd "));
    const TileFile file = decode_obj(files, std::nullopt);
    EXPECT_THAT(file.tile.face_site, ::testing::ElementsAre(8, 9, 7));
}

/// Returns the numbers of each line of `text` that begins with `word`.
std::vector<plane::Vec2> lines_of(const std::string& text, const std::string& word) {
    std::vector<plane::Vec2> numbers;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string first;
        plane::Vec2 pair;
        if (words >> first >> pair.x() >> pair.y() && first == word) numbers.push_back(pair);
    }
    return numbers;
}

TEST(Obj, TextureCoordinatesOfPartnersDifferByTheOffset) {
    for (const plane::Lattice& lattice : testing::awkward_lattices()) {
        for (const plane::Tile& tile :
             {testing::grid_tile(lattice, 7, 5), testing::triangle_grid_tile(lattice, 3, 5)}) {
            const std::string text = encode_obj(tile, {}, "t.obj")[0].bytes;
            const std::vector<plane::Vec2> uv = lines_of(text, "vt");
            ASSERT_EQ(uv.size(), tile.points.size());
            for (const plane::VertexPair& pair : tile.vertex_pairs) {
                EXPECT_EQ(uv[pair.w] - uv[pair.v], plane::Vec2(pair.offset.i, pair.offset.j));
            }
            for (int v = 0; v < tile.n_vertices(); ++v) {
                EXPECT_LT((uv[v] - lattice.to_lattice(tile.points[v])).norm(), 1e-6);
            }
        }
    }
}

TEST(Obj, CommentsCountFromOne) {
    const auto files = encode_obj(testing::grid_tile(kSquare, 1, 1), {}, "t.obj");
    EXPECT_THAT(files[0].bytes, HasSubstr("# pcvt vertex_pair 1 4 1 1\n"));
    EXPECT_THAT(files[0].bytes, HasSubstr("# pcvt edge_pair 1 2 3 4 0 1\n"));
    EXPECT_THAT(files[2].bytes, HasSubstr("[0, 3, 1, 1]"));
}

TEST(Obj, PlainObjOfOtherProgramsIsRead) {
    const TileFile file = read_obj(
        "\xEF\xBB\xBF# other\r\nmtllib a b.mtl\r\no tile\r\nvn 0 0 1\r\nvt 0 0\r\n"
        "v 0 0 -0.0 1 0.5 0\r\nv\t1 0 0\r\nv 1 1 0 # corner\r\nv 0 1 0\r\ng x\r\ns off\r\n"
        "usemtl m\r\nf 1 2/1 3//1\r\nf -4/1/1 -2 4",
        plane::Lattice({2, 0}, {0, 3}));
    EXPECT_EQ(file.tile.kind, plane::MeshKind::kDelaunay);
    EXPECT_THAT(file.tile.faces.corners, ::testing::ElementsAre(0, 1, 2, 0, 2, 3));
    EXPECT_EQ(file.tile.lattice.b(), plane::Vec2(0, 3));
    EXPECT_FALSE(file.has_vertex_pairs || file.has_edge_pairs);
    EXPECT_TRUE(file.tile.vertex_site.empty());
}

TEST(Obj, TheLatticeOfTheFileOverridesTheGivenOne) {
    EXPECT_EQ(read_obj(kOneObjCell, plane::Lattice({2, 0}, {0, 3})).tile.lattice.a(),
              plane::Vec2(1, 0));
    EXPECT_THAT(obj_fault(with("# pcvt lattice 1 0 0 1\n", "")),
                StartsWith("t.obj: the file names no lattice; pass --lattice AX,AY,BX,BY"));
}

TEST(Obj, FaultsOfVerticesNameTheirLine) {
    EXPECT_THAT(obj_fault(with("v 0 0 0", "v 0 0")), StartsWith("t.obj:9: a vertex has 3 numbers"));
    EXPECT_THAT(obj_fault(with("v 0 0 0", "v 0 0 0 1")), StartsWith("t.obj:9: a vertex has 3"));
    EXPECT_THAT(obj_fault(with("v 0 0 0", "v 0 0 1e-9")), StartsWith("t.obj:9: z is not 0; "));
    EXPECT_THAT(obj_fault(with("v 0 0 0", "v nan 0 0")), StartsWith("t.obj:9: 'nan' is not a fin"));
    EXPECT_THAT(obj_fault(with("v 0 0 0", "w 0 0 0")),
                StartsWith("t.obj:9: 'w' is not a supported statement"));
}

TEST(Obj, FaultsOfFacesNameTheirLine) {
    const auto fault = [](const char* face) { return obj_fault(with("f 1 2 3 4", face)); };
    EXPECT_THAT(fault("f 1 2"), StartsWith("t.obj:13: a face needs 3 corners; "));
    EXPECT_THAT(fault("f"), StartsWith("t.obj:13: a face needs 3 corners; "));
    EXPECT_THAT(fault("f 1 2 3 5"), StartsWith("t.obj:13: vertex 5 does not exist; "));
    EXPECT_THAT(fault("f 1 2 3 0"), StartsWith("t.obj:13: vertex 0 does not exist; "));
    EXPECT_THAT(fault("f 1 2 3 -5"), HasSubstr(" does not exist; "));
    EXPECT_THAT(fault("f 1 2 3 -2147483648"), HasSubstr(" does not exist; "));
    EXPECT_THAT(fault("f 1 2 3 1"), StartsWith("t.obj:13: vertex 1 is a corner twice; "));
    EXPECT_THAT(fault("f 1 2 3.0"), StartsWith("t.obj:13: '3.0' is not a whole number; "));
    EXPECT_THAT(fault("f 1 2 3/"), "");
    EXPECT_THAT(fault("f 1 2 3//"), StartsWith("t.obj:13: '' is not a number; "));
    EXPECT_THAT(fault("f 1 2 3/1/1/1"), StartsWith("t.obj:13: '3/1/1/1' is not a corner; "));
    EXPECT_THAT(fault(""), StartsWith("t.obj: there is no face; "));
    EXPECT_THAT(obj_fault(""), StartsWith("t.obj: there is no vertex; "));
    EXPECT_THAT(obj_fault(with("kind cells", "kind triangles")),
                StartsWith("t.obj:13: a face of a triangle tile has 3 corners; "));
}

TEST(Obj, FaultsOfTheSeamNameTheirLine) {
    const auto fault = [](const char* old, const char* other) {
        return obj_fault(with(old, other));
    };
    EXPECT_THAT(fault("kind cells", "kind cell"), StartsWith("t.obj:1: the kind is unclear; "));
    EXPECT_THAT(fault("kind cells", "kind"), StartsWith("t.obj:1: the kind is unclear; "));
    EXPECT_THAT(fault("lattice 1 0 0 1", "lattice 1 0 0"),
                StartsWith("t.obj:2: the lattice is unclear; "));
    EXPECT_THAT(fault("lattice 1 0 0 1", "lattice 1 0 2 0"), StartsWith("t.obj:2: "));
    EXPECT_THAT(fault("lattice 1 0 0 1", "lattice 1 0 0 inf"), StartsWith("t.obj:2: 'inf'"));
    EXPECT_THAT(fault("# pcvt kind cells", "# pcvt lattice 1 0 0 1"),
                StartsWith("t.obj:2: a second line states the lattice; "));
    EXPECT_THAT(fault("pair 1 2 1 0", "pair 1 2 1"),
                StartsWith("t.obj:3: vertex_pair has 4 numbers here, not 3; "));
    EXPECT_THAT(fault("pair 1 2 1 0", "pair 0 2 1 0"),
                StartsWith("t.obj:3: index 0 does not exist; "));
    EXPECT_THAT(fault("pair 1 2 1 0", "pair 1 5 1 0"), HasSubstr("a pair names vertex 5, which"));
    EXPECT_THAT(fault("1 2 4 3 0 1", "1 2 4 9 0 1"), HasSubstr("a pair names vertex 9, which"));
    EXPECT_THAT(fault("pair 1 2 1 0", "pair 1 2 1 268435457"), HasSubstr("the offset 268435457; "));
    EXPECT_THAT(fault("sites 0", "sites 0 1"),
                StartsWith("t.obj: there are 2 sites for 1 faces; "));
    EXPECT_THAT(fault("# pcvt sites 0", "# pcvt"), StartsWith("t.obj:8: a word is missing"));
    EXPECT_THAT(fault("# pcvt sites 0", "# pcvt x"), StartsWith("t.obj:8: pcvt does not know 'x'"));
}

TEST(Obj, BinaryFilesAreRefused) {
    EXPECT_THAT(obj_fault(std::string("v 0\0", 4)),
                StartsWith("t.obj:1: holds a NUL byte, so it appears to be a binary file; "));
}

TEST(Obj, TheSidecarMustAgreeWithTheComments) {
    auto files = encode_obj(testing::grid_tile(kSquare, 2, 2), {}, "t.obj");
    const std::string sidecar = files[2].bytes;
    const auto fault_with = [&](const std::string& piece, const std::string& other) {
        files[2].bytes = sidecar;
        EXPECT_THAT(sidecar, HasSubstr(piece));
        files[2].bytes.replace(sidecar.find(piece), piece.size(), other);
        return obj_fault(files);
    };
    EXPECT_THAT(fault_with("[0, 2, 1, 0]", "[0, 2, 1, 1]"),
                StartsWith("t.seam.json: its vertex pairs differ from those in the comments of"));
    EXPECT_THAT(fault_with("[0, 1, 6, 7, 0, 1]", "[0, 1, 6, 7, 1, 1]"), HasSubstr("edge pairs"));
    EXPECT_THAT(fault_with("[[1, 0], [0, 1]]", "[[1, 0], [0, 2]]"), HasSubstr("lattice differ"));
    EXPECT_THAT(fault_with("\"cells\"", "\"triangles\""), HasSubstr("its kind and lattice differ"));
    EXPECT_THAT(fault_with("    0, 1, 2, 3", "0, 1, 2, 2"), HasSubstr("its sites differ"));
}

TEST(Obj, TheSidecarGivesTheSeamWhereTheCommentsAreLost) {
    const plane::Tile tile = testing::grid_tile(kSquare, 2, 3);
    auto files = encode_obj(tile, {}, "t.obj");
    std::string bare;
    for (std::size_t at = files[0].bytes.find("\nv "); at < files[0].bytes.size(); ++at) {
        bare += files[0].bytes[at];
    }
    files[0].bytes = bare;
    testing::expect_same_tile(decode_obj(files, std::nullopt).tile, tile);
}

TEST(Obj, FaultsOfTheSidecarNameIt) {
    auto files = encode_obj(testing::grid_tile(kSquare, 1, 1), {}, "t.obj");
    const std::string sidecar = files[2].bytes;
    const auto fault_with = [&](const std::string& piece, const std::string& other) {
        files[2].bytes = sidecar;
        EXPECT_THAT(sidecar, HasSubstr(piece));
        files[2].bytes.replace(sidecar.find(piece), piece.size(), other);
        return obj_fault(files);
    };
    EXPECT_THAT(fault_with("\"version\"", "version"),
                StartsWith("t.seam.json:3: is not valid JSON"));
    EXPECT_THAT(fault_with("\"version\": 1", "\"version\": 2"), HasSubstr("its version is not 1"));
    EXPECT_THAT(fault_with("pcvt seam", "seam"), HasSubstr("it is not a pcvt seam file"));
    EXPECT_THAT(fault_with("\"index_base\": 0", "\"index_base\": 1"), HasSubstr("index base"));
    EXPECT_THAT(fault_with("\"cells\"", "7"), HasSubstr("none of cells, triangles and grains"));
    EXPECT_THAT(fault_with("\"sites\"", "\"site\""), HasSubstr("\"sites\" is missing"));
    EXPECT_THAT(fault_with("[[1, 0], [0, 1]]", "[[1, 0]]"), HasSubstr("\"lattice\" is not"));
    EXPECT_THAT(fault_with("[[1, 0], [0, 1]]", "[[1, 0], [2, 0]]"), StartsWith("t.seam.json: "));
    EXPECT_THAT(fault_with("[[1, 0], [0, 1]]", "[[1, 0], \"b\"]"), HasSubstr("\"lattice\" is not"));
    EXPECT_THAT(fault_with("[0, 1, 1, 0]", "[0, 1, 1]"), HasSubstr("does not have 4 numbers"));
    for (const char* other : {"[0, 1, 1, 18446744073709551615]", "[0, 1, 1, -2147483649]",
                              "[0, 1, 1, 0.5]", "[0, 1, 1, null]"}) {
        EXPECT_THAT(fault_with("[0, 1, 1, 0]", other), HasSubstr("32-bit integer")) << other;
    }
    EXPECT_THAT(fault_with("[0, 1, 1, 0]", "7"), HasSubstr("does not hold lists"));
}

TEST(Obj, NonFiniteCoordinatesAreInternalErrors) {
    plane::Tile tile = testing::grid_tile(kSquare, 1, 1);
    tile.points[3].y() = std::numeric_limits<double>::infinity();
    EXPECT_THROW(encode_obj(tile, {}, "t.obj"), InternalError);
}

TEST(Obj, DamagedFilesGiveATileOrAFaultAndNothingElse) {
    std::mt19937_64 random(7);
    const auto files = encode_obj(testing::triangle_grid_tile(kSquare, 2, 2), {}, "t.obj");
    int n_refused = 0;
    for (int k = 0; k < 4000; ++k) {
        auto damaged = files;
        auto& bytes = damaged[k % 2 == 0 ? 0 : 2].bytes;
        bytes = testing::mutated(bytes, random);
        const std::string fault = obj_fault(damaged);
        if (fault.empty()) continue;
        ++n_refused;
        EXPECT_THAT(fault, ::testing::AnyOf(StartsWith("t.obj"), StartsWith("t.mtl"),
                                            StartsWith("t.seam.json")));
        EXPECT_THAT(fault, HasSubstr("; "));
    }
    EXPECT_GT(n_refused, 1000);
}

}  // namespace
}  // namespace pcvt
