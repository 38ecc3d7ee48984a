#include "io/tile_formats.hpp"

#include <gmock/gmock.h>

#include "mesher/mesh/outline.hpp"
#include "mesher/mesh/voronoi.hpp"

namespace pcvt {
namespace {

OpenMeshTile example(const TileFormat& format) {
    const Lattice lattice({1, 0}, {0.37, 0.81});
    const PeriodicDelaunay delaunay(Sites(lattice, uniform_points(lattice, 7, 5)));
    const PeriodicMesh mesh = format.triangles_only ? triangle_mesh(delaunay) : cell_mesh(delaunay);
    return make_tile(mesh, whole_outline(mesh, Vec2(0, 0)));
}

TEST(TileFormats, ExtensionsPickTheFormatInAnyCase) {
    for (const char* name :
         {".obj", ".ply", ".glb", ".gltf", ".om", ".svg", ".msh", ".inp", ".vtu", ".foam"}) {
        ASSERT_NE(find_tile_format(std::string("a.b/c") + name), nullptr) << name;
        EXPECT_EQ(find_tile_format(std::string("a.b/c") + name)->extension, name);
    }
    EXPECT_EQ(find_tile_format("TILE.OBJ")->extension, ".obj");
    for (const char* path : {"", "obj", ".obj", "a.obj/b", "a.stl", "a.", "a.obj "}) {
        EXPECT_EQ(find_tile_format(path), nullptr) << path;
    }
}

TEST(TileFormats, EveryFormatWritesThePathsThatItPromises) {
    for (const TileFormat& format : tile_formats()) {
        const OpenMeshTile tile = example(format);
        const std::string path = "dir/tile" + format.extension;
        std::vector<std::string> written;
        for (const EncodedFile& file : encode_tile(format, tile, path)) {
            written.push_back(file.path);
            EXPECT_FALSE(file.bytes.empty()) << file.path;
        }
        EXPECT_EQ(written, format.paths(path));
        EXPECT_EQ(written.front(), path + (format.is_folder ? "/constant/polyMesh/points" : ""));
    }
}

TEST(TileFormats, EveryFormatReadsItsOwnFilesButThePicture) {
    for (const TileFormat& format : tile_formats()) {
        const OpenMeshTile tile = example(format);
        ASSERT_EQ(format.decode == nullptr, format.extension == ".svg");
        if (!format.decode) continue;
        const TileFile file = format.decode(encode_tile(format, tile, "t" + format.extension), {});
        EXPECT_NE(file.has_vertex_pairs, format.is_folder) << format.extension;
        EXPECT_TRUE(file.has_vertex_pairs || file.has_edge_pairs) << format.extension;
        EXPECT_EQ(file.tile.lattice.b(), Vec2(0.37, 0.81)) << format.extension;
    }
}

TEST(TileFormats, TheSameTileGivesTheSameBytes) {
    for (const TileFormat& format : tile_formats()) {
        const auto first = encode_tile(format, example(format), "t" + format.extension);
        const auto second = encode_tile(format, example(format), "t" + format.extension);
        ASSERT_EQ(first.size(), second.size());
        for (std::size_t k = 0; k < first.size(); ++k) {
            EXPECT_EQ(first[k].bytes, second[k].bytes) << first[k].path;
        }
    }
}

}  // namespace
}  // namespace pcvt
