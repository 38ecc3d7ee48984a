#include "mesher/space/grains/grains.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "mesher/space/box/box_cells.hpp"
#include "mesher/space/cvt/cvt.hpp"
#include "mesher/space/cvt/weighted_cells.hpp"
#include "mesher/space/grains/cell_filling.hpp"
#include "mesher/space/grains/cell_sizes.hpp"
#include "mesher/space/grains/shared_moves.hpp"
#include "mesher/space/mesh/short_edges.hpp"
#include "mesher/space/proof/tetrahedral_proof.hpp"
#include "tests/support/case_count.hpp"
#include "tests/support/grain_cases.hpp"
#include "tests/support/polyhedra.hpp"
#include "tests/support/random_numbers.hpp"

namespace pcvt::space {
namespace {

using testing::SpaceCase;

/// Large enough that a cell has some hundred tetrahedra.
constexpr double kPart = 1.4;

Grains grains_of(const Sites& sites, const CellComplex& complex, int n_threads = 1) {
    Workers workers(n_threads);
    return mesh_grains(sites, complex, {.size = sites.spacing() / kPart, .n_rounds = 1}, workers);
}

Grains grains_of(const SpaceCase& c, int n_threads = 1) {
    return grains_of(Sites(c.lattice, c.points), testing::complex_of(c), n_threads);
}

/// Law (2) of GrainMesh, where faces are plane.
void expect_volumes(const GrainMesh& mesh, const CellComplex& complex) {
    std::vector<double> volumes(static_cast<std::size_t>(complex.n_cells), 0);
    for (std::size_t t = 0; t < mesh.tetrahedra.cell.size(); ++t) {
        volumes[mesh.tetrahedra.cell[t]] +=
            tetrahedron_volume(mesh.tetrahedra, static_cast<int>(t));
    }
    const std::vector<CellBody> bodies = cell_bodies(complex);
    for (std::size_t s = 0; s < bodies.size(); ++s) {
        EXPECT_NEAR(volumes[s] / bodies[s].volume, 1, 1e-9);
    }
}

using Triple = std::array<int, 3>;

Triple sorted(Triple triple) {
    std::sort(triple.begin(), triple.end());
    return triple;
}

/// Law (3) of GrainMesh: the tetrahedra of each cell have the stated triangles as their boundary.
void expect_triangles(const GrainMesh& mesh, int n_cells) {
    std::vector<std::map<Triple, int>> sides(static_cast<std::size_t>(n_cells));
    for (std::size_t t = 0; t < mesh.tetrahedra.cell.size(); ++t) {
        const auto& c = mesh.tetrahedra.tetrahedra[t];
        for (const Triple& side : {Triple{c[0], c[1], c[2]}, Triple{c[0], c[1], c[3]},
                                   Triple{c[0], c[2], c[3]}, Triple{c[1], c[2], c[3]}}) {
            ++sides[mesh.tetrahedra.cell[t]][sorted(side)];
        }
    }
    std::vector<std::set<Triple>> outside(static_cast<std::size_t>(n_cells));
    for (std::size_t s = 0; s < sides.size(); ++s) {
        for (const auto& [triple, n] : sides[s]) {
            if (n == 1) outside[s].insert(triple);
        }
    }
    for (const GrainTriangle& triangle : mesh.triangles) {
        EXPECT_EQ(outside[triangle.cell].erase(sorted(triangle.points)), 1u);
        EXPECT_EQ(outside[triangle.neighbour].erase(sorted(triangle.partners)), 1u);
        for (std::size_t k = 0; k < 3; ++k) {
            const TetrahedralMesh& all = mesh.tetrahedra;
            const Corner here = all.corner(triangle.points[k]);
            const Corner there = all.corner(triangle.partners[k]);
            EXPECT_EQ(here.site, there.site);
            EXPECT_EQ(here.offset + triangle.offset, there.offset);
        }
    }
    for (const auto& left : outside) EXPECT_TRUE(left.empty());
}

/// Law (1) of GrainMesh, exactly: a point is the first of its orbit plus a translation.
void expect_exact_partners(const TetrahedralMesh& mesh) {
    std::map<int, int> first;
    for (int p = 0; p < mesh.n_points(); ++p) {
        const int f = first.try_emplace(mesh.point_site[p], p).first->second;
        const Vec3 image = mesh.points[f] + mesh.lattice.translation(mesh.point_offset[p]);
        EXPECT_EQ(mesh.points[p], image);
    }
}

void expect_laws(const Grains& grains, const CellComplex& complex) {
    const GrainMesh& mesh = grains.mesh;
    const TetrahedralProof proof = prove_tetrahedra(mesh.tetrahedra);
    EXPECT_EQ(proof.n_sites - proof.n_edges + proof.n_triangles - mesh.tetrahedra.n_tetrahedra(),
              0);
    expect_volumes(mesh, complex);
    expect_triangles(mesh, complex.n_cells);
    expect_exact_partners(mesh.tetrahedra);
    EXPECT_TRUE(std::is_sorted(mesh.tetrahedra.cell.begin(), mesh.tetrahedra.cell.end()));
}

TEST(Grains, ObeyTheLawsOnAllLattices) {
    for (const SpaceCase& c : testing::space_cases()) {
        // Thin cells of the others take minutes.
        const bool is_small = c.points.cols() <= (c.name.find("lattice") == 0 ? 8 : 1);
        if (!is_small || c.name.find("thin") == 0) continue;
        SCOPED_TRACE(c.name);
        const Grains grains = grains_of(c);
        expect_laws(grains, testing::complex_of(c));
        EXPECT_GT(grains.angles.smallest, 5);
    }
}

/// Some of these cells are their own neighbours.
TEST(Grains, ObeyTheLawsForFewCells) {
    const Lattice cube = Lattice::box(1, 1, 1);
    for (const int n : {2, 3, 5, 8}) {
        SCOPED_TRACE(n);
        const SpaceCase c{"cube", cube, uniform_points(cube, n, static_cast<std::uint64_t>(n))};
        expect_laws(grains_of(c), testing::complex_of(c));
    }
}

TEST(Grains, ObeyTheLawsInPowerCells) {
    const Lattice oblique({1, 0.2, 0.1}, {-0.3, 0.9, 0.2}, {0.4, 0.3, 1.2});
    std::mt19937_64 random(1);
    for (const int n : {2, 10}) {
        SCOPED_TRACE(n);
        const Points points = uniform_points(oblique, n, static_cast<std::uint64_t>(n));
        Eigen::VectorXd weights(n);
        for (double& w : weights) w = 0.01 * testing::random_number(random);
        const WeightedCells cells = weighted_cells(oblique, points, weights, {});
        const CellComplex complex =
            cell_complex(cells.delaunay.sites, cells.delaunay.tetrahedra, cells.delaunay.weights);
        expect_laws(grains_of(cells.delaunay.sites, complex), complex);
    }
}

/// Faces whose short edges were removed are not plane; the cells fill the torus all the same.
TEST(Grains, FillCellsWithoutShortEdges) {
    const Lattice cube = Lattice::box(1, 1, 1);
    const Sites sites(cube, uniform_points(cube, 15, 4));
    const CellComplex all = testing::complex_of({"random", cube, uniform_points(cube, 15, 4)});
    for (const double shortest : {0.02, 0.1}) {
        const CellComplex complex = without_short_edges(all, shortest);
        const Grains grains = grains_of(sites, complex);
        const TetrahedralProof proof = prove_tetrahedra(grains.mesh.tetrahedra);
        EXPECT_NEAR(proof.volume, 1, 1e-12);
        expect_triangles(grains.mesh, complex.n_cells);
        expect_exact_partners(grains.mesh.tetrahedra);
    }
}

/// Law (2) of mesh_grains().
TEST(Grains, HaveNoSmallAnglesInCentroidalCells) {
    const Lattice cube = Lattice::box(1, 1, 1);
    CvtOptions options;
    options.run.tolerance = 1e-3;
    const CvtResult cells = compute_cvt(cube, uniform_points(cube, 50, 1), options);
    const CellComplex complex = cell_complex(cells.delaunay.sites, cells.delaunay.tetrahedra);
    Workers one_worker(1);
    const Grains grains = mesh_grains(cells.delaunay.sites, complex, {}, one_worker);
    expect_laws(grains, complex);
    for (const SharpFeature& sharp : grains.sharp_features) ASSERT_GT(sharp.angle, 8);
    DihedralRange all = grains.angles;
    all.add(grains.angles_at_features);
    EXPECT_GE(all.smallest, 18);
    EXPECT_LE(all.largest, 160);
    std::vector<double> angles;
    const TetrahedralMesh& mesh = grains.mesh.tetrahedra;
    for (const auto& [a, b, c, d] : mesh.tetrahedra) {
        angles.push_back(
            dihedral_range(mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d])
                .smallest);
    }
    EXPECT_EQ(*std::min_element(angles.begin(), angles.end()), all.smallest);
    const auto hundredth = angles.begin() + static_cast<std::ptrdiff_t>(angles.size() / 100);
    std::nth_element(angles.begin(), hundredth, angles.end());
    EXPECT_GE(*hundredth, 27);
    EXPECT_NEAR(static_cast<double>(angles.size()) / complex.n_cells, 300, 60);
}

/// Cells of plates touch their own images, so that a move changes a tetrahedron with two images of
/// the node twice.
TEST(SharedMoves, RaiseTheSmallestSineOfPlatesThatMeetThemselves) {
    Workers one_worker(1);
    const Lattice plate = Lattice::box(1, 1, 0.05);
    const auto c = testing::voronoi_case(plate, uniform_points(plate, 3, 3));
    const std::vector<double> sizes = cell_sizes(c.complex, c.sites.spacing()).sizes;
    GrainSurface surface = grain_surface(c.complex, sizes, one_worker);
    std::vector<CellHull> hulls = cell_hulls(c.complex, surface);
    std::vector<CellTetrahedra> cells;
    for (std::size_t k = 0; k < hulls.size(); ++k) {
        cells.push_back(*fill_cell(hulls[k], sizes[k]));
    }
    const auto worst = [&] {
        return std::min({cells[0].worst(), cells[1].worst(), cells[2].worst()});
    };
    SharedMoves shared(c.complex, surface, hulls, cells, one_worker);
    for (int k = 0; k < 2; ++k) {
        const double before = worst();
        shared.move_nodes();
        EXPECT_GE(worst(), before);
    }
}

/// A node of tetrahedra of order 2: a point twice, or the ends of the edge in whose middle it lies.
using Node = std::array<int, 2>;

std::vector<Node> nodes_of(const Triple& triangle) {
    const auto [a, b, c] = sorted(triangle);
    return {{a, a}, {b, b}, {c, c}, {a, b}, {b, c}, {a, c}};
}

/// The place of a node in the unit cube, in steps of 1e-5.
std::array<int, 3> place_in_cube(const TetrahedralMesh& mesh, const Node& node) {
    const Vec3 p = (mesh.points[node[0]] + mesh.points[node[1]]) / 2;
    const auto step = [](double x) {
        // Sides of the cube and of steps lie where rounding does not matter.
        x += 0.123'456;
        return static_cast<int>(1e5 * (x - std::floor(x)));
    };
    return {step(p.x()), step(p.y()), step(p.z())};
}

/// Law (3) of tied_images(), counted from positions: of the images of each node on the seam one
/// lies on no slave, a triangle at the larger offset of its pair.
void expect_ties(const GrainMesh& mesh) {
    std::map<Node, bool> is_tied;
    for (const GrainTriangle& triangle : mesh.triangles) {
        if (triangle.offset == Offset{}) continue;
        const bool is_slave = triangle.offset < Offset{};
        for (const Node& node : nodes_of(triangle.points)) is_tied[node] |= is_slave;
        for (const Node& node : nodes_of(triangle.partners)) is_tied[node] |= !is_slave;
    }
    std::map<std::array<int, 3>, int> n_masters;
    for (const auto& [node, tied] : is_tied) {
        n_masters[place_in_cube(mesh.tetrahedra, node)] += tied ? 0 : 1;
    }
    for (const auto& [place, n] : n_masters) EXPECT_EQ(n, 1);
}

/// The lattice of three sites leaves two vertices and an edge untied unless cells are moved.
TEST(Grains, TieEachNodeOfALatticeToOneMaster) {
    const Lattice cube = Lattice::box(1, 1, 1);
    Workers one_worker(1);
    for (int n = 1; n <= 8; ++n) {
        SCOPED_TRACE(n);
        const Sites sites(cube, testing::lattice_points(n));
        const CellComplex complex = testing::complex_of({"", cube, testing::lattice_points(n)});
        for (const CellComplex& cells : {complex, cells_in_box(sites, complex, Vec3::Zero())}) {
            const Grains grains =
                mesh_grains(sites, cells, {.size = sites.spacing(), .n_rounds = 0}, one_worker);
            const TetrahedralMesh& mesh = grains.mesh.tetrahedra;
            EXPECT_EQ(n_untied_points(mesh, prove_tetrahedra(mesh)), 0);
            expect_ties(grains.mesh);
        }
    }
}

/// Law (3) of mesh_grains().
TEST(Grains, BytesDoNotDependOnThreads) {
    const Lattice cube = Lattice::box(1, 1, 1);
    const SpaceCase c{"random", cube, uniform_points(cube, 12, 3)};
    const Grains one = grains_of(c);
    const Grains three = grains_of(c, 3);
    EXPECT_EQ(one.mesh.tetrahedra.points, three.mesh.tetrahedra.points);
    EXPECT_EQ(one.mesh.tetrahedra.tetrahedra, three.mesh.tetrahedra.tetrahedra);
    EXPECT_EQ(one.mesh.tetrahedra.cell, three.mesh.tetrahedra.cell);
    EXPECT_EQ(one.angles.smallest, three.angles.smallest);
}

/// Powers of two change no digit of a position, whatever the unit of length.
TEST(Grains, KeepTheirDigitsInAnyUnit) {
    const Points points = uniform_points(Lattice::box(1, 1, 1), 6, 2);
    const Grains here = grains_of({"one", Lattice::box(1, 1, 1), points});
    for (const double unit : {0x1p100, 0x1p-100}) {
        const Grains there = grains_of({"scaled", Lattice::box(unit, unit, unit), unit * points});
        ASSERT_EQ(here.mesh.tetrahedra.tetrahedra, there.mesh.tetrahedra.tetrahedra);
        for (std::size_t p = 0; p < here.mesh.tetrahedra.points.size(); ++p) {
            EXPECT_EQ(unit * here.mesh.tetrahedra.points[p], there.mesh.tetrahedra.points[p]);
        }
        EXPECT_EQ(here.angles.smallest, there.angles.smallest);
    }
}

TEST(Grains, TranslationOfTheSitesByAPeriodChangesNothing) {
    const Lattice oblique({1, 0.2, 0.1}, {-0.3, 0.9, 0.2}, {0.4, 0.3, 1.2});
    const Sites sites(oblique, uniform_points(oblique, 6, 9));
    Points moved(3, 6);
    for (SiteId s = 0; s < 6; ++s) moved.col(s) = sites.position(s);
    const Grains here = grains_of({"here", oblique, moved});
    moved.col(2) += oblique.a() - 2 * oblique.b();
    const Grains there = grains_of({"there", oblique, moved});
    ASSERT_EQ(here.mesh.tetrahedra.cell, there.mesh.tetrahedra.cell);
    EXPECT_EQ(here.mesh.tetrahedra.tetrahedra, there.mesh.tetrahedra.tetrahedra);
}

/// The law of sharp_features(): the named angles are those of the cells, and no other is as small.
TEST(SharpFeatures, AreTheSharpCornersOfFaces) {
    const Lattice cube = Lattice::box(1, 1, 1);
    const SpaceCase c{"random", cube, uniform_points(cube, 20, 2)};
    const CellComplex complex = testing::complex_of(c);
    std::vector<double> expected;
    for (int f = 0; f < complex.n_faces(); ++f) {
        const auto corners = complex.corners_of(f);
        const std::size_t n = corners.size();
        for (std::size_t k = 0; k < n; ++k) {
            const Vec3 at = complex.position(corners[k]);
            const Vec3 u = complex.position(corners[(k + 1) % n]) - at;
            const Vec3 w = complex.position(corners[(k + n - 1) % n]) - at;
            const double angle = std::acos(u.dot(w) / (u.norm() * w.norm())) * 180 / M_PI;
            if (angle < kSharpAngle) expected.push_back(angle);
        }
    }
    std::vector<double> named;
    for (const SharpFeature& sharp : grains_of(c).sharp_features) {
        if (sharp.kind == SharpFeature::Kind::kFaceCorner) named.push_back(sharp.angle);
    }
    std::sort(expected.begin(), expected.end());
    std::sort(named.begin(), named.end());
    ASSERT_EQ(named.size(), expected.size());
    EXPECT_GT(named.size(), 0u);
    for (std::size_t k = 0; k < named.size(); ++k) EXPECT_NEAR(named[k], expected[k], 1e-6);
}

TEST(SharpFeatures, CubesHaveNone) {
    EXPECT_TRUE(
        grains_of({"grid", Lattice::box(1, 1, 1), testing::grid_points(2)}).sharp_features.empty());
}

TEST(Grains, SmallerSizesGiveMoreTetrahedra) {
    const Lattice cube = Lattice::box(1, 1, 1);
    const SpaceCase c{"random", cube, uniform_points(cube, 4, 5)};
    const Sites sites(cube, c.points);
    const CellComplex complex = testing::complex_of(c);
    std::size_t before = 0;
    for (const double part : {1.5, 3.0, 5.0}) {
        Workers one_worker(1);
        const Grains grains = mesh_grains(
            sites, complex, {.size = sites.spacing() / part, .n_rounds = 0}, one_worker);
        EXPECT_GT(grains.mesh.tetrahedra.cell.size(), before);
        before = grains.mesh.tetrahedra.cell.size();
        expect_volumes(grains.mesh, complex);
    }
}

}  // namespace
}  // namespace pcvt::space
