#include "plugin/job_proof.hpp"

#include <gmock/gmock.h>

#include "io/gltf_writer.hpp"
#include "mesher/cvt.hpp"
#include "mesher/error.hpp"
#include "mesher/outline.hpp"

namespace pcvt {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;

AnyTile cells(const Lattice& lattice, int n) {
    const CvtResult result = compute_cvt(lattice, uniform_points(lattice, n, 0), {});
    const PeriodicMesh mesh = periodic_mesh(result, TileKind::kCells);
    return make_tile(mesh, whole_outline(mesh, Vec2::Zero()));
}

const TileFormat& glb() { return *find_tile_format("t.glb"); }

std::string refusal(const AnyTile& tile, const Vec2& origin) {
    try {
        prove_files(glb(), encode_glb(tile, "t.glb"), tile, origin);
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "";
}

TEST(JobProof, AFaithfulFileIsProved) {
    const AnyTile tile = cells(Lattice::rectangle(1, 1), 8);
    EXPECT_NO_THROW(prove_own_tile(tile));
    EXPECT_NO_THROW(prove_files(glb(), encode_glb(tile, "t.glb"), tile, Vec2::Zero()));
}

TEST(JobProof, ABrokenFileOfATileThatFitsIsAFaultOfPcvt) {
    const AnyTile tile = cells(Lattice::rectangle(1, 1), 8);
    FlatTile moved = flatten(tile);
    moved.points[moved.vertex_pairs.at(0).w].x() += 1e-3;
    EXPECT_THROW(prove_files(glb(), encode_glb(moved, "t.glb"), tile, Vec2::Zero()), InternalError);
    FlatTile unpaired = flatten(tile);
    unpaired.vertex_pairs.pop_back();
    EXPECT_THROW(prove_files(glb(), encode_glb(unpaired, "t.glb"), tile, Vec2::Zero()),
                 InternalError);
}

TEST(JobProof, ATileTooFineForFloatsIsRefusedWithTheAdviceThatHelps) {
    const AnyTile thin = cells(Lattice::rectangle(1, 1e-4), 1);
    EXPECT_NO_THROW(prove_own_tile(thin));
    EXPECT_THAT(refusal(thin, {0, 0}), EndsWith("take another format"));
    EXPECT_THAT(refusal(thin, {1, 0}), EndsWith("or an origin nearer to 0,0"));
    EXPECT_THAT(refusal(thin, {0, 0}), HasSubstr("t.glb: "));
}

}  // namespace
}  // namespace pcvt
