#include "mesher/plane/delaunay/mirror_diagram.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "mesher/plane/delaunay/predicates.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/special_sites.hpp"

namespace pcvt::plane {
namespace {

using testing::lattices;
using testing::random_lattice;

/// Pieces smaller than this are touching corners, which exist or not depending on rounding.
constexpr double kNothing = 1e-13;

double area(const std::vector<Vec2>& polygon) {
    double doubled = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec2& p = polygon[k];
        const Vec2& q = polygon[(k + 1) % polygon.size()];
        doubled += p.x() * q.y() - p.y() * q.x();
    }
    return doubled / 2;
}

using Areas = std::map<std::pair<SiteId, Offset>, double>;

Areas areas(const std::vector<Piece>& pieces) {
    Areas areas;
    for (const Piece& piece : pieces) {
        const double size = area(piece.polygon);
        if (size > kNothing) areas[{piece.site, piece.offset}] += size;
    }
    return areas;
}

/// Computes the pieces by clipping with the bisectors of all images, neighbours or not.
Areas brute_force_areas(const Sites& sites) {
    const Lattice& basis = sites.reduction().reduced;
    const auto plane = [&](const Image& p) {
        return Vec2(basis.to_position({p.u + p.offset.i, p.v + p.offset.j}));
    };
    std::vector<Image> images;
    for (SiteId s = 0; s < sites.n_sites(); ++s) {
        for (int i = -2; i <= 2; ++i) {
            for (int j = -2; j <= 2; ++j) images.push_back(image(sites, s, {i, j}));
        }
    }
    Areas found;
    for (const Image& p : images) {
        std::vector<Vec2> polygon{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        for (const Image& q : images) {
            const Vec2 d = plane(q) - plane(p);
            if (d.norm() == 0) continue;
            const auto beyond = [&](const Vec2& u) {
                return d.dot(basis.to_position(u) - plane(p)) - d.squaredNorm() / 2;
            };
            std::vector<Vec2> kept;
            for (std::size_t k = 0; k < polygon.size(); ++k) {
                const Vec2& x = polygon[k];
                const Vec2& y = polygon[(k + 1) % polygon.size()];
                if (beyond(x) <= 0) kept.push_back(x);
                if (beyond(x) * beyond(y) < 0) {
                    kept.push_back(x + beyond(x) / (beyond(x) - beyond(y)) * (y - x));
                }
            }
            polygon = kept;
        }
        if (area(polygon) > kNothing) found[{p.site, p.offset}] = area(polygon);
    }
    return found;
}

void expect_equal(const Areas& actual, const Areas& expected) {
    ASSERT_EQ(actual.size(), expected.size());
    for (auto a = actual.begin(), e = expected.begin(); a != actual.end(); ++a, ++e) {
        ASSERT_EQ(a->first, e->first);
        ASSERT_NEAR(a->second, e->second, 1e-12);
    }
}

using Corners = std::array<std::pair<SiteId, Offset>, 3>;

std::vector<Corners> triangle_set(const std::vector<Triangle>& triangles) {
    std::vector<Corners> set;
    for (const Triangle& t : triangles) {
        Corners corners;
        for (int k = 0; k < 3; ++k) corners[k] = {t[k].site, t[k].offset};
        std::sort(corners.begin(), corners.end());
        set.push_back(corners);
    }
    std::sort(set.begin(), set.end());
    return set;
}

void expect_same_diagram(const Sites& sites) {
    const MirrorDiagram mirrors = mirror_diagram(sites, WithPieces::kYes);
    const MirrorDiagram copies = full_copies_diagram(sites, WithPieces::kYes);
    expect_equal(areas(mirrors.pieces), areas(copies.pieces));
    ASSERT_EQ(triangle_set(mirrors.triangles), triangle_set(copies.triangles));
}

TEST(MirrorDiagram, EqualsTheFullCopiesOnAThousandSmallInputs) {
    std::mt19937_64 random(1);
    const auto named = lattices();
    for (int k = 0; k < 1000; ++k) {
        const int n = 1 + k % 40;
        const Lattice lattice =
            k % 2 == 0 ? random_lattice(random) : named[(k / 2) % named.size()].lattice;
        SCOPED_TRACE("input " + std::to_string(k) + " n = " + std::to_string(n));
        expect_same_diagram(Sites(lattice, uniform_points(lattice, n, random())));
        if (HasFatalFailure()) return;
    }
}

TEST(MirrorDiagram, EqualsTheFullCopiesOnTwentyLargerInputs) {
    const auto named = lattices();
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const auto& [name, lattice] = named[seed % named.size()];
        SCOPED_TRACE(name);
        expect_same_diagram(Sites(lattice, uniform_points(lattice, 1000, seed)));
    }
}

TEST(MirrorDiagram, EqualsTheFullCopiesWhereSitesAreCocircularOrOnTheSeam) {
    for (const auto& [name, sites] : testing::special_sites()) {
        SCOPED_TRACE(name);
        expect_same_diagram(sites);
    }
}

/// CGAL lists the faces of both in different orders.
TEST(MirrorDiagram, HasAnOrderOfItsOwn) {
    std::mt19937_64 random(7);
    for (int k = 0; k < 100; ++k) {
        const Lattice lattice = random_lattice(random);
        const Sites sites(lattice, uniform_points(lattice, 1 + k % 40, random()));
        EXPECT_EQ(mirror_diagram(sites).triangles, full_copies_diagram(sites).triangles) << k;
    }
}

TEST(MirrorDiagram, EqualsClippingByAllBisectors) {
    std::mt19937_64 random(2);
    for (int k = 0; k < 60; ++k) {
        const Lattice lattice = random_lattice(random);
        const Sites sites(lattice, uniform_points(lattice, 1 + k % 12, random()));
        SCOPED_TRACE("input " + std::to_string(k));
        expect_equal(areas(mirror_diagram(sites, WithPieces::kYes).pieces),
                     brute_force_areas(sites));
    }
}

TEST(MirrorDiagram, PiecesFillTheDomain) {
    for (const auto& [name, lattice] : lattices()) {
        const Sites sites(lattice, uniform_points(lattice, 57, 4));
        double total = 0;
        for (const Piece& piece : mirror_diagram(sites, WithPieces::kYes).pieces) {
            total += area(piece.polygon);
        }
        EXPECT_NEAR(total, 1, 1e-12) << name;
    }
}

// Section 5 of the paper: the number of mirrors is about the square root of the number of sites.
/// By Euler's formula: 2 n - 2 - (corners of the hull).
TEST(MirrorDiagram, TheFirstStepIsThePlaneTriangulation) {
    Points square(2, 5);
    square << 0.1, 0.9, 0.9, 0.1, 0.4, 0.1, 0.1, 0.9, 0.9, 0.5;
    EXPECT_EQ(euclidean_delaunay(Sites(Lattice::rectangle(1, 1), square)), 4u);
}

TEST(MirrorDiagram, TheNumberOfMirrorsGrowsWithTheSquareRoot) {
    const Lattice unit = Lattice::rectangle(1, 1);
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
        const Sites sites(unit, uniform_points(unit, 10000, seed));
        const double ratio = mirror_diagram(sites).n_mirrors / 100.0;
        EXPECT_GT(ratio, 3.3);
        EXPECT_LT(ratio, 4.0);
    }
    EXPECT_EQ(mirror_diagram(Sites(unit, uniform_points(unit, 1, 0))).n_mirrors, 8);
}

// According to the paper inner cells do not change; about 0.7 sqrt(n) of them do.
TEST(MirrorDiagram, SomeInnerCellsShrinkContraryToThePaper) {
    const Lattice unit = Lattice::rectangle(1, 1);
    const Sites sites(unit, uniform_points(unit, 10000, 1));
    const MirrorDiagram diagram = mirror_diagram(sites);
    EXPECT_GT(diagram.n_shrunk_inner_sites, 30);
    EXPECT_LT(diagram.n_shrunk_inner_sites, 120);
}

}  // namespace
}  // namespace pcvt::plane
