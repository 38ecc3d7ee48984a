#include "io/gltf/gltf_place.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "io/formats/file_proof.hpp"
#include "io/formats/formats.hpp"
#include "io/gltf/gltf_reader.hpp"
#include "io/gltf/plane_gltf.hpp"
#include "tests/support/example_lattices.hpp"
#include "tests/support/glb.hpp"
#include "tests/support/grid_tile.hpp"

namespace pcvt {
namespace {

using testing::Glb;
using ::testing::HasSubstr;
using testing::kOblique;

/// A grid whose lower left corner lies at whole periods from 0.
plane::Tile distant_grid(const plane::Lattice& lattice, double i, double j) {
    return moved_by(testing::grid_tile(lattice, 5, 6), lattice.to_position({i, j}));
}

std::vector<EncodedFile> encoded(const plane::Tile& tile) { return encode_glb(tile, {}, "t.glb"); }

/// The fault of the file of a distant grid that states its sites, with the entry of its JSON
/// replaced.
std::string distant_fault(const std::string& pointer, const nlohmann::json& value) {
    plane::Tile tile = distant_grid(kOblique, 20, -30);
    tile.columns = tile.rows = 1;
    Glb parts = testing::split_glb(encoded(tile).front().bytes);
    parts.json[nlohmann::json::json_pointer(pointer)] = value;
    try {
        decode_gltf({{"t.glb", testing::join_glb(parts.json.dump(), parts.binary)}}, std::nullopt);
    } catch (const BadFile& fault) {
        return fault.what();
    }
    return "";
}

TEST(GltfPlace, NodesOfDistantTilesAreMovedByWholePeriods) {
    for (const auto& [i, j] : {std::pair(20.0, -30.0), {4e5, 0.0}, {0.0, 1e9}, {-9000.0, 9000.0}}) {
        const plane::Tile tile = distant_grid(kOblique, i, j);
        const std::vector<EncodedFile> files = encoded(tile);
        const TileFile file = decode_gltf(files, std::nullopt);
        const plane::Vec2 periods = kOblique.to_lattice(file.translation);
        EXPECT_NEAR(periods.x(), i, 1);
        EXPECT_NEAR(periods.y(), j, 1);
        double largest = 0;
        for (int v = 0; v < tile.n_vertices(); ++v) {
            const plane::Vec2& local = file.tile.points[v];
            largest = std::max(largest, local.cwiseAbs().maxCoeff());
            EXPECT_EQ(local, plane::Vec2(
                                 (tile.points[v] - file.translation).cast<float>().cast<double>()));
        }
        EXPECT_LT(largest, 3);
    }
}

TEST(GltfPlace, NearTilesStayWhereTheyAre) {
    const plane::Tile tile = distant_grid(kOblique, 7, -7);
    const Glb parts = testing::split_glb(encoded(tile).front().bytes);
    EXPECT_FALSE(parts.json["nodes"][0].contains("translation"));
    EXPECT_EQ(decode_gltf(encoded(tile), std::nullopt).translation, plane::Vec2::Zero());
}

TEST(GltfPlace, DistantTilesAreProved) {
    const Format& format = *find_format("t.glb");
    for (const plane::Lattice& lattice : {kOblique, plane::Lattice({1, 0}, {20.37, 0.81})}) {
        const plane::Tile tile = distant_grid(lattice, 1e4, 3e6);
        const std::vector<EncodedFile> files = encoded(tile);
        EXPECT_NO_THROW(prove_file(format, files, decode_gltf(files, std::nullopt)));
    }
}

TEST(GltfPlace, OtherTranslationsAreRefused) {
    EXPECT_EQ(distant_fault("/nodes/0/name", "tile"), "");
    EXPECT_THAT(distant_fault("/nodes/0/translation/0", 0.25), HasSubstr("whole periods"));
    EXPECT_THAT(distant_fault("/nodes/0/translation/2", 1), HasSubstr("along z"));
    EXPECT_THAT(distant_fault("/nodes/0/translation", {1, 2}), HasSubstr("not [x, y, z]"));
    EXPECT_THAT(distant_fault("/nodes/0/translation/1", "far"), HasSubstr("not [x, y, z]"));
    EXPECT_THAT(distant_fault("/nodes/2/translation", {1, 0, 0}),
                HasSubstr("different translations"));
    EXPECT_THAT(distant_fault("/nodes/0/scale", {1, 1, 2}), HasSubstr("'scale'"));
}

}  // namespace
}  // namespace pcvt
