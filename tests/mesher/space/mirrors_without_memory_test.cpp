// Triangulates after a triangulation that ended because an allocation failed.

#include <gtest/gtest.h>

#include "mesher/base/checkpoint.hpp"
#include "mesher/space/space_mirrors.hpp"
#include "tests/support/failing_new.hpp"

namespace pcvt {
namespace {

using testing::allocations_left;
using testing::fails_once;

SpaceSites some_sites() {
    const SpaceLattice cube = SpaceLattice::box(1, 1, 1);
    return {cube, uniform_points(cube, 12, 3)};
}

/// Triangulates with the k-th allocation failing; returns whether it succeeded.
bool triangulates(const SpaceSites& sites, long k) {
    fails_once = true;
    allocations_left = k;
    bool succeeded = true;
    try {
        space_mirrors(sites);
    } catch (const std::bad_alloc&) {
        succeeded = false;
    }
    allocations_left = -1;
    return succeeded;
}

TEST(MirrorsWithoutMemory, LeaveLaterTriangulationsOfTheThreadRight) {
    const SpaceSites sites = some_sites();
    const std::vector<Tetrahedron> expected = space_mirrors(sites).tetrahedra;
    long k = 0;
    while (!triangulates(sites, k)) {
        ASSERT_EQ(space_mirrors(sites).tetrahedra, expected) << k;
        ASSERT_LT(++k, 100000);
    }
    EXPECT_GT(k, 100);
}

class Impatience final : public Client {
   public:
    void pass() override { throw Cancelled{}; }
};

TEST(MirrorsWithoutMemory, LeaveLaterTriangulationsOfTheThreadCancellable) {
    const SpaceSites sites = some_sites();
    ASSERT_FALSE(triangulates(sites, 50));
    Impatience impatience;
    const ClientScope scope(&impatience);
    EXPECT_THROW(space_mirrors(sites), Cancelled);
}

}  // namespace
}  // namespace pcvt
