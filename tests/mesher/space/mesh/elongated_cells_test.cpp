#include "mesher/space/mesh/elongated_cells.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mesher/base/law_violation.hpp"
#include "mesher/space/cvt/cvt.hpp"
#include "mesher/space/mesh/cell_measures.hpp"
#include "mesher/space/mesh/cell_sites.hpp"
#include "mesher/space/proof/polyhedral_proof.hpp"
#include "tests/support/space_lattices.hpp"

namespace pcvt::space {
namespace {

struct ElongatedCase {
    Sites sites;
    CellComplex round;
    CellComplex cells;
    PolyhedralMesh mesh;
    Points images;
};

ElongatedCase elongated(const Lattice& lattice, const Metric& metric, const PeriodicDelaunay& d) {
    const Sites sites = metric.from_round(d.sites, lattice);
    const CellComplex round = cell_complex(d.sites, d.tetrahedra);
    const CellComplex cells = from_round(round, metric, sites);
    std::vector<Offset> images;
    PolyhedralMesh mesh = polyhedral_mesh(sites, cells, lattice.a() * 0.3, &images);
    mesh.metric = metric;
    return {sites, round, cells, mesh, sites_of_cells(cells, images)};
}

ElongatedCase elongated(const Lattice& lattice, const Metric& metric, int n, std::uint64_t seed) {
    return elongated(lattice, metric,
                     periodic_delaunay(Sites(metric.to_round(lattice),
                                             metric.to_round(uniform_points(lattice, n, seed)))));
}

// Law 1, and proofs of the tile in the metric and in no other one.
TEST(ElongatedCells, KeepTheirVolumesAndAreProvedInTheirMetric) {
    std::uint64_t seed = 0;
    for (const auto& [name, lattice] : testing::space_lattices()) {
        for (const int n : {1, 2, 3, 8, 40}) {
            const Metric metric(seed % 2 == 0 ? 10 : 0.3, Vec3(1, 0.5 * double(seed % 3), 0.2));
            SCOPED_TRACE(name + " " + std::to_string(n));
            ElongatedCase c = elongated(lattice, metric, n, ++seed);
            const std::vector<double> volumes = cell_table(c.cells).measure;
            const std::vector<double> of_round = cell_table(c.round).measure;
            for (int s = 0; s < n; ++s) {
                EXPECT_NEAR(volumes[s], of_round[s], 1e-9 * lattice.volume() / n);
            }
            EXPECT_NO_THROW(prove_polyhedra(c.mesh));
            EXPECT_LT(prove_cell_sites(c.mesh, c.images).from_bisector, kBisectorTolerance);
            if (n < 3) continue;
            c.mesh.metric = Metric(metric.ratio() * 1.01, metric.axis());
            EXPECT_THROW(prove_cell_sites(c.mesh, c.images), NotATile);
        }
    }
}

// Law 2.
TEST(ElongatedCells, HoldThePointsNearestInTheMetric) {
    const Lattice lattice = testing::kCube;
    const Metric metric(4, {1, 2, 0});
    const ElongatedCase c = elongated(lattice, metric, 12, 5);
    for (int s = 0; s < 12; ++s) {
        const std::vector<CellBody> bodies = cell_bodies(c.cells);
        const auto nearest_of = [&](SiteId site) {
            double least = std::numeric_limits<double>::infinity();
            for (int k = 0; k < 343; ++k) {
                const Offset o{k / 49 - 3, k / 7 % 7 - 3, k % 7 - 3};
                const Vec3 d = c.sites.position(site) + lattice.translation(o) - bodies[s].centroid;
                least = std::min(least, metric.to_round(d).norm());
            }
            return least;
        };
        for (SiteId t = 0; t < 12; ++t) EXPECT_LE(nearest_of(s), nearest_of(t) + 1e-12);
    }
}

/// The root of the second moments of all cells along a direction.
double extent(const CellComplex& complex, const Vec3& along) {
    // Squares the cells along the direction: the second moment is that of the difference between
    // a stretched and a plain copy.
    CellComplex stretched = complex;
    const Eigen::Matrix3d twice = Eigen::Matrix3d::Identity() + along * along.transpose();
    const auto map = [&](Vec3& p) { p = twice * p; };
    for (Vec3& p : stretched.vertices) map(p);
    std::array<Vec3, 3> periods = complex.reduced.periods();
    for (Vec3& p : periods) map(p);
    stretched.reduced = Lattice(periods[0], periods[1], periods[2]);
    double sum = 0;
    const std::vector<CellBody> plain = cell_bodies(complex);
    const std::vector<CellBody> wide = cell_bodies(stretched);
    for (std::size_t s = 0; s < plain.size(); ++s) {
        // wide = 2 (across + 4 along), plain = across + along
        sum += std::sqrt((wide[s].moment / 2 - plain[s].moment) / 3 / plain[s].volume);
    }
    return sum / double(plain.size());
}

TEST(ElongatedCells, OfARunAreAsLongAsTheRatioSays) {
    const Lattice lattice = testing::kCube;
    for (const double ratio : {2.0, 5.0, 10.0}) {
        const Vec3 axis = ratio == 5 ? Vec3(1, 2, 3) : Vec3(1, 0, 0);
        const Metric metric(ratio, axis);
        CvtOptions options;
        options.run.tolerance = 1e-3;
        const CvtResult result = compute_cvt(
            metric.to_round(lattice), metric.to_round(uniform_points(lattice, 300, 1)), options);
        const ElongatedCase c = elongated(lattice, metric, result.delaunay);
        const Vec3 along = axis.normalized();
        const Vec3 across = along.unitOrthogonal();
        const double widths = (extent(c.cells, across) + extent(c.cells, along.cross(across))) / 2;
        EXPECT_NEAR(extent(c.cells, along) / widths, ratio, 0.02 * ratio);
    }
}

}  // namespace
}  // namespace pcvt::space
