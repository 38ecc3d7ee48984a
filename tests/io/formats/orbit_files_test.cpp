#include <gmock/gmock.h>

#include <array>

#include "io/formats/file_proof.hpp"
#include "mesher/plane/tile/build_tile.hpp"
#include "tests/support/damaged_text.hpp"
#include "tests/support/example_lattices.hpp"
#include "tests/support/grid_tile.hpp"

namespace pcvt {
namespace {

using ::testing::ElementsAreArray;
using ::testing::HasSubstr;
using testing::kSquare;

constexpr std::array kOrbits{0, 1, 1, 0};

/// The files of four sites that have these orbits.
std::vector<EncodedFile> encoded(const std::string& path, const plane::Tile& tile) {
    return encode_tile(*find_format(path), tile, path, {.site_orbits = kOrbits});
}

void prove_orbit(const std::vector<EncodedFile>& files) {
    const Format& format = *find_format(files.front().path);
    prove_file(format, files, decode_tile(format, files, std::nullopt));
}

/// Returns the reason for which the files are refused; "" if they are proved.
std::string orbit_refusal(const std::vector<EncodedFile>& files) {
    try {
        prove_orbit(files);
    } catch (const InvalidInput& fault) {
        return fault.what();
    }
    return "";
}

/// Returns the refusal of the first file with `piece` replaced by `other`.
std::string orbit_fault_with(std::vector<EncodedFile> files, const std::string& piece,
                             const std::string& other) {
    std::string& text = files.front().bytes;
    text = testing::exchanged(text, piece, other);
    return orbit_refusal(files);
}

TEST(OrbitFiles, OrbitsReadBackFromEveryFormatThatStatesThem) {
    int n_formats = 0;
    for (const Format& format : formats()) {
        if (!format.states_orbits) continue;
        ++n_formats;
        for (const plane::Tile& tile :
             {testing::grid_tile(kSquare, 2, 2), testing::grain_grid_tile(kSquare, 2, 2)}) {
            if (tile.kind == plane::MeshKind::kVoronoi && !format.holds_polygons) continue;
            const auto files = encoded("t" + std::string(format.extension), tile);
            const TileFile file = decode_tile(format, files, std::nullopt);
            EXPECT_THAT(file.site_orbits, ElementsAreArray(kOrbits)) << format.extension;
            EXPECT_NO_THROW(prove_orbit(files)) << format.extension;
        }
    }
    EXPECT_EQ(n_formats, 4);
}

TEST(OrbitFiles, TrianglesStateTheOrbitsOfAllSites) {
    const plane::Tile triangles = testing::triangle_grid_tile(kSquare, 2, 2);
    for (const char* path : {"t.obj", "t.msh", "t.inp"}) {
        const auto files = encoded(path, triangles);
        const TileFile file = decode_tile(*find_format(path), files, std::nullopt);
        EXPECT_THAT(file.site_orbits, ElementsAreArray(kOrbits)) << path;
        EXPECT_NO_THROW(prove_orbit(files)) << path;
    }
}

TEST(OrbitFiles, CommentsThatFitNoSitesAreRefused) {
    const plane::Tile grains = testing::grain_grid_tile(kSquare, 2, 2);
    for (const char* path : {"t.obj", "t.msh", "t.inp"}) {
        const auto files = encoded(path, grains);
        const auto fault = [&](const std::string& other) {
            return orbit_fault_with(files, "site_orbits 0 1 1 0\n", "site_orbits " + other + "\n");
        };
        EXPECT_THAT(fault("0 1 1"), HasSubstr("there are 3 orbits of 4 sites")) << path;
        EXPECT_THAT(fault("0 1 1 0 0"), HasSubstr("there are 5 orbits of 4 sites")) << path;
        EXPECT_THAT(fault("0 2 2 0"), HasSubstr("not counted in the order")) << path;
        EXPECT_THAT(fault("0 1 -1 0"), HasSubstr("not counted in the order")) << path;
        EXPECT_THAT(fault("0 1 x 0"), HasSubstr("x")) << path;
    }
}

TEST(OrbitFiles, SetsAndViewsAgreeWithTheComment) {
    const plane::Tile grains = testing::grain_grid_tile(kSquare, 2, 2);
    const auto inp = encoded("t.inp", grains);
    EXPECT_NE(orbit_fault_with(inp, "site_orbits 0 1 1 0\n", "site_orbits 0 1 1 1\n"), "");
    EXPECT_NE(orbit_fault_with(inp, "ORBIT_1\nCELL_1,CELL_2\n", "ORBIT_1\nCELL_1,CELL_3\n"), "");
    EXPECT_NE(orbit_fault_with(inp, "ELSET=ORBIT_1\n", "ELSET=ORBIT_7\n"), "");
    // A set of a user who has no symmetry.
    std::vector<EncodedFile> foreign =
        encode_tile(*find_format("t.inp"), grains, "t.inp", FileOptions{});
    foreign.front().bytes += "*ELSET,ELSET=ORBIT_1\nCELL_1,CELL_3\n";
    EXPECT_NO_THROW(prove_orbit(foreign));
    const auto msh = encoded("t.msh", grains);
    EXPECT_NE(orbit_fault_with(msh, "site_orbits 0 1 1 0\n", "site_orbits 0 1 1 1\n"), "");
    const std::string& text = msh.front().bytes;
    const std::string view = text.substr(text.find("$ElementData\n1\n\"orbit\""));
    const std::string first = view.substr(0, view.find("\n1 ") + 3);
    EXPECT_NE(orbit_fault_with(msh, first + "0\n", first + "1\n"), "");
}

TEST(OrbitFiles, CellsOfOneOrbitHaveOneArea) {
    const plane::PeriodicDelaunay delaunay(plane::Sites(kSquare, uniform_points(kSquare, 4, 3)));
    const plane::Tile cells = build_tile(delaunay, {}).tile;
    for (const char* path : {"t.obj", "t.vtu"}) {
        EXPECT_THAT(orbit_refusal(encoded(path, cells)),
                    HasSubstr("law of the orbits: the cells of sites "))
            << path;
    }
}

}  // namespace
}  // namespace pcvt
