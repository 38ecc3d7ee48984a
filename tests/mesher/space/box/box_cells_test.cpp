#include "mesher/space/box/box_cells.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "mesher/base/law_violation.hpp"
#include "mesher/space/box/box_sides.hpp"
#include "mesher/space/cvt/weighted_cells.hpp"
#include "mesher/space/mesh/cell_sites.hpp"
#include "mesher/space/mesh/short_edges.hpp"
#include "mesher/space/proof/polyhedral_proof.hpp"
#include "tests/support/polyhedra.hpp"
#include "tests/support/random_numbers.hpp"

namespace pcvt::space {
namespace {

using testing::complex_of;
using testing::space_cases;
using testing::SpaceCase;

/// V - E + F - C of the torus, and whether the faces of each cell close.
int euler(const CellComplex& complex) {
    std::set<int> vertices;
    std::set<std::tuple<int, int, Offset>> edges;
    std::map<std::tuple<SiteId, VertexImage, VertexImage>, int> sides;
    for (int f = 0; f < complex.n_faces(); ++f) {
        const CellFace& face = complex.faces[f];
        const auto corners = complex.corners_of(f);
        for (std::size_t k = 0; k < corners.size(); ++k) {
            VertexImage v = corners[k];
            VertexImage w = corners[(k + 1) % corners.size()];
            vertices.insert(v.vertex);
            edges.insert(w < v && v.vertex != w.vertex
                             ? std::tuple(w.vertex, v.vertex, v.offset - w.offset)
                             : std::tuple(v.vertex, w.vertex,
                                          v.vertex == w.vertex
                                              ? std::max(w.offset - v.offset, v.offset - w.offset)
                                              : w.offset - v.offset));
            ++sides[{face.cell, v, w}];
            v.offset = v.offset - face.offset;
            w.offset = w.offset - face.offset;
            ++sides[{face.neighbour, w, v}];
        }
    }
    for (const auto& [side, count] : sides) {
        const auto& [cell, v, w] = side;
        EXPECT_EQ(count, 1);
        EXPECT_TRUE(sides.contains({cell, w, v}));
    }
    return static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) + complex.n_faces() -
           complex.n_cells;
}

/// Laws (1) and (2), and the laws of PolyhedralMesh for the pieces.
void expect_laws(const Sites& sites, const CellComplex& complex, const Vec3& origin) {
    const CellComplex pieces = cells_in_box(sites, complex, origin);
    EXPECT_EQ(euler(pieces), 0);
    ASSERT_EQ(pieces.n_cells, std::ssize(pieces.piece_cell));
    EXPECT_TRUE(std::is_sorted(pieces.piece_cell.begin(), pieces.piece_cell.end()));
    const std::vector<CellBody> parts = cell_bodies(pieces);
    const std::vector<CellBody> bodies = cell_bodies(complex);
    std::vector<double> volumes(bodies.size(), 0);
    for (std::size_t p = 0; p < parts.size(); ++p) {
        EXPECT_GT(parts[p].volume, 0);
        volumes[pieces.piece_cell[p]] += parts[p].volume;
    }
    const double mean = sites.lattice().volume() / sites.n_sites();
    for (std::size_t s = 0; s < bodies.size(); ++s) {
        EXPECT_NEAR(volumes[s], bodies[s].volume, 1e-11 * mean) << s;
    }
    PolyhedralMesh mesh = polyhedral_mesh(sites, pieces, origin);
    put_on_sides(origin, mesh);
    const PolyhedralProof proof = prove_polyhedra(mesh);
    EXPECT_TRUE(proof.boundary_is_manifold);
    EXPECT_EQ(proof.n_translations, 3);
    for (const Vec3& p : mesh.points) {
        const Vec3 u = sites.lattice().to_lattice(p - origin);
        EXPECT_GE(u.minCoeff(), -1e-14);
        EXPECT_LE(u.maxCoeff(), 1 + 1e-14);
    }
}

/// An origin without digits in common with lattices.
Vec3 origin_of(const Lattice& lattice) { return lattice.to_position({0.123, -1.345, 0.678}); }

TEST(BoxCells, ObeyTheLawsOnAllLattices) {
    for (const SpaceCase& c : space_cases()) {
        SCOPED_TRACE(c.name);
        const Sites sites(c.lattice, c.points);
        const CellComplex complex = complex_of(c);
        expect_laws(sites, complex, origin_of(c.lattice));
    }
}

/// The sides of the box run through vertices, along edges and in faces of cells, and through
/// sites.
TEST(BoxCells, ObeyTheLawsWherePlanesMeetCellsOfLattices) {
    const Lattice cube = Lattice::box(1, 1, 1);
    for (const int n : {1, 2, 4, 8, 16, 27, 32, 54}) {
        const SpaceCase c{"lattice", cube, testing::lattice_points(n)};
        const Sites sites(cube, c.points);
        const CellComplex complex = complex_of(c);
        for (const double u : {0.0, 1.0 / 12, 0.125, 1.0 / 6, 0.25, 1.0 / 3, 0.5}) {
            for (const Vec3& origin : {Vec3(u, u, u), Vec3(u, 0, 0.25), Vec3(0.1, u, 0.5)}) {
                SCOPED_TRACE(::testing::Message() << n << " sites, origin " << origin.transpose());
                expect_laws(sites, complex, origin);
            }
        }
    }
}

/// A convex polyhedron by its faces, for clipping by half-spaces.
using Polyhedron = std::vector<std::vector<Vec3>>;

Polyhedron box_at(const Lattice& lattice, const Vec3& origin) {
    const auto corner = [&](int i, int j, int k) -> Vec3 {
        return origin + lattice.translation({i, j, k});
    };
    Polyhedron box{{corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0), corner(1, 0, 0)},
                   {corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1)},
                   {corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1)},
                   {corner(0, 1, 0), corner(0, 1, 1), corner(1, 1, 1), corner(1, 1, 0)},
                   {corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), corner(0, 1, 0)},
                   {corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1), corner(1, 0, 1)}};
    if (!lattice.right_handed()) {
        for (auto& face : box) std::reverse(face.begin(), face.end());
    }
    return box;
}

/// The part of a polyhedron with normal . p <= limit.
Polyhedron clipped(const Polyhedron& whole, const Vec3& normal, double limit) {
    Polyhedron part;
    std::vector<Vec3> cap;
    for (const auto& face : whole) {
        std::vector<Vec3> kept;
        for (std::size_t k = 0; k < face.size(); ++k) {
            const Vec3& p = face[k];
            const Vec3& q = face[(k + 1) % face.size()];
            const double here = normal.dot(p) - limit;
            const double there = normal.dot(q) - limit;
            if (here <= 0) kept.push_back(p);
            if ((here <= 0) == (there <= 0)) continue;
            cap.push_back(p + here / (here - there) * (q - p));
            kept.push_back(cap.back());
        }
        if (kept.size() >= 3) part.push_back(kept);
    }
    if (cap.size() < 3) return part;
    Vec3 middle = Vec3::Zero();
    for (const Vec3& p : cap) middle += p / static_cast<double>(cap.size());
    const Vec3 x = (cap[0] - middle).normalized();
    const Vec3 y = normal.normalized().cross(x);
    std::sort(cap.begin(), cap.end(), [&](const Vec3& p, const Vec3& q) {
        return std::atan2((p - middle).dot(y), (p - middle).dot(x)) <
               std::atan2((q - middle).dot(y), (q - middle).dot(x));
    });
    part.push_back(cap);
    return part;
}

CellBody body_of(const Polyhedron& polyhedron) {
    PyramidSum sum(polyhedron[0][0]);
    for (const auto& face : polyhedron) sum.add(face);
    return sum.body();
}

/// Law (3), by clipping the box at the planes between sites.
void expect_clipped_boxes(const SpaceCase& c, const Vec3& origin) {
    const Sites sites(c.lattice, c.points);
    const CellComplex pieces = cells_in_box(sites, complex_of(c), origin);
    const std::vector<CellBody> bodies = cell_bodies(pieces);
    const Lattice& reduced = sites.reduction().reduced;
    for (int p = 0; p < pieces.n_cells; ++p) {
        const Vec3 here = pieces.sites[p];
        Polyhedron part = box_at(c.lattice, origin);
        for (SiteId t = 0; t < sites.n_sites(); ++t) {
            for (int k = 0; k < 125; ++k) {
                const Vec3 image = sites.position(t) - sites.position(pieces.piece_cell[p]) +
                                   reduced.translation({k / 25 - 2, k / 5 % 5 - 2, k % 5 - 2});
                if (image.norm() < 1e-9) continue;
                part = clipped(part, image, image.dot(here + image / 2));
                ASSERT_FALSE(part.empty());
            }
        }
        const CellBody body = body_of(part);
        EXPECT_NEAR(bodies[p].volume, body.volume, 1e-11 * c.lattice.volume());
        if (body.volume < 1e-6 * c.lattice.volume()) continue;
        EXPECT_LT((bodies[p].centroid - body.centroid).norm(), 1e-6 * sites.spacing());
    }
}

TEST(BoxCells, AreThePartsOfTheCellsInTheBox) {
    for (const SpaceCase& c : space_cases()) {
        if (c.points.cols() > 3 || c.name.find("thin") == 0) continue;
        SCOPED_TRACE(c.name);
        expect_clipped_boxes(c, origin_of(c.lattice));
    }
}

TEST(BoxCells, ObeyTheLawsInPowerCells) {
    const Lattice oblique({1, 0.2, 0.1}, {-0.3, 0.9, 0.2}, {0.4, 0.3, 1.2});
    std::mt19937_64 random(1);
    for (const int n : {1, 3, 20}) {
        SCOPED_TRACE(n);
        Eigen::VectorXd weights(n);
        for (double& w : weights) w = 0.01 * testing::random_number(random);
        const WeightedCells cells =
            weighted_cells(oblique, uniform_points(oblique, n, 3), weights, {});
        const PeriodicDelaunay& delaunay = cells.delaunay;
        expect_laws(delaunay.sites,
                    cell_complex(delaunay.sites, delaunay.tetrahedra, delaunay.weights),
                    origin_of(oblique));
    }
}

/// Faces are not plane.
TEST(BoxCells, FillTheBoxWithoutShortEdges) {
    const Lattice cube = Lattice::box(1, 1, 1);
    for (const std::uint64_t seed : {1, 2, 3}) {
        const SpaceCase c{"random", cube, uniform_points(cube, 60, seed)};
        const Sites sites(cube, c.points);
        for (const double shortest : {0.02, 0.1}) {
            SCOPED_TRACE(::testing::Message() << "seed " << seed << ", " << shortest << " h");
            const CellComplex complex = without_short_edges(complex_of(c), shortest);
            const CellComplex pieces = cells_in_box(sites, complex, {0, 0.3, -0.1});
            EXPECT_EQ(euler(pieces), 0);
            const PolyhedralMesh mesh = polyhedral_mesh(sites, pieces);
            EXPECT_NEAR(prove_polyhedra(mesh).volume, 1, 1e-12);
            std::vector<Offset> images(static_cast<std::size_t>(pieces.n_cells));
            EXPECT_LE(prove_cell_sites(mesh, sites_of_cells(pieces, images)).from_bisector,
                      shortest);
        }
    }
}

void expect_equal_pieces(const CellComplex& here, const CellComplex& there, const Vec3& moved) {
    ASSERT_EQ(here.piece_cell, there.piece_cell);
    const std::vector<CellBody> bodies = cell_bodies(here);
    const std::vector<CellBody> others = cell_bodies(there);
    for (std::size_t p = 0; p < bodies.size(); ++p) {
        EXPECT_NEAR(bodies[p].volume, others[p].volume, 1e-12);
        EXPECT_LT((bodies[p].centroid + moved - others[p].centroid).norm(), 1e-6);
    }
}

/// Law (4).
TEST(BoxCells, TranslationsOfTheLatticeChangeNothing) {
    const Lattice oblique({1, 0.2, 0.1}, {-0.3, 0.9, 0.2}, {2.4, 0.3, 1.2});
    SpaceCase c{"oblique", oblique, uniform_points(oblique, 10, 9)};
    const Vec3 origin(0.1, 0.2, 0.3);
    const CellComplex here = cells_in_box(Sites(oblique, c.points), complex_of(c), origin);
    c.points.col(2) += oblique.a() - 2 * oblique.b();
    const Sites sites(oblique, c.points);
    expect_equal_pieces(here, cells_in_box(sites, complex_of(c), origin), Vec3::Zero());
    const Vec3 moved = oblique.translation({3, -5, 1});
    expect_equal_pieces(here, cells_in_box(sites, complex_of(c), origin + moved), moved);
}

/// The pieces have the sites of their cells, and a site of another cell is refuted.
TEST(BoxCells, AreProvedToBeTheCellsOfTheirSites) {
    const Lattice cube = Lattice::box(1, 1, 1);
    const SpaceCase c{"random", cube, uniform_points(cube, 12, 5)};
    const Sites all(cube, c.points);
    const CellComplex pieces = cells_in_box(all, complex_of(c), Vec3::Zero());
    const PolyhedralMesh mesh = polyhedral_mesh(all, pieces);
    Points sites = sites_of_cells(pieces, std::vector<Offset>(mesh.piece_cell.size()));
    EXPECT_EQ(cells_of_pieces(cube, sites), mesh.piece_cell);
    EXPECT_LT(prove_cell_sites(mesh, sites).from_bisector, 1e-12);
    EXPECT_TRUE(cells_of_pieces(cube, all.positions()).empty());
    sites.col(3).x() += 1;
    EXPECT_THROW(prove_cell_sites(mesh, sites), NotATile);
}

/// Sides of the box that pass through faces, edges and vertices of cubes up to 1e-6 cut nothing off
/// where vertices are snapped.
TEST(SnappedVertices, LeaveNoThinPieces) {
    Points points(3, 8);
    for (int k = 0; k < 8; ++k) {
        points.col(k) = Vec3(0.25, 0.25, 0.25) + Vec3(k & 1, k >> 1 & 1, k >> 2) / 2;
    }
    const PeriodicDelaunay delaunay = periodic_delaunay(Sites(Lattice::box(1, 1, 1), points));
    const CellComplex cells = cell_complex(delaunay.sites, delaunay.tetrahedra);
    for (const Vec3& origin : {Vec3(1e-6, -2e-6, 3e-6), Vec3(2e-6, 0.2, -1e-6)}) {
        const CellComplex pieces = cells_in_box(delaunay.sites, cells, origin, kSnappedVertices);
        EXPECT_EQ(euler(pieces), 0);
        const std::vector<CellBody> bodies = cell_bodies(pieces);
        double least = 1;
        for (const CellBody& body : bodies) least = std::min(least, body.volume);
        EXPECT_GT(least, 0.01);
        EXPECT_EQ(pieces.n_cells, origin.y() < 0.1 ? 8 : 12);
        const CellComplex cut = cells_in_box(delaunay.sites, cells, origin);
        EXPECT_GT(cut.n_cells, pieces.n_cells);
    }
}

/// An edge of 1e-6 keeps both ends, though both are near to a side.
TEST(SnappedVertices, RemainApartWhereAnEdgeIsShorter) {
    const Lattice cube = Lattice::box(1, 1, 1);
    std::mt19937_64 random(3);
    Points points(3, 8);
    for (int k = 0; k < 8; ++k) {
        const Vec3 arm(testing::random_number(random), testing::random_number(random),
                       testing::random_number(random));
        points.col(k) = Vec3(0.25, 0.25, 0.25) + Vec3(k & 1, k >> 1 & 1, k >> 2) / 2 + 2e-6 * arm;
    }
    const PeriodicDelaunay delaunay = periodic_delaunay(Sites(cube, points));
    const CellComplex cells = cell_complex(delaunay.sites, delaunay.tetrahedra);
    const CellComplex pieces =
        cells_in_box(delaunay.sites, cells, Vec3(0.5, 0.2, 0.3), kSnappedVertices);
    EXPECT_EQ(euler(pieces), 0);
    double shortest = 1;
    for (int f = 0; f < pieces.n_faces(); ++f) {
        const auto corners = pieces.corners_of(f);
        for (std::size_t k = 0; k < corners.size(); ++k) {
            shortest = std::min(shortest, (pieces.position(corners[k]) -
                                           pieces.position(corners[(k + 1) % corners.size()]))
                                              .norm());
        }
    }
    EXPECT_GT(shortest, 1e-11);
}

/// The least height of a piece above its largest face.
double thinnest(const CellComplex& pieces) {
    std::vector<double> area(static_cast<std::size_t>(pieces.n_cells), 0);
    for (int f = 0; f < pieces.n_faces(); ++f) {
        const auto corners = pieces.corners_of(f);
        Vec3 twice = Vec3::Zero();
        const Vec3 first = pieces.position(corners[0]);
        for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
            twice += (pieces.position(corners[k]) - first)
                         .cross(pieces.position(corners[k + 1]) - first);
        }
        for (const SiteId cell : {pieces.faces[f].cell, pieces.faces[f].neighbour}) {
            area[cell] = std::max(area[cell], twice.norm() / 2);
        }
    }
    double thinnest = 1;
    const std::vector<CellBody> bodies = cell_bodies(pieces);
    for (int c = 0; c < pieces.n_cells; ++c) {
        thinnest = std::min(thinnest, bodies[c].volume / area[c]);
    }
    return thinnest;
}

/// Sides through square faces of truncated octahedra of which some corners are too far to be
/// snapped: the part between the others lies in the side.
TEST(SnappedVertices, CutFacesThatHaveOtherCorners) {
    const Lattice cube = Lattice::box(1, 1, 1);
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        SCOPED_TRACE(seed);
        const double h = std::cbrt(1.0 / 16);
        Points points = 1.6e-4 * h * uniform_points(cube, 16, seed);
        for (int k = 0; k < 16; ++k) {
            points.col(k) +=
                Vec3(k & 1, k >> 1 & 1, k >> 2 & 1) / 2 + Vec3::Constant((k >> 3) / 4.0);
        }
        const PeriodicDelaunay delaunay = periodic_delaunay(Sites(cube, points));
        const CellComplex cells = cell_complex(delaunay.sites, delaunay.tetrahedra);
        for (const Vec3& origin : {cells.sites[3], cells.vertices[0]}) {
            const CellComplex pieces =
                cells_in_box(delaunay.sites, cells, origin, kSnappedVertices);
            EXPECT_EQ(euler(pieces), 0);
            EXPECT_GT(thinnest(pieces), 3e-5 * h);
        }
    }
}

/// A side through whole faces of cubes whose edges have inner vertices.
TEST(SnappedVertices, TouchFacesAlongSeveralEdges) {
    const Lattice cube = Lattice::box(1, 1, 1);
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
        SCOPED_TRACE(seed);
        Points points = 1e-6 * uniform_points(cube, 27, seed);
        for (int k = 0; k < 27; ++k) points.col(k) += Vec3(k % 3, k / 3 % 3, k / 9) / 3;
        const PeriodicDelaunay delaunay = periodic_delaunay(Sites(cube, points));
        const CellComplex cells = without_short_edges(
            cell_complex(delaunay.sites, delaunay.tetrahedra), 1e-3, ShrinkRule::kWideCorners);
        ASSERT_GT(cells.vertices.size(), 27U);
        const CellComplex pieces =
            cells_in_box(delaunay.sites, cells, Vec3(1, 1, 1) / 6, kSnappedVertices);
        EXPECT_EQ(euler(pieces), 0);
        EXPECT_EQ(pieces.n_cells, 27);
    }
}

}  // namespace
}  // namespace pcvt::space
