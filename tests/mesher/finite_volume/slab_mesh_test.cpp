#include "mesher/finite_volume/slab_mesh.hpp"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "mesher/finite_volume/slab_tile.hpp"
#include "mesher/mesh/outline.hpp"
#include "mesher/mesh/voronoi.hpp"
#include "mesher/proof/validate.hpp"
#include "mesher/tile/tile.hpp"
#include "tests/support/grid_tile.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;
using testing::lattices;

FlatTile random_tile(const Lattice& lattice, int n, TileKind kind) {
    const PeriodicDelaunay delaunay(Sites(lattice, uniform_points(lattice, n, 4)));
    const PeriodicMesh mesh =
        kind == TileKind::kCells ? cell_mesh(delaunay) : triangle_mesh(delaunay);
    return flatten(make_tile(mesh, whole_outline(mesh, Vec2(0, 0))));
}

std::vector<Eigen::Vector3d> face_points(const SlabMesh& slab, int f) {
    std::vector<Eigen::Vector3d> points;
    for (int c = slab.face_begin[f]; c < slab.face_begin[f + 1]; ++c) {
        points.push_back(slab.points[slab.corners[c]]);
    }
    return points;
}

/// The corners of each face, each face beginning with its smallest.
std::vector<std::vector<int>> turned_faces(const FlatTile& tile) {
    std::vector<std::vector<int>> faces;
    for (int f = 0; f < tile.n_faces(); ++f) {
        std::vector<int> face(tile.corners.begin() + tile.face_begin[f],
                              tile.corners.begin() + tile.face_begin[f + 1]);
        std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
        faces.push_back(face);
    }
    return faces;
}

TEST(SlabMesh, ATileComesBackFromItsBackPlaneAndItsPatches) {
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {1, 2, 7, 40}) {
            for (const TileKind kind : {TileKind::kCells, TileKind::kTriangles}) {
                FlatTile tile = random_tile(lattice, n, kind);
                FlatTile back = slab_tile(slab_mesh(tile));
                EXPECT_EQ(back.points, tile.points) << name;
                EXPECT_EQ(turned_faces(back), turned_faces(tile)) << name;
                std::sort(back.edge_pairs.begin(), back.edge_pairs.end());
                std::sort(tile.edge_pairs.begin(), tile.edge_pairs.end());
                EXPECT_TRUE(back.edge_pairs == tile.edge_pairs) << name << ' ' << n;
            }
        }
    }
}

TEST(SlabMesh, NormalsLeaveTheOwner) {
    const FlatTile tile = random_tile(Lattice({1, 0}, {0.37, 0.81}), 40, TileKind::kCells);
    const SlabMesh slab = slab_mesh(tile);
    for (int f = 0; f < slab.n_faces(); ++f) {
        const auto points = face_points(slab, f);
        const Eigen::Vector3d normal = (points[1] - points[0]).cross(points[2] - points[0]);
        const Vec2& site = tile.site_points[slab.owner[f]];
        const Eigen::Vector3d centre(site.x(), site.y(), slab.points.back().z() / 2);
        EXPECT_GT(normal.dot(points[0] - centre), 0) << f;
        if (f >= slab.n_inner_faces()) continue;
        EXPECT_LT(slab.owner[f], slab.neighbour[f]);
        if (f > 0) {
            EXPECT_LE(std::pair(slab.owner[f - 1], slab.neighbour[f - 1]),
                      std::pair(slab.owner[f], slab.neighbour[f]));
        }
    }
}

TEST(SlabMesh, FacesOfASeamAnswerEachOtherPointByPoint) {
    const SlabMesh slab =
        slab_mesh(random_tile(Lattice({1, 0}, {0.37, 0.81}), 40, TileKind::kCells));
    int n_answers = 0;
    for (const SlabPatch& patch : slab.patches) {
        if (patch.partner < 0) continue;
        const SlabPatch& partner = slab.patches[patch.partner];
        ASSERT_EQ(patch.n_faces, partner.n_faces);
        EXPECT_EQ(patch.name, seam_name(patch.offset));
        for (int k = 0; k < patch.n_faces; ++k) {
            const auto here = face_points(slab, patch.first_face + k);
            const auto there = face_points(slab, partner.first_face + k);
            for (int p = 0; p < 4; ++p, ++n_answers) {
                const Eigen::Vector3d gap = there[(4 - p) % 4] - here[p];
                EXPECT_LT((gap.head<2>() - patch.separation).norm(), 1e-15);
                EXPECT_EQ(gap.z(), 0);
            }
        }
    }
    EXPECT_GT(n_answers, 100);
}

/// What slab_tile says about a sound slab after `damage`.
template <class Damage>
std::string fault_after(Damage damage) {
    SlabMesh slab = slab_mesh(testing::grid_tile(Lattice({1, 0}, {0.37, 0.81}), 4, 3));
    damage(slab);
    try {
        slab_tile(slab);
    } catch (const NotATile& fault) {
        return fault.what();
    }
    return "";
}

TEST(SlabMesh, BrokenPlanesAreRefused) {
    EXPECT_EQ(fault_after([](SlabMesh&) {}), "");
    EXPECT_THAT(fault_after([](SlabMesh& s) { s.points.back().x() += 1e-15; }),
                HasSubstr("law (1) of slabs"));
    EXPECT_THAT(fault_after([](SlabMesh& s) { s.points[3].z() = 1e-15; }),
                HasSubstr("law (1) of slabs"));
    EXPECT_THAT(fault_after([](SlabMesh& s) { std::swap(s.corners[1], s.corners[2]); }),
                HasSubstr("not an upright wall"));
    EXPECT_THAT(fault_after([](SlabMesh& s) { s.corners.back() = s.corners[0]; }),
                HasSubstr("not a prism"));
}

TEST(SlabMesh, FacesOutOfOrderAreRefused) {
    EXPECT_THAT(fault_after([](SlabMesh& s) { std::swap(s.owner[0], s.neighbour[0]); }),
                HasSubstr("not below its neighbour"));
    EXPECT_THAT(fault_after([](SlabMesh& s) { std::swap(s.neighbour[0], s.neighbour[1]); }),
                HasSubstr("out of order"));
    EXPECT_THAT(fault_after([](SlabMesh& s) { ++s.neighbour[0]; }), HasSubstr("law (2) of slabs"));
    EXPECT_THAT(fault_after([](SlabMesh& s) { s.owner.back() = 99; }), HasSubstr("law (2)"));
    EXPECT_THAT(fault_after([](SlabMesh& s) { s.owner[s.patches[0].first_face] = 12; }),
                HasSubstr("12 and 12 faces for 13 cells"));
    EXPECT_THAT(fault_after([](SlabMesh& s) {
                    s.face_begin[s.face_begin.size() - 13] -= 4;
                    s.face_begin[s.face_begin.size() - 14] = s.face_begin[s.face_begin.size() - 13];
                }),
                HasSubstr("law ("));
    EXPECT_THAT(fault_after([](SlabMesh& s) { s.corners[5] = -1; }), HasSubstr("point -1"));
    EXPECT_THAT(fault_after([](SlabMesh& s) {
                    std::rotate(s.corners.begin(), s.corners.begin() + 1, s.corners.begin() + 4);
                    std::swap(s.corners[0], s.corners[1]);
                    std::swap(s.corners[2], s.corners[3]);
                }),
                HasSubstr("law ("));
    EXPECT_THAT(fault_after([](SlabMesh& s) { --s.patches[1].n_faces; }), HasSubstr("patch"));
    EXPECT_THAT(fault_after([](SlabMesh& s) { s.patches.pop_back(); }), HasSubstr("leave face"));
}

TEST(SlabMesh, FalseSeamsAreRefused) {
    EXPECT_THAT(fault_after([](SlabMesh& s) { s.patches[0].separation.x() += 1e-12; }),
                HasSubstr("states another separation"));
    EXPECT_THAT(fault_after([](SlabMesh& s) { s.patches[0].partner = 2; }),
                HasSubstr("do not answer each other"));
    EXPECT_THAT(fault_after([](SlabMesh& s) {
                    const auto first = s.corners.begin() + s.face_begin[s.patches[0].first_face];
                    std::rotate(first, first + 1, first + 4);
                }),
                HasSubstr("do not begin at points that answer each other"));
}

TEST(SlabMesh, FacesOfASeamInAnotherOrderAreNotItsPairs) {
    SlabMesh slab = slab_mesh(testing::grid_tile(Lattice::rectangle(1, 1), 4, 3));
    const auto first = slab.corners.begin() + slab.face_begin[slab.patches[0].first_face];
    std::swap_ranges(first, first + 4, first + 4);
    std::swap(slab.owner[slab.patches[0].first_face], slab.owner[slab.patches[0].first_face + 1]);
    const FlatTile tile = slab_tile(slab);
    EXPECT_THROW(compare_edge_pairs(tile, prove_tile(tile, Precision::kDouble)), NotATile);
}

}  // namespace
}  // namespace pcvt
