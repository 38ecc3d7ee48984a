#include "mesher/plane/interfaces/interface_sites.hpp"

#include <gtest/gtest.h>

#include "mesher/plane/interfaces/empty_circles.hpp"
#include "mesher/plane/mesh/interface_proof.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "tests/support/random_inclusions.hpp"

namespace pcvt::plane {
namespace {

struct Case {
    InclusionSet set;
    double h;
};

Case random_case(int seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    const double lean = 0.8 * unit(random);
    const Lattice lattice({1, 0}, {lean, 0.6 + unit(random)});
    const int n_shapes = 1 + int(30 * unit(random));
    const int n_across = int(5 * unit(random));
    const double fraction = 0.1 + 0.5 * unit(random);
    const auto list = testing::random_inclusions(lattice, {n_shapes, n_across, fraction}, random);
    return {InclusionSet(lattice, list),
            std::sqrt(lattice.area() / std::pow(10, 2 + 2 * unit(random)))};
}

InterfaceSites place(const Case& one) {
    return place_interface_sites(one.set, [&](const Vec2&) { return one.h; });
}

constexpr int kCases = 100;

// Law (1), against all seeds and their nearest images.
TEST(InterfaceSites, SlowCirclesHoldTheSeedsOfTheirChordsAndNoOther) {
    for (int seed = 0; seed < kCases; ++seed) {
        const Case one = random_case(seed);
        const InterfaceSites pairs = place(one);
        const Lattice& reduced = one.set.reduction().reduced;
        for (std::size_t c = 0; c < pairs.circles.size(); c += 41) {
            const EmptyCircle& circle = pairs.circles[c];
            int n_on = 0;
            for (int s = 0; s < pairs.n_seeds(); ++s) {
                for (int k = 0; k < 9; ++k) {
                    const Vec2 d =
                        pairs.coordinates.col(s) + Vec2(k % 3 - 1, k / 3 - 1) - circle.centre;
                    const double ratio = reduced.to_position(d).norm() / circle.radius;
                    const bool is_on = std::abs(ratio - 1) < 1e-9;
                    EXPECT_TRUE(is_on || ratio > 1.009) << seed << ": " << ratio;
                    n_on += is_on;
                }
            }
            EXPECT_TRUE(n_on == 4 || n_on == 3) << seed << ": " << n_on;
        }
    }
}

// Law (2), for any other sites.
TEST(InterfaceSites, SlowChordsAreEdgesAmongAnySitesOutsideOfTheCircles) {
    for (int seed = 0; seed < kCases; ++seed) {
        const Case one = random_case(seed);
        const InterfaceSites pairs = place(one);
        const Reduction& reduction = one.set.reduction();
        const EmptyCircles circles(reduction.reduced, pairs.circles);
        const Points points = uniform_points(one.set.lattice(), 500, std::uint64_t(seed));
        std::vector<Vec2> outside;
        for (const auto& p : points.colwise()) {
            const Vec2 u = reduction.reduced.to_lattice(p);
            if (!circles.contain(u))
                outside.emplace_back(wrap(u.x()).fraction, wrap(u.y()).fraction);
        }
        Points all(2, pairs.n_seeds() + std::ssize(outside));
        all.leftCols(pairs.n_seeds()) = pairs.coordinates;
        for (std::size_t k = 0; k < outside.size(); ++k) {
            all.col(pairs.n_seeds() + static_cast<Eigen::Index>(k)) = outside[k];
        }
        const PeriodicDelaunay delaunay(Sites(one.set.lattice(), reduction, all));
        EXPECT_TRUE(every_chord_is_an_edge(cell_mesh(delaunay), pairs.chords)) << seed;
    }
}

// Law (3).
TEST(InterfaceSites, SlowPolygonsOfChordsHaveTheAreasOfTheirShapes) {
    for (int seed = 0; seed < kCases; ++seed) {
        const Case one = random_case(seed);
        const InterfaceSites pairs = place(one);
        for (int k = 0; k < one.set.size(); ++k) {
            const double area = shape_area(one.set[k].shape);
            EXPECT_NEAR(polygon_area(pairs.polygons[k]) / area, 1, 1e-12);
        }
    }
}

// The mirror image is exact but for the rounding of coordinates to multiples of 2^-51.
TEST(InterfaceSites, SeedsAreMirroredInTheirChords) {
    for (int seed = 0; seed < kCases; ++seed) {
        const Case one = random_case(seed);
        const InterfaceSites pairs = place(one);
        const Lattice& reduced = one.set.reduction().reduced;
        for (const Chord& chord : pairs.chords) {
            const Vec2 inside = reduced.to_position(pairs.coordinates.col(chord.inside));
            const Vec2 outside = reduced.to_position(pairs.coordinates.col(chord.outside)) +
                                 one.set.lattice().translation(chord.offset);
            for (const Vec2& node : {chord.from, chord.to}) {
                EXPECT_NEAR((inside - node).norm(), (outside - node).norm(), 3e-15);
            }
            EXPECT_GT(cross(chord.to - chord.from, inside - chord.from), 0);
            EXPECT_EQ(pairs.inclusion[chord.inside], chord.inclusion);
            EXPECT_EQ(pairs.inclusion[chord.outside], -1);
        }
    }
}

// Each angle from 8 to 352 degrees, inside or outside of the polygon.
TEST(InterfaceSites, CornersOfAnyAngleAreResolved) {
    const Lattice unit = Lattice::rectangle(1, 1);
    for (int degrees = 8; degrees <= 172; degrees += 4) {
        const double half = degrees * std::numbers::pi / 360;
        const Vec2 tip(0.1, 0.4);
        const Vec2 up = tip + 0.35 * Vec2(std::cos(half), std::sin(half));
        const Vec2 down = tip + 0.35 * Vec2(std::cos(half), -std::sin(half));
        const double sharpest = std::min<double>(degrees, (180 - degrees) / 2);
        const Polygon notched{tip, down, {0.05, down.y() - 0.05}, {0.05, up.y() + 0.05}, up};
        for (const Polygon& polygon : {Polygon{tip, down, up}, notched}) {
            for (const double h : {0.3, 0.05, 0.01}) {
                const Case one{InclusionSet(unit, {{polygon, 1, 1}}), h};
                const InterfaceSites pairs = place(one);
                EXPECT_LT(pairs.n_seeds(), 100 + 20 / h + 2500 / sharpest) << degrees;
                EXPECT_NEAR(polygon_area(pairs.polygons[0]), shape_area(polygon), 1e-15);
            }
        }
    }
}

TEST(InterfaceSites, NarrowGapsStayOpen) {
    for (const double gap : {1e-2, 1e-3, 1e-4}) {
        const std::vector<Circle> circles{{{0.3, 0.5}, 0.1}, {{0.5 + gap, 0.5}, 0.1}};
        const Case one{InclusionSet(Lattice::rectangle(1, 1), circular_inclusions(circles, 1)),
                       0.03};
        const InterfaceSites pairs = place(one);
        EXPECT_LT(pairs.n_seeds(), 60 / std::sqrt(gap));
        EXPECT_FALSE(testing::shapes_meet(pairs.polygons[0], pairs.polygons[1], {0, 0}));
    }
}

TEST(InterfaceSites, ChordsAreAsLongAsTheSpacingWhereNothingIsNear) {
    const InclusionSet set(Lattice::rectangle(1, 1), {{Circle{{0.9, 0.1}, 0.3}, 1, 1}});
    const InterfaceSites pairs =
        place_interface_sites(set, [](const Vec2& p) { return p.x() < 0.9 ? 0.01 : 0.02; });
    for (const Chord& chord : pairs.chords) {
        const double length = (chord.to - chord.from).norm();
        const double x = chord.from.x() - std::floor(chord.from.x());
        if (x > 0.65 && x < 0.85) {
            EXPECT_NEAR(length, 0.01, 1e-3);
        } else if (x < 0.15 || x > 0.95) {
            EXPECT_NEAR(length, 0.02, 2e-3);
        }
    }
}

}  // namespace
}  // namespace pcvt::plane
