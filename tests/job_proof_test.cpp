#include "plugin/job_proof.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "io/gltf_writer.hpp"
#include "io/obj_writer.hpp"
#include "io/ply_writer.hpp"
#include "mesher/cvt.hpp"
#include "mesher/error.hpp"
#include "mesher/outline.hpp"

namespace pcvt {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;

FlatTile cells(const Lattice& lattice, int n) {
    const CvtResult result = compute_cvt(lattice, uniform_points(lattice, n, 0), {});
    const PeriodicMesh mesh = periodic_mesh(result, TileKind::kCells);
    return flatten(make_tile(mesh, whole_outline(mesh, Vec2::Zero())));
}

const TileFormat& glb() { return *find_tile_format("t.glb"); }

std::string refusal(const FlatTile& tile, const Vec2& origin) {
    try {
        prove_files(glb(), encode_glb(tile, "t.glb"), tile, origin);
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "";
}

TEST(JobProof, AFaithfulFileIsProved) {
    const FlatTile tile = cells(Lattice::rectangle(1, 1), 8);
    EXPECT_NO_THROW(prove_own_tile(tile));
    EXPECT_NO_THROW(prove_files(glb(), encode_glb(tile, "t.glb"), tile, Vec2::Zero()));
}

TEST(JobProof, ABrokenFileOfATileThatFitsIsAFaultOfPcvt) {
    const FlatTile tile = cells(Lattice::rectangle(1, 1), 8);
    FlatTile moved = tile;
    moved.points[moved.vertex_pairs.at(0).w].x() += 1e-3;
    EXPECT_THROW(prove_files(glb(), encode_glb(moved, "t.glb"), tile, Vec2::Zero()), InternalError);
    FlatTile unpaired = tile;
    unpaired.vertex_pairs.pop_back();
    EXPECT_THROW(prove_files(glb(), encode_glb(unpaired, "t.glb"), tile, Vec2::Zero()),
                 InternalError);
}

/// The fault of a file of `written` beside the tile that it should hold, which is proved.
void expect_refused(const FlatTile& written, const FlatTile& tile) {
    for (const char* path : {"t.obj", "t.ply", "t.vtu", "t.foam"}) {
        const TileFormat& format = *find_tile_format(path);
        EXPECT_NO_THROW(prove_files(
            format, format.encode(AnyTile(std::in_place_type<CellTile>, tile.lattice), tile, path),
            tile, Vec2::Zero()));
        const auto files =
            format.encode(AnyTile(std::in_place_type<CellTile>, tile.lattice), written, path);
        EXPECT_THROW(prove_files(format, files, tile, Vec2::Zero()), InternalError) << path;
    }
}

TEST(JobProof, AFileIsComparedInEveryNumberBeforeItsProofIsSpared) {
    const FlatTile tile = cells(Lattice({1, 0}, {0.37, 0.81}), 9);
    FlatTile moved = tile;
    moved.points[moved.vertex_pairs.at(0).w].x() += 1e-12;
    expect_refused(moved, tile);
    FlatTile turned = tile;
    std::reverse(turned.corners.begin(), turned.corners.begin() + turned.face_begin[1]);
    expect_refused(turned, tile);
}

TEST(JobProof, StoredPairsAreComparedToo) {
    const FlatTile tile = cells(Lattice({1, 0}, {0.37, 0.81}), 9);
    FlatTile unpaired = tile;
    unpaired.edge_pairs.pop_back();
    EXPECT_THROW(
        prove_files(*find_tile_format("t.obj"), encode_obj(unpaired, "t.obj"), tile, Vec2::Zero()),
        InternalError);
    unpaired = tile;
    unpaired.vertex_pairs.pop_back();
    EXPECT_THROW(
        prove_files(*find_tile_format("t.ply"), encode_ply(unpaired, "t.ply"), tile, Vec2::Zero()),
        InternalError);
}

TEST(JobProof, ATileTooFineForFloatsIsRefusedWithTheAdviceThatHelps) {
    const FlatTile thin = cells(Lattice::rectangle(1, 1e-4), 1);
    EXPECT_NO_THROW(prove_own_tile(thin));
    EXPECT_THAT(refusal(thin, {0, 0}), EndsWith("take another format"));
    EXPECT_THAT(refusal(thin, {1, 0}), EndsWith("or an origin nearer to 0,0"));
    EXPECT_THAT(refusal(thin, {0, 0}), HasSubstr("t.glb: "));
}

}  // namespace
}  // namespace pcvt
