#include <gmock/gmock.h>

#include "io/formats/file_proof.hpp"
#include "io/formats/formats.hpp"
#include "mesher/base/error.hpp"
#include "mesher/plane/proof/generated_tile.hpp"
#include "tests/support/holed_tiles.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;
using Files = std::vector<EncodedFile>;

const std::vector<plane::Tile>& tiles() {
    static const std::vector<plane::Tile> tiles = [] {
        std::vector<plane::Tile> made;
        for (const plane::MeshKind kind : {plane::MeshKind::kVoronoi, plane::MeshKind::kGrains}) {
            for (const plane::Outline outline : {plane::Outline::kWhole, plane::Outline::kBox}) {
                made.push_back(testing::holed_tile({.kind = kind, .outline = outline}));
            }
        }
        made.push_back(testing::holed_tile({.kind = plane::MeshKind::kGrains, .order = 2}));
        made.push_back(testing::holed_tile({.kind = plane::MeshKind::kDelaunay}));
        made.push_back(testing::holed_tile({.repeat = {2, 1}}));
        return made;
    }();
    return tiles;
}

bool holds_holed(const Format& format, const plane::Tile& tile) {
    if (!format.needs_tile() || !format.is_readable()) return false;
    if (!format.holds_polygons && tile.kind == plane::MeshKind::kVoronoi) return false;
    const bool is_cut = tile.kind == plane::MeshKind::kVoronoi && !tile.whole_sides.empty();
    return !(format.is_folder && is_cut);
}

/// Calls visit(format, tile, files) for each format and each tile that it holds.
template <class Visit>
void for_each_file(const Visit& visit) {
    for (const Format& format : formats()) {
        for (const plane::Tile& tile : tiles()) {
            if (!holds_holed(format, tile)) continue;
            const std::string path = "t" + std::string(format.extension);
            SCOPED_TRACE(path + " of " + mesh_kind_row(tile.kind).word + ", " +
                         std::to_string(tile.n_faces()) + " faces");
            visit(format, tile, encode_tile(format, tile, path));
        }
    }
}

TEST(HoledFiles, EachFormatGivesTheHolesBackAndIsProved) {
    for_each_file([](const Format& format, const plane::Tile& tile, const Files& files) {
        const TileFile file = decode_tile(format, files, std::nullopt);
        EXPECT_EQ(file.tile.holes, tile.holes);
        EXPECT_EQ(file.tile.wall_edges, tile.wall_edges);
        const plane::TileProof proof = prove_file(format, files, file);
        EXPECT_EQ(proof.wall_edges, tile.wall_edges);
        prove_tile_files(format, files, tile, plane::Vec2::Zero(), {});
    });
}

/// The complaint about a tile as it was read.
std::string complaint(const TileFile& file) {
    try {
        prove_tile_file(file);
        return "";
    } catch (const NotATile& fault) {
        return fault.what();
    }
}

TEST(HoledFiles, AFileThatLacksAnEdgeOfAHoleIsRefused) {
    for_each_file([](const Format& format, const plane::Tile&, const Files& files) {
        TileFile file = decode_tile(format, files, std::nullopt);
        const plane::WallEdge last = file.tile.wall_edges.back();
        file.tile.wall_edges.pop_back();
        EXPECT_THAT(complaint(file), HasSubstr("has no reversed partner"));
        file.tile.wall_edges.push_back(last);
        EXPECT_EQ(complaint(file), "");
        file.tile.wall_edges.front().wall = plane::WallId::hole(1);
        EXPECT_THAT(complaint(file), HasSubstr("has two names"));
    });
}

TEST(HoledFiles, EdgesOfVerticesThatDoNotExistAreRefused) {
    for_each_file([](const Format& format, const plane::Tile& tile, Files files) {
        for (EncodedFile& file : files) {
            const std::size_t at = file.bytes.find("pcvt hole hole_1 ");
            if (at == std::string::npos) continue;
            const std::size_t number = at + std::string("pcvt hole hole_1 ").size();
            file.bytes.insert(number, std::to_string(10 + tile.n_vertices()) + "0");
            EXPECT_THROW(decode_tile(format, files, std::nullopt), InvalidInput);
        }
    });
}

}  // namespace
}  // namespace pcvt
