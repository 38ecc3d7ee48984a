#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "io/gltf/space_gltf_proof.hpp"
#include "mesher/space/mesh/boundary_surface.hpp"
#include "tests/support/damaged_text.hpp"
#include "tests/support/space_tiles.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;

EncodedFile encoded_glb(const SpaceTile& tile, SurfaceForm form = SurfaceForm::kCells) {
    return encode_glb_surfaces(surface_list(tile.mesh, tile.sites, form), "t.glb").front();
}

GlbProof proof_of(const EncodedFile& file) {
    return prove_glb_surfaces(file, decode_glb_surfaces(file));
}

TEST(GlbSurfaces, HasANodeForEachCell) {
    const SpaceTile tile = testing::random_space_tile(6);
    const GlbSurfaces glb = decode_glb_surfaces(encoded_glb(tile));
    ASSERT_EQ(glb.groups.size(), 6U);
    for (int s = 0; s < 6; ++s) EXPECT_EQ(glb.groups[s].name, "cell_" + std::to_string(s));
    EXPECT_EQ(glb.list.surface.sites, tile.sites);
    EXPECT_EQ(glb.list.surface.lattice.periods(), tile.mesh.lattice.periods());
    EXPECT_EQ(glb.list.form, SurfaceForm::kCells);
}

TEST(GlbSurfaces, IsProvedFromItsBytes) {
    for (const testing::SpaceCase& c : testing::space_cases()) {
        SCOPED_TRACE(c.name);
        const SpaceTile tile = testing::tile_of(c);
        for (const SurfaceForm form : {SurfaceForm::kCells, SurfaceForm::kBoundary}) {
            const std::vector<EncodedFile> files{encoded_glb(tile, form)};
            EXPECT_EQ(space_file_kind(files), SpaceFileKind::kTriangles);
            prove_own_space_files(files, tile);
            const GlbProof proof = proof_of(files.front());
            EXPECT_NEAR(proof.volume, c.lattice.volume(), proof.tolerance);
        }
    }
}

TEST(GlbSurfaces, OfManyCellsHasOneNode) {
    const space::Lattice cube = space::Lattice::box(1, 1, 1);
    const SpaceTile tile =
        testing::tile_of({"many", cube, uniform_points(cube, kMaxCellNodes + 1, 1)});
    const EncodedFile file = encoded_glb(tile);
    for (const FaceGroup& group : decode_glb_surfaces(file).groups) EXPECT_EQ(group.name, "cells");
    prove_own_space_files({file}, tile);
}

TEST(GlbSurfaces, OfAnotherTileIsNoProof) {
    const EncodedFile file = encoded_glb(testing::random_space_tile(6));
    EXPECT_THROW(prove_own_space_files({file}, testing::random_space_tile(7)), InternalError);
    EncodedFile renamed = file;
    for (auto at = renamed.bytes.find("cell_3"); at != std::string::npos;
         at = renamed.bytes.find("cell_3")) {
        renamed.bytes[at + 5] = '4';
    }
    EXPECT_THROW(prove_own_space_files({renamed}, testing::random_space_tile(6)), InternalError);
}

TEST(GlbSurfaces, RefutesOtherNormals) {
    const EncodedFile file = encoded_glb(testing::random_space_tile(3));
    GlbSurfaces glb = decode_glb_surfaces(file);
    glb.normals[4][0] += 1e-3F;
    EXPECT_THROW(prove_glb_surfaces(file, glb), BadFile);
}

TEST(GlbSurfaces, RefutesOtherSites) {
    const SpaceTile tile = testing::random_space_tile(5);
    for (int s = 0; s < 5; ++s) {
        SpaceTile moved = tile;
        moved.sites(s % 3, s) += 1e-4;
        const EncodedFile file = encoded_glb(moved);
        EXPECT_THROW(proof_of(file), NotATile) << s;
    }
    SpaceTile exchanged = tile;
    exchanged.sites.col(1).swap(exchanged.sites.col(3));
    const EncodedFile file = encoded_glb(exchanged);
    EXPECT_THROW(proof_of(file), NotATile);
}

TEST(GlbSurfaces, RefutesMovedCorners) {
    const EncodedFile file = encoded_glb(testing::random_space_tile(3));
    std::uint32_t json_length = 0;
    std::memcpy(&json_length, file.bytes.data() + 12, 4);
    const std::size_t data = 28 + json_length;
    // The first accessor holds the corners of cell 0.
    for (std::size_t corner = 0; corner < 10; ++corner) {
        EncodedFile damaged = file;
        float x = 0;
        std::memcpy(&x, file.bytes.data() + data + 12 * corner, 4);
        x += 0.01F;
        std::memcpy(damaged.bytes.data() + data + 12 * corner, &x, 4);
        EXPECT_THROW(proof_of(damaged), NotATile) << corner;
    }
}

TEST(GlbSurfaces, RefusesDamagedDocuments) {
    const EncodedFile file = encoded_glb(testing::random_space_tile(3));
    const auto fault = [&](const std::string& piece, const std::string& other) {
        EncodedFile damaged = file;
        damaged.bytes = testing::exchanged(damaged.bytes, piece, other);
        return testing::fault_in([&] { decode_glb_surfaces(damaged); });
    };
    EXPECT_THAT(fault("\"lattice\":[[1,", "\"lattice\":[[0,"), "");
    EXPECT_THAT(fault("\"lattice\":", "\"lottice\":"), HasSubstr("not [a, b, c]"));
    EXPECT_THAT(fault("\"sites\":[[", "\"sites\":[7]"), HasSubstr("t.glb"));
    EXPECT_THAT(fault("\"POSITION\"", "\"PASITION\""), HasSubstr("POSITION"));
    EXPECT_THAT(fault("\"children\"", "\"childran\""), HasSubstr("no surface"));
}

TEST(GlbSurfaces, RefusesCoordinatesBeyondSinglePrecision) {
    const space::Lattice huge = space::Lattice::box(1e39, 1e39, 1e39);
    const SpaceTile tile = testing::tile_of({"huge", huge, uniform_points(huge, 4, 1)});
    EXPECT_THROW(encoded_glb(tile), InvalidInput);
}

}  // namespace
}  // namespace pcvt
