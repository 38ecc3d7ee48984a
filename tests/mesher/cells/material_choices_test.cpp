#include "mesher/cells/material_choices.hpp"

#include <gmock/gmock.h>

#include "mesher/base/error.hpp"
#include "mesher/cells/orientations.hpp"
#include "mesher/plane/mesh/cell_measures.hpp"
#include "mesher/plane/mesh/voronoi.hpp"

namespace pcvt::plane {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

CellTable few_cells(int n) {
    const Lattice square = Lattice::rectangle(1, 1);
    return cell_table(cell_mesh(PeriodicDelaunay(Sites(square, uniform_points(square, n, 3)))));
}

TEST(MaterialChoices, NothingChosenIsNothing) {
    EXPECT_TRUE(choose_materials({}, few_cells(5), 1).empty());
    EXPECT_TRUE(MaterialChoices{}.empty());
}

TEST(MaterialChoices, GivenOrientationsBelongToTheSitesInTheirOrder) {
    const std::vector<BungeAngles> given{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
    const MaterialChoices choices{.orientations = given};
    const CellMaterials materials = choose_materials(choices, few_cells(3), 1);
    EXPECT_EQ(materials.site_orientation, given);
    EXPECT_TRUE(phase_figures(choices, materials, few_cells(3)).empty());
    EXPECT_THAT([&] { choose_materials(choices, few_cells(4), 1); },
                ThrowsMessage<InvalidInput>(
                    HasSubstr("3 orientations for 4 sites; give one for each site")));
}

TEST(MaterialChoices, ListsAreLongerThanTheSitesOrHaveWeights) {
    const std::vector<BungeAngles> list = random_orientations(9, 1);
    MaterialChoices choices{.orientations = list};
    const auto drawn = [&](int n, std::uint64_t seed) {
        return choose_materials(choices, few_cells(n), seed).site_orientation;
    };
    EXPECT_EQ(drawn(9, 1), list);
    EXPECT_EQ(drawn(5, 1).size(), 5U);
    EXPECT_EQ(drawn(5, 1), drawn(5, 1));
    EXPECT_NE(drawn(5, 1), drawn(5, 2));
    EXPECT_THAT([&] { drawn(10, 1); },
                ThrowsMessage<InvalidInput>(HasSubstr("9 orientations for 10 sites; give one for "
                                                      "each site, or a list to draw from")));
    choices.orientation_weights = {0, 0, 3, 0, 0, 0, 0, 0, 0};
    EXPECT_EQ(drawn(12, 1), std::vector<BungeAngles>(12, list[2]));
    EXPECT_EQ(drawn(9, 1), std::vector<BungeAngles>(9, list[2]));
}

TEST(MaterialChoices, FiguresAreThoseOfTheCells) {
    const CellTable cells = few_cells(40);
    const MaterialChoices choices{.phases = parse_phases("a:0.25,b:0.75"),
                                  .draws_orientations = true};
    const CellMaterials materials = choose_materials(choices, cells, 5);
    EXPECT_EQ(materials.phase_names, (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(materials.site_orientation, random_orientations(40, 5));
    const std::vector<PhaseFigures> figures = phase_figures(choices, materials, cells);
    ASSERT_EQ(figures.size(), 2u);
    double area = 0;
    int count = 0;
    for (SiteId s = 0; s < 40; ++s) {
        if (materials.site_phase[s] != 1) continue;
        area += cells.measure[s];
        ++count;
    }
    EXPECT_EQ(figures[1].name, "b");
    EXPECT_EQ(figures[1].wanted, 0.75);
    EXPECT_NEAR(figures[1].reached, area, 1e-12);
    EXPECT_EQ(figures[1].n_cells, count);
    EXPECT_EQ(figures[0].n_cells, 40 - count);
}

}  // namespace
}  // namespace pcvt::plane
