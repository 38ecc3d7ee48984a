#include <gmock/gmock.h>

#include <cmath>
#include <set>

#include "io/gltf/gltf_reader.hpp"
#include "io/gltf/gltf_writer.hpp"
#include "tests/support/glb.hpp"
#include "tests/support/grid_tile.hpp"
#include "tests/support/mutation.hpp"
#include "tests/support/tile_equality.hpp"

namespace pcvt {
namespace {

using ::testing::AllOf;
using testing::awkward_lattices;
using ::testing::Each;
using testing::Glb;
using testing::grain_grid_tile;
using testing::grid_tile;
using ::testing::HasSubstr;
using testing::split_glb;
using ::testing::StartsWith;
using testing::triangle_grid_tile;

const Lattice kOblique({1, 0}, {0.37, 0.81});

std::string glb(const Tile& tile) { return encode_glb(tile, "t.glb").at(0).bytes; }

TileFile read(const std::string& bytes, const std::optional<Lattice>& lattice = {}) {
    return decode_gltf({{"t.glb", bytes}}, lattice);
}

std::string fault_of(const std::string& bytes) {
    try {
        read(bytes);
    } catch (const BadFile& fault) {
        return fault.what();
    }
    return "";
}

/// Tiles of all kinds; the cells with one node each and with one node for all. Each tile has the
/// same number of faces at every site.
std::vector<Tile> tiles_of(const Lattice& lattice) {
    return {grid_tile(lattice, 1, 1),          grid_tile(lattice, 5, 6),
            grid_tile(lattice, 41, 50),        triangle_grid_tile(lattice, 1, 1),
            triangle_grid_tile(lattice, 5, 6), grain_grid_tile(lattice, 1, 1),
            grain_grid_tile(lattice, 5, 6)};
}

/// Returns the fault of a small file with the JSON value at `pointer` replaced.
std::string fault_with(const std::string& pointer, const nlohmann::json& value) {
    Glb parts = split_glb(glb(grid_tile(kOblique, 2, 3)));
    parts.json[nlohmann::json::json_pointer(pointer)] = value;
    return fault_of(testing::join_glb(parts.json.dump(), parts.binary));
}

/// Runs the reader on damaged bytes, which it may accept or refuse with BadFile, nothing else.
void survive(const std::string& bytes) {
    try {
        read(bytes, kOblique);
    } catch (const BadFile& fault) {
        EXPECT_THAT(fault.what(), AllOf(StartsWith("t.glb:"), Not(HasSubstr("\n"))));
    }
}

TEST(Gltf, ReadsBackPointsLatticeAndPairs) {
    for (const Lattice& lattice : awkward_lattices()) {
        for (const Tile& tile : tiles_of(lattice)) {
            const TileFile file = read(glb(tile));
            EXPECT_EQ(file.tile.kind, tile.kind);
            EXPECT_EQ(file.precision, Precision::kSingle);
            EXPECT_EQ(file.tile.lattice.a(), lattice.a());
            EXPECT_EQ(file.tile.lattice.b(), lattice.b());
            EXPECT_TRUE(file.has_vertex_pairs);
            EXPECT_FALSE(file.has_edge_pairs);
            EXPECT_TRUE(file.tile.vertex_pairs == tile.vertex_pairs);
            ASSERT_GE(file.tile.n_vertices(), tile.n_vertices());
            for (int v = 0; v < tile.n_vertices(); ++v) {
                EXPECT_EQ(file.tile.points[v], tile.points[v].cast<float>().cast<double>());
            }
        }
    }
}

TEST(Gltf, TrianglesOfACellKeepItsSiteAndItsArea) {
    for (const Tile& tile : {grid_tile(kOblique, 5, 6), grid_tile(kOblique, 41, 50)}) {
        const Tile back = read(glb(tile)).tile;
        std::vector<double> area(tile.n_faces());
        for (int f = 0; f < back.n_faces(); ++f) {
            const auto corner = [&](int k) { return back.points[back.faces.corners[3 * f + k]]; };
            const Vec2 u = corner(1) - corner(0);
            const Vec2 v = corner(2) - corner(0);
            area[back.face_site[f]] += (u.x() * v.y() - u.y() * v.x()) / 2;
        }
        const double expected = kOblique.area() / tile.n_faces();
        EXPECT_THAT(area, Each(::testing::DoubleNear(expected, 1e-4 * expected)));
    }
}

TEST(Gltf, TriangleTilesKeepTheirFacesAndSites) {
    const Tile tile = triangle_grid_tile(kOblique, 5, 6);
    const Tile back = read(glb(tile)).tile;
    EXPECT_EQ(back.faces.corners, tile.faces.corners);
    EXPECT_EQ(back.faces.begin, tile.faces.begin);
    EXPECT_EQ(back.vertex_site, tile.vertex_site);
    EXPECT_TRUE(back.face_site.empty());
}

TEST(Gltf, TrianglesOfAGrainShareTheirVertices) {
    const Tile tile = grain_grid_tile(kOblique, 5, 6);
    const Tile back = read(glb(tile)).tile;
    EXPECT_EQ(back.face_site, tile.face_site);
    // Each grain has four vertices, and each vertex belongs to one grain.
    EXPECT_EQ(std::set<int>(back.faces.corners.begin(), back.faces.corners.end()).size(), 4 * 30U);
    EXPECT_EQ(back.n_vertices(), 4 * 30);
}

TEST(Gltf, ReadsAsATileOnEveryLattice) {
    for (const Lattice& lattice : awkward_lattices()) {
        for (const Tile& tile : tiles_of(lattice)) {
            const TileFile file = read(glb(tile));
            const TileProof proof = prove_tile(file.tile, file.precision);
            EXPECT_EQ(proof.n_vertices, tile.n_vertices());
            EXPECT_NO_THROW(compare_vertex_pairs(file.tile, proof));
        }
    }
}

TEST(Gltf, StatedCopiesDoNotChangeTheProof) {
    for (const Tile& tile : {grid_tile(kOblique, 41, 50), grain_grid_tile(kOblique, 5, 6)}) {
        TileFile file = read(glb(tile));
        EXPECT_FALSE(file.tile.copies.empty());
        const TileProof stated = prove_tile(file.tile, file.precision);
        file.tile.copies.clear();
        const TileProof found = prove_tile(file.tile, file.precision);
        EXPECT_EQ(stated.first_copy, found.first_copy);
        EXPECT_EQ(stated.n_merged, found.n_merged);
        EXPECT_TRUE(stated.vertex_pairs == found.vertex_pairs);
        EXPECT_TRUE(stated.edge_pairs == found.edge_pairs);
    }
}

TEST(Gltf, TextAndBinaryHoldTheSameTile) {
    for (const Tile& tile : tiles_of(kOblique)) {
        const std::string text = encode_gltf(tile, "t.gltf").at(0).bytes;
        EXPECT_THAT(text, StartsWith("{"));
        testing::expect_same_tile(read(text).tile, read(glb(tile)).tile);
    }
}

TEST(Gltf, BoundsMatchTheStoredFloats) {
    for (const Tile& tile : tiles_of(Lattice({1e6 / 3, 1e5 / 7}, {-1e5, 1e6 / 9}))) {
        const Glb file = split_glb(glb(tile));
        for (const auto& mesh : file.json["meshes"]) {
            const std::size_t id = mesh["primitives"][0]["attributes"]["POSITION"];
            const std::vector<float> points = testing::accessor_floats(file, id, 3);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                std::set<double> values;
                for (std::size_t k = axis; k < points.size(); k += 3) values.insert(points[k]);
                EXPECT_EQ(file.json["accessors"][id]["min"][axis], *values.begin());
                EXPECT_EQ(file.json["accessors"][id]["max"][axis], *values.rbegin());
            }
        }
    }
}

TEST(Gltf, FewCellsHaveANodeAndAMaterialEach) {
    const Glb file = split_glb(glb(grid_tile(kOblique, 5, 6)));
    EXPECT_EQ(file.json["nodes"].size(), 1u + 30u + 1u);
    EXPECT_EQ(file.json["materials"].size(), 30u + 1u);
    EXPECT_EQ(file.json["nodes"][0]["name"], "tile");
    for (std::size_t cell = 0; cell < 30; ++cell) {
        const auto& node = file.json["nodes"][1 + cell];
        const auto& mesh = file.json["meshes"][node["mesh"].get<std::size_t>()]["primitives"][0];
        const auto& material = file.json["materials"][mesh["material"].get<std::size_t>()];
        EXPECT_EQ(node["name"], "cell_" + std::to_string(cell));
        EXPECT_EQ(material["name"], node["name"]);
        EXPECT_EQ(material["doubleSided"], true);
        EXPECT_EQ(material["pbrMetallicRoughness"]["metallicFactor"], 0);
        EXPECT_EQ(mesh["attributes"]["POSITION"], 0);
    }
}

TEST(Gltf, ManyCellsHaveVerticesOfTheirOwn) {
    const Tile tile = grid_tile(kOblique, 41, 50);
    const Glb file = split_glb(glb(tile));
    EXPECT_EQ(file.json["nodes"].size(), 3u);
    const auto& attributes = file.json["meshes"][0]["primitives"][0]["attributes"];
    const auto ids = testing::accessor_floats(file, attributes["_CELL_ID"], 1);
    const auto points = testing::accessor_floats(file, attributes["POSITION"], 3);
    const auto& copies = file.json["nodes"][0]["extras"]["periodic"]["vertexCopies"];
    ASSERT_EQ(ids.size(), tile.faces.corners.size());
    ASSERT_EQ(copies.size(), tile.faces.corners.size() - tile.points.size());
    for (std::size_t k = 0; k < copies.size(); ++k) {
        const std::size_t v = copies[k];
        EXPECT_EQ(points[3 * v], points[3 * (tile.points.size() + k)]);
        EXPECT_EQ(points[3 * v + 1], points[3 * (tile.points.size() + k) + 1]);
    }
}

TEST(Gltf, OutlinesLieAboveTheSurface) {
    const Glb file = split_glb(glb(grid_tile(Lattice::rectangle(20, 1), 5, 6)));
    const auto& primitive = file.json["meshes"].back()["primitives"][0];
    EXPECT_EQ(primitive["mode"], 1);
    const auto& accessor = file.json["accessors"][primitive["attributes"]["POSITION"].get<int>()];
    EXPECT_EQ(accessor["min"][2], 0.002f * 20);
    const auto& indices = file.json["accessors"][primitive["indices"].get<int>()];
    EXPECT_EQ(indices["count"], 2 * (6 * 6 + 5 * 7));
    EXPECT_EQ(file.json["extensionsUsed"], nlohmann::json({"KHR_materials_unlit"}));
}

TEST(Gltf, ViewsAreAlignedAndHaveATarget) {
    for (const Tile& tile : tiles_of(kOblique)) {
        const Glb file = split_glb(glb(tile));
        for (const auto& view : file.json["bufferViews"]) {
            EXPECT_EQ(view.value("byteOffset", 0) % 4, 0);
            EXPECT_TRUE(view["target"] == 34962 || view["target"] == 34963);
        }
    }
}

TEST(Gltf, TheSameTileGivesTheSameBytes) {
    for (const Tile& tile : tiles_of(kOblique)) EXPECT_EQ(glb(tile), glb(tile));
}

TEST(Gltf, RefusesTilesThatFloat32CannotHold) {
    EXPECT_THROW(glb(grid_tile(Lattice::rectangle(1e60, 1e60), 2, 2)), InvalidInput);
    EXPECT_THROW(glb(grid_tile(Lattice::rectangle(1e-60, 1e-60), 2, 2)), InvalidInput);
    Tile far = grid_tile(Lattice::rectangle(1, 1), 4, 4);
    for (Vec2& p : far.points) p.x() += 1e9;
    EXPECT_THROW(glb(far), InvalidInput);
}

TEST(Gltf, SitesBeyondFloat32ExceedALimit) {
    Tile tile = grid_tile(kOblique, 1, 1);
    tile.face_site[0] = (1 << 24) - 1;
    EXPECT_NO_THROW(glb(tile));
    tile.face_site[0] = 1 << 24;
    EXPECT_THROW(glb(tile), LimitExceeded);
}

TEST(GltfReader, RequiresALatticeFromTheFileOrTheCaller) {
    EXPECT_THAT(fault_with("/nodes/0/extras", nullptr), HasSubstr("--lattice"));
    Glb parts = split_glb(glb(grid_tile(kOblique, 2, 3)));
    parts.json["nodes"][0].erase("extras");
    const TileFile file = read(testing::join_glb(parts.json.dump(), parts.binary), kOblique);
    EXPECT_EQ(file.tile.lattice.b(), kOblique.b());
    EXPECT_FALSE(file.has_vertex_pairs);
}

/// Returns the .gltf file `text` with its base64 replaced.
std::string with_base64(const std::string& text, const std::string& base64) {
    const std::size_t begin = text.find(";base64,") + 8;
    return text.substr(0, begin) + base64 + text.substr(text.find('"', begin));
}

TEST(GltfReader, AcceptsEscapedBase64AndRefusesItsOwnPlaceholders) {
    const std::string text = encode_gltf(grid_tile(kOblique, 2, 3), "t.gltf").at(0).bytes;
    const std::size_t begin = text.find(";base64,") + 8;
    const std::string base64 = text.substr(begin, text.find('"', begin) - begin);
    const auto points_of = [](const std::string& file) {
        return decode_gltf({{"t.gltf", file}}, std::nullopt).tile.points;
    };
    EXPECT_EQ(points_of(with_base64(text, "\\u0041" + base64.substr(1))), points_of(text));
    for (const char* damaged : {"#0", "#1", "#", "AA#A", "AAA"}) {
        EXPECT_THROW(points_of(with_base64(text, damaged)), BadFile) << damaged;
    }
}

TEST(GltfReader, NamesTheFault) {
    const auto lone = nlohmann::json::parse("[[[0, 1, 1]]]");
    EXPECT_THAT(fault_with("/buffers/0/uri", "tile.bin"), HasSubstr("embedded"));
    EXPECT_THAT(fault_with("/nodes/1/translation", {1, 0, 0}), HasSubstr("translation"));
    EXPECT_THAT(fault_with("/extensionsRequired", {"KHR_draco_mesh_compression"}),
                HasSubstr("extension"));
    EXPECT_THAT(fault_with("/accessors/0/count", 1000000), HasSubstr("buffer view"));
    EXPECT_THAT(fault_with("/accessors/0/componentType", 5123), HasSubstr("floats"));
    EXPECT_THAT(fault_with("/bufferViews/0/byteLength", 4000000000u), HasSubstr("not a count"));
    EXPECT_THAT(fault_with("/bufferViews/0/byteLength", 1000000), HasSubstr("leaves its buffer;"));
    EXPECT_THAT(fault_with("/bufferViews/2/byteOffset", 1000000), HasSubstr("leaves its buffer;"));
    EXPECT_THAT(fault_with("/nodes/0/children/0", 99), HasSubstr("no entry 99"));
    EXPECT_THAT(fault_with("/nodes/1/children", {0}), HasSubstr("two parents"));
    EXPECT_THAT(fault_with("/nodes/1/name", "ground"), HasSubstr("some triangles"));
    EXPECT_THAT(fault_with("/nodes/0/extras/periodic/vertexPairs", lone),
                HasSubstr("[v, w, i, j]"));
    EXPECT_THAT(fault_with("/nodes/0/extras/periodic/vertexPairs/0/1", 12), HasSubstr("range"));
    EXPECT_THAT(fault_with("/nodes/0/extras/periodic/lattice", 5), HasSubstr("lattice"));
    EXPECT_THAT(fault_with("/meshes/0/primitives/0/mode", 5), HasSubstr("strips"));
    EXPECT_THAT(fault_with("/asset/version", "1.0"), HasSubstr("2.0"));
    EXPECT_THAT(fault_of(""), StartsWith("t.glb:1: not JSON"));
    EXPECT_THAT(fault_of("{\n\"asset\": oops}"), StartsWith("t.glb:2: not JSON"));
}

TEST(GltfReader, RefusesIndicesBeyondTheVertices) {
    Glb parts = split_glb(glb(grid_tile(kOblique, 2, 3)));
    const std::size_t accessor = parts.json["meshes"][0]["primitives"][0]["indices"];
    const std::size_t view = parts.json["accessors"][accessor]["bufferView"];
    parts.binary[parts.json["bufferViews"][view]["byteOffset"].get<std::size_t>()] = 12;
    EXPECT_THAT(fault_of(testing::join_glb(parts.json.dump(), parts.binary)),
                HasSubstr("beyond the last vertex, 11"));
}

TEST(GltfReader, SurvivesDeeplyNestedJson) {
    const std::string deep = std::string(300000, '[') + std::string(300000, ']');
    survive(R"({"asset":{"version":"2.0"},"scenes":)" + deep + "}");
    survive(R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"extras":)" + deep +
            "}]}");
}

TEST(GltfReader, SurvivesEveryTruncation) {
    const std::string binary = glb(grid_tile(kOblique, 1, 2));
    const std::string text = encode_gltf(triangle_grid_tile(kOblique, 1, 1), "t").at(0).bytes;
    for (std::size_t n = 0; n < binary.size(); ++n) EXPECT_NE(fault_of(binary.substr(0, n)), "");
    for (std::size_t n = 0; n <= text.rfind('}'); ++n) EXPECT_NE(fault_of(text.substr(0, n)), "");
}

TEST(GltfReader, SurvivesMutatedFiles) {
    std::mt19937_64 random(7);
    for (const Tile& tile : {grid_tile(kOblique, 1, 2), triangle_grid_tile(kOblique, 2, 1)}) {
        const std::string text = encode_gltf(tile, "t").at(0).bytes;
        const Glb parts = split_glb(glb(tile));
        const std::string json = parts.json.dump();
        for (int round = 0; round < 1000; ++round) {
            survive(testing::mutated(text, random));
            survive(testing::mutated(glb(tile), random));
            survive(testing::join_glb(testing::mutated(json, random), parts.binary));
            survive(testing::join_glb(json, testing::mutated(parts.binary, random)));
        }
    }
}

}  // namespace
}  // namespace pcvt
