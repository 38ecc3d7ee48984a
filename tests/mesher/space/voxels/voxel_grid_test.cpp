#include "mesher/space/voxels/voxel_grid.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesher/base/error.hpp"
#include "tests/support/space_lattices.hpp"

namespace pcvt::space {
namespace {

using ::testing::HasSubstr;

template <class Fault>
std::string refused_grid(const Lattice& lattice, VoxelCounts counts) {
    try {
        voxel_grid(lattice, {0, 0, 0}, counts);
    } catch (const Fault& fault) {
        return fault.what();
    }
    return "";
}

TEST(VoxelGridInSpace, FillsTheDomainOfEveryBox) {
    const VoxelGrid plain = voxel_grid(Lattice::box(2, 1, 3), {0.5, -3, 7}, {4, 8, 6});
    EXPECT_EQ(plain.corner, Vec3(0.5, -3, 7));
    EXPECT_EQ(plain.size, Vec3(2, 1, 3));
    EXPECT_EQ(plain.spacing(), Vec3(0.5, 0.125, 0.5));
    EXPECT_EQ(plain.n_voxels(), 192U);
    // Periods in another order, of which two point down.
    const Lattice turned({0, -1, 0}, {0, 0, 3}, {-2, 0, 0});
    const VoxelGrid grid = voxel_grid(turned, {0.5, -3, 7}, {4, 8, 6});
    EXPECT_EQ(grid.corner, Vec3(-1.5, -4, 7));
    EXPECT_EQ(grid.size, Vec3(2, 1, 3));
}

TEST(VoxelGridInSpace, TakesOtherBasesOfABox) {
    const VoxelGrid grid =
        voxel_grid(Lattice({2, 0, 0}, {2, 1, 0}, {-4, 3, 3}), {1, 2, 3}, {4, 4, 4});
    EXPECT_EQ(grid.corner, Vec3(1, 2, 3));
    EXPECT_EQ(grid.size, Vec3(2, 1, 3));
}

TEST(VoxelGridInSpace, RefusesLatticesThatAreNotBoxes) {
    for (const auto& [name, lattice] : testing::space_lattices()) {
        const Lattice reduced = reduce(lattice).reduced;
        const Vec3 lengths(reduced.a().norm(), reduced.b().norm(), reduced.c().norm());
        const bool is_box = std::abs(lengths.prod() / lattice.volume() - 1) < 1e-12;
        const auto words = is_box ? std::string() : "voxels need periods along x, y and z; use a";
        EXPECT_THAT(refused_grid<InvalidInput>(lattice, {8, 8, 8}), HasSubstr(words)) << name;
        EXPECT_EQ(refused_grid<InvalidInput>(lattice, {8, 8, 8}).empty(), is_box) << name;
    }
    // A box that is turned has a box as its reduced basis, but not along the axes.
    const Lattice turned({1, 1, 0}, {1, -1, 0}, {0, 0, 1});
    EXPECT_THAT(refused_grid<InvalidInput>(turned, {8, 8, 8}), HasSubstr("along x, y and z"));
}

TEST(VoxelGridInSpace, RefusesCountsOutOfRange) {
    for (const VoxelCounts counts : {VoxelCounts{1, 8, 8}, {8, -8, 8}, {8, 8, 1}, {0, 0, 1}}) {
        EXPECT_THAT(refused_grid<InvalidInput>(testing::kCube, counts),
                    HasSubstr("three counts, NX,NY,NZ, each of them 2 or more"));
    }
    EXPECT_THAT(refused_grid<LimitExceeded>(testing::kCube, {1 << 10, 1 << 10, (1 << 8) + 1}),
                HasSubstr("1024 x 1024 x 257 voxels are too many; take at most 2^28"));
    EXPECT_EQ(refused_grid<Error>(testing::kCube, {1 << 10, 1 << 10, 1 << 8}), "");
}

TEST(VoxelGridInSpace, DefaultsToSixteenVoxelsAlongACellOrFewer) {
    EXPECT_EQ(default_voxels(testing::kCube, 1000), (VoxelCounts{160, 160, 160}));
    EXPECT_EQ(default_voxels(Lattice::box(2, 1, 1), 2), (VoxelCounts{32, 16, 16}));
    for (const double n : {65'000.0, 70'000.0, 1e6, 6e7}) {
        const VoxelCounts counts = default_voxels(Lattice::box(1, 2, 3), n);
        const double n_voxels = double(counts.x) * counts.y * counts.z;
        EXPECT_LE(n_voxels, kMostVoxels) << n;
        EXPECT_GE(n_voxels, 0.9 * kMostVoxels) << n;
    }
}

}  // namespace
}  // namespace pcvt::space
