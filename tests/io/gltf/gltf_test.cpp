#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <set>

#include "io/bytes/output_error.hpp"
#include "io/gltf/gltf_reader.hpp"
#include "io/gltf/plane_gltf.hpp"
#include "tests/support/example_lattices.hpp"
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
using testing::kOblique;
using testing::split_glb;
using ::testing::StartsWith;
using testing::triangle_grid_tile;

std::string glb(const plane::Tile& tile, GltfNodes nodes = GltfNodes::kBySize) {
    return encode_glb(tile, {.gltf_nodes = nodes}, "t.glb").at(0).bytes;
}

TileFile read(const std::string& bytes, const std::optional<plane::Lattice>& lattice = {}) {
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
std::vector<plane::Tile> tiles_of(const plane::Lattice& lattice) {
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
    for (const plane::Lattice& lattice : awkward_lattices()) {
        for (const plane::Tile& tile : tiles_of(lattice)) {
            const TileFile file = read(glb(tile));
            EXPECT_EQ(file.tile.kind, tile.kind);
            EXPECT_EQ(file.precision, plane::Precision::kSingle);
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
    for (const GltfNodes nodes : {GltfNodes::kCells, GltfNodes::kOne}) {
        for (const plane::Tile& tile : {grid_tile(kOblique, 5, 6), grid_tile(kOblique, 41, 50),
                                        grain_grid_tile(kOblique, 5, 6)}) {
            const plane::Tile back = read(glb(tile, nodes)).tile;
            std::map<SiteId, double> area;
            for (int f = 0; f < back.n_faces(); ++f) {
                const auto corner = [&](int k) {
                    return back.points[back.faces.corners[3 * f + k]];
                };
                const plane::Vec2 u = corner(1) - corner(0);
                const plane::Vec2 v = corner(2) - corner(0);
                area[back.face_site[f]] += (u.x() * v.y() - u.y() * v.x()) / 2;
            }
            const std::set<SiteId> sites(tile.face_site.begin(), tile.face_site.end());
            ASSERT_EQ(area.size(), sites.size());
            const double expected = kOblique.area() / static_cast<double>(sites.size());
            for (const auto& [site, sum] : area) EXPECT_NEAR(sum, expected, 1e-4 * expected);
        }
    }
}

TEST(Gltf, TriangleTilesKeepTheirFacesAndSites) {
    const plane::Tile tile = triangle_grid_tile(kOblique, 5, 6);
    const plane::Tile back = read(glb(tile)).tile;
    EXPECT_EQ(back.faces.corners, tile.faces.corners);
    EXPECT_EQ(back.faces.begin, tile.faces.begin);
    EXPECT_EQ(back.vertex_site, tile.vertex_site);
    EXPECT_TRUE(back.face_site.empty());
}

TEST(Gltf, AllTrianglesShareTheVerticesOfTheTile) {
    for (const GltfNodes nodes : {GltfNodes::kCells, GltfNodes::kOne}) {
        for (const plane::Tile& tile :
             {grid_tile(kOblique, 5, 6), grain_grid_tile(kOblique, 5, 6)}) {
            const plane::Tile back = read(glb(tile, nodes)).tile;
            EXPECT_EQ(back.n_vertices(), tile.n_vertices());
            EXPECT_TRUE(back.copies.empty());
        }
    }
}

TEST(Gltf, ReadsAsATileOnEveryLattice) {
    for (const plane::Lattice& lattice : awkward_lattices()) {
        for (const plane::Tile& tile : tiles_of(lattice)) {
            for (const GltfNodes nodes : {GltfNodes::kCells, GltfNodes::kOne}) {
                const TileFile file = read(glb(tile, nodes));
                const plane::TileProof proof = prove_tile(file.tile, file.precision);
                EXPECT_EQ(proof.n_vertices, tile.n_vertices());
                EXPECT_NO_THROW(compare_vertex_pairs(file.tile, proof));
            }
        }
    }
}

/// Appends numbers as they lie in memory.
template <class Number>
void append_bytes(std::string& bytes, const std::vector<Number>& numbers) {
    bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number));
}

/// Returns a grid of parallelograms in which the first cell at a vertex keeps it and every other
/// cell has a copy; sites are in _CELL_ID.
std::string unwelded(const plane::Tile& tile) {
    std::vector<float> points;
    std::vector<float> sites(tile.points.size(), -1);
    std::vector<std::uint32_t> indices;
    nlohmann::json copies = nlohmann::json::array();
    const auto add_point = [&](int v) {
        for (const double x : {tile.points[v].x(), tile.points[v].y(), 0.0}) {
            points.push_back(static_cast<float>(x));
        }
    };
    for (int v = 0; v < tile.n_vertices(); ++v) add_point(v);
    for (int f = 0; f < tile.n_faces(); ++f) {
        std::vector<std::uint32_t> corners;
        for (const int v : tile.faces[f]) {
            const bool is_first = sites[v] < 0;
            corners.push_back(is_first ? v : static_cast<int>(sites.size()));
            if (!is_first) {
                add_point(v);
                sites.push_back(0);
                copies.push_back(v);
            }
            sites[corners.back()] = static_cast<float>(tile.face_site[f]);
        }
        for (const int k : {0, 1, 2, 0, 2, 3}) indices.push_back(corners[k]);
    }
    // Only the data of the surface are exchanged.
    Glb parts = split_glb(glb(tile, GltfNodes::kOne));
    parts.binary.clear();
    append_bytes(parts.binary, points);
    append_bytes(parts.binary, sites);
    append_bytes(parts.binary, indices);
    const std::size_t ends[] = {0, 12 * sites.size(), 16 * sites.size(), parts.binary.size()};
    parts.json["bufferViews"] = nlohmann::json::array();
    for (int k = 0; k < 3; ++k) {
        parts.json["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", ends[k]}, {"byteLength", ends[k + 1] - ends[k]}});
    }
    parts.json["buffers"] = {{{"byteLength", parts.binary.size()}}};
    parts.json["accessors"] = nlohmann::json::parse(
        R"([{"bufferView": 0, "componentType": 5126, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5126, "type": "SCALAR"},
            {"bufferView": 2, "componentType": 5125, "type": "SCALAR"}])");
    for (int k = 0; k < 3; ++k) {
        parts.json["accessors"][k]["count"] = k < 2 ? sites.size() : indices.size();
    }
    parts.json["meshes"] = nlohmann::json::parse(
        R"([{"primitives": [{"attributes": {"POSITION": 0, "_CELL_ID": 1}, "indices": 2}]}])");
    parts.json["nodes"][0]["children"] = {1};
    parts.json["nodes"][0]["extras"]["periodic"].erase("cellTriangles");
    parts.json["nodes"][0]["extras"]["periodic"]["vertexCopies"] = copies;
    return testing::join_glb(parts.json.dump(), parts.binary);
}

TEST(GltfReader, CopiesOfVerticesDoNotChangeTheProof) {
    const plane::Tile tile = grid_tile(kOblique, 7, 5);
    TileFile file = read(unwelded(tile));
    EXPECT_EQ(file.tile.kind, plane::MeshKind::kVoronoi);
    ASSERT_EQ(file.tile.n_vertices(), 4 * 35);
    ASSERT_EQ(file.tile.copies.size(), file.tile.points.size() - tile.points.size());
    const plane::TileProof stated = prove_tile(file.tile, file.precision);
    EXPECT_EQ(stated.n_vertices, tile.n_vertices());
    EXPECT_NO_THROW(compare_vertex_pairs(file.tile, stated));
    file.tile.copies.clear();
    const plane::TileProof found = prove_tile(file.tile, file.precision);
    EXPECT_EQ(stated.first_copy, found.first_copy);
    EXPECT_EQ(stated.n_merged, found.n_merged);
    EXPECT_TRUE(stated.vertex_pairs == found.vertex_pairs);
    EXPECT_TRUE(stated.edge_pairs == found.edge_pairs);
}

TEST(Gltf, TextAndBinaryHoldTheSameTile) {
    for (const plane::Tile& tile : tiles_of(kOblique)) {
        const std::string text = encode_gltf(tile, {}, "t.gltf").at(0).bytes;
        EXPECT_THAT(text, StartsWith("{"));
        testing::expect_same_tile(read(text).tile, read(glb(tile)).tile);
    }
}

TEST(Gltf, BoundsMatchTheStoredFloats) {
    for (const plane::Tile& tile : tiles_of(plane::Lattice({1e6 / 3, 1e5 / 7}, {-1e5, 1e6 / 9}))) {
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

TEST(Gltf, ManyCellsAndGrainsAreOneNodeWithAPrimitiveForEachColour) {
    for (const plane::Tile& tile : {grid_tile(kOblique, 41, 50), grain_grid_tile(kOblique, 5, 6)}) {
        const Glb file = split_glb(glb(tile));
        ASSERT_EQ(file.json["nodes"].size(), 3u);
        EXPECT_EQ(file.json["nodes"][1]["name"], "cells");
        const auto& primitives = file.json["meshes"][0]["primitives"];
        ASSERT_EQ(primitives.size(), 1u);
        const bool grains = tile.kind == plane::MeshKind::kGrains;
        EXPECT_EQ(file.json["materials"][0]["name"], grains ? "sides_3" : "sides_4");
        EXPECT_EQ(primitives[0]["material"], 0);
        EXPECT_FALSE(primitives[0]["attributes"].contains("COLOR_0"));
        EXPECT_EQ(file.json["accessors"][0]["count"], tile.points.size());
        const auto& cells = file.json["nodes"][0]["extras"]["periodic"]["cellTriangles"];
        ASSERT_EQ(cells.size(), tile.n_faces() / (grains ? 2u : 1u));
        EXPECT_EQ(cells[7], nlohmann::json({7, 2}));
    }
}

TEST(Gltf, NodesForCellsAreMadeOnRequest) {
    const Glb grains = split_glb(glb(grain_grid_tile(kOblique, 5, 6), GltfNodes::kCells));
    EXPECT_EQ(grains.json["nodes"].size(), 1u + 30u + 1u);
    EXPECT_EQ(grains.json["nodes"][30]["name"], "cell_29");
    const Glb few = split_glb(glb(grid_tile(kOblique, 5, 6), GltfNodes::kOne));
    EXPECT_EQ(few.json["nodes"].size(), 3u);
}

TEST(Gltf, TextureCoordinatesPointDownAndDifferByTheOffsetOfPartners) {
    for (const plane::Lattice& lattice : awkward_lattices()) {
        for (const plane::Tile& tile : tiles_of(lattice)) {
            const Glb file = split_glb(glb(tile));
            for (const auto& mesh : file.json["meshes"]) {
                const auto& attributes = mesh["primitives"][0]["attributes"];
                EXPECT_EQ(attributes.contains("TEXCOORD_0"), mesh["name"] != "outlines");
            }
            const std::size_t accessor =
                file.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"];
            const std::vector<float> uv = testing::accessor_floats(file, accessor, 2);
            ASSERT_EQ(uv.size(), 2 * tile.points.size());
            for (const auto& [v, w, offset] : tile.vertex_pairs) {
                EXPECT_EQ(uv[2 * w] - uv[2 * v], static_cast<float>(offset.i));
                EXPECT_EQ(uv[2 * w + 1] - uv[2 * v + 1], static_cast<float>(-offset.j));
            }
            for (int v = 0; v < tile.n_vertices(); ++v) {
                const plane::Vec2 u = lattice.to_lattice(tile.points[v]);
                EXPECT_NEAR(uv[2 * v], u.x(), 1e-6);
                EXPECT_NEAR(uv[2 * v + 1], 1 - u.y(), 1e-6);
            }
        }
    }
}

TEST(Gltf, OutlinesLieAboveTheSurface) {
    const Glb file = split_glb(glb(grid_tile(plane::Lattice::rectangle(20, 1), 5, 6)));
    const auto& primitive = file.json["meshes"].back()["primitives"][0];
    EXPECT_EQ(primitive["mode"], 1);
    const auto& accessor = file.json["accessors"][primitive["attributes"]["POSITION"].get<int>()];
    EXPECT_EQ(accessor["min"][2], 0.002f * 20);
    const auto& indices = file.json["accessors"][primitive["indices"].get<int>()];
    EXPECT_EQ(indices["count"], 2 * (6 * 6 + 5 * 7));
    EXPECT_EQ(file.json["extensionsUsed"], nlohmann::json({"KHR_materials_unlit"}));
}

TEST(Gltf, PiecesOfOneCellKeepTheEdgeBetweenThem) {
    // The square cell of a single site, cut along a diagonal. Fans begin at the first corners.
    for (const std::vector<int>& corners :
         {std::vector<int>{0, 1, 2, 0, 2, 3}, {0, 2, 3, 0, 1, 2}, {1, 2, 3, 1, 3, 0}}) {
        plane::Tile tile{.lattice = plane::Lattice({1, 0}, {0, 1}),
                         .kind = plane::MeshKind::kVoronoi};
        tile.points = {plane::Vec2(0, 0), plane::Vec2(1, 0), plane::Vec2(1, 1), plane::Vec2(0, 1)};
        tile.face_site = {0, 0};
        tile.columns = tile.rows = 1;
        tile.site_positions = {plane::Vec2(0.5, 0.5)};
        tile.faces.add(std::span(corners).first(3));
        tile.faces.add(std::span(corners).last(3));
        for (const GltfNodes nodes : {GltfNodes::kCells, GltfNodes::kOne}) {
            EXPECT_EQ(fault_of(glb(tile, nodes)), "");
        }
    }
}

TEST(Gltf, ViewsAreAlignedAndHaveATarget) {
    for (const plane::Tile& tile : tiles_of(kOblique)) {
        const Glb file = split_glb(glb(tile));
        for (const auto& view : file.json["bufferViews"]) {
            EXPECT_EQ(view.value("byteOffset", 0) % 4, 0);
            EXPECT_TRUE(view["target"] == 34962 || view["target"] == 34963);
        }
    }
}

TEST(Gltf, TheSameTileGivesTheSameBytes) {
    for (const plane::Tile& tile : tiles_of(kOblique)) EXPECT_EQ(glb(tile), glb(tile));
}

TEST(Gltf, RefusesTilesThatFloat32CannotHold) {
    EXPECT_THROW(glb(grid_tile(plane::Lattice::rectangle(1e60, 1e60), 2, 2)), CoarsePrecision);
    EXPECT_THROW(glb(grid_tile(plane::Lattice::rectangle(1e-60, 1e-60), 2, 2)), CoarsePrecision);
}

TEST(Gltf, SitesBeyondFloat32ExceedALimit) {
    plane::Tile tile = grid_tile(kOblique, 1, 1);
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
    const std::string text = encode_gltf(grid_tile(kOblique, 2, 3), {}, "t.gltf").at(0).bytes;
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
    EXPECT_THAT(fault_with("/bufferViews/3/byteOffset", 1000000), HasSubstr("leaves its buffer;"));
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

TEST(GltfReader, CellTrianglesCountEveryTriangleOnce) {
    Glb parts = split_glb(glb(grid_tile(kOblique, 2, 3), GltfNodes::kOne));
    auto& cells = parts.json["nodes"][0]["extras"]["periodic"]["cellTriangles"];
    const auto fault = [&](const char* rows) {
        cells = nlohmann::json::parse(rows);
        return fault_of(testing::join_glb(parts.json.dump(), parts.binary));
    };
    EXPECT_EQ(fault("[[5, 12]]"), "");
    EXPECT_THAT(fault("[[0, 11]]"), HasSubstr("does not count all triangles"));
    EXPECT_THAT(fault("[[0, 5], [1, 8]]"), HasSubstr("range"));
    EXPECT_THAT(fault("[[268435456, 12]]"), HasSubstr("range"));
    EXPECT_THAT(fault("[[0, -1]]"), HasSubstr("not a count"));
    EXPECT_THAT(fault("[[0]]"), HasSubstr("[site, n]"));
    EXPECT_THAT(fault("7"), HasSubstr("not a list"));
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
    const std::string text = encode_gltf(triangle_grid_tile(kOblique, 1, 1), {}, "t").at(0).bytes;
    for (std::size_t n = 0; n < binary.size(); ++n) EXPECT_NE(fault_of(binary.substr(0, n)), "");
    for (std::size_t n = 0; n <= text.rfind('}'); ++n) EXPECT_NE(fault_of(text.substr(0, n)), "");
}

TEST(GltfReader, SurvivesMutatedFiles) {
    std::mt19937_64 random(7);
    for (const plane::Tile& tile :
         {grid_tile(kOblique, 1, 2), triangle_grid_tile(kOblique, 2, 1)}) {
        const std::string text = encode_gltf(tile, {}, "t").at(0).bytes;
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
