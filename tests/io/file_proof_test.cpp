#include "io/file_proof.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "io/gltf/gltf_writer.hpp"
#include "mesher/base/error.hpp"
#include "mesher/cvt/cvt.hpp"
#include "mesher/mesh/outline.hpp"
#include "mesher/mesh/voronoi.hpp"
#include "mesher/proof/generated_tile.hpp"
#include "mesher/tile/tile_builder.hpp"

namespace pcvt {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;

Tile cells(const Lattice& lattice, int n) {
    const CvtResult result = compute_cvt(lattice, uniform_points(lattice, n, 0), {});
    const PeriodicMesh mesh = periodic_mesh(result.delaunay, MeshKind::kVoronoi);
    return make_tile(mesh, whole_outline(mesh, Vec2::Zero()));
}

const TileFormat& glb() { return *find_tile_format("t.glb"); }

std::string refusal(const Tile& tile, const Vec2& origin) {
    try {
        prove_tile_files(glb(), encode_glb(tile, {}, "t.glb"), tile, origin);
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "";
}

TEST(FileProof, AFaithfulFileIsProved) {
    const Tile tile = cells(Lattice::rectangle(1, 1), 8);
    EXPECT_NO_THROW(verify_generated_tile(tile));
    EXPECT_NO_THROW(prove_tile_files(glb(), encode_glb(tile, {}, "t.glb"), tile, Vec2::Zero()));
}

TEST(FileProof, ABrokenFileOfATileThatFitsIsAFaultOfPcvt) {
    const Tile tile = cells(Lattice::rectangle(1, 1), 8);
    Tile moved = tile;
    moved.points[moved.vertex_pairs.at(0).w].x() += 1e-3;
    EXPECT_THROW(prove_tile_files(glb(), encode_glb(moved, {}, "t.glb"), tile, Vec2::Zero()),
                 InternalError);
    Tile unpaired = tile;
    unpaired.vertex_pairs.pop_back();
    EXPECT_THROW(prove_tile_files(glb(), encode_glb(unpaired, {}, "t.glb"), tile, Vec2::Zero()),
                 InternalError);
}

void prove(const std::string& path, const Tile& written, const Tile& proved) {
    const TileFormat& format = *find_tile_format(path);
    prove_tile_files(format, encode_tile(format, written, path), proved, Vec2::Zero());
}

TEST(FileProof, AFileIsComparedInEveryNumberBeforeItsProofIsSkipped) {
    const Tile tile = cells(Lattice({1, 0}, {0.37, 0.81}), 9);
    Tile moved = tile;
    moved.points[moved.vertex_pairs.at(0).w].x() += 1e-12;
    for (const char* path : {"t.obj", "t.ply", "t.vtu", "t.foam"}) {
        EXPECT_NO_THROW(prove(path, tile, tile)) << path;
        EXPECT_THROW(prove(path, moved, tile), InternalError) << path;
    }
    Tile turned = tile;
    std::reverse(turned.faces.corners.begin(),
                 turned.faces.corners.begin() + turned.faces.begin[1]);
    for (const char* path : {"t.obj", "t.ply", "t.vtu"}) {
        EXPECT_THROW(prove(path, turned, tile), InternalError) << path;
    }
}

TEST(FileProof, StoredPairsAreComparedToo) {
    const Tile tile = cells(Lattice({1, 0}, {0.37, 0.81}), 9);
    Tile unpaired = tile;
    unpaired.edge_pairs.pop_back();
    EXPECT_THROW(prove("t.obj", unpaired, tile), InternalError);
    unpaired = tile;
    unpaired.vertex_pairs.pop_back();
    for (const char* path : {"t.obj", "t.ply", "t.vtu"}) {
        EXPECT_THROW(prove(path, unpaired, tile), InternalError) << path;
    }
}

TEST(FileProof, ATileTooFineForFloatsIsRefusedWithTheAdviceThatHelps) {
    const Tile thin = cells(Lattice::rectangle(1, 1e-4), 1);
    EXPECT_NO_THROW(verify_generated_tile(thin));
    EXPECT_THAT(refusal(thin, {0, 0}), EndsWith("take another format"));
    EXPECT_THAT(refusal(thin, {1, 0}), EndsWith("or an origin nearer to 0,0"));
    EXPECT_THAT(refusal(thin, {0, 0}), HasSubstr("t.glb: "));
}

}  // namespace
}  // namespace pcvt
