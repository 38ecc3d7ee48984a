#include "mesher/space/box/plane_levels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "mesher/space/mesh/cell_faces.hpp"
#include "tests/support/polyhedra.hpp"

namespace pcvt::space {
namespace {

/// The cells of a cubic lattice whose sites have moved a little, so that their corners fall apart
/// into edges of about that length.
CellComplex fallen_apart(double moved, std::uint64_t seed) {
    Points points = moved * uniform_points(Lattice::box(1, 1, 1), 8, seed);
    for (int k = 0; k < 8; ++k) points.col(k) += Vec3(k & 1, k >> 1 & 1, k >> 2) / 2;
    return testing::complex_of({"", Lattice::box(1, 1, 1), points});
}

constexpr double kSnapped = 4e-5;
constexpr Nearness kNear{1e-12, kSnapped};

bool is_near(const AxisPlanes& planes, const Vec3& p) {
    return planes.distance(static_cast<int>(std::round(planes.height(p))), p) <= kSnapped;
}

/// The length of an edge of a face, before and after.
template <class Take>
void visit_edges(const CellComplex& before, const CellComplex& after, const Take& take) {
    for (int f = 0; f < before.n_faces(); ++f) {
        const auto corners = before.corners_of(f);
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const VertexImage& a = corners[k];
            const VertexImage& b = corners[(k + 1) % corners.size()];
            take(a.vertex, b.vertex, (before.position(b) - before.position(a)).norm(),
                 (after.position(b) - after.position(a)).norm());
        }
    }
}

/// Vertices near to a plane lie on it, but those of edges that would almost vanish.
TEST(PutOnPlanes, KeepsEdges) {
    const Lattice cube = Lattice::box(1, 1, 1);
    int n_snapped = 0;
    for (const double moved : {1e-4, 3e-5, 1e-5}) {
        for (std::uint64_t seed = 1; seed <= 6; ++seed) {
            const CellComplex before = fallen_apart(moved, seed);
            for (const int axis : {0, 1, 2}) {
                for (const Vec3& origin : {before.vertices[0], before.vertices[7]}) {
                    CellComplex after = before;
                    const AxisPlanes planes(cube, axis, origin);
                    const std::vector<int> levels = put_on_planes(planes, kNear, after);
                    for (std::size_t v = 0; v < levels.size(); ++v) {
                        const double moved_by = (after.vertices[v] - before.vertices[v]).norm();
                        EXPECT_LE(moved_by, kSnapped * (1 + 1e-9));
                        n_snapped += moved_by > 1e-9 && levels[v] % 2 == 0 ? 1 : 0;
                    }
                    visit_edges(before, after, [](int, int, double length, double now) {
                        EXPECT_GE(now, 0.45 * length);
                    });
                }
            }
        }
    }
    EXPECT_GT(n_snapped, 100);
}

/// A short edge of which one end is too far from the plane keeps both ends where they are, up to a
/// part of its length.
TEST(PutOnPlanes, KeepsBothEndsOfShortEdges) {
    const Lattice cube = Lattice::box(1, 1, 1);
    int n_kept = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const CellComplex before = fallen_apart(1e-4, seed);
        for (int first = 0; first < 20; ++first) {
            CellComplex after = before;
            const Vec3 origin = before.vertices[first] + Vec3(0.9 * kSnapped, 0, 0);
            const AxisPlanes planes(cube, 0, origin);
            put_on_planes(planes, kNear, after);
            const auto near = [&](int v) { return is_near(planes, before.vertices[v]); };
            visit_edges(before, after, [&](int a, int b, double length, double) {
                if (length >= 2 * kSnapped || near(a) == near(b)) return;
                for (const int v : {a, b}) {
                    EXPECT_LE((after.vertices[v] - before.vertices[v]).norm(),
                              length / kEdgeOverSnap * (1 + 1e-9));
                }
                ++n_kept;
            });
        }
    }
    EXPECT_GT(n_kept, 10);
}

/// A small square with corners up to 0.9 of the distance from the planes: normal to them, it would
/// become a line, though its edges keep 0.7 of their lengths; along them, it is snapped.
TEST(PutOnPlanes, KeepsFacesThatWouldBecomeLines) {
    const Lattice cube = Lattice::box(1, 1, 1);
    const double a = 0.45 * kSnapped;
    CellComplex before{.reduced = cube, .n_cells = 1};
    before.vertices = {{0, 0.5, 0.5}, {a, 0.5 - a, 0.5}, {2 * a, 0.5, 0.5}, {a, 0.5 + a, 0.5}};
    before.faces = {{0, 0, {}}};
    before.begin = {0, 4};
    for (int v = 0; v < 4; ++v) before.corners.push_back({v, {}});
    CellComplex across = before;
    put_on_planes(AxisPlanes(cube, 0, Vec3::Zero()), kNear, across);
    EXPECT_EQ(across.vertices, before.vertices);
    CellComplex along = before;
    const Vec3 below(0, 0, 0.5 - 0.9 * kSnapped);
    put_on_planes(AxisPlanes(cube, 2, below), kNear, along);
    for (const Vec3& vertex : along.vertices) EXPECT_NEAR(vertex.z(), below.z(), 1e-15);
}

}  // namespace
}  // namespace pcvt::space
