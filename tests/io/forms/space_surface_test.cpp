#include "io/forms/space_surface.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/space_tiles.hpp"

namespace pcvt {
namespace {

SurfaceMesh mesh_of(const SpaceTile& tile, SurfaceForm form) {
    return surface_mesh(surface_list(tile.mesh, tile.sites, form), SeamForm::kNone);
}

TEST(SpaceSurface, HasAGroupForEachCell) {
    const SurfaceMesh mesh = mesh_of(testing::random_space_tile(6), SurfaceForm::kCells);
    ASSERT_EQ(mesh.groups.size(), 6U);
    for (std::size_t g = 0; g < 6; ++g) {
        EXPECT_EQ(mesh.groups[g].name, "cell_" + std::to_string(g));
        const int first = mesh.groups[g].first_face;
        EXPECT_EQ(mesh.classes[mesh.face_class[first]].name,
                  "faces_" + std::to_string(mesh.group_end(g) - first));
    }
    EXPECT_EQ(mesh.group_end(5), mesh.faces.n_faces());
}

TEST(SpaceSurface, ColoursBothSidesOfASeamAlike) {
    const SpaceTile tile =
        testing::tile_of({"cube", space::Lattice::box(1, 1, 1), space::Points::Zero(3, 1)});
    const SurfaceMesh mesh = mesh_of(tile, SurfaceForm::kBoundary);
    EXPECT_EQ(mesh.groups.size(), 6U);
    EXPECT_EQ(mesh.classes.size(), 3U);
    EXPECT_EQ(mesh.face_class.size(), 6U);
}

TEST(SpaceSurface, StatesAPairOfFacesInOneLineOrInTwoRows) {
    const SpaceTile tile = testing::random_space_tile(4);
    const SurfaceList list = surface_list(tile.mesh, tile.sites, SurfaceForm::kBoundary);
    const auto n_faces = static_cast<std::size_t>(list.surface.n_faces());
    const std::vector<int> lines = surface_mesh(list, SeamForm::kLines).notes.back().integers();
    ASSERT_EQ(lines.size(), n_faces / 2 * 5);
    for (std::size_t k = 0; k < lines.size(); k += 5) {
        EXPECT_GT((space::Offset{lines[k + 2], lines[k + 3], lines[k + 4]}), space::Offset{});
        EXPECT_EQ(list.surface.partner[lines[k]], lines[k + 1]);
    }
    const std::vector<int> rows = surface_mesh(list, SeamForm::kColumns).notes.back().integers();
    ASSERT_EQ(rows.size(), n_faces * 4);
    EXPECT_EQ(rows[4], list.surface.partner[1]);
}

TEST(SpaceSurface, GivesBackItsCells) {
    const SpaceTile tile = testing::random_space_tile(5);
    const SurfaceList list = surface_list(tile.mesh, tile.sites, SurfaceForm::kCells);
    EXPECT_EQ(assembled_cells(list, "t").points, tile.mesh.points);
    SurfaceList other = list;
    std::swap(other.surface.cell.front(), other.surface.cell.back());
    EXPECT_THROW(assembled_cells(other, "t"), BadFile);
    other = list;
    other.surface.cell.front() = -1;
    EXPECT_THROW(assembled_cells(other, "t"), BadFile);
    other = list;
    other.surface.sites.conservativeResize(3, 4);
    EXPECT_THROW(assembled_cells(other, "t"), BadFile);
    other = list;
    other.surface.faces.corners.front() = static_cast<int>(list.surface.points.size());
    EXPECT_THROW(require_faces(other, "t"), BadFile);
}

}  // namespace
}  // namespace pcvt
