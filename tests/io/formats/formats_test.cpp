#include "io/formats/formats.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <iterator>

#include "mesher/plane/mesh/outline.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/tile/tile_builder.hpp"

namespace pcvt {
namespace {

plane::Tile example(const Format& format) {
    const plane::Lattice lattice({1, 0}, {0.37, 0.81});
    const plane::PeriodicDelaunay delaunay(plane::Sites(lattice, uniform_points(lattice, 7, 5)));
    const plane::PeriodicMesh mesh =
        format.holds_polygons ? cell_mesh(delaunay) : triangle_mesh(delaunay);
    return make_tile(mesh, whole_outline(mesh, plane::Vec2(0, 0)));
}

std::vector<Format> formats_of_tiles() {
    std::vector<Format> of_tiles;
    std::copy_if(formats().begin(), formats().end(), std::back_inserter(of_tiles),
                 [](const Format& format) { return format.needs_tile(); });
    return of_tiles;
}

TEST(Formats, ExtensionsPickTheFormatInAnyCase) {
    for (const char* name :
         {".obj", ".ply", ".glb", ".gltf", ".om", ".stl", ".svg", ".png", ".dxf", ".html", ".msh",
          ".inp", ".vtu", ".foam", ".nc", ".vti", ".csv", ".txt"}) {
        ASSERT_NE(find_format(std::string("a.b/c") + name), nullptr) << name;
        EXPECT_EQ(find_format(std::string("a.b/c") + name)->extension, name);
    }
    EXPECT_EQ(find_format("TILE.OBJ")->extension, ".obj");
    for (const char* path : {"", "obj", ".obj", "a.obj/b", "a.step", "a.", "a.obj "}) {
        EXPECT_EQ(find_format(path), nullptr) << path;
    }
}

TEST(Formats, EveryFormatWritesThePathsThatItPromises) {
    for (const Format& format : formats_of_tiles()) {
        const plane::Tile tile = example(format);
        const std::string path = "dir/tile" + std::string(format.extension);
        std::vector<std::string> written;
        for (const EncodedFile& file : encode_tile(format, tile, path)) {
            written.push_back(file.path);
            // ParaView opens a folder by an empty file.
            EXPECT_EQ(file.bytes.empty(), file.path == path + "/tile.foam") << file.path;
        }
        EXPECT_EQ(written, format.paths(path));
        EXPECT_EQ(written.front(), path + (format.is_folder ? "/constant/polyMesh/points" : ""));
    }
}

TEST(Formats, EveryFormatReadsItsOwnFilesButPictures) {
    for (const Format& format : formats_of_tiles()) {
        const plane::Tile tile = example(format);
        const auto is_picture = {".svg", ".png", ".dxf", ".html"};
        ASSERT_EQ(!format.is_readable(), std::find(is_picture.begin(), is_picture.end(),
                                                   format.extension) != is_picture.end());
        if (!format.is_readable()) continue;
        const TileFile file = decode_tile(format, encode_tile(format, tile, "t"), {});
        EXPECT_NE(file.has_vertex_pairs, format.is_folder) << format.extension;
        EXPECT_TRUE(file.has_vertex_pairs || file.has_edge_pairs) << format.extension;
        EXPECT_EQ(file.tile.lattice.b(), plane::Vec2(0.37, 0.81)) << format.extension;
    }
}

TEST(Formats, SitesAndGridsOfTheTorusAreRowsAsWell) {
    const Format& sites = *find_format("s.txt");
    EXPECT_TRUE(std::holds_alternative<SiteWriter*>(sites.write));
    EXPECT_FALSE(sites.is_readable());
    const Format& grid = *find_format("g.Nc");
    EXPECT_TRUE(std::holds_alternative<TorusWriter*>(grid.write));
    EXPECT_TRUE(grid.reads_grid());
    const plane::Lattice oblique({1, 0}, {0.37, 0.81});
    EXPECT_THROW(grid.check({.lattice = oblique, .n_sites = 0}), InvalidInput);
}

TEST(Formats, TheSameTileGivesTheSameBytes) {
    for (const Format& format : formats_of_tiles()) {
        const auto first = encode_tile(format, example(format), "t");
        const auto second = encode_tile(format, example(format), "t");
        ASSERT_EQ(first.size(), second.size());
        for (std::size_t k = 0; k < first.size(); ++k) {
            EXPECT_EQ(first[k].bytes, second[k].bytes) << first[k].path;
        }
    }
}

}  // namespace
}  // namespace pcvt
