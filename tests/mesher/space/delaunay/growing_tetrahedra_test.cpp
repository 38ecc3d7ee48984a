#include "mesher/space/delaunay/growing_tetrahedra.hpp"

#include <gtest/gtest.h>

#include "mesher/space/delaunay/periodic_delaunay.hpp"
#include "tests/support/space_families.hpp"

namespace pcvt::space {
namespace {

using Cell = GrowingTetrahedra::Cell;

constexpr int kStart = 343;

/// The points of a grid, which have small spheres, and others.
Points grid_and(const Points& others) {
    Points all(3, kStart + others.cols());
    all.leftCols(kStart) = testing::cubic_points(testing::Cubic::kSimple, 7);
    all.rightCols(others.cols()) = others;
    return all;
}

/// Triangulates the grid and inserts the other sites.
class Grown {
   public:
    explicit Grown(const Points& others)
        : sites_(cube(), grid_and(others)),
          start_(torus_tetrahedra({cube(), sites_.coordinates().leftCols(kStart)})),
          growing_(gram(), sites_.coordinates(), start_) {}

    void insert_all() {
        for (SiteId s = kStart; s < sites_.n_sites(); ++s) ASSERT_TRUE(growing_.insert(s));
    }
    GrowingTetrahedra& growing() { return growing_; }

    /// Each facet has another side with the same three sites, and the apex there lies outside of
    /// the sphere.
    void expect_delaunay() const {
        const auto& cells = growing_.cells();
        for (int f = 0; f < 4 * int(cells.size()); ++f) {
            if (cells[f / 4].is_gap()) continue;
            const int o = cells[f / 4].opposite[f % 4];
            ASSERT_EQ(cells[o / 4].opposite[o % 4], f);
            ASSERT_EQ(sites_of(f), sites_of(o));
            const auto [p, q, r, s] = images(cells[f / 4]);
            ASSERT_GT(orientation(p, q, r, s), 0);
            const Image apex = nearest(cells[o / 4].site[o % 4], f % 4 == 0 ? q : p);
            ASSERT_FALSE(violates_delaunay(gram(), p, q, r, s, apex));
        }
    }

   private:
    static Lattice cube() { return Lattice::box(1, 1, 1); }
    static Gram gram() { return gram_of(cube()); }

    std::array<SiteId, 3> sites_of(int f) const {
        std::array<SiteId, 3> sites;
        for (int k = 0; k < 3; ++k) {
            sites[k] = growing_.cells()[f / 4].site[TorusTetrahedra::kFacetCorners[f % 4][k]];
        }
        std::sort(sites.begin(), sites.end());
        return sites;
    }
    Image nearest(SiteId site, const Image& to) const {
        const Vec3 d = sites_.coordinates().col(site) - to.at;
        return {to.at + d - d.array().round().matrix(), {site, {}}};
    }
    std::array<Image, 4> images(const Cell& cell) const {
        const Image first = image(sites_.coordinates(), {cell.site[0], {}});
        return {first, nearest(cell.site[1], first), nearest(cell.site[2], first),
                nearest(cell.site[3], first)};
    }

    Sites sites_;
    TorusTetrahedra start_;
    GrowingTetrahedra growing_;
};

TEST(GrowingTetrahedra, StayDelaunayAfterEachSite) {
    const Points points = uniform_points(Lattice::box(1, 1, 1), 40, 1);
    Grown grown(points);
    for (SiteId s = kStart; s < kStart + 40; ++s) {
        ASSERT_TRUE(grown.growing().insert(s));
        grown.expect_delaunay();
    }
}

/// Sites on facets, edges and spheres of the grid, and across its seam.
TEST(GrowingTetrahedra, TakeSitesInSpecialPlaces) {
    Points points(3, 5);
    for (int k = 0; k < 5; ++k) {
        points.col(k) = Vec3(0.5 + k, 0.5 * (k % 3), 0.5 * (k % 2)) / 7;
    }
    points(2, 4) = 1 - 0x1p-50;
    Grown grown(points);
    grown.insert_all();
    grown.expect_delaunay();
}

/// A site amid a sphere of others, more than are linked by the table.
TEST(GrowingTetrahedra, TakeASiteWithManyNeighbours) {
    constexpr int kRound = 600;
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    Points points(3, kRound + 1);
    const Vec3 centre = Vec3::Constant(0.5 / 7);
    for (int s = 0; s < kRound; ++s) {
        const double x = normal(random);
        const double y = normal(random);
        points.col(s) = centre + 0.05 * Vec3(x, y, normal(random)).normalized();
    }
    points.col(kRound) = centre;
    Grown grown(points);
    grown.insert_all();
    grown.expect_delaunay();
    int n_at_centre = 0;
    for (const Cell& cell : grown.growing().cells()) {
        n_at_centre += std::count(cell.site.begin(), cell.site.end(), kStart + kRound) > 0;
    }
    EXPECT_GT(n_at_centre, 1000);
}

TEST(GrowingTetrahedra, RefuseACoincidingSite) {
    const Lattice cube = Lattice::box(1, 1, 1);
    const Points grid = testing::cubic_points(testing::Cubic::kSimple, 7);
    const TorusTetrahedra start = torus_tetrahedra({cube, grid});
    Points twice(3, 2 * kStart);
    twice << grid, grid;
    const Sites sites(cube, reduce(cube), twice);
    GrowingTetrahedra growing(gram_of(cube), sites.coordinates(), start);
    for (SiteId s = kStart; s < 2 * kStart; ++s) EXPECT_FALSE(growing.insert(s));
    EXPECT_EQ(int(growing.cells().size()), start.n_tetrahedra());
}

}  // namespace
}  // namespace pcvt::space
