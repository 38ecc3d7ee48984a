#include "mesher/plane/mesh/voronoi.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "mesher/base/error.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/nearest_site.hpp"
#include "tests/support/special_sites.hpp"

namespace pcvt::plane {
namespace {

using testing::lattices;
using testing::squared_distance;

Vec2 corner(const PeriodicMesh& mesh, int c) {
    return mesh.vertices[mesh.corner_vertex[c]] + mesh.lattice.translation(mesh.corner_offset[c]);
}

// Laws 1 and 2.
void expect_torus(const PeriodicMesh& mesh) {
    const int n_edges = mesh.n_corners() / 2;
    ASSERT_EQ(mesh.n_vertices() - n_edges + mesh.n_faces(), 0);
    double doubled = 0;
    for (int c = 0; c < mesh.n_corners(); ++c) {
        const int o = mesh.opposite[c];
        ASSERT_NE(o, c);
        ASSERT_EQ(mesh.opposite[o], c);
        ASSERT_EQ(mesh.corner_vertex[mesh.next(c)], mesh.corner_vertex[o]);
        const Vec2 p = corner(mesh, c);
        const Vec2 q = corner(mesh, mesh.next(c));
        doubled += p.x() * q.y() - p.y() * q.x();
        ASSERT_GT((q - p).norm(), 1e-10 * std::sqrt(mesh.lattice.area() / mesh.n_faces()));
    }
    ASSERT_NEAR(doubled / 2, mesh.lattice.area(), 1e-12 * mesh.lattice.area() * mesh.n_faces());
}

// Checks law 3 at the corners: no other image is nearer to a corner of a cell than its site.
void expect_nearest(const PeriodicDelaunay& delaunay, const PeriodicMesh& cells) {
    const double h2 = std::pow(delaunay.sites().spacing(), 2);
    for (SiteId s = 0; s < cells.n_faces(); ++s) {
        for (int c = cells.face_begin[s]; c < cells.face_begin[s + 1]; ++c) {
            const Vec2 p = corner(cells, c);
            const double own = (delaunay.sites().position(s) - p).squaredNorm();
            ASSERT_NEAR(own, squared_distance(delaunay.sites(), p), 1e-7 * h2 + 1e-12 * own);
        }
    }
}

void expect_laws(const Sites& sites) {
    const PeriodicDelaunay delaunay(sites);
    const PeriodicMesh cells = cell_mesh(delaunay);
    expect_torus(cells);
    expect_nearest(delaunay, cells);
    expect_torus(triangle_mesh(delaunay));
}

TEST(Voronoi, LawsHoldForOneSiteAndMoreOnEveryLattice) {
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {1, 2, 3, 4, 5, 6, 7, 8, 60}) {
            SCOPED_TRACE(name + " n = " + std::to_string(n));
            expect_laws(Sites(lattice, uniform_points(lattice, n, 1)));
        }
    }
}

TEST(Voronoi, LawsHoldWhereSitesAreCocircular) {
    for (const auto& [name, sites] : testing::special_sites()) {
        SCOPED_TRACE(name);
        expect_laws(sites);
    }
}

/// Sites that lie on one circle but for a few rounding errors of its centre's merging.
Sites nearly_cocircular_sites(std::mt19937_64& random) {
    std::uniform_real_distribution<double> uniform(0, 2 * M_PI);
    std::normal_distribution<double> normal(0, 1e-10);
    Points points(2, 5 + static_cast<int>(random() % 5));
    for (auto point : points.colwise()) {
        const double angle = uniform(random);
        const double radius = 0.3 + normal(random);
        point << 0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle);
    }
    return {Lattice::rectangle(1, 1), points};
}

double shortest_edge(const PeriodicMesh& cells) {
    double shortest = std::sqrt(cells.lattice.area());
    for (int c = 0; c < cells.n_corners(); ++c) {
        const double length = (corner(cells, cells.next(c)) - corner(cells, c)).norm();
        shortest = std::min(shortest, length);
    }
    return shortest;
}

// Law 4. A merged vertex lies at one of its circumcentres, which shortens other edges.
TEST(Voronoi, MergingLeavesNoShortEdge) {
    std::mt19937_64 random(1);
    int n_refused = 0;
    for (int k = 0; k < 3000; ++k) {
        const PeriodicDelaunay delaunay(nearly_cocircular_sites(random));
        try {
            const PeriodicMesh cells = cell_mesh(delaunay);
            expect_torus(cells);
            ASSERT_GE(shortest_edge(cells), 0.999 * kSameVertex * delaunay.sites().spacing()) << k;
        } catch (const InvalidInput&) {
            ++n_refused;
        }
    }
    EXPECT_LT(n_refused, 60);
}

TEST(Voronoi, CocircularSitesShareOneVertex) {
    for (const double corner : {0.0, 1.0 / 3}) {
        const PeriodicMesh cells = cell_mesh(
            PeriodicDelaunay(testing::grid_sites(Lattice::rectangle(1, 1), 5, 5, corner, corner)));
        EXPECT_EQ(cells.n_vertices(), 25);
        EXPECT_EQ(cells.n_corners(), 100);
    }
}

// All triangles inside the circle have the same circumcentre, which is one vertex of the diagram.
TEST(Voronoi, HundredsOfSitesOnACircleShareOneVertex) {
    const int n = 300;
    Points points(2, n);
    for (int k = 0; k < n; ++k) {
        const double angle = 2 * M_PI * k / n;
        points.col(k) << 0.5 + 0.4 * std::cos(angle), 0.5 + 0.4 * std::sin(angle);
    }
    const PeriodicMesh cells = cell_mesh(PeriodicDelaunay(Sites(Lattice::rectangle(1, 1), points)));
    std::vector<int> valence(cells.vertices.size(), 0);
    for (const int v : cells.corner_vertex) ++valence[v];
    EXPECT_EQ(*std::max_element(valence.begin(), valence.end()), n);
}

TEST(Voronoi, RefusesACellThatIsTooSmallToWrite) {
    Points points(2, 7);
    points.col(0) << 0.5, 0.5;
    for (int k = 0; k < 6; ++k) {
        points.col(k + 1) << 0.5 + 1e-12 * std::cos(k), 0.5 + 1e-12 * std::sin(k);
    }
    EXPECT_THROW(cell_mesh(PeriodicDelaunay(Sites(Lattice::rectangle(1, 1), points))),
                 InvalidInput);
}

}  // namespace
}  // namespace pcvt::plane
