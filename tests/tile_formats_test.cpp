#include "io/tile_formats.hpp"

#include <gmock/gmock.h>

#include "mesher/outline.hpp"
#include "mesher/voronoi.hpp"

namespace pcvt {
namespace {

AnyTile example() {
    const Lattice lattice({1, 0}, {0.37, 0.81});
    const PeriodicDelaunay delaunay(Sites(lattice, uniform_points(lattice, 7, 5)));
    const PeriodicMesh cells = cell_mesh(delaunay);
    return make_tile(cells, whole_outline(cells, Vec2(0, 0)));
}

TEST(TileFormats, ExtensionsPickTheFormatInAnyCase) {
    for (const char* name : {".obj", ".ply", ".glb", ".gltf", ".om", ".svg"}) {
        ASSERT_NE(find_tile_format(std::string("a.b/c") + name), nullptr) << name;
        EXPECT_EQ(find_tile_format(std::string("a.b/c") + name)->extension, name);
    }
    EXPECT_EQ(find_tile_format("TILE.OBJ")->extension, ".obj");
    for (const char* path : {"", "obj", ".obj", "a.obj/b", "a.stl", "a.", "a.obj "}) {
        EXPECT_EQ(find_tile_format(path), nullptr) << path;
    }
}

TEST(TileFormats, EveryFormatWritesThePathsThatItPromises) {
    const AnyTile tile = example();
    for (const TileFormat& format : tile_formats()) {
        const std::string path = "dir/tile" + format.extension;
        std::vector<std::string> written;
        for (const EncodedFile& file : format.encode(tile, path)) {
            written.push_back(file.path);
            EXPECT_FALSE(file.bytes.empty()) << file.path;
        }
        EXPECT_EQ(written, format.paths(path));
        EXPECT_EQ(written.front(), path);
    }
}

TEST(TileFormats, EveryFormatReadsItsOwnFilesButThePicture) {
    const AnyTile tile = example();
    for (const TileFormat& format : tile_formats()) {
        ASSERT_EQ(format.decode == nullptr, format.extension == ".svg");
        if (!format.decode) continue;
        const TileFile file = format.decode(format.encode(tile, "t" + format.extension), {});
        EXPECT_TRUE(file.has_vertex_pairs) << format.extension;
        EXPECT_EQ(file.tile.lattice.b(), Vec2(0.37, 0.81)) << format.extension;
    }
}

TEST(TileFormats, TheSameTileGivesTheSameBytes) {
    for (const TileFormat& format : tile_formats()) {
        const auto first = format.encode(example(), "t" + format.extension);
        const auto second = format.encode(example(), "t" + format.extension);
        ASSERT_EQ(first.size(), second.size());
        for (std::size_t k = 0; k < first.size(); ++k) {
            EXPECT_EQ(first[k].bytes, second[k].bytes) << first[k].path;
        }
    }
}

}  // namespace
}  // namespace pcvt
