#include "mesher/space/grains/face_triangulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "tests/support/random_numbers.hpp"

namespace pcvt::space {
namespace {

constexpr FaceLimits kLimits{.radius = 0.3, .sine = 0.37, .most_points = 4000};

double cross(const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); }

double area(const Point2& a, const Point2& b, const Point2& c) { return cross(b - a, c - a) / 2; }

/// Corners on a circle or, flattened, on an ellipse, with points on the sides.
std::vector<Point2> random_polygon(std::mt19937_64& random) {
    const int n = testing::random_integer(random, 3, 8);
    const double flatness = testing::random_integer(random, 0, 1) == 0 ? 1 : 0.2;
    std::vector<double> angles;
    for (int k = 0; k < n; ++k) {
        angles.push_back((k + 0.8 * testing::random_number(random)) * 2 * std::numbers::pi / n);
    }
    const auto corner = [&](int k) {
        return Point2(std::cos(angles[k]), flatness * std::sin(angles[k]));
    };
    std::vector<Point2> points;
    for (int k = 0; k < n; ++k) {
        const Point2 a = corner(k);
        const Point2 b = corner((k + 1) % n);
        const int parts = testing::random_integer(random, 1, 4);
        for (int i = 0; i < parts; ++i) points.push_back(a + (b - a) * i / parts);
    }
    return points;
}

/// Law (1).
void expect_cover(const FaceTriangulation& face) {
    const int n = face.n_boundary();
    std::set<std::pair<int, int>> edges;
    double sum = 0;
    for (const auto& t : face.triangles()) {
        const double part = area(face.points()[t[0]], face.points()[t[1]], face.points()[t[2]]);
        EXPECT_GT(part, 0);
        sum += part;
        for (int k = 0; k < 3; ++k) {
            EXPECT_TRUE(edges.emplace(t[k], t[(k + 1) % 3]).second) << "an edge occurs twice";
        }
    }
    double whole = 0;
    for (int k = 0; k < n; ++k) {
        EXPECT_TRUE(edges.contains({k, (k + 1) % n}));
        EXPECT_FALSE(edges.contains({(k + 1) % n, k}));
        whole += cross(face.points()[k], face.points()[(k + 1) % n]) / 2;
    }
    const auto n_open = std::count_if(edges.begin(), edges.end(), [&](const auto& e) {
        return !edges.contains({e.second, e.first});
    });
    EXPECT_EQ(n_open, n);
    EXPECT_NEAR(sum, whole, 1e-12);
}

double radius(const FaceTriangulation& face, const std::array<int, 3>& t, Point2& centre) {
    const Point2 a = face.points()[t[0]];
    const Point2 b = face.points()[t[1]] - a;
    const Point2 c = face.points()[t[2]] - a;
    const double d = 2 * cross(b, c);
    const double bb = b.squaredNorm();
    const double cc = c.squaredNorm();
    const Point2 arm((c.y() * bb - b.y() * cc) / d, (b.x() * cc - c.x() * bb) / d);
    centre = a + arm;
    return arm.norm();
}

TEST(FaceTriangulation, CoversThePolygonAfterEachStep) {
    std::mt19937_64 random(1);
    for (int k = 0; k < 200; ++k) {
        SCOPED_TRACE(k);
        FaceTriangulation face(random_polygon(random));
        expect_cover(face);
        face.refine(kLimits);
        expect_cover(face);
        face.improve();
        expect_cover(face);
    }
}

/// Law (2).
TEST(FaceTriangulation, KeepsTheLimitsAwayFromSegmentsThatStopIt) {
    std::mt19937_64 random(2);
    for (int k = 0; k < 200; ++k) {
        SCOPED_TRACE(k);
        FaceTriangulation face(random_polygon(random));
        const std::vector<int> obstacles = face.refine(kLimits);
        const int n = face.n_boundary();
        EXPECT_TRUE(std::is_sorted(obstacles.begin(), obstacles.end()));
        for (const auto& t : face.triangles()) {
            Point2 centre;
            const double r = radius(face, t, centre);
            const double sine =
                smallest_sine(face.points()[t[0]], face.points()[t[1]], face.points()[t[2]]);
            if (r <= kLimits.radius && sine >= kLimits.sine) continue;
            const bool is_stopped = std::any_of(obstacles.begin(), obstacles.end(), [&](int s) {
                const Point2 a = face.points()[s] - centre;
                const Point2 b = face.points()[(s + 1) % n] - centre;
                return a.dot(b) < 1e-9 || cross(a, b) < 1e-9;
            });
            EXPECT_TRUE(is_stopped);
        }
    }
}

/// A side with points that come as close as `least` to its ends.
void add_side(const Point2& a, const Point2& b, double least, std::vector<Point2>& points) {
    points.push_back(a);
    std::vector<double> cuts;
    for (double cut = 0.4; cut > least; cut /= 1.8) cuts.push_back(cut);
    for (auto cut = cuts.rbegin(); cut != cuts.rend(); ++cut) points.push_back(a + *cut * (b - a));
    for (const double cut : cuts) points.push_back(b + cut * (a - b));
}

/// Two sides that are one straight line up to 1e-9, and whose points come as close to its ends.
TEST(FaceTriangulation, HasNoTriangleWithPointsOfTwoSidesOfOneLine) {
    std::vector<Point2> points;
    add_side({0, 0}, {0.5, -1e-9}, 1e-9, points);
    add_side({0.5, -1e-9}, {1, 0}, 1e-9, points);
    points.insert(points.end(), {{1.2, 1}, {-0.2, 1}});
    const FaceTriangulation face(points);
    expect_cover(face);
    for (const auto& t : face.triangles()) {
        EXPECT_GT(smallest_sine(face.points()[t[0]], face.points()[t[1]], face.points()[t[2]]),
                  1e-10);
    }
}

TEST(FaceTriangulation, ImprovementsWidenTheSmallestAngle) {
    std::mt19937_64 random(3);
    const auto worst = [](const FaceTriangulation& face) {
        double least = 1;
        for (const auto& t : face.triangles()) {
            least = std::min(least, smallest_sine(face.points()[t[0]], face.points()[t[1]],
                                                  face.points()[t[2]]));
        }
        return least;
    };
    double gain = 0;
    for (int k = 0; k < 50; ++k) {
        FaceTriangulation face(random_polygon(random));
        face.refine(kLimits);
        const double before = worst(face);
        face.improve();
        EXPECT_GE(worst(face), before);
        gain += worst(face) - before;
    }
    EXPECT_GT(gain, 1);
}

TEST(FaceTriangulation, StopsAtTheLargestNumberOfPoints) {
    FaceTriangulation face({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    face.refine({.radius = 0.01, .sine = 0.3, .most_points = 50});
    EXPECT_LE(face.points().size(), 50u);
    expect_cover(face);
}

}  // namespace
}  // namespace pcvt::space
