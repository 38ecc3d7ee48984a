#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>

#include "io/forms/space_surface.hpp"
#include "io/graphics/obj_reader.hpp"
#include "io/graphics/obj_writer.hpp"
#include "io/graphics/ply_reader.hpp"
#include "io/graphics/ply_writer.hpp"
#include "mesher/space/mesh/boundary_surface.hpp"
#include "tests/support/damaged_text.hpp"
#include "tests/support/space_tiles.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A text format of surfaces.
struct TextFormat {
    std::string path;
    SeamForm seam;
    std::vector<EncodedFile> (*encode)(const SurfaceMesh& mesh, const std::string& path);
    SurfaceList (*decode)(const EncodedFile& file);
};

SurfaceMesh mesh_of(const SpaceTile& tile, SurfaceForm form, SeamForm seam) {
    return surface_mesh(surface_list(tile.mesh, tile.sites, form), seam);
}

class SurfaceFiles : public ::testing::TestWithParam<TextFormat> {
   protected:
    static std::vector<EncodedFile> encoded(const SpaceTile& tile, SurfaceForm form) {
        return GetParam().encode(mesh_of(tile, form, GetParam().seam), GetParam().path);
    }

    static void prove(const std::vector<EncodedFile>& files) {
        if (space_file_kind(files) == SpaceFileKind::kPolyhedra) {
            prove_space_files(files);
        } else {
            prove_boundary_files(files);
        }
    }

    /// Whether the files are refused.
    static bool is_refused(const std::vector<EncodedFile>& files) {
        try {
            // A file that no longer says that it holds surfaces is none in space.
            if (!space_file_kind(files)) return true;
            prove(files);
        } catch (const InvalidInput&) {
            return true;
        }
        return false;
    }

    static std::string fault(const std::string& piece, const std::string& other,
                             SurfaceForm form = SurfaceForm::kCells) {
        std::vector<EncodedFile> files = encoded(testing::random_space_tile(6), form);
        files.front().bytes = testing::exchanged(files.front().bytes, piece, other);
        return testing::fault_in([&] { prove(files); });
    }
};

TEST_P(SurfaceFiles, GiveBackTheSurfaces) {
    for (const testing::SpaceCase& c : testing::space_cases()) {
        SCOPED_TRACE(c.name);
        const SpaceTile tile = testing::tile_of(c);
        for (const SurfaceForm form : {SurfaceForm::kCells, SurfaceForm::kBoundary}) {
            const space::TileSurface list = surface_list(tile.mesh, tile.sites, form).surface;
            const SurfaceList read = GetParam().decode(encoded(tile, form).front());
            const space::TileSurface& found = read.surface;
            EXPECT_EQ(read.form, form);
            EXPECT_EQ(found.lattice.periods(), list.lattice.periods());
            EXPECT_EQ(found.points, list.points);
            EXPECT_EQ(found.faces, list.faces);
            EXPECT_EQ(found.cell, list.cell);
            EXPECT_EQ(found.sites, list.sites);
            EXPECT_EQ(found.partner, list.partner);
            EXPECT_EQ(found.offset, list.offset);
        }
    }
}

TEST_P(SurfaceFiles, AreProvedFromTheirBytes) {
    for (const testing::SpaceCase& c : testing::space_cases()) {
        SCOPED_TRACE(c.name);
        const SpaceTile tile = testing::tile_of(c);
        prove_own_space_files(encoded(tile, SurfaceForm::kCells), tile);
        if (!boundary_is_manifold(tile.mesh)) continue;
        prove_own_space_files(encoded(tile, SurfaceForm::kBoundary), tile);
    }
}

TEST_P(SurfaceFiles, OfAnotherTileAreNoProof) {
    const SpaceTile tile = testing::random_space_tile(6);
    SpaceTile other = tile;
    other.sites(1, 2) += 1e-17;
    other.sites(0, 0) = std::nextafter(other.sites(0, 0), 1.0);
    EXPECT_THROW(prove_own_space_files(encoded(tile, SurfaceForm::kCells), other), InternalError);
    for (const SurfaceForm form : {SurfaceForm::kCells, SurfaceForm::kBoundary}) {
        EXPECT_THROW(prove_own_space_files(encoded(tile, form), testing::random_space_tile(7)),
                     InternalError);
    }
}

/// Every word of a file is changed once: a digit, a letter or a sign of it.
TEST_P(SurfaceFiles, AreRefusedWithAnyOtherWord) {
    const SpaceTile tile = testing::random_space_tile(3);
    for (const SurfaceForm form : {SurfaceForm::kCells, SurfaceForm::kBoundary}) {
        const std::vector<EncodedFile> files = encoded(tile, form);
        ASSERT_FALSE(is_refused(files));
        int n_mutants = 0;
        for (std::size_t k = 0; k < files.size(); ++k) {
            const std::string& bytes = files[k].bytes;
            for (std::size_t at = 0; at < bytes.size(); ++at) {
                const bool begins =
                    at == 0 || std::isspace(static_cast<unsigned char>(bytes[at - 1])) != 0;
                if (!begins || std::isspace(static_cast<unsigned char>(bytes[at])) != 0) continue;
                std::vector<EncodedFile> mutant = files;
                char& first = mutant[k].bytes[at];
                first = first == '7' ? '3' : '7';
                EXPECT_TRUE(is_refused(mutant))
                    << files[k].path << " " << at << ": " << bytes.substr(at, 30);
                ++n_mutants;
            }
        }
        EXPECT_GT(n_mutants, 400);
    }
}

TEST_P(SurfaceFiles, AreRefusedWhenTheyEndEarly) {
    for (const SurfaceForm form : {SurfaceForm::kCells, SurfaceForm::kBoundary}) {
        const std::vector<EncodedFile> files = encoded(testing::random_space_tile(3), form);
        for (std::size_t size = 0; size + 1 < files.front().bytes.size(); size += 7) {
            std::vector<EncodedFile> cut = files;
            cut.front().bytes.resize(size);
            EXPECT_TRUE(is_refused(cut)) << size;
        }
    }
}

TEST_P(SurfaceFiles, NameTheLineOfAFault) {
    EXPECT_THAT(fault("kind boundary", "knd boundary", SurfaceForm::kBoundary),
                HasSubstr("pcvt does not know 'knd'"));
    EXPECT_THAT(fault("lattice 1 ", "lattice x "), HasSubstr("is not a number"));
    EXPECT_THAT(fault("lattice 1 ", "lattice "), HasSubstr("lattice has 9 numbers here, not 8"));
}

TEST(PlySurfaces, NameTheLineOfAFault) {
    const SpaceTile tile = testing::random_space_tile(3);
    const EncodedFile file =
        encode_ply_mesh(mesh_of(tile, SurfaceForm::kCells, SeamForm::kColumns), "t.ply").front();
    const auto fault = [](const std::string& bytes) {
        return testing::fault_in([&] { decode_ply_surfaces({"t.ply", bytes}); });
    };
    const auto n_lines = std::count(file.bytes.begin(), file.bytes.end(), '\n');
    const std::size_t last = file.bytes.rfind('\n', file.bytes.size() - 2) + 1;
    EXPECT_THAT(fault(file.bytes.substr(0, last)),
                StartsWith("t.ply:" + std::to_string(n_lines - 1) +
                           ": the file ends before its last 'site'; "));
    // The last of too many vertices is read as a face.
    EXPECT_THAT(fault(testing::exchanged(file.bytes, "end_header\n", "end_header\n0 0 0\n")),
                HasSubstr(" is not a whole number; "));
}

INSTANTIATE_TEST_SUITE_P(All, SurfaceFiles,
                         ::testing::Values(TextFormat{"t.obj", SeamForm::kLines, encode_obj_mesh,
                                                      decode_obj_surfaces},
                                           TextFormat{"t.ply", SeamForm::kColumns, encode_ply_mesh,
                                                      decode_ply_surfaces}),
                         [](const auto& chosen) { return chosen.param.path.substr(2); });

TEST(ObjMesh, HasAGroupForEachCellAndItsColourByFaces) {
    const SpaceTile tile =
        testing::tile_of({"bcc", space::Lattice::box(1, 1, 1), testing::lattice_points(2)});
    const auto files =
        encode_obj_mesh(mesh_of(tile, SurfaceForm::kCells, SeamForm::kLines), "a/t.obj");
    ASSERT_EQ(files.size(), 2U);
    EXPECT_EQ(files[1].path, "a/t.mtl");
    EXPECT_THAT(files[0].bytes, HasSubstr("mtllib t.mtl\n"));
    EXPECT_THAT(files[0].bytes, HasSubstr("\ng cell_0\nusemtl faces_14\nf "));
    EXPECT_THAT(files[0].bytes, HasSubstr("\ng cell_1\nusemtl faces_14\nf "));
    EXPECT_THAT(files[1].bytes, HasSubstr("newmtl faces_14\nKd "));
}

TEST(ObjMesh, IsReadWithoutItsMaterials) {
    auto files = encode_obj_mesh(
        mesh_of(testing::random_space_tile(4), SurfaceForm::kCells, SeamForm::kLines), "t.obj");
    files.pop_back();
    EXPECT_EQ(prove_space_files(files).proof.n_cells, 4);
}

TEST(ObjMesh, OfABoundaryHasAGroupForEachSideOfTheSeam) {
    const SpaceTile tile =
        testing::tile_of({"cube", space::Lattice::box(1, 1, 1), space::Points::Zero(3, 1)});
    const std::string text =
        encode_obj_mesh(mesh_of(tile, SurfaceForm::kBoundary, SeamForm::kLines), "t.obj")
            .front()
            .bytes;
    for (const char* side : {"0_0_1", "0_0_-1", "0_1_0", "0_-1_0", "1_0_0", "-1_0_0"}) {
        EXPECT_THAT(text, HasSubstr("\ng seam_" + std::string(side) + "\n"));
    }
}

}  // namespace
}  // namespace pcvt
