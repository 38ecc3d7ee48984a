#include "mesher/plane/interfaces/inclusion_set.hpp"

#include <gmock/gmock.h>

#include "tests/support/example_lattices.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/random_inclusions.hpp"

namespace pcvt::plane {
namespace {

using testing::kSquare;

Vec2 random_point(const Lattice& lattice, std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(-2, 2);
    const double u = unit(random);
    return lattice.to_position({u, unit(random)});
}

std::vector<Lattice> test_lattices() {
    return {kSquare, Lattice({1, 0}, {0.4, 0.7}), Lattice({1, 0}, {3.3, 1}),
            Lattice({0.3, 1.1}, {1, 0.2})};
}

/// Calls visit(translation) for the images near the domain.
template <class Visit>
void for_each_image(const Visit& visit) {
    for (int i = -12; i <= 12; ++i) {
        for (int j = -12; j <= 12; ++j) visit(Offset{i, j});
    }
}

// Law (2), against all images.
TEST(InclusionSet, FindsTheInclusionOfAnyImageOfAPoint) {
    std::mt19937_64 random(1);
    for (const Lattice& lattice : test_lattices()) {
        const auto list = testing::random_inclusions(lattice, {8, 4, 0.5}, random);
        const InclusionSet set(lattice, list);
        int n_inside = 0;
        for (int k = 0; k < 300; ++k) {
            const Vec2 p = random_point(lattice, random);
            int expected = -1;
            for_each_image([&](Offset o) {
                for (int i = 0; i < set.size(); ++i) {
                    const Vec2 q = p - lattice.translation(o);
                    if (signed_distance(list[i].shape, q) < 0) expected = i;
                }
            });
            EXPECT_EQ(set.containing(p), expected);
            EXPECT_EQ(set.containing(p + lattice.translation({2, -1})), expected);
            n_inside += expected >= 0;
        }
        EXPECT_GT(n_inside, 5);
    }
}

// Laws (2) and (4), against all images.
TEST(InclusionSet, TheInnermostShapeContainsAPoint) {
    std::mt19937_64 random(4);
    int n_nested = 0;
    for (const Lattice& lattice : test_lattices()) {
        auto list = testing::random_inclusions(lattice, {6, 4, 0.5}, random);
        // Two shapes in each round one, the first of them as an image.
        const std::size_t n = list.size();
        for (std::size_t k = 0; k < n; ++k) {
            if (std::holds_alternative<Polygon>(list[k].shape)) continue;
            const auto* const circle = std::get_if<Circle>(&list[k].shape);
            const EllipseAxes axes =
                circle ? ellipse_axes(*circle) : ellipse_axes(std::get<Ellipse>(list[k].shape));
            const Vec2 centre = axes.centre + 0.1 * axes.b * axes.along;
            list.push_back({Circle{centre + lattice.translation({3, -2}), axes.b / 2}, 1, 98});
            list.push_back({Ellipse{centre, axes.b / 4, axes.b / 8, 20}, 1, 99});
        }
        const InclusionSet set(lattice, list);
        for (int k = 0; k < 300; ++k) {
            const Vec2 p = random_point(lattice, random);
            int expected = -1;
            int around = -1;
            for_each_image([&](Offset o) {
                for (int i = 0; i < set.size(); ++i) {
                    if (!(signed_distance(list[i].shape, p - lattice.translation(o)) < 0)) continue;
                    const bool is_smaller = expected < 0 || shape_area(list[i].shape) <
                                                                shape_area(list[expected].shape);
                    around = is_smaller ? expected : around < 0 ? i : around;
                    if (is_smaller) expected = i;
                }
            });
            EXPECT_EQ(set.containing(p), expected);
            // Of two shapes around a point, the outer one is the parent of the inner one.
            EXPECT_EQ(expected >= 0 && set.parent(expected) >= 0, around >= 0);
            n_nested += around >= 0;
        }
    }
    EXPECT_GT(n_nested, 10);
}

TEST(InclusionSet, ParentsAreTheSmallestShapesAround) {
    const std::vector<Inclusion> list{
        {Circle{{0.5, 0.5}, 0.1}, 1, 1},
        {Polygon{{0.2, 0.2}, {0.8, 0.2}, {0.8, 0.8}, {0.2, 0.8}}, 2, 2},
        {Ellipse{{0.5, 0.5}, 0.2, 0.15, 40}, 1, 3},
        {Circle{{0.05, 0.05}, 0.1}, 1, 4},
        {Circle{{1.08, 1.05}, 0.02}, 3, 5}};
    const InclusionSet set(kSquare, list);
    for (const auto& [k, parent] : {std::pair(0, 2), {1, -1}, {2, 1}, {3, -1}, {4, 3}}) {
        EXPECT_EQ(set.parent(k), parent) << k;
    }
    EXPECT_EQ(set.containing({0.5, 0.5}), 0);
    EXPECT_EQ(set.containing({0.5, 0.64}), 2);
    EXPECT_EQ(set.containing({0.25, 0.25}), 1);
    EXPECT_EQ(set.containing({0.08, 0.05}), 4);
    // Between walls, images lie in images.
    const InclusionSet walled(kSquare, {list[0], list[1], list[2]}, Walls::kXY);
    for (int k = 0; k < walled.size(); ++k) {
        const int parent = set.parent(k % 3);
        EXPECT_EQ(walled.parent(k), parent < 0 ? -1 : parent + k / 3 * 3) << k;
    }
}

TEST(InclusionSet, MeasuresGapsToOtherShapesAndImages) {
    std::mt19937_64 random(2);
    for (const Lattice& lattice : test_lattices()) {
        const auto list = testing::random_inclusions(lattice, {5, 3, 0.5}, random);
        const InclusionSet set(lattice, list);
        for (int own = 0; own < set.size(); ++own) {
            for (const Vec2& p : testing::points_on(list[own].shape, 5)) {
                double least = 1;
                for_each_image([&](Offset o) {
                    for (int i = 0; i < set.size(); ++i) {
                        if (i == own && o == Offset{}) continue;
                        const Vec2 q = p - lattice.translation(o);
                        least = std::min(least, std::abs(signed_distance(list[i].shape, q)));
                    }
                });
                EXPECT_NEAR(set.distance_to_others(own, p, 1), least, 1e-14);
                EXPECT_EQ(set.distance_to_others(own, p, least / 2), least / 2);
            }
        }
    }
}

// Law (1), against all images.
TEST(InclusionSet, RefusesExactlyShapesThatMeetAnImage) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    int n_refused = 0;
    for (int k = 0; k < 400; ++k) {
        const Lattice lattice = test_lattices()[k % 4];
        std::vector<Inclusion> list;
        for (int i = 0; i < 2; ++i) {
            const double radius = std::sqrt(lattice.area()) * (0.05 + 0.5 * unit(random));
            list.push_back(
                {testing::random_shape(random_point(lattice, random), radius, random), 1, i + 3});
        }
        bool meets = false;
        for_each_image([&](Offset o) {
            const Vec2 t = lattice.translation(o);
            meets =
                meets || shape_relation(list[0].shape, list[1].shape, t) == ShapeRelation::kMeet;
            if (o == Offset{}) return;
            meets = meets || testing::shapes_meet(list[0].shape, list[0].shape, t) ||
                    testing::shapes_meet(list[1].shape, list[1].shape, t);
        });
        bool refused = false;
        try {
            const InclusionSet set(lattice, list);
        } catch (const InvalidInput&) {
            refused = true;
        }
        EXPECT_EQ(refused, meets) << k;
        n_refused += refused;
    }
    EXPECT_GT(n_refused, 100);
    EXPECT_LT(n_refused, 350);
}

TEST(InclusionSet, NamesTheLinesOfWhatItRefuses) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Inclusion good{Circle{{0.5, 0.5}, 0.1}, 1, 3};
    const std::vector<std::pair<Inclusion, std::string>> cases{
        {{Circle{{0, 0}, 0}, 1, 7}, "line 7: the radius must be positive"},
        {{Circle{{0, 0}, nan}, 1, 7}, "line 7: the radius must be positive"},
        {{Circle{{nan, 0}, 0.1}, 1, 7}, "line 7: a coordinate is not finite"},
        {{Circle{{0, 0}, 0.1}, 0, 7}, "line 7: the tag must be at least 1"},
        {{Ellipse{{0, 0}, 0.1, -0.1, 0}, 1, 7}, "line 7: both semi-axes must be positive"},
        {{Ellipse{{0, 0}, 0.1, 0.1, nan}, 1, 7}, "line 7: the angle is not finite"},
        {{Polygon{{0, 0}, {0.1, 0}}, 1, 7}, "line 7: a polygon needs at least three corners"},
        {{Polygon{{0, 0}, {0.1, 0}, {0.1, 0}, {0, 0.1}}, 1, 7},
         "line 7: corner 2 of the polygon repeats the next one"},
        {{Polygon{{0, 0}, {0.1, 0}, {0.2, 0}}, 1, 7},
         "line 7: corner 1 of the polygon is sharper than 3 degrees"},
        {{Polygon{{0, 0}, {0.1, 0.002}, {0.1, -0.002}}, 1, 7},
         "line 7: corner 1 of the polygon is sharper than 3 degrees"},
        {{Polygon{{0, 0.1}, {0.1, 0.1}, {0, 0.101}, {-0.1, 0.2}, {-0.1, 0}}, 1, 7},
         "line 7: corner 2 of the polygon is sharper than 3 degrees"},
        {{Polygon{{0, 0}, {0.1, 0.1}, {0.1, 0}, {0, 0.1}}, 1, 7},
         "line 7: the polygon has no area"},
        {{Polygon{{0, 0}, {0.2, 0}, {0, 0.1}, {0.1, 0.2}, {0.1, -0.1}}, 1, 7},
         "line 7: the polygon crosses or touches itself"},
        {{Circle{{0, 0}, 0.6}, 1, 7}, "line 7: the shape is larger than the domain"},
        {{Ellipse{{0, 0}, 100, 1e-4, 45}, 1, 7}, "line 7: the shape is larger than the domain"},
        {{Circle{{0, 0}, 0.5}, 1, 7}, "line 7: the shape meets an image of itself"},
        {{Circle{{1e12, 0}, 0.1}, 1, 7}, "line 7: the shape lies more than 2^30 periods away"},
        {{Circle{{2.5, -0.3}, 0.1}, 1, 7},
         "line 7: the shape overlaps that of line 3; move one of them"},
        {{Circle{{0.58, 0.5}, 0.02}, 1, 7},
         "line 7: the shape overlaps that of line 3; move one of them"},
        {{Circle{{1.5, 0.5}, 0.02}, 1, 7},
         "line 7: the shape lies on an image of that of line 3 but differs from it in size"},
    };
    for (const auto& [bad, message] : cases) {
        try {
            const InclusionSet set(kSquare, {good, bad});
            ADD_FAILURE() << "accepted: " << message;
        } catch (const InvalidInput& error) {
            EXPECT_THAT(error.what(), ::testing::StartsWith(message));
        }
    }
}

TEST(InclusionSet, RefusesShapesThatTouchAWall) {
    const Lattice box = Lattice::rectangle(2, 1);
    const std::vector<std::pair<Shape, const char*>> shapes{
        {Circle{{0.2, 0.5}, 0.2}, "wall_left"},
        {Circle{{1.9, 0.5}, 0.2}, "wall_right"},
        {Ellipse{{1, 0.2}, 0.1, 0.3, 10}, "wall_bottom"},
        {Polygon{{1, 0.5}, {1.3, 0.5}, {1.2, 1}}, "wall_top"},
        {Polygon{{1, -0.5}, {1.3, -0.5}, {1.2, -0.1}}, "wall_bottom"},
    };
    for (const auto& [shape, wall] : shapes) {
        try {
            const InclusionSet set(box, {{shape, 1, 7}}, Walls::kXY);
            ADD_FAILURE() << "accepted at " << wall;
        } catch (const InvalidInput& error) {
            const std::string message = std::string("line 7: the shape touches or crosses ") + wall;
            EXPECT_THAT(error.what(), ::testing::StartsWith(message));
        }
    }
    // Only walls matter.
    EXPECT_NO_THROW(InclusionSet(box, {{Circle{{0.2, 0.5}, 0.2}, 1, 1}}, Walls::kY));
    EXPECT_NO_THROW(InclusionSet(box, {{Ellipse{{1, 0.35}, 0.1, 0.3, 10}, 1, 1}}, Walls::kY));
}

TEST(InclusionSet, ContainsTheMirrorImagesOfShapesBetweenWalls) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> unit(-3, 3);
    for (int k = 0; k < 300; ++k) {
        const Walls walls = kWalls[1 + k % 3].walls;
        const Lattice domain = Lattice::rectangle(1.3, 1);
        const InclusionSet set(domain, testing::random_inclusions(domain, {.walls = walls}, random),
                               walls);
        EXPECT_EQ(set.size(), set.n_given() * n_images(walls));
        for (int m = 0; m < 20; ++m) {
            const Vec2 p(unit(random), unit(random));
            const int inside = set.containing(p);
            for (int r = 0; r < n_images(walls); ++r) {
                const int image = set.containing(mirror_image(p, walls, r));
                ASSERT_EQ(image < 0, inside < 0);
                if (inside >= 0) {
                    EXPECT_EQ(image % set.n_given(), inside % set.n_given());
                }
            }
        }
    }
}

TEST(InclusionSet, TurnsPolygonsCounterClockwise) {
    const InclusionSet set(kSquare, {{Polygon{{0, 0}, {0, 0.3}, {0.3, 0}}, 1, 1}});
    EXPECT_NEAR(polygon_area(std::get<Polygon>(set[0].shape)), 0.045, 1e-15);
}

TEST(InclusionSet, MayBeEmpty) {
    const InclusionSet set(kSquare, {});
    EXPECT_EQ(set.containing({0.3, 0.4}), -1);
}

}  // namespace
}  // namespace pcvt::plane
