#include "io/pictures/space_picture.hpp"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>

#include "tests/support/space_tiles.hpp"

namespace pcvt {
namespace {

std::vector<ShownFace> faces_of(const SpaceTile& tile) {
    return shown_faces(tile, cell_colours(tile, Colouring::kFaces));
}

using ::testing::HasSubstr;

double area_of(const std::vector<plane::Vec2>& corners) {
    double twice = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const plane::Vec2& p = corners[k];
        const plane::Vec2& q = corners[(k + 1) % corners.size()];
        twice += p.x() * q.y() - p.y() * q.x();
    }
    return twice / 2;
}

bool contains(const std::vector<plane::Vec2>& corners, const plane::Vec2& point) {
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const plane::Vec2 side = corners[(k + 1) % corners.size()] - corners[k];
        const plane::Vec2 to = point - corners[k];
        if (side.x() * to.y() - side.y() * to.x() < 0) return false;
    }
    return true;
}

TEST(SpacePicture, ShowsFacesTurnedToTheViewer) {
    for (const testing::SpaceCase& c : testing::space_cases()) {
        SCOPED_TRACE(c.name);
        const std::vector<ShownFace> faces = faces_of(testing::tile_of(c));
        ASSERT_FALSE(faces.empty());
        for (const ShownFace& face : faces) EXPECT_GE(area_of(face.corners), 0);
    }
}

/// The directions of shown_faces(), and the distance of a face of the tile towards the viewer.
const space::Vec3 kTowards = space::Vec3(0.5, -0.8, 0.46).normalized();

/// The last painted face at a point is the nearest one, which a search of all faces finds.
TEST(SpacePicture, PaintsTheNearestFaceLast) {
    const SpaceTile tile = testing::random_space_tile(30);
    const std::vector<ShownFace> faces = faces_of(tile);
    const space::Vec3 right = space::Vec3::UnitZ().cross(kTowards).normalized();
    const space::Vec3 up = kTowards.cross(right);
    int n_tested = 0;
    for (const ShownFace& sample : faces) {
        plane::Vec2 point = plane::Vec2::Zero();
        for (const plane::Vec2& corner : sample.corners)
            point += corner / double(sample.corners.size());
        const ShownFace* last = nullptr;
        for (const ShownFace& face : faces) {
            if (contains(face.corners, point)) last = &face;
        }
        double nearest = -1e300;
        std::vector<plane::Vec2> expected;
        for (int f = tile.mesh.n_inner_faces(); f < tile.mesh.n_faces(); ++f) {
            std::vector<plane::Vec2> corners;
            space::Vec3 sum = space::Vec3::Zero();
            space::Vec3 normal = space::Vec3::Zero();
            const auto face = tile.mesh.faces[f];
            for (std::size_t k = 0; k < face.size(); ++k) {
                const space::Vec3& p = tile.mesh.points[face[k]];
                corners.emplace_back(p.dot(right), p.dot(up));
                sum += p;
                normal += p.cross(tile.mesh.points[face[(k + 1) % face.size()]]);
            }
            if (normal.dot(kTowards) <= 0 || !contains(corners, point)) continue;
            const space::Vec3 origin = right * point.x() + up * point.y();
            const double depth =
                (sum / double(face.size()) - origin).dot(normal) / kTowards.dot(normal);
            if (depth > nearest) {
                nearest = depth;
                expected = corners;
            }
        }
        ASSERT_NE(last, nullptr);
        EXPECT_EQ(last->corners, expected);
        ++n_tested;
    }
    EXPECT_GT(n_tested, 30);
}

TEST(SpacePicture, NamesTheNumbersOfFaces) {
    const SpaceTile tile =
        testing::tile_of({"octahedra", space::Lattice::box(1, 1, 1), testing::lattice_points(16)});
    EXPECT_THAT(encode_space_svg(tile, Colouring::kFaces, "t.svg").front().bytes,
                HasSubstr(">14 faces: 16<"));
}

TEST(SpacePicture, OfOneTileHasTheSameBytes) {
    const SpaceTile tile = testing::random_space_tile(8);
    const std::string png = encode_space_png(tile, Colouring::kFaces, "t.png").front().bytes;
    EXPECT_EQ(png, encode_space_png(tile, Colouring::kFaces, "t.png").front().bytes);
    EXPECT_TRUE(png.starts_with("\x89PNG"));
}

}  // namespace
}  // namespace pcvt
