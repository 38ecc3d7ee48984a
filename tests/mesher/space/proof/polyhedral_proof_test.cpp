#include "mesher/space/proof/polyhedral_proof.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "mesher/plane/proof/validate.hpp"
#include "mesher/space/mesh/boundary_surface.hpp"
#include "tests/support/polyhedra.hpp"

namespace pcvt::space {
namespace {

PolyhedralMesh random_mesh() {
    const Lattice cube = Lattice::box(1, 1, 1);
    return testing::mesh_of({"", cube, uniform_points(cube, 40, 5)});
}

/// Expects that the proof of a damaged mesh names a law.
template <class Damage>
void expect_refuted(const char* law, const Damage& damage) {
    PolyhedralMesh mesh = random_mesh();
    damage(mesh);
    try {
        prove_polyhedra(mesh);
        ADD_FAILURE() << "law " << law << " was not refuted";
    } catch (const NotATile& error) {
        EXPECT_THAT(error.what(), ::testing::HasSubstr(law));
    }
}

TEST(ProvePolyhedra, NamesTheBrokenOrder) {
    expect_refuted("(1)",
                   [](PolyhedralMesh& mesh) { std::swap(mesh.owner[0], mesh.neighbour[0]); });
    expect_refuted("(1)", [](PolyhedralMesh& mesh) { mesh.patches[0].n_faces -= 1; });
    expect_refuted("(1)",
                   [](PolyhedralMesh& mesh) { mesh.faces.corners[1] = mesh.faces.corners[0]; });
    expect_refuted("(1)", [](PolyhedralMesh& mesh) { mesh.faces.corners[0] = mesh.n_points(); });
    expect_refuted("(1)", [](PolyhedralMesh& mesh) { mesh.owner.back() = -1; });
}

TEST(ProvePolyhedra, NamesTheBrokenCell) {
    expect_refuted("(2)", [](PolyhedralMesh& mesh) {
        auto* const corners = mesh.faces.corners.data();
        std::reverse(corners, corners + mesh.faces.begin[1]);
    });
    expect_refuted("(2)", [](PolyhedralMesh& mesh) { mesh.owner.back() = 0; });
    expect_refuted("(2)", [](PolyhedralMesh& mesh) {
        // A point that only inner faces have: its cells become concave, and the volumes still sum.
        std::vector<bool> outer(mesh.points.size(), false);
        for (int c = mesh.faces.begin[mesh.n_inner_faces()]; c < mesh.faces.begin.back(); ++c) {
            outer[mesh.faces.corners[c]] = true;
        }
        const auto inner = std::find(outer.begin(), outer.end(), false) - outer.begin();
        mesh.points[inner] += Vec3(0.03, 0.02, -0.03);
    });
}

TEST(ProvePolyhedra, NamesTheBrokenSeam) {
    expect_refuted("(3)", [](PolyhedralMesh& mesh) {
        for (Vec3& p : mesh.points) p.x() *= 1 + 1e-12;
    });
    expect_refuted("(3)", [](PolyhedralMesh& mesh) { mesh.patches[0].offset[0] += 1; });
    expect_refuted("(3)", [](PolyhedralMesh& mesh) { mesh.patches[0].partner = 0; });
    expect_refuted("another translation",
                   [](PolyhedralMesh& mesh) { mesh.patches[0].separation.x() += 1e-15; });
    expect_refuted("another translation",
                   [](PolyhedralMesh& mesh) { mesh.patches[0].name = mesh.patches[1].name; });
    expect_refuted("(3)", [](PolyhedralMesh& mesh) {
        // The same face from another corner.
        auto* const corners = mesh.faces.corners.data();
        std::rotate(corners + mesh.faces.begin[mesh.n_inner_faces()],
                    corners + mesh.faces.begin[mesh.n_inner_faces()] + 1,
                    corners + mesh.faces.begin[mesh.n_inner_faces() + 1]);
    });
}

TEST(ProvePolyhedra, NamesTheBrokenOrbit) {
    expect_refuted("(6)", [](PolyhedralMesh& mesh) { mesh.point_offset.back().k += 1; });
    expect_refuted("(6)", [](PolyhedralMesh& mesh) { mesh.point_orbit.back() -= 1; });
    expect_refuted("(6)", [](PolyhedralMesh& mesh) { mesh.points[0].x() = std::nan(""); });
}

/// Two cubes that share only an edge, or only a corner.
TEST(BoundaryIsManifold, FindsPinchedEdgesAndPoints) {
    for (const Vec3& step : {Vec3(1, 1, 0), Vec3(1, 1, 1)}) {
        PolyhedralMesh mesh{{}, Lattice::box(9, 9, 9)};
        const auto point = [&](const Vec3& p) {
            const auto found = std::find(mesh.points.begin(), mesh.points.end(), p);
            if (found == mesh.points.end()) mesh.points.push_back(p);
            return static_cast<int>(std::find(mesh.points.begin(), mesh.points.end(), p) -
                                    mesh.points.begin());
        };
        for (int cube = 0; cube < 2; ++cube) {
            for (int face = 0; face < 6; ++face) {
                const int axis = face / 2;
                std::vector<int> corners;
                for (int k = 0; k < 4; ++k) {
                    Vec3 p = cube * step;
                    p[axis] += face % 2;
                    p[(axis + 1) % 3] += k == 1 || k == 2 ? 1 : 0;
                    p[(axis + 2) % 3] += k >= 2 ? 1 : 0;
                    corners.push_back(point(p));
                }
                if (face % 2 == 0) std::reverse(corners.begin(), corners.end());
                mesh.faces.add(corners);
                mesh.owner.push_back(cube);
            }
            EXPECT_EQ(boundary_is_manifold(mesh), cube == 0);
        }
    }
}

}  // namespace
}  // namespace pcvt::space
