#include "io/colours/cell_colours.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "io/colours/pole_colours.hpp"
#include "io/colours/site_classes.hpp"
#include "mesher/base/error.hpp"
#include "mesher/cells/orientations.hpp"

namespace pcvt {
namespace {

const ColourClass& class_of(const TileColours& colours, int cell) {
    return colours.classes[colours.class_of[cell]];
}

TEST(CellColours, OfFacesAreThoseOfSidesWithEightMore) {
    const TileColours colours = cell_colours(Colouring::kFaces, {.n_faces = {14, 12, 14, 17}});
    EXPECT_EQ(colours.classes.size(), 3U);
    EXPECT_EQ(class_of(colours, 0).name, "faces_14");
    EXPECT_EQ(class_of(colours, 0).label, "14 faces: 2");
    EXPECT_EQ(hex(class_of(colours, 0).colour), hex(side_colour(6)));
    EXPECT_EQ(hex(class_of(colours, 3).colour), hex(side_colour(9)));
}

TEST(CellColours, OfSizesAreClassesOfTheDiameterOverTheMean) {
    // Diameters 1, 2 and 2 times one length, in cells of the mean volume 17 / 3.
    const TileColours colours =
        cell_colours(Colouring::kSize, {.n_faces = {4, 4, 4}, .volumes = {8, 1, 8}});
    EXPECT_EQ(colours.class_of[0], colours.class_of[2]);
    EXPECT_LT(colours.class_of[1], colours.class_of[0]);
    for (const int cell : {0, 1}) {
        const double size = std::cbrt((cell == 0 ? 8.0 : 1.0) * 3 / 17);
        double least = 0;
        double most = 0;
        ASSERT_EQ(std::sscanf(class_of(colours, cell).label.c_str(), "%lf to %lf h", &least, &most),
                  2);
        EXPECT_LE(least, size * 1.01);
        EXPECT_GE(most, size * 0.99);
    }
}

TEST(CellColours, OfOrientationsAreThoseOfThePoleFigureRounded) {
    CellMaterials materials{.site_orientation = random_orientations(3000, 3)};
    materials.site_orientation.push_back({0, 0, 0});
    const TileColours colours = cell_colours(
        Colouring::kOrientation, {.n_faces = std::vector<int>(3001, 14), .materials = &materials});
    EXPECT_LE(colours.classes.size(), 867U);
    for (int s = 0; s < 3001; ++s) {
        const auto exact = pole_colour(materials.site_orientation[s]);
        const Colour& shown = class_of(colours, s).colour;
        EXPECT_NEAR(255 * shown.r, exact[0], 7.51);
        EXPECT_NEAR(255 * shown.g, exact[1], 7.51);
        EXPECT_NEAR(255 * shown.b, exact[2], 7.51);
    }
    EXPECT_EQ(class_of(colours, 3000).name, "ipf_ff0000");
    std::set<std::string> names;
    for (const ColourClass& shown : colours.classes) names.insert(shown.name);
    EXPECT_EQ(names.size(), colours.classes.size());
}

TEST(CellColours, OfPhasesHaveTheirNames) {
    const CellMaterials materials{.phase_names = {"a", "b"}, .site_phase = {1, 0, 1}};
    const TileColours colours =
        cell_colours(Colouring::kPhase, {.n_faces = {4, 4, 4}, .materials = &materials});
    EXPECT_EQ(class_of(colours, 0).name, "phase_b");
    EXPECT_EQ(class_of(colours, 0).label, "b: 2");
    EXPECT_EQ(class_of(colours, 1).name, "phase_a");
}

TEST(CellColours, OfThePlaneAreRefused) {
    for (const ColouringRow& row : kColourings) {
        if (row.in_space) continue;
        EXPECT_THROW(cell_colours(row.colouring, {.n_faces = {4}}), InternalError) << row.word;
    }
}

TEST(CellColours, OfNeighboursDifferWhereSevenSuffice) {
    // A complete graph of seven nodes, in both orders, with loops and pairs twice.
    std::vector<std::pair<SiteId, SiteId>> pairs;
    for (SiteId s = 0; s < 7; ++s) {
        for (SiteId t = 0; t < 7; ++t) pairs.emplace_back(s, t);
    }
    const std::vector<int> classes = classes_of_neighbours(pairs, 7);
    EXPECT_EQ(std::set<int>(classes.begin(), classes.end()).size(), 7U);
    EXPECT_EQ(classes_of_neighbours({{0, 0}}, 1), (std::vector<int>{0}));
}

}  // namespace
}  // namespace pcvt
