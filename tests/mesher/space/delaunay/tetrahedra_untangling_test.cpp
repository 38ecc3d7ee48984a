#include "mesher/space/delaunay/tetrahedra_untangling.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/support/space_families.hpp"
#include "tests/support/space_laws.hpp"

namespace pcvt::space {
namespace {

/// A star holds each corner at the site once, and no other.
TEST(StarOfCorner, HoldsEveryCornerAtTheSite) {
    std::mt19937_64 random(3);
    for (int job = 0; job < 30; ++job) {
        SCOPED_TRACE(job);
        const Lattice lattice = testing::random_space_lattice(random);
        const Sites sites(lattice, uniform_points(lattice, 1 + job, random()));
        const TorusTetrahedra tetrahedra = periodic_delaunay(sites).tetrahedra;
        std::vector<std::vector<int>> corners(static_cast<std::size_t>(sites.n_sites()));
        for (int c = 0; c < tetrahedra.n_facets(); ++c) {
            corners[tetrahedra.corner(c).site].push_back(c);
        }
        for (const std::vector<int>& expected : corners) {
            std::vector<int> star = star_of_corner(tetrahedra, expected.back());
            std::sort(star.begin(), star.end());
            EXPECT_EQ(star, expected);
        }
    }
}

/// A triangulation and coordinates to which its sites shall move.
struct Tangle {
    PeriodicDelaunay delaunay;
    Gram gram;
    Points moved;

    Tangle(const Sites& sites, double size, std::uint64_t seed)
        : delaunay(periodic_delaunay(sites)),
          gram(gram_of(sites.reduction().reduced)),
          moved(sites.coordinates()) {
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> uniform(-size, size);
        for (double& x : moved.reshaped()) {
            x = std::nearbyint((x + uniform(random)) * kGrid) / kGrid;
        }
    }

    std::vector<int> inverted() const {
        std::vector<int> found;
        for (int t = 0; t < delaunay.tetrahedra.n_tetrahedra(); ++t) {
            if (!is_positive(delaunay.tetrahedra, moved, t)) found.push_back(t);
        }
        return found;
    }

    std::vector<Tetrahedron> all_tetrahedra() const {
        std::vector<Tetrahedron> all;
        for (int t = 0; t < delaunay.tetrahedra.n_tetrahedra(); ++t) {
            all.push_back(delaunay.tetrahedra.tetrahedron(t));
        }
        return all;
    }

    /// Untangles, and proves the list of exchanged tetrahedra.
    bool untangle(std::size_t most_held) {
        std::vector<int> all(static_cast<std::size_t>(delaunay.tetrahedra.n_facets()));
        std::iota(all.begin(), all.end(), 0);
        std::vector<Tetrahedron> before = all_tetrahedra();
        TetrahedraUntangling untangling(delaunay.tetrahedra, delaunay.sites.coordinates(), moved,
                                        gram);
        const bool done = untangling.run(inverted(), all, most_held);
        const auto [removed, added] = untangling.take_exchanged();
        std::vector<Tetrahedron> after = all_tetrahedra();
        before.insert(before.end(), added.begin(), added.end());
        after.insert(after.end(), removed.begin(), removed.end());
        std::sort(before.begin(), before.end());
        std::sort(after.begin(), after.end());
        EXPECT_TRUE(before == after);
        return done;
    }
};

/// The result is a new build's, at the coordinates as they were; most repairs succeed.
TEST(TetrahedraUntangling, EqualsANewBuild) {
    std::mt19937_64 random(4);
    int n_done = 0;
    int n_tangled = 0;
    for (int job = 0; job < 60; ++job) {
        SCOPED_TRACE(job);
        const Lattice lattice = testing::random_space_lattice(random);
        const int n = 1 + int(random() % 60);
        const double size = 0.3 / std::cbrt(n) / double(1 + random() % 4);
        Tangle tangle(Sites(lattice, uniform_points(lattice, n, random())), size, random());
        if (tangle.inverted().empty()) continue;
        ++n_tangled;
        const Points target = tangle.moved;
        const bool done = tangle.untangle(std::size_t(n));
        EXPECT_EQ(tangle.moved, target);
        if (!done) continue;
        ++n_done;
        testing::expect_torus(tangle.delaunay.tetrahedra, target);
        testing::expect_delaunay(tangle.delaunay.tetrahedra, target, tangle.gram);
    }
    EXPECT_GT(n_tangled, 30);
    EXPECT_GT(n_done, 0.8 * n_tangled);
    RecordProperty("tangled", n_tangled);
    RecordProperty("done", n_done);
}

/// Where a site cannot make half of its remaining move, or a quarter, it makes a short one.
TEST(TetrahedraUntangling, SucceedsAmongSitesInTheCube) {
    const Lattice cube = Lattice::box(1, 1, 1);
    int n_failed = 0;
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        const int n = 300;
        Tangle tangle(Sites(cube, uniform_points(cube, n, seed)), 0.2 / std::cbrt(n), seed);
        if (!tangle.untangle(std::size_t(n))) ++n_failed;
    }
    EXPECT_EQ(n_failed, 0);
}

TEST(TetrahedraUntangling, GivesUpWhereTooManySitesMoveBack) {
    const Lattice cube = Lattice::box(1, 1, 1);
    Tangle tangle(Sites(cube, uniform_points(cube, 60, 1)), 0.1, 1);
    ASSERT_GT(tangle.inverted().size(), 5U);
    const Points target = tangle.moved;
    EXPECT_FALSE(tangle.untangle(3));
    EXPECT_EQ(tangle.moved, target);
}

}  // namespace
}  // namespace pcvt::space
