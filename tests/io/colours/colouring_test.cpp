#include "io/colours/colouring.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesher/base/error.hpp"
#include "tests/support/grid_tile.hpp"

namespace pcvt {
namespace {

using testing::grid_tile;

CellMaterials phases_of(int n_phases, int n_sites) {
    CellMaterials materials;
    for (int k = 0; k < n_phases; ++k) materials.phase_names.push_back("p" + std::to_string(k));
    for (int s = 0; s < n_sites; ++s) materials.site_phase.push_back(s * s % n_phases);
    return materials;
}

TEST(Colouring, ByPhaseEachCellHasTheClassOfItsPhase) {
    const plane::Tile tile = grid_tile(plane::Lattice::rectangle(1, 1), 4, 4);
    const CellMaterials materials = phases_of(3, 16);
    const TileColours colours = tile_colours(tile, Colouring::kPhase, {.materials = &materials});
    ASSERT_EQ(colours.classes.size(), 3U);
    for (int f = 0; f < tile.n_faces(); ++f) {
        EXPECT_EQ(colours.class_of[f], materials.site_phase[tile.face_site[f]]);
    }
    // Squares modulo 3: six zeros, ten ones, no two.
    EXPECT_EQ(colours.classes[0].label, "p0: 6");
    EXPECT_EQ(colours.classes[1].label, "p1: 10");
    EXPECT_EQ(colours.classes[2].label, "p2: 0");
    EXPECT_EQ(colours.classes[1].name, "phase_p1");
    EXPECT_NE(hex(colours.classes[0].colour), hex(colours.classes[1].colour));
}

TEST(Colouring, ByTagCellsHaveTheColoursOfTheirPhasesUnderAnotherTitle) {
    const plane::Tile tile = grid_tile(plane::Lattice::rectangle(1, 1), 4, 4);
    const CellMaterials tags = phases_of(3, 16);
    const TileColours by_tag = tile_colours(tile, Colouring::kTag, {.materials = &tags});
    const TileColours by_phase = tile_colours(tile, Colouring::kPhase, {.materials = &tags});
    EXPECT_EQ(by_tag.class_of, by_phase.class_of);
    EXPECT_EQ(by_tag.explanation, " by tag");
    EXPECT_THROW(tile_colours(tile, Colouring::kTag, {}), InternalError);
}

TEST(Colouring, ByOrbitEachCellHasTheClassOfItsOrbit) {
    const plane::Tile tile = grid_tile(plane::Lattice::rectangle(1, 1), 4, 4);
    // The mirror that exchanges columns 1 and 3.
    const std::vector<int> column{0, 1, 2, 1};
    std::vector<int> orbits;
    for (int s = 0; s < 16; ++s) orbits.push_back(3 * (s / 4) + column[s % 4]);
    const TileColours colours = tile_colours(tile, Colouring::kOrbit, {.orbits = orbits});
    ASSERT_EQ(colours.classes.size(), 12U);
    for (int f = 0; f < tile.n_faces(); ++f) {
        EXPECT_EQ(colours.class_of[f], orbits[tile.face_site[f]]);
    }
    EXPECT_EQ(colours.classes[1].name, "orbit_1");
    EXPECT_NE(hex(colours.classes[0].colour), hex(colours.classes[1].colour));
    // Seven colours would not name twelve orbits.
    EXPECT_EQ(colours.classes[1].label, "");
    for (int& orbit : orbits) orbit %= 3;
    const TileColours few = tile_colours(tile, Colouring::kOrbit, {.orbits = orbits});
    EXPECT_EQ(few.classes[0].label, "orbit 0: 4");
    EXPECT_EQ(few.classes[1].label, "orbit 1: 8");
}

TEST(Colouring, ByOrientationCellsHaveTheirColoursOfTheInversePoleFigure) {
    const plane::Tile tile = grid_tile(plane::Lattice::rectangle(1, 1), 2, 2);
    const CellMaterials materials{
        .site_orientation = {{0, 0, 0}, {0, 45, 0}, {30, 0, 0}, {0, 54.735610317245346, 45}}};
    const TileColours colours =
        tile_colours(tile, Colouring::kOrientation, {.materials = &materials});
    const std::vector<std::string> expected{"#ff0000", "#00ff00", "#ff0000", "#0000ff"};
    for (int f = 0; f < tile.n_faces(); ++f) {
        EXPECT_EQ(hex(colours.classes[colours.class_of[f]].colour), expected[tile.face_site[f]]);
    }
    EXPECT_EQ(colours.classes.size(), 3U);
    EXPECT_EQ(default_picture_colouring(tile, {.materials = &materials}), Colouring::kOrientation);
    EXPECT_THROW(tile_colours(tile, Colouring::kOrientation, {}), InternalError);
}

TEST(Colouring, AQuantityThatIsMissingIsAFaultOfTheCaller) {
    const plane::Tile tile = grid_tile(plane::Lattice::rectangle(1, 1), 4, 4);
    EXPECT_THROW(tile_colours(tile, Colouring::kPhase, {}), InternalError);
    EXPECT_THROW(tile_colours(tile, Colouring::kDensity, {}), InternalError);
    EXPECT_THROW(tile_colours(tile, Colouring::kOrbit, {}), InternalError);
    const CellMaterials only_orientations{.site_orientation = {{1, 2, 3}}};
    EXPECT_THROW(tile_colours(tile, Colouring::kPhase, {.materials = &only_orientations}),
                 InternalError);
}

TEST(Colouring, PicturesShowPhasesWhereThereAreSome) {
    const plane::Tile tile = grid_tile(plane::Lattice::rectangle(1, 1), 4, 4);
    const CellMaterials materials = phases_of(2, 16);
    EXPECT_EQ(default_picture_colouring(tile, {.materials = &materials}), Colouring::kPhase);
    EXPECT_EQ(default_picture_colouring(tile, {}), Colouring::kSides);
}

}  // namespace
}  // namespace pcvt
