#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/graphics/om_reader.hpp"
#include "io/graphics/om_writer.hpp"
#include "mesher/space/mesh/boundary_surface.hpp"
#include "tests/support/damaged_text.hpp"
#include "tests/support/space_tiles.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;

EncodedFile encoded_om(const SpaceTile& tile) {
    return encode_om_boundary(tile_surface(tile.mesh, tile.sites), "t.om").front();
}

bool is_refused(const EncodedFile& file) {
    try {
        if (!space_file_kind({file})) return true;
        prove_boundary_files({file});
    } catch (const InvalidInput&) {
        return true;
    }
    return false;
}

TEST(OmBoundary, GivesBackTheSurface) {
    for (const testing::SpaceCase& c : testing::space_cases()) {
        const SpaceTile tile = testing::tile_of(c);
        if (!boundary_is_manifold(tile.mesh)) continue;
        SCOPED_TRACE(c.name);
        const space::TileSurface surface = tile_surface(tile.mesh, tile.sites);
        const space::TileSurface found = decode_om_boundary(encoded_om(tile));
        EXPECT_EQ(found.points, surface.points);
        EXPECT_EQ(found.faces, surface.faces);
        EXPECT_EQ(found.cell, surface.cell);
        EXPECT_EQ(found.partner, surface.partner);
        EXPECT_EQ(found.offset, surface.offset);
        EXPECT_EQ(found.sites, surface.sites);
        EXPECT_EQ(space_file_kind({encoded_om(tile)}), SpaceFileKind::kBoundary);
        prove_own_space_files({encoded_om(tile)}, tile);
    }
}

TEST(OmBoundary, IsRefusedWithAnyOtherByte) {
    // Positions may differ in their last bits, which are read as they are.
    const EncodedFile file = encoded_om(testing::random_space_tile(2));
    ASSERT_FALSE(is_refused(file));
    int n_accepted = 0;
    for (std::size_t at = 0; at < file.bytes.size(); ++at) {
        EncodedFile mutant = file;
        mutant.bytes[at] = static_cast<char>(mutant.bytes[at] ^ 0x55);
        n_accepted += is_refused(mutant) ? 0 : 1;
    }
    const auto n_numbers = static_cast<int>(3 * decode_om_boundary(file).points.size() + 3 * 2);
    EXPECT_LE(n_accepted, n_numbers);
}

TEST(OmBoundary, IsRefusedWhenItEndsEarly) {
    const EncodedFile file = encoded_om(testing::random_space_tile(2));
    for (std::size_t size = 0; size < file.bytes.size(); size += 3) {
        EXPECT_TRUE(is_refused({"t.om", file.bytes.substr(0, size)})) << size;
    }
}

TEST(OmBoundary, RefusesDamagedProperties) {
    const EncodedFile file = encoded_om(testing::random_space_tile(3));
    for (const char* name : {"pcvt_lattice", "pcvt_face_offset", "pcvt_face_cell", "pcvt_sites"}) {
        EncodedFile damaged = file;
        damaged.bytes = testing::exchanged(damaged.bytes, name, "q" + std::string(name).substr(1));
        EXPECT_THAT(testing::fault_in([&] { decode_om_boundary(damaged); }), HasSubstr(name));
    }
}

}  // namespace
}  // namespace pcvt
