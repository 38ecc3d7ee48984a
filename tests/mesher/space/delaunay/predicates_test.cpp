#include "mesher/space/delaunay/predicates.hpp"

#include <CGAL/MP_Float.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "tests/support/space_lattices.hpp"

namespace pcvt::space {
namespace {

using Exact = CGAL::MP_Float;
using Corners = std::array<Image, 5>;

/// Images on a coarse grid of all 2^-k, so that many are coplanar and cospherical, some of them
/// displaced by a few units of the last place.
Corners random_images(std::mt19937_64& random) {
    Corners images;
    const double grid = std::ldexp(1, int(random() % 3) + 1);
    const std::uint64_t n_values = random() % 2 == 0 ? 3 : 9;
    const bool displaced = random() % 2 == 0;
    for (int k = 0; k < 5; ++k) {
        for (int axis = 0; axis < 3; ++axis) {
            double& x = images[k].at[axis];
            x = double(random() % n_values) / grid - 1;
            if (displaced) x += (double(random() % 5) - 2) / kGrid;
        }
        images[k].name = {k, {}};
    }
    return images;
}

struct ExactVector {
    Exact x, y, z, h;
};

ExactVector exact_vector(const Gram& g, const Image& from, const Image& to) {
    const Exact x = Exact(to.at.x()) - Exact(from.at.x());
    const Exact y = Exact(to.at.y()) - Exact(from.at.y());
    const Exact z = Exact(to.at.z()) - Exact(from.at.z());
    const Exact h = Exact(g.aa) * x * x + Exact(g.bb) * y * y + Exact(g.cc) * z * z +
                    Exact(2) * (Exact(g.ab) * x * y + Exact(g.ac) * x * z + Exact(g.bc) * y * z);
    return {x, y, z, h};
}

Exact exact_determinant(const ExactVector& p, const ExactVector& q, const ExactVector& r) {
    return p.x * (q.y * r.z - q.z * r.y) - p.y * (q.x * r.z - q.z * r.x) +
           p.z * (q.x * r.y - q.y * r.x);
}

int exact_orientation(const Corners& c) {
    const Gram g{1, 0, 0, 1, 0, 1};
    return CGAL::sign(exact_determinant(exact_vector(g, c[0], c[1]), exact_vector(g, c[0], c[2]),
                                        exact_vector(g, c[0], c[3])));
}

/// The height of the fifth point above the lifted hyperplane of the others, by the first of them.
int exact_in_sphere(const Gram& g, const Corners& c) {
    const auto p = exact_vector(g, c[0], c[1]);
    const auto q = exact_vector(g, c[0], c[2]);
    const auto r = exact_vector(g, c[0], c[3]);
    const auto t = exact_vector(g, c[0], c[4]);
    const Exact value = t.h * exact_determinant(p, q, r) - p.h * exact_determinant(t, q, r) -
                        q.h * exact_determinant(p, t, r) - r.h * exact_determinant(p, q, t);
    return -CGAL::sign(value);
}

std::vector<Gram> grams() {
    std::vector<Gram> all;
    for (const auto& [name, lattice] : testing::space_lattices()) {
        all.push_back(gram_of(reduce(lattice).reduced));
    }
    return all;
}

TEST(Gram, IsTheMetricInUnitsOfTheShortestPeriod) {
    for (const auto& [name, lattice] : testing::space_lattices()) {
        SCOPED_TRACE(name);
        const Lattice reduced = reduce(lattice).reduced;
        const Gram gram = gram_of(reduced);
        EXPECT_GE(gram.aa, 0.25);
        EXPECT_LT(gram.aa, 1);
        const double per_unit = gram.aa / reduced.a().squaredNorm();
        const Vec3 u(0.3, -0.7, 1.1);
        EXPECT_NEAR(gram.squared_length(u.x(), u.y(), u.z()),
                    per_unit * reduced.to_position(u).squaredNorm(),
                    1e-13 * gram.squared_length(u.x(), u.y(), u.z()));
    }
}

TEST(Orientation3, EqualsMultiprecision) {
    std::mt19937_64 random(1);
    int n_zero = 0;
    for (int k = 0; k < 20'000; ++k) {
        const Corners c = random_images(random);
        const int expected = exact_orientation(c);
        n_zero += expected == 0 ? 1 : 0;
        EXPECT_EQ(orientation(c[0], c[1], c[2], c[3]), expected);
        EXPECT_EQ(orientation(c[1], c[0], c[2], c[3]), -expected);
    }
    EXPECT_GT(n_zero, 100);
}

TEST(InSphere, EqualsMultiprecision) {
    std::mt19937_64 random(2);
    int n_zero = 0;
    for (const Gram& gram : grams()) {
        for (int k = 0; k < 2'000; ++k) {
            Corners c = random_images(random);
            if (exact_orientation(c) == 0) continue;
            if (exact_orientation(c) < 0) std::swap(c[0], c[1]);
            const int expected = exact_in_sphere(gram, c);
            n_zero += expected == 0 ? 1 : 0;
            EXPECT_EQ(in_sphere(gram, c[0], c[1], c[2], c[3], c[4]), expected);
        }
    }
    EXPECT_GT(n_zero, 100);
}

TEST(InSphere, CentreIsInside) {
    const auto at = [](double x, double y, double z) { return Image{{x, y, z}, {0, {}}}; };
    const Gram cube = gram_of(Lattice::box(1, 1, 1));
    EXPECT_GT(
        in_sphere(cube, at(0, 0, 0), at(1, 0, 0), at(0, 1, 0), at(0, 0, 1), at(0.25, 0.25, 0.25)),
        0);
}

TEST(InSphere, TranslationsChangeNothing) {
    std::mt19937_64 random(3);
    for (const Gram& gram : grams()) {
        for (int k = 0; k < 200; ++k) {
            const Corners c = random_images(random);
            Corners moved = c;
            for (Image& image : moved) image.at += Vec3(-1, 2, 1);
            if (orientation(c[0], c[1], c[2], c[3]) <= 0) continue;
            EXPECT_EQ(violates_delaunay(gram, c[0], c[1], c[2], c[3], c[4]),
                      violates_delaunay(gram, moved[0], moved[1], moved[2], moved[3], moved[4]));
        }
    }
}

/// The two triangulations of the hull of five points are complementary: the rule picks one.
TEST(ViolatesDelaunay, PicksOneOfTwoTriangulations) {
    std::mt19937_64 random(4);
    int n_ties = 0;
    for (int k = 0; k < 20'000; ++k) {
        const Gram gram{1, 0, 0, 1, 0, 1};
        Corners c = random_images(random);
        if (orientation(c[0], c[1], c[2], c[3]) <= 0) continue;
        // The facet opposite to corner 0 with the fifth point beyond it.
        if (orientation(c[1], c[3], c[2], c[4]) >= 0) continue;
        const int tie = in_sphere(gram, c[0], c[1], c[2], c[3], c[4]) == 0 ? 1 : 0;
        n_ties += tie;
        EXPECT_EQ(violates_delaunay(gram, c[0], c[1], c[2], c[3], c[4]),
                  violates_delaunay(gram, c[4], c[1], c[3], c[2], c[0]));
    }
    EXPECT_GT(n_ties, 20);
}

TEST(InCoplanarCircle, MeasuresInTheMetric) {
    const auto at = [](double x, double y, double z) { return Image{{x, y, z}, {0, {}}}; };
    for (const Gram& gram : {Gram{1, 0, 0, 1, 0, 1}, Gram{1, 0, 0, 1, 0, 100}}) {
        const Image p = at(0, 0, 0);
        const Image q = at(1, 0, 0.5);
        const Image r = at(0, 1, 0);
        EXPECT_EQ(in_coplanar_circle(gram, p, q, r, at(1, 1, 0.5)), 0);
        EXPECT_EQ(in_coplanar_circle(gram, p, r, q, at(1, 1, 0.5)), 0);
        EXPECT_EQ(in_coplanar_circle(gram, p, q, r, at(0.5, 0.5, 0.25)), 1);
        EXPECT_EQ(in_coplanar_circle(gram, p, r, q, at(0.5, 0.5, 0.25)), 1);
        EXPECT_EQ(in_coplanar_circle(gram, p, q, r, at(1.5, 1.5, 0.75)), -1);
    }
}

TEST(Circumcentre3, IsEquidistant) {
    std::mt19937_64 random(5);
    for (const Gram& gram : grams()) {
        for (int k = 0; k < 100; ++k) {
            const Corners c = random_images(random);
            if (std::abs(orientation(c[0], c[1], c[2], c[3])) == 0) continue;
            Eigen::Matrix3d edges;
            for (int e = 0; e < 3; ++e) edges.col(e) = c[e + 1].at - c[0].at;
            if (std::abs(edges.determinant()) < 1e-3) continue;
            const Vec3 centre = c[0].at + circumcentre(gram, c[0], c[1], c[2], c[3]);
            const auto distance = [&](int corner) {
                const Vec3 d = c[corner].at - centre;
                return gram.squared_length(d.x(), d.y(), d.z());
            };
            for (int corner = 1; corner < 4; ++corner) {
                EXPECT_NEAR(distance(corner), distance(0), 1e-10 * (gram.cc + distance(0)));
            }
        }
    }
}

}  // namespace
}  // namespace pcvt::space
