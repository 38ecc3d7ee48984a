#include <gmock/gmock.h>

#include <set>

#include "io/formats/formats.hpp"
#include "io/formats/space_file_proof.hpp"
#include "io/gltf/space_gltf_proof.hpp"
#include "tests/support/damaged_text.hpp"
#include "tests/support/space_tiles.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kSurfaces[] = {"t.obj", "t.ply", "t.glb"};

std::vector<EncodedFile> encoded(const SpaceTile& tile, const std::string& path,
                                 const FileOptions& options = {}) {
    return find_format(path)->space->encode(tile, options, path);
}

SpaceTile tile_with_materials(int n) {
    SpaceTile tile = testing::random_space_tile(n);
    tile.materials = testing::some_materials(n);
    return tile;
}

testing::SpaceCase random_case(int n) {
    const space::Lattice oblique({1, 0.2, 0.1}, {-0.3, 0.9, 0.2}, {0.4, 0.3, 1.2});
    return {"random", oblique, uniform_points(oblique, n, 3)};
}

/// Whether the proof of a file refuses it.
bool is_refused(const std::vector<EncodedFile>& files) {
    try {
        switch (space_file_kind(files).value()) {
            case SpaceFileKind::kTriangles:
                prove_glb_surfaces(files.front(), decode_glb_surfaces(files.front()));
                break;
            case SpaceFileKind::kBoundary:
                prove_boundary_files(files);
                break;
            default:
                prove_space_files(files);
        }
    } catch (const InvalidInput&) {
        return true;
    }
    return false;
}

TEST(SpaceColours, FilesOfEachColouringHoldTheirTile) {
    for (const int n : {1, 2, 5, 20}) {
        const SpaceTile tile = tile_with_materials(n);
        for (const ColouringRow& row : kColourings) {
            if (!row.in_space) continue;
            for (const char* path : kSurfaces) {
                SCOPED_TRACE(std::string(path) + " " + row.word + " " + std::to_string(n));
                const auto files = encoded(tile, path, {.colouring = row.colouring});
                prove_own_space_files(files, tile);
                EXPECT_FALSE(is_refused(files));
                SpaceTile other = tile;
                other.materials.site_orientation.back().phi1 += 1e-9;
                EXPECT_THROW(prove_own_space_files(files, other), InternalError);
            }
        }
    }
}

TEST(SpaceColours, ManyCellsHaveOneNodeInTheOrderOfTheirColours) {
    SpaceTile tile = testing::tile_of(random_case(kMaxCellNodes + 1));
    tile.materials = testing::some_materials(kMaxCellNodes + 1);
    for (const ColouringRow& row : kColourings) {
        if (!row.in_space) continue;
        SCOPED_TRACE(row.word);
        const auto files = encoded(tile, "t.glb", {.colouring = row.colouring});
        prove_own_space_files(files, tile);
        EXPECT_FALSE(is_refused(files));
    }
}

TEST(SpaceColours, BoundariesStateTheMaterialsOfTheirCells) {
    const SpaceTile tile = tile_with_materials(12);
    for (const char* path : kSurfaces) {
        const auto files = encoded(tile, path, {.surfaces = SurfaceForm::kBoundary});
        prove_own_space_files(files, tile);
        EXPECT_FALSE(is_refused(files));
    }
}

TEST(SpaceColours, PhasesAndOrientationsAreShownWhereNobodyChooses) {
    SpaceTile tile = testing::random_space_tile(6);
    EXPECT_THAT(encoded(tile, "t.obj")[0].bytes, HasSubstr("usemtl faces_"));
    EXPECT_THAT(encoded(tile, "t.obj")[0].bytes, Not(HasSubstr("colouring")));
    tile.materials = testing::some_materials(6);
    EXPECT_THAT(encoded(tile, "t.obj")[0].bytes, HasSubstr("usemtl phase_a\n"));
    tile.materials.phase_names.clear();
    tile.materials.site_phase.clear();
    EXPECT_THAT(encoded(tile, "t.obj")[0].bytes, HasSubstr("usemtl ipf_"));
    EXPECT_THAT(encoded(tile, "t.svg")[0].bytes, HasSubstr("by orientation"));
}

TEST(SpaceColours, OfNeighboursDifferAcrossFacesAndSeam) {
    const SpaceTile tile = testing::random_space_tile(60);
    const std::vector<int> classes = cells_apart(tile.mesh);
    int n_equal = 0;
    for (int f = 0; f < tile.mesh.n_inner_faces(); ++f) {
        n_equal += classes[tile.mesh.owner[f]] == classes[tile.mesh.neighbour[f]] ? 1 : 0;
    }
    for (const FiniteVolumePatch& patch : tile.mesh.patches) {
        const FiniteVolumePatch& partner = tile.mesh.patches[patch.partner];
        for (int k = 0; k < patch.n_faces; ++k) {
            n_equal += classes[tile.mesh.owner[patch.first_face + k]] ==
                               classes[tile.mesh.owner[partner.first_face + k]]
                           ? 1
                           : 0;
        }
    }
    // Seven colours do not suffice for all cells in space.
    EXPECT_LE(n_equal, 60 * 15 / 50);
}

TEST(SpaceColours, DamagedStatementsAreRefused) {
    const SpaceTile tile = tile_with_materials(5);
    const auto refused = [&](const std::string& path, const std::string& piece,
                             const std::string& other, Colouring colouring) {
        std::vector<EncodedFile> files = encoded(tile, path, {.colouring = colouring});
        std::string& bytes = files.front().bytes;
        const std::size_t at = bytes.find(piece);
        if (at == std::string::npos) throw InternalError(path + " lacks " + piece);
        bytes.replace(at, piece.size(), other);
        return is_refused(files);
    };
    for (const char* path : {"t.obj", "t.ply"}) {
        SCOPED_TRACE(path);
        EXPECT_TRUE(
            refused(path, "pcvt colouring phase", "pcvt colouring size", Colouring::kPhase));
        EXPECT_TRUE(refused(path, "pcvt colouring phase", "pcvt colouring tag", Colouring::kPhase));
        EXPECT_TRUE(refused(path, "site_phases 0 1", "site_phases 1 1", Colouring::kPhase));
        EXPECT_TRUE(refused(path, "site_phases 0 1", "site_phases 2 1", Colouring::kPhase));
        EXPECT_TRUE(refused(path, "site_phases 0 1 1", "site_phases 0 1", Colouring::kPhase));
        EXPECT_TRUE(refused(path, "pcvt angles", "pcvt angls", Colouring::kPhase));
    }
    EXPECT_TRUE(
        refused("t.glb", "\"colouring\":\"phase\"", "\"colouring\":\"faces\"", Colouring::kPhase));
    EXPECT_TRUE(refused("t.glb", "\"sitePhases\":[0,1", "\"sitePhases\":[1,1", Colouring::kPhase));
    EXPECT_TRUE(refused("t.glb", "\"sitePhases\":[0,1", "\"sitePhases\":[7,1", Colouring::kPhase));
    EXPECT_TRUE(refused("t.glb", "\"phases\":[\"a\"", "\"phases\":[\"b\"", Colouring::kPhase));
    EXPECT_TRUE(refused("t.glb", "\"phases\":[\"a\"", "\"phases\":[7", Colouring::kPhase));
}

TEST(SpaceColours, PowerCellsStateTheirWeights) {
    for (const int n : {1, 2, 5, 30}) {
        SpaceTile tile = testing::power_tile_of(random_case(n), n > 5 ? 0.004 : 0.02);
        tile.materials = testing::some_materials(n);
        prove_own_space_files(encoded(tile, "t.foam"), tile);
        const auto glb = encoded(tile, "t.glb", {.colouring = Colouring::kSize});
        prove_own_space_files(glb, tile);
        EXPECT_FALSE(is_refused(glb));
        for (int s = 0; n > 1 && s < std::min(n, 6); ++s) {
            SpaceTile other = tile;
            other.weights[s] += 1e-3;
            EXPECT_TRUE(is_refused(encoded(other, "t.glb"))) << s;
            other = tile;
            other.sites(s % 3, s) += 1e-3;
            EXPECT_TRUE(is_refused(encoded(other, "t.glb"))) << s;
        }
        for (const char* path : {"t.obj", "t.ply"}) {
            SCOPED_TRACE(path + std::to_string(n));
            std::vector<EncodedFile> files = encoded(tile, path, {.colouring = Colouring::kSize});
            prove_own_space_files(files, tile);
            EXPECT_FALSE(is_refused(files));
            if (n < 5) continue;
            std::string& bytes = files.front().bytes;
            const std::size_t at = bytes.find("pcvt weights ");
            ASSERT_NE(at, std::string::npos);
            bytes.insert(at + 13, "1");
            EXPECT_TRUE(is_refused(files));
        }
    }
}

TEST(SpaceColours, CasesHaveAZoneForEachPhase) {
    const SpaceTile tile = tile_with_materials(5);
    std::vector<EncodedFile> files = encoded(tile, "t.foam");
    prove_own_space_files(files, tile);
    const auto zones = std::find_if(files.begin(), files.end(), [](const EncodedFile& file) {
        return file.path.ends_with("/cellZones");
    });
    ASSERT_NE(zones, files.end());
    EXPECT_THAT(zones->bytes, HasSubstr("phase_a\n{"));
    EXPECT_THAT(zones->bytes, HasSubstr("2\n(\n0\n3\n)"));
    const std::string before = zones->bytes;
    zones->bytes.replace(zones->bytes.find("(\n0\n3\n)"), 8, "(\n0\n2\n)");
    EXPECT_TRUE(is_refused(files));
    zones->bytes = before;
    EXPECT_FALSE(is_refused(files));
    files.erase(zones);
    EXPECT_TRUE(is_refused(files));
    prove_own_space_files(encoded(testing::random_space_tile(5), "t.foam"),
                          testing::random_space_tile(5));
}

}  // namespace
}  // namespace pcvt
