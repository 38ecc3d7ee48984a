#include "mesher/space/mesh/polyhedron_graph.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace pcvt::space {
namespace {

std::vector<Corners> faces_on(const std::vector<std::vector<int>>& numbers) {
    std::vector<Corners> faces;
    for (const std::vector<int>& face : numbers) {
        Corners& corners = faces.emplace_back();
        for (const int v : face) corners.push_back({v, {}});
    }
    return faces;
}

const std::vector<std::vector<int>> kTetrahedron{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
const std::vector<std::vector<int>> kCube{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                          {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

TEST(PolyhedronGraph, IsThatOfTetrahedronPyramidAndCube) {
    EXPECT_TRUE(is_polyhedron(faces_on(kTetrahedron)));
    EXPECT_TRUE(is_polyhedron(faces_on(kCube)));
    EXPECT_TRUE(
        is_polyhedron(faces_on({{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}})));
}

TEST(PolyhedronGraph, KeepsImagesOfOneVertexApart) {
    std::vector<Corners> cube = faces_on(kCube);
    for (Corners& face : cube) {
        for (VertexImage& corner : face) {
            if (corner.vertex >= 4) corner = {corner.vertex - 4, {0, 0, 1}};
        }
    }
    EXPECT_TRUE(is_polyhedron(cube));
}

TEST(PolyhedronGraph, HasFourFacesThatClose) {
    EXPECT_FALSE(is_polyhedron(faces_on({{0, 1, 2}, {0, 2, 1}})));
    std::vector<Corners> faces = faces_on(kCube);
    faces.pop_back();
    EXPECT_FALSE(is_polyhedron(faces));
    faces = faces_on(kCube);
    std::reverse(faces[0].begin(), faces[0].end());
    EXPECT_FALSE(is_polyhedron(faces));
}

TEST(PolyhedronGraph, HasNoFaceThatMeetsItself) {
    EXPECT_FALSE(is_polyhedron(faces_on(
        {{0, 2, 1, 0, 5, 4}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 4, 3}, {4, 5, 3}, {5, 0, 3}})));
}

TEST(PolyhedronGraph, MayHaveCornersOnStraightEdges) {
    std::vector<std::vector<int>> cube = kCube;
    cube[0] = {0, 3, 2, 1, 8};
    cube[2] = {0, 8, 1, 5, 4};
    EXPECT_TRUE(is_polyhedron(faces_on(cube)));
}

TEST(PolyhedronGraph, HasFacesThatMeetOnce) {
    // The tip of a pyramid on a triangle over a corner of its base: one triangle lies on the base.
    EXPECT_FALSE(
        is_polyhedron(faces_on({{0, 3, 2, 1}, {0, 1, 2}, {0, 2, 4}, {2, 3, 4}, {3, 0, 4}})));
    // Four lunes between two poles: opposite ones meet at both.
    EXPECT_FALSE(is_polyhedron(faces_on({{0, 2, 1, 3}, {0, 3, 1, 4}, {0, 4, 1, 5}, {0, 5, 1, 2}})));
}

TEST(PolyhedronGraph, IsOneSphere) {
    // Two tetrahedra that share a corner, and two apart.
    std::vector<std::vector<int>> two = kTetrahedron;
    two.insert(two.end(), {{3, 5, 4}, {3, 4, 6}, {4, 5, 6}, {5, 3, 6}});
    EXPECT_FALSE(is_polyhedron(faces_on(two)));
    two = kTetrahedron;
    two.insert(two.end(), {{7, 5, 4}, {7, 4, 6}, {4, 5, 6}, {5, 7, 6}});
    EXPECT_FALSE(is_polyhedron(faces_on(two)));
}

}  // namespace
}  // namespace pcvt::space
