#include "io/forms/plane_surface.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/grid_tile.hpp"

namespace pcvt {
namespace {

using ::testing::ElementsAre;

const plane::Lattice kSquare({1, 0}, {0, 1});

const NoteTable& note_of(const SurfaceMesh& mesh, std::string_view name) {
    for (const NoteTable& note : mesh.notes) {
        if (note.word == name || note.columns == name) return note;
    }
    throw InvalidInput("no such note");
}

TEST(PlaneSurface, LiesInThePlane) {
    const plane::Tile tile = testing::grid_tile(kSquare, 2, 2);
    const SurfaceMesh mesh = surface_mesh(tile, SeamForm::kLines);
    EXPECT_EQ(mesh.kind, "cells");
    EXPECT_EQ(mesh.faces, tile.faces);
    ASSERT_EQ(mesh.points.size(), tile.points.size());
    EXPECT_EQ(mesh.points[3], Eigen::Vector3d(tile.points[3].x(), tile.points[3].y(), 0));
    EXPECT_THAT(note_of(mesh, "lattice").reals(), ElementsAre(1, 0, 0, 1));
}

TEST(PlaneSurface, StatesPairsInLinesOrOrbitsInColumns) {
    const plane::Tile tile = testing::grid_tile(kSquare, 1, 1);
    const SurfaceMesh lines = surface_mesh(tile, SeamForm::kLines, std::vector{0});
    std::vector<int> edges;
    for (const plane::EdgePair& p : tile.edge_pairs) {
        edges.insert(edges.end(), {p.v0, p.v1, p.w0, p.w1, p.offset.i, p.offset.j});
    }
    EXPECT_EQ(note_of(lines, "edge_pair").integers(), edges);
    EXPECT_THAT(note_of(lines, "site_orbits").integers(), ElementsAre(0));
    const SurfaceMesh columns = surface_mesh(tile, SeamForm::kColumns);
    EXPECT_THAT(note_of(columns, "orbit offset_i offset_j").integers(),
                ElementsAre(0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1));
    EXPECT_EQ(note_of(columns, "site").of, NoteOf::kFaces);
}

}  // namespace
}  // namespace pcvt
