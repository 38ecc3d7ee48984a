#include "mesher/plane/tessellation/tessellate.hpp"

#include <gmock/gmock.h>

#include <numbers>
#include <numeric>

#include "mesher/cells/target_areas.hpp"
#include "mesher/plane/symmetry/special_positions.hpp"
#include "mesher/plane/tessellation/tags.hpp"
#include "tests/support/example_lattices.hpp"

namespace pcvt::plane {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using testing::kSquare;
using ::testing::Lt;

CvtOptions three_steps() { return {.run = {.max_iterations = 3}}; }

double total(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Two fibres and a pore.
TaggedInclusions some_inclusions(std::vector<std::string> holes) {
    return {.shapes = {{Circle{{0.25, 0.25}, 0.15}, 1, 1},
                       {Circle{{0.75, 0.75}, 0.15}, 1, 2},
                       {Circle{{0.75, 0.25}, 0.1}, 2, 3}},
            .tag_names = {"matrix", "fibre", "pore"},
            .holes = std::move(holes)};
}

TEST(Tessellate, CellsBetweenWallsFillTheDomainOfTheUser) {
    for (const Walls walls : {Walls::kNone, Walls::kX, Walls::kXY}) {
        const Tessellation cells =
            tessellate(kSquare, {walls}, uniform_points(kSquare, 50, 1), three_steps());
        EXPECT_EQ(cells.n_sites(), 50);
        EXPECT_EQ(cells.lattice().area(), 1);
        EXPECT_NEAR(total(cells.table().measure), 1, 1e-12);
    }
}

TEST(Tessellate, PowerCellsHaveTheirAreas) {
    const Eigen::VectorXd areas =
        scaled_areas(draw_areas(parse_area_law("gamma:0.3"), 50, 1), 50, 1);
    for (const Walls walls : {Walls::kNone, Walls::kY}) {
        const Tessellation cells = tessellate(kSquare, {walls}, uniform_points(kSquare, 50, 1),
                                              AreaCvtOptions{.areas = areas});
        EXPECT_EQ(site_weights(cells).size(), 50);
        for (SiteId s = 0; s < 50; ++s) EXPECT_NEAR(cells.table().measure[s] / areas[s], 1, 1e-6);
    }
}

TEST(Tessellate, OrbitsAreCountedInTheOrderOfTheirFirstSites) {
    const PlaneGroup group(PlaneGroupName::kP4m, kSquare);
    const OrbitPlan plan = distribute(group, special_positions(group), 60);
    const Tessellation cells = tessellate(random_sites(group, plan, 1), three_steps());
    ASSERT_EQ(cells.site_orbits.size(), 60);
    int next = 0;
    for (const int orbit : cells.site_orbits) {
        EXPECT_LE(orbit, next);
        next = std::max(next, orbit + 1);
    }
    EXPECT_EQ(cells.n_orbits(), next);
}

TEST(Tessellate, TagsBecomePhasesOutsideOfHoles) {
    const Tessellation cells =
        tessellate(kSquare, {}, some_inclusions({"pore"}), 600, 1, three_steps());
    const CellMaterials materials = tag_materials(cells);
    EXPECT_THAT(materials.phase_names, ElementsAre("matrix", "fibre"));
    EXPECT_EQ(materials.site_phase.size(), wrapped_sites(cells, Vec2::Zero()).cols());
    EXPECT_THAT(materials.site_phase, Each(Lt(2)));
    EXPECT_EQ(cells.interfaces.value().shapes.size(), 3);
}

TEST(Tessellate, TagsOfNestedShapesHaveTheAreasOfTheRings) {
    const TaggedInclusions coated{
        .shapes = {{Circle{{0.5, 0.5}, 0.2}, 1, 1}, {Circle{{0.5, 0.5}, 0.25}, 2, 2}},
        .tag_names = {"matrix", "core", "coating"},
        .holes = {}};
    const Tessellation cells = tessellate(kSquare, {}, coated, 600, 1, three_steps());
    EXPECT_EQ(cells.interfaces.value().n_nested, 1);
    EXPECT_NEAR(total(cells.tag_areas), 1, 1e-12);
    EXPECT_NEAR(cells.tag_areas[2], 0.0225 * std::numbers::pi, 1e-12);
    for (const PhaseFigures& tag : tag_figures(cells)) {
        EXPECT_NEAR(tag.reached, tag.wanted, 1e-12) << tag.name;
    }
    // A hole has no shapes inside; one inside of a shape is as any other.
    const auto with_hole = [&](const char* hole) {
        TaggedInclusions holed = coated;
        holed.holes = {hole};
        return tessellate(kSquare, {}, holed, 600, 1, three_steps());
    };
    EXPECT_EQ(tag_materials(with_hole("core")).phase_names.size(), 2U);
    try {
        with_hole("coating");
        FAIL();
    } catch (const BadInclusion& fault) {
        EXPECT_STREQ(fault.what(),
                     "line 1: the shape lies in the hole coating of line 2; leave the shape or the "
                     "hole out");
    }
}

TEST(Tessellate, TagsReachTheAreasOfTheirShapes) {
    const Tessellation cells = tessellate(kSquare, {}, some_inclusions({}), 2000, 1, three_steps());
    EXPECT_NEAR(total(cells.tag_areas), 1, 1e-12);
    for (const PhaseFigures& tag : tag_figures(cells)) {
        EXPECT_NEAR(tag.reached / tag.wanted, 1, 0.05) << tag.name;
    }
}

}  // namespace
}  // namespace pcvt::plane
