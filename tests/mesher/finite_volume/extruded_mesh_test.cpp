#include "mesher/finite_volume/extruded_mesh.hpp"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "mesher/finite_volume/extruded_base.hpp"
#include "mesher/plane/mesh/outline.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/proof/validate.hpp"
#include "mesher/plane/tile/tile_builder.hpp"
#include "tests/support/grid_tile.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/random_meshes.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;
using testing::lattices;
using testing::random_tile;

std::vector<Eigen::Vector3d> face_points(const FiniteVolumeMesh& extruded, int f) {
    std::vector<Eigen::Vector3d> points;
    for (const int v : extruded.faces[f]) {
        points.push_back(extruded.points[v]);
    }
    return points;
}

/// Returns the corners of each face, starting with the smallest index.
std::vector<std::vector<int>> turned_faces(const plane::Tile& tile) {
    std::vector<std::vector<int>> faces;
    for (int f = 0; f < tile.n_faces(); ++f) {
        std::vector<int> face(tile.faces[f].begin(), tile.faces[f].end());
        std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
        faces.push_back(face);
    }
    return faces;
}

TEST(ExtrudedMesh, ItsBaseIsTheTile) {
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {1, 2, 7, 40}) {
            for (const plane::MeshKind kind :
                 {plane::MeshKind::kVoronoi, plane::MeshKind::kDelaunay}) {
                plane::Tile tile = random_tile(lattice, n, kind);
                plane::Tile back = extruded_base(extruded_mesh(tile), lattice, kind);
                EXPECT_EQ(back.points, tile.points) << name;
                EXPECT_EQ(turned_faces(back), turned_faces(tile)) << name;
                std::sort(back.edge_pairs.begin(), back.edge_pairs.end());
                std::sort(tile.edge_pairs.begin(), tile.edge_pairs.end());
                EXPECT_TRUE(back.edge_pairs == tile.edge_pairs) << name << ' ' << n;
            }
        }
    }
}

TEST(ExtrudedMesh, NormalsPointOutOfTheOwner) {
    const plane::Tile tile =
        random_tile(plane::Lattice({1, 0}, {0.37, 0.81}), 40, plane::MeshKind::kVoronoi);
    const FiniteVolumeMesh extruded = extruded_mesh(tile);
    for (int f = 0; f < extruded.n_faces(); ++f) {
        const auto points = face_points(extruded, f);
        const Eigen::Vector3d normal = (points[1] - points[0]).cross(points[2] - points[0]);
        const plane::Vec2& site = tile.site_points[extruded.owner[f]];
        const Eigen::Vector3d centre(site.x(), site.y(), extruded.points.back().z() / 2);
        EXPECT_GT(normal.dot(points[0] - centre), 0) << f;
        if (f >= extruded.n_inner_faces()) continue;
        EXPECT_LT(extruded.owner[f], extruded.neighbour[f]);
        if (f > 0) {
            EXPECT_LE(std::pair(extruded.owner[f - 1], extruded.neighbour[f - 1]),
                      std::pair(extruded.owner[f], extruded.neighbour[f]));
        }
    }
}

TEST(ExtrudedMesh, FacesOfASeamMatchPointByPoint) {
    const FiniteVolumeMesh extruded = extruded_mesh(
        random_tile(plane::Lattice({1, 0}, {0.37, 0.81}), 40, plane::MeshKind::kVoronoi));
    int n_answers = 0;
    for (const FiniteVolumePatch& patch : extruded.patches) {
        if (patch.partner < 0) continue;
        const FiniteVolumePatch& partner = extruded.patches[patch.partner];
        ASSERT_EQ(patch.n_faces, partner.n_faces);
        EXPECT_EQ(patch.name, seam_name(std::span<const int>(patch.offset)));
        for (int k = 0; k < patch.n_faces; ++k) {
            const auto here = face_points(extruded, patch.first_face + k);
            const auto there = face_points(extruded, partner.first_face + k);
            for (int p = 0; p < 4; ++p, ++n_answers) {
                const Eigen::Vector3d gap = there[(4 - p) % 4] - here[p];
                EXPECT_LT((gap - patch.separation).norm(), 1e-15);
                EXPECT_EQ(gap.z(), 0);
            }
        }
    }
    EXPECT_GT(n_answers, 100);
}

/// Returns the message of extruded_base for a sound extruded mesh after `damage`.
template <class Damage>
std::string fault_after(Damage damage) {
    const plane::Lattice lattice({1, 0}, {0.37, 0.81});
    FiniteVolumeMesh extruded = extruded_mesh(testing::grid_tile(lattice, 4, 3));
    damage(extruded);
    try {
        extruded_base(extruded, lattice, plane::MeshKind::kVoronoi);
    } catch (const NotATile& fault) {
        return fault.what();
    }
    return "";
}

TEST(ExtrudedMesh, BrokenPlanesAreRefused) {
    EXPECT_EQ(fault_after([](FiniteVolumeMesh&) {}), "");
    EXPECT_THAT(fault_after([](FiniteVolumeMesh& s) { s.points.back().x() += 1e-15; }),
                HasSubstr("law (1) of extruded meshes"));
    EXPECT_THAT(fault_after([](FiniteVolumeMesh& s) { s.points[3].z() = 1e-15; }),
                HasSubstr("law (1) of extruded meshes"));
    EXPECT_THAT(
        fault_after([](FiniteVolumeMesh& s) { std::swap(s.faces.corners[1], s.faces.corners[2]); }),
        HasSubstr("not an upright face"));
    EXPECT_THAT(
        fault_after([](FiniteVolumeMesh& s) { s.faces.corners.back() = s.faces.corners[0]; }),
        HasSubstr("not a prism"));
}

TEST(ExtrudedMesh, FacesOutOfOrderAreRefused) {
    EXPECT_THAT(fault_after([](FiniteVolumeMesh& s) { std::swap(s.owner[0], s.neighbour[0]); }),
                HasSubstr("not below its neighbour"));
    EXPECT_THAT(fault_after([](FiniteVolumeMesh& s) { std::swap(s.neighbour[0], s.neighbour[1]); }),
                HasSubstr("out of order"));
    EXPECT_THAT(fault_after([](FiniteVolumeMesh& s) { ++s.neighbour[0]; }),
                HasSubstr("law (2) of extruded meshes"));
    EXPECT_THAT(fault_after([](FiniteVolumeMesh& s) { s.owner.back() = 99; }),
                HasSubstr("law (2)"));
    EXPECT_THAT(fault_after([](FiniteVolumeMesh& s) { s.owner[s.patches[0].first_face] = 12; }),
                HasSubstr("12 and 12 faces for 13 cells"));
    EXPECT_THAT(fault_after([](FiniteVolumeMesh& s) {
                    s.faces.begin[s.faces.begin.size() - 13] -= 4;
                    s.faces.begin[s.faces.begin.size() - 14] =
                        s.faces.begin[s.faces.begin.size() - 13];
                }),
                HasSubstr("law ("));
    EXPECT_THAT(fault_after([](FiniteVolumeMesh& s) { s.faces.corners[5] = -1; }),
                HasSubstr("point -1"));
    EXPECT_THAT(fault_after([](FiniteVolumeMesh& s) {
                    std::rotate(s.faces.corners.begin(), s.faces.corners.begin() + 1,
                                s.faces.corners.begin() + 4);
                    std::swap(s.faces.corners[0], s.faces.corners[1]);
                    std::swap(s.faces.corners[2], s.faces.corners[3]);
                }),
                HasSubstr("law ("));
    EXPECT_THAT(fault_after([](FiniteVolumeMesh& s) { --s.patches[1].n_faces; }),
                HasSubstr("patch"));
    EXPECT_THAT(fault_after([](FiniteVolumeMesh& s) { s.patches.pop_back(); }),
                HasSubstr("leave face"));
}

TEST(ExtrudedMesh, FalseSeamsAreRefused) {
    EXPECT_THAT(fault_after([](FiniteVolumeMesh& s) { s.patches[0].separation.x() += 1e-12; }),
                HasSubstr("states a separation other than"));
    EXPECT_THAT(fault_after([](FiniteVolumeMesh& s) { s.patches[0].name = "seam_1_1"; }),
                HasSubstr("states a separation other than"));
    EXPECT_THAT(fault_after([](FiniteVolumeMesh& s) { s.patches[0].partner = 2; }),
                HasSubstr("do not match each other"));
    EXPECT_THAT(fault_after([](FiniteVolumeMesh& s) {
                    const auto first =
                        s.faces.corners.begin() + s.faces.begin[s.patches[0].first_face];
                    std::rotate(first, first + 1, first + 4);
                }),
                HasSubstr("do not begin at matching points"));
}

TEST(ExtrudedMesh, SwappedFacesOfASeamAreRefused) {
    const plane::Lattice lattice = plane::Lattice::rectangle(1, 1);
    FiniteVolumeMesh extruded = extruded_mesh(testing::grid_tile(lattice, 4, 3));
    const auto first =
        extruded.faces.corners.begin() + extruded.faces.begin[extruded.patches[0].first_face];
    std::swap_ranges(first, first + 4, first + 4);
    std::swap(extruded.owner[extruded.patches[0].first_face],
              extruded.owner[extruded.patches[0].first_face + 1]);
    const plane::Tile tile = extruded_base(extruded, lattice, plane::MeshKind::kVoronoi);
    EXPECT_THROW(compare_edge_pairs(tile, prove_tile(tile, plane::Precision::kDouble)), NotATile);
}

}  // namespace
}  // namespace pcvt
