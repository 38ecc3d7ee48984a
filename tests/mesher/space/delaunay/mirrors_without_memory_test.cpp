// Triangulates after a triangulation that ended because an allocation failed.

#include <gtest/gtest.h>

#include <thread>

#include "mesher/base/checkpoint.hpp"
#include "mesher/space/delaunay/mirror_diagram.hpp"
#include "tests/support/failing_new.hpp"

/// Leaks that the leak sanitizer does not report: CGAL 5.5 loses a block of cells or vertices where
/// the memory for its list of blocks is missing.
// NOLINTNEXTLINE(bugprone-reserved-identifier,readability-identifier-naming): the sanitizer's name
extern "C" const char* __lsan_default_suppressions() { return "leak:allocate_new_block\n"; }

namespace pcvt::space {
namespace {

using testing::allocations_left;
using testing::fails_once;

Sites some_sites() {
    const Lattice cube = Lattice::box(1, 1, 1);
    return {cube, uniform_points(cube, 12, 3)};
}

/// Triangulates with the k-th allocation failing; returns whether it succeeded.
bool triangulates(const Sites& sites, long k) {
    fails_once = true;
    allocations_left = k;
    bool succeeded = true;
    try {
        mirror_diagram(sites);
    } catch (const std::bad_alloc&) {
        succeeded = false;
    }
    allocations_left = -1;
    return succeeded;
}

/// Runs work() in a thread in which no allocation has failed yet.
template <class Work>
void in_thread(const Work& work) {
    std::thread(work).join();
}

TEST(MirrorsWithoutMemory, LeaveLaterTriangulationsOfTheThreadRight) {
    const Sites sites = some_sites();
    const std::vector<Tetrahedron> expected = mirror_diagram(sites).tetrahedra;
    bool succeeded = false;
    long k = 0;
    for (; !succeeded && k < 100000; ++k) {
        in_thread([&] {
            succeeded = triangulates(sites, k);
            EXPECT_EQ(mirror_diagram(sites).tetrahedra, expected) << k;
        });
    }
    EXPECT_TRUE(succeeded);
    EXPECT_GT(k, 30);
}

class Impatience final : public Client {
   public:
    void pass() override { throw Cancelled{}; }
};

TEST(MirrorsWithoutMemory, LeaveLaterTriangulationsOfTheThreadCancellable) {
    const Sites sites = some_sites();
    in_thread([&] {
        ASSERT_FALSE(triangulates(sites, 20));
        Impatience impatience;
        const ClientScope scope(&impatience);
        EXPECT_THROW(mirror_diagram(sites), Cancelled);
    });
}

}  // namespace
}  // namespace pcvt::space
