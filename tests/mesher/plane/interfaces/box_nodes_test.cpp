#include "mesher/plane/interfaces/box_nodes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "mesher/plane/interfaces/interface_sites.hpp"

namespace pcvt::plane {
namespace {

/// The distances between the sides of a family.
double spacing(const Lattice& lattice, int axis) {
    return lattice.area() / (axis == 0 ? lattice.b() : lattice.a()).norm();
}

/// The distance from the nearest side of a family.
double away_from_side(const InclusionSet& set, const Vec2& p, int axis) {
    const double at = *set.box_coordinate(p, axis);
    return (at - std::round(at)) * spacing(set.domain(), axis);
}

bool is_on_a_side(const InclusionSet& set, const Vec2& p) {
    return std::abs(away_from_side(set, p, 0)) < 1e-13 ||
           std::abs(away_from_side(set, p, 1)) < 1e-13;
}

bool is_corner(const Shape& shape, const Vec2& p) {
    const auto* polygon = std::get_if<Polygon>(&shape);
    return polygon != nullptr && std::any_of(polygon->begin(), polygon->end(),
                                             [&](const Vec2& q) { return (q - p).norm() < 1e-12; });
}

/// Expects that no node lies near to a place where a side crosses a chord beside it, unless the
/// angle is small, the node lies on a side, or it is a corner of the shape.
/// @returns the number of nodes on sides.
int expect_no_node_beside_a_side(const InclusionSet& set, const Polygon& nodes) {
    int n_on = 0;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const bool is_on = is_on_a_side(set, nodes[k]);
        n_on += is_on;
        if (is_on || is_corner(set[0].shape, nodes[k])) continue;
        for (int axis = 0; axis < 2; ++axis) {
            const double away = away_from_side(set, nodes[k], axis);
            for (const std::size_t other : {k + 1, k + nodes.size() - 1}) {
                const Vec2& q = nodes[other % nodes.size()];
                const double rise =
                    (*set.box_coordinate(q, axis) - *set.box_coordinate(nodes[k], axis)) *
                    spacing(set.domain(), axis);
                const bool is_steep = std::abs(rise) > 0.5 * (q - nodes[k]).norm();
                const double share = -away / rise;
                EXPECT_FALSE(is_steep && share > 0 && share < 0.12) << nodes[k].transpose();
            }
        }
    }
    return n_on;
}

/// A hexagon with corners that are not sharp.
Polygon hexagon(const Vec2& centre, double radius, double turn) {
    Polygon corners;
    for (int k = 0; k < 6; ++k) {
        const double t = turn + k * std::numbers::pi / 3;
        corners.push_back(centre + radius * Vec2(std::cos(t), std::sin(t)));
    }
    return corners;
}

TEST(BoxNodes, LieOnSidesOfTheBoxOrAwayFromThem) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> unit(0, 1);
    int n_on = 0;
    for (int k = 0; k < 600; ++k) {
        const Lattice lattice({1, 0}, {k % 3 == 0 ? 0 : 0.6 * unit(random), 0.8 + unit(random)});
        const Vec2 corner(unit(random), unit(random));
        // Through the centre, or anywhere.
        const Vec2 centre = k % 2 == 0 ? corner : Vec2(corner + Vec2(unit(random), unit(random)));
        const double radius = 0.1 + 0.2 * unit(random);
        Shape shape = Circle{centre, radius};
        if (k % 5 == 1) shape = Ellipse{centre, radius, 0.4 * radius, 360 * unit(random)};
        if (k % 5 == 2) shape = hexagon(centre, radius, unit(random));
        // A second shape in a gap makes chords of different lengths.
        const Vec2 beside = centre + lattice.to_position({0.5, 0.5});
        InclusionSet set(lattice, {{shape, 1, 1}, {Circle{beside, 0.05}, 1, 2}});
        set.set_box(corner);
        const double h = 0.02 + 0.06 * unit(random);
        const InterfaceSites sites = place_interface_sites(
            set, [&](const Vec2& p) { return h * (1 + 0.3 * std::sin(9 * p.x())); });
        n_on += expect_no_node_beside_a_side(set, sites.polygons[0]);
        EXPECT_NEAR(polygon_area(sites.polygons[0]), shape_area(shape), 1e-14);
    }
    EXPECT_GT(n_on, 300);
}

TEST(BoxNodes, AreTheUsualOnesWithoutABox) {
    const InclusionSet set(Lattice::rectangle(1, 1), {{Circle{{0.3, 0.4}, 0.2}, 1, 1}});
    const EllipseAxes ellipse = ellipse_axes(Circle{{0.3, 0.4}, 0.2});
    std::vector<double> degrees{0, 60, 130, 200, 290};
    const std::vector<double> before = degrees;
    slide_onto_box(set, ellipse, degrees);
    EXPECT_EQ(degrees, before);
    std::vector<double> places{0, 0.1, 0.2};
    slide_onto_box(set, {0, 0}, {1, 0}, places);
    EXPECT_EQ(places, (std::vector<double>{0, 0.1, 0.2}));
}

TEST(BoxNodes, SlideAlongALineUpToAFifthOfAChord) {
    InclusionSet set(Lattice::rectangle(1, 1), {});
    set.set_box({0.119, 0.5});
    std::vector<double> places{0, 0.1, 0.2, 0.3};
    slide_onto_box(set, {0, 0}, {1, 0}, places);
    EXPECT_NEAR(places[1], 0.119, 1e-15);
    EXPECT_EQ(places[2], 0.2);
    set.set_box({0.125, 0.5});
    places = {0, 0.1, 0.2, 0.3};
    slide_onto_box(set, {0, 0}, {1, 0}, places);
    EXPECT_EQ(places[1], 0.1);
}

}  // namespace
}  // namespace pcvt::plane
