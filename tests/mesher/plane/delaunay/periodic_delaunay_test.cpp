#include "mesher/plane/delaunay/periodic_delaunay.hpp"

#include <gtest/gtest.h>

#include "mesher/base/error.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/nearest_site.hpp"
#include "tests/support/special_sites.hpp"

namespace pcvt::plane {
namespace {

using testing::lattices;
using testing::squared_distance;

Sites random_sites(const Lattice& lattice, int n, std::uint64_t seed) {
    return {lattice, uniform_points(lattice, n, seed)};
}

// Law 1, checked independently: no image of any site lies inside any circumcircle.
void expect_empty_circles(const PeriodicDelaunay& delaunay) {
    const Sites& sites = delaunay.sites();
    const Lattice& reduced = sites.reduction().reduced;
    const TorusTriangulation& t = delaunay.triangulation();
    for (int h = 0; h < t.n_halfedges(); h += 3) {
        std::array<Vec2, 3> p;
        for (int k = 0; k < 3; ++k) {
            const Corner& c = t.corner(h + k);
            p[k] = sites.position(c.site) + reduced.translation(c.offset);
        }
        const Vec2 d = p[1] - p[0];
        const Vec2 e = p[2] - p[0];
        const double det = 2 * (d.x() * e.y() - d.y() * e.x());
        ASSERT_GT(det, 0);
        const Vec2 along = (d.squaredNorm() * e - e.squaredNorm() * d) / det;
        const Vec2 radius(along.y(), -along.x());
        const double nearest = squared_distance(sites, p[0] + radius);
        ASSERT_GT(nearest, radius.squaredNorm() * (1 - 1e-8));
    }
}

TEST(PeriodicDelaunay, CirclesAreEmptyForSmallNOnEveryLattice) {
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {1, 2, 3, 4, 5, 6, 7, 8, 30}) {
            SCOPED_TRACE(name + " n = " + std::to_string(n));
            expect_empty_circles(PeriodicDelaunay(random_sites(lattice, n, 1)));
        }
    }
}

TEST(PeriodicDelaunay, CirclesAreEmptyWhereSitesAreCocircular) {
    for (const auto& [name, sites] : testing::special_sites()) {
        SCOPED_TRACE(name);
        expect_empty_circles(PeriodicDelaunay(sites));
    }
}

TEST(PeriodicDelaunay, RejectsATriangulationThatIsNotDelaunay) {
    for (const auto& [name, lattice] : lattices()) {
        const PeriodicDelaunay delaunay(random_sites(lattice, 20, 1));
        for (int h = 0; h < delaunay.triangulation().n_halfedges(); ++h) {
            TorusTriangulation wrong = delaunay.triangulation();
            wrong.flip(h);
            EXPECT_THROW(PeriodicDelaunay(delaunay.sites(), wrong), InternalError) << name << h;
        }
    }
}

}  // namespace
}  // namespace pcvt::plane
