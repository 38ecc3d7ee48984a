#include <gmock/gmock.h>

#include <algorithm>
#include <random>

#include "io/formats/file_proof.hpp"
#include "io/formats/formats.hpp"
#include "mesher/plane/proof/validate.hpp"
#include "tests/support/layer_case.hpp"
#include "tests/support/mutation.hpp"
#include "tests/support/walled_tiles.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;
using testing::walled_tile;

using Files = std::vector<EncodedFile>;

std::string& text_of(Files& files, const std::string& name) {
    return std::find_if(files.begin(), files.end(),
                        [&](const EncodedFile& f) { return f.path == "t.foam/" + name; })
        ->bytes;
}

Files walled_case(Walls walls = Walls::kY) {
    return testing::layer_case(walled_tile(walls, WallCells::kWhole, 12, {}));
}

/// Returns why `pcvt check` refuses the files; empty if it accepts them.
std::string wall_fault(const Files& files) {
    const Format& format = *find_format("t.foam");
    try {
        prove_file(format, files, decode_tile(format, files, std::nullopt));
    } catch (const InvalidInput& fault) {
        return fault.what();
    }
    return "";
}

/// Returns the fault of the example with each `piece` of the file `name` replaced by `other`.
std::string wall_fault_with(const std::string& name, const std::string& piece,
                            const std::string& other) {
    Files files = walled_case();
    std::string& text = text_of(files, name);
    std::size_t at = text.find(piece);
    EXPECT_NE(at, std::string::npos) << piece;
    for (; at != std::string::npos; at = text.find(piece, at + other.size())) {
        text.replace(at, piece.size(), other);
    }
    return wall_fault(files);
}

TEST(FoamWalls, TilesReadBackExactlyWithTheirWalls) {
    std::mt19937_64 random(6);
    for (const Walls walls : {Walls::kX, Walls::kY, Walls::kXY}) {
        for (const WallCells cells : {WallCells::kWhole, WallCells::kHalf}) {
            for (const plane::MeshKindRow& row : plane::kMeshKinds) {
                if (row.kind == plane::MeshKind::kDelaunay && cells == WallCells::kWhole) continue;
                const int n = static_cast<int>(6 + random() % 30);
                SCOPED_TRACE(std::string(walls_row(walls).word) + ' ' + row.word + ' ' +
                             std::to_string(n));
                const plane::Tile tile = walled_tile(walls, cells, n, {.kind = row.kind});
                const Files files = testing::layer_case(tile);
                EXPECT_EQ(wall_fault(files), "");
                const TileFile file = decode_foam_layer(files, std::nullopt);
                EXPECT_TRUE(file.has_wall_edges);
                EXPECT_EQ(file.tile.points, tile.points);
                EXPECT_EQ(file.tile.walls, walls);
                EXPECT_EQ(file.tile.wall_edges, tile.wall_edges);
            }
        }
    }
}

TEST(FoamWalls, TheFieldsHaveConditionsOnWalls) {
    Files files = walled_case(Walls::kXY);
    EXPECT_THAT(text_of(files, "constant/polyMesh/boundary"),
                HasSubstr("    wall_left\n    {\n        type            wall;\n"));
    for (const WallSideRow& row : kWallSides) {
        const std::string name = std::string("    ") + row.word + " { type ";
        EXPECT_THAT(text_of(files, "0/U"), HasSubstr(name + "noSlip; }"));
        EXPECT_THAT(text_of(files, "0/p"), HasSubstr(name + "zeroGradient; }"));
        EXPECT_THAT(text_of(files, "0/T"), HasSubstr(name + "zeroGradient; }"));
    }
    Files moving = testing::layer_case(walled_tile(Walls::kXY, WallCells::kWhole, 150, {}));
    EXPECT_THAT(text_of(moving, "constant/transportProperties"), HasSubstr("U begins to fall as"));
    moving = testing::layer_case(walled_tile(Walls::kY, WallCells::kWhole, 150, {}));
    // pi^2, for the height 1.
    EXPECT_THAT(text_of(moving, "constant/transportProperties"), HasSubstr("fall as exp(-9.8696"));
}

TEST(FoamWalls, FalsePatchesAreRefused) {
    const std::string boundary = "constant/polyMesh/boundary";
    EXPECT_THAT(wall_fault_with(boundary, "wall_top", "wall_left"),
                HasSubstr("lies off its patch"));
    EXPECT_THAT(wall_fault_with(boundary, "wall_top", "lid"),
                HasSubstr("a wall without the one opposite to it"));
    EXPECT_THAT(wall_fault_with(boundary, "wall_top", "back"),
                HasSubstr("two patches have one name"));
    EXPECT_THAT(wall_fault_with(boundary, " wall;", " empty;"), HasSubstr("is neither an empty"));
    EXPECT_THAT(wall_fault_with(boundary, " wall;", " patch;"), HasSubstr("is neither an empty"));
    EXPECT_THAT(wall_fault_with(boundary, " walls 0 1", " walls 1 1"),
                HasSubstr("the comment on walls means xy, but the patches y; "));
    EXPECT_THAT(wall_fault_with(boundary, "// pcvt walls 0 1\n", ""),
                HasSubstr("the comment on walls means none, but the patches y; "));
    // The ranges of the two walls, exchanged by their names.
    Files files = walled_case();
    std::string& text = text_of(files, boundary);
    const std::size_t low = text.find("wall_bottom");
    const std::size_t high = text.find("wall_top");
    text.replace(high, 8, "wall_bottom");
    text.replace(low, 11, "wall_top");
    EXPECT_THAT(wall_fault(files), HasSubstr("lies off its patch wall_top"));
}

TEST(FoamWalls, FalseConditionsAreRefused) {
    EXPECT_THAT(wall_fault_with("0/U", "noSlip", "slip"), HasSubstr("t.foam/0/U:"));
    EXPECT_THAT(wall_fault_with("0/p", "zeroGradient", "noSlip"), HasSubstr("t.foam/0/p:"));
    EXPECT_THAT(wall_fault_with("0/T", "wall_top", "wall_left"), HasSubstr("t.foam/0/T:"));
}

TEST(FoamWalls, RangesOfWallPatchesAreProved) {
    for (const char* key : {"nFaces          ", "startFace       "}) {
        for (const char* wall : {"wall_bottom", "wall_top"}) {
            for (const int change : {-1, 1}) {
                Files files = walled_case();
                std::string& text = text_of(files, "constant/polyMesh/boundary");
                const std::size_t at = text.find(key, text.find(wall)) + std::string(key).size();
                const std::size_t end = text.find(';', at);
                const int number = std::stoi(text.substr(at, end - at));
                text.replace(at, end - at, std::to_string(number + change));
                EXPECT_THAT(wall_fault(files), HasSubstr("; correct startFace and nFaces"))
                    << wall << ' ' << key << change;
            }
        }
    }
}

TEST(FoamWalls, ThicknessesAreReadBack) {
    const plane::Tile tile = walled_tile(Walls::kY, WallCells::kWhole, 12, {});
    Files files = testing::layer_case(tile, 0.3);
    EXPECT_EQ(decode_foam_layer(files, std::nullopt).thickness, 0.3);
    EXPECT_EQ(wall_fault(files), "");
    const Format& format = *find_format("t.foam");
    prove_tile_files(format, files, tile, {0, 0}, {.thickness = 0.3});
    EXPECT_THROW(prove_tile_files(format, files, tile, {0, 0}, {.thickness = 0.25}), InternalError);
}

TEST(FoamWalls, LayersOfAnotherScaleThanTheCellsAreRefused) {
    const Format& format = *find_format("t.foam");
    FormatRequest request{.lattice = plane::Lattice::rectangle(2, 1),
                          .tile = {.kind = plane::MeshKind::kVoronoi},
                          .n_sites = 200};
    for (const auto& [thickness, is_held] :
         {std::pair(0.0, true), {1.01e-4, true}, {99.0, true}, {9.9e-5, false}, {101.0, false}}) {
        request.files.thickness = thickness;
        if (is_held) {
            EXPECT_NO_THROW(format.check(request)) << thickness;
        } else {
            EXPECT_THROW(format.check(request), InvalidInput) << thickness;
        }
    }
}

TEST(FoamWalls, DamagedFilesGiveATileOrAFaultAndNothingElse) {
    std::mt19937_64 random(5);
    const Files sound = walled_case(Walls::kXY);
    int n_refused = 0;
    for (int k = 0; k < 1000; ++k) {
        Files files = sound;
        std::string& bytes = files[random() % 5].bytes;
        bytes = testing::mutated(bytes, random);
        const std::string fault = wall_fault(files);
        if (fault.empty()) continue;
        ++n_refused;
        EXPECT_THAT(fault, ::testing::AnyOf(::testing::StartsWith("t.foam/"),
                                            ::testing::StartsWith("law ")));
    }
    EXPECT_GT(n_refused, 600);
}

}  // namespace
}  // namespace pcvt
