#include "mesher/space/delaunay/image_search.hpp"

#include <gtest/gtest.h>

#include "tests/support/space_lattices.hpp"

namespace pcvt::space {
namespace {

/// The nearest admitted image among all within three periods.
Corner brute_force(const Sites& sites, const Gram& gram, const Vec3& point, double radius,
                   const ImageSearch::Admits& admits) {
    Corner found{-1, {}};
    double least = radius * radius;
    for (SiteId s = 0; s < sites.n_sites(); ++s) {
        for (int o = 0; o < 343; ++o) {
            const Corner corner{s, {o / 49 - 3, o / 7 % 7 - 3, o % 7 - 3}};
            const Vec3 d = image(sites.coordinates(), corner).at - point;
            const double distance = gram.squared_length(d.x(), d.y(), d.z());
            if (distance <= least && admits(corner)) {
                least = distance;
                found = corner;
            }
        }
    }
    return found;
}

TEST(ImageSearch, FindsTheNearestImage) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(-1, 2);
    for (const auto& [name, lattice] : testing::space_lattices()) {
        SCOPED_TRACE(name);
        for (const int n : {1, 7, 60}) {
            const Sites sites(lattice, uniform_points(lattice, n, 1));
            const ImageSearch search(sites);
            for (int k = 0; k < 20; ++k) {
                const double u = uniform(random);
                const double v = uniform(random);
                const Vec3 point(u, v, uniform(random));
                const double radius = search.spacing() * 0.5 * (k % 4 + 1);
                const ImageSearch::Admits admits = [k](const Corner& corner) {
                    return (corner.site + corner.offset.i + k) % 3 != 0;
                };
                EXPECT_EQ(search.nearest(point, radius, admits),
                          brute_force(sites, search.gram(), point, radius, admits));
            }
        }
    }
}

TEST(ImageSearch, ExtentBoundsABall) {
    for (const auto& [name, lattice] : testing::space_lattices()) {
        SCOPED_TRACE(name);
        const Sites sites(lattice, uniform_points(lattice, 5, 1));
        const ImageSearch search(sites);
        // The point of the unit ball with the largest first coordinate.
        const Lattice& reduced = sites.reduction().reduced;
        const Vec3 along = reduced.b().cross(reduced.c()).normalized();
        const double unit = reduced.a().norm() / std::sqrt(search.gram().aa);
        EXPECT_NEAR(reduced.to_lattice(unit * along).x(), search.extent().x(),
                    1e-12 * search.extent().x());
    }
}

}  // namespace
}  // namespace pcvt::space
