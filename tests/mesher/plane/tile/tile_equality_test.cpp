#include "mesher/plane/tile/tile_equality.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/example_lattices.hpp"
#include "tests/support/grid_tile.hpp"

namespace pcvt::plane {
namespace {

using testing::grid_tile;
using testing::kOblique;
using testing::triangle_grid_tile;

/// The tile with its faces from the last to the first.
Tile faces_reversed(const Tile& tile) {
    Tile reversed = tile;
    reversed.faces = {};
    for (int f = tile.n_faces() - 1; f >= 0; --f) {
        reversed.faces.add(tile.faces[f]);
    }
    std::reverse(reversed.face_site.begin(), reversed.face_site.end());
    return reversed;
}

TEST(SameGeometry, TheOrderOfFacesDoesNotMatter) {
    for (const Tile& tile : {grid_tile(kOblique, 5, 6), triangle_grid_tile(kOblique, 3, 2)}) {
        const Tile reversed = faces_reversed(tile);
        EXPECT_NE(reversed.faces.corners, tile.faces.corners);
        EXPECT_TRUE(same_geometry(tile, tile));
        EXPECT_TRUE(same_geometry(reversed, tile));
        EXPECT_TRUE(same_geometry(tile, reversed));
    }
}

TEST(SameGeometry, NoNumberMayDiffer) {
    const Tile tile = grid_tile(kOblique, 5, 6);
    for (const bool in_order : {true, false}) {
        const Tile same = in_order ? tile : faces_reversed(tile);
        for (std::size_t c = 0; c < same.faces.corners.size(); ++c) {
            Tile other = same;
            other.faces.corners[c] = (other.faces.corners[c] + 1) % other.n_vertices();
            EXPECT_FALSE(same_geometry(other, tile)) << c;
        }
        for (std::size_t v = 0; v < same.points.size(); ++v) {
            Tile other = same;
            double& y = other.points[v].y();
            y = std::nextafter(y, std::numeric_limits<double>::infinity());
            EXPECT_FALSE(same_geometry(other, tile)) << v;
        }
    }
    Tile other = tile;
    other.lattice = Lattice({1, 0}, {0.37, std::nextafter(0.81, 1)});
    EXPECT_FALSE(same_geometry(other, tile));
}

TEST(SameGeometry, FacesMayBeNeitherRepeatedNorRegroupedNorLacking) {
    const Tile tile = grid_tile(kOblique, 5, 6);
    Tile repeated = tile;
    std::copy_n(tile.faces.corners.begin(), tile.faces.begin[1],
                repeated.faces.corners.begin() + tile.faces.begin[7]);
    EXPECT_FALSE(same_geometry(repeated, tile));
    Tile regrouped = tile;
    ++regrouped.faces.begin[3];
    EXPECT_FALSE(same_geometry(regrouped, tile));
    Tile lacking = tile;
    lacking.faces.begin.pop_back();
    lacking.faces.corners.resize(static_cast<std::size_t>(lacking.faces.begin.back()));
    EXPECT_FALSE(same_geometry(lacking, tile));
}

TEST(SameGeometry, FacesOutOfTheirListsAreNoFacesOfATile) {
    const Tile tile = grid_tile(kOblique, 2, 2);
    for (const int v : {-1, tile.n_vertices()}) {
        Tile outside = tile;
        outside.faces.corners.back() = v;
        EXPECT_FALSE(same_geometry(outside, tile));
    }
    Tile hollow = tile;
    hollow.faces.begin[1] = 0;
    EXPECT_FALSE(same_geometry(hollow, tile));
}

}  // namespace
}  // namespace pcvt::plane
