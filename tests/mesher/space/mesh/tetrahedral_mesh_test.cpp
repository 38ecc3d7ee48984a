#include "mesher/space/mesh/tetrahedral_mesh.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesher/plane/proof/validate.hpp"
#include "mesher/space/proof/tetrahedral_proof.hpp"
#include "tests/support/polyhedra.hpp"

namespace pcvt::space {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

PeriodicDelaunay delaunay_of(const testing::SpaceCase& c) {
    return periodic_delaunay(Sites(c.lattice, c.points));
}

TetrahedralMesh random_mesh(int n) {
    const Lattice oblique({1, 0.2, 0.1}, {-0.3, 0.9, 0.2}, {2.4, 0.3, 1.2});
    return tetrahedral_mesh(periodic_delaunay(Sites(oblique, uniform_points(oblique, n, 5))));
}

/// The message of the proof; empty if it accepts the mesh.
std::string fault_of(const TetrahedralMesh& mesh) {
    try {
        prove_tetrahedra(mesh);
    } catch (const NotATile& fault) {
        return fault.what();
    }
    return "";
}

/// Random sites, and the lattices whose coordinates doubles represent: SC, BCC and FCC among them.
std::vector<testing::SpaceCase> cases() {
    std::vector<testing::SpaceCase> kept;
    for (testing::SpaceCase& c : testing::space_cases()) {
        const bool thirds =
            c.points.cols() % 3 == 0 && c.name.find_first_of("lg") == 0 && c.name.find("left") != 0;
        if (!thirds) kept.push_back(std::move(c));
    }
    return kept;
}

TEST(TetrahedralMesh, ObeysTheLawsOnAllLattices) {
    for (const testing::SpaceCase& c : cases()) {
        SCOPED_TRACE(c.name);
        const PeriodicDelaunay delaunay = delaunay_of(c);
        const TetrahedralMesh mesh = tetrahedral_mesh(delaunay);
        const TetrahedralProof proof = prove_tetrahedra(mesh);
        EXPECT_EQ(mesh.n_tetrahedra(), delaunay.tetrahedra.n_tetrahedra());
        EXPECT_EQ(proof.n_sites, c.points.cols());
        EXPECT_EQ(2 * proof.n_triangles, 4 * mesh.n_tetrahedra());
        EXPECT_NEAR(proof.volume, c.lattice.volume(), 1e-12 * c.lattice.volume());
    }
}

TEST(TetrahedralMesh, PairsPointsByTheStatedTranslation) {
    const TetrahedralMesh mesh = random_mesh(40);
    const TetrahedralProof proof = prove_tetrahedra(mesh);
    EXPECT_FALSE(proof.pairs.empty());
    for (const TrianglePair& pair : proof.pairs) {
        EXPECT_GT(pair.offset, Offset{});
        for (int k = 0; k < 3; ++k) {
            const Vec3 image = mesh.points[pair.first[k]] + mesh.lattice.translation(pair.offset);
            EXPECT_LT((mesh.points[pair.second[k]] - image).norm(), 1e-14);
        }
    }
}

TEST(TetrahedralMesh, LiesRoundTheDomain) {
    const Lattice box = Lattice::box(2, 1, 3);
    const TetrahedralMesh mesh =
        tetrahedral_mesh(periodic_delaunay(Sites(box, uniform_points(box, 400, 2))));
    int n_outside = 0;
    for (const std::array<int, 4>& corners : mesh.tetrahedra) {
        Vec3 sum = Vec3::Zero();
        for (const int v : corners) sum += mesh.points[v];
        const Vec3 u = box.to_lattice(sum / 4);
        n_outside += u.minCoeff() < 0 || u.maxCoeff() > 1 ? 1 : 0;
    }
    EXPECT_LT(n_outside, mesh.n_tetrahedra() / 50);
}

TEST(TetrahedralMesh, MayHaveSmallTetrahedraThatAreWellShaped) {
    const Lattice cube = Lattice::box(1, 1, 1);
    Points points(3, 5);
    points << 0.5, 0.50047, 0.5, 0.50013, 0.9,  //
        0.5, 0.5, 0.50051, 0.50008, 0.1,        //
        0.5, 0.5, 0.5, 0.50053, 0.2;
    const TetrahedralMesh mesh = tetrahedral_mesh(periodic_delaunay(Sites(cube, points)));
    EXPECT_TRUE(flat_tetrahedra(mesh, 5).empty());
    EXPECT_LT(prove_tetrahedra(mesh).smallest_volume, kFlatTetrahedron / 5);
}

TEST(TetrahedralMesh, NamesFlatTetrahedra) {
    TetrahedralMesh mesh = random_mesh(20);
    EXPECT_TRUE(flat_tetrahedra(mesh, 20).empty());
    const std::array<int, 4> corners = mesh.tetrahedra[3];
    mesh.points[corners[3]] =
        (mesh.points[corners[0]] + mesh.points[corners[1]] + mesh.points[corners[2]]) / 3;
    EXPECT_THAT(flat_tetrahedra(mesh, 20), Contains(3));
}

TEST(TetrahedralMesh, IsRefutedByTheLawThatItBreaks) {
    const TetrahedralMesh mesh = random_mesh(20);
    EXPECT_EQ(fault_of(mesh), "");
    TetrahedralMesh turned = mesh;
    std::swap(turned.tetrahedra[3][0], turned.tetrahedra[3][1]);
    EXPECT_THAT(fault_of(turned), HasSubstr("law (1)"));
    TetrahedralMesh moved = mesh;
    moved.points.back().x() += 1e-9;
    EXPECT_THAT(fault_of(moved), HasSubstr("law (2)"));
    TetrahedralMesh renamed = mesh;
    for (SiteId& site : renamed.point_site) ++site;
    EXPECT_THAT(fault_of(renamed), HasSubstr("law (2)"));
    TetrahedralMesh shortened = mesh;
    shortened.tetrahedra.pop_back();
    EXPECT_THAT(fault_of(shortened), HasSubstr("law (4)"));
    TetrahedralMesh doubled = mesh;
    doubled.points.push_back(doubled.points[0]);
    doubled.point_site.push_back(doubled.point_site[0]);
    doubled.point_offset.push_back(doubled.point_offset[0]);
    EXPECT_THAT(fault_of(doubled), HasSubstr("law (2)"));
}

}  // namespace
}  // namespace pcvt::space
