#include "mesher/plane/voxels/voxel_grid.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "mesher/base/error.hpp"

namespace pcvt::plane {
namespace {

using ::testing::HasSubstr;

template <class Fault>
std::string grid_refusal(const Lattice& lattice, VoxelCounts counts) {
    try {
        voxel_grid(lattice, {0, 0}, counts);
    } catch (const Fault& fault) {
        return fault.what();
    }
    return "";
}

TEST(VoxelGrid, FillsTheDomainOfEveryRectangle) {
    const VoxelGrid plain = voxel_grid(Lattice::rectangle(2, 1), {0.5, -3}, {4, 8});
    EXPECT_EQ(plain.corner, Vec2(0.5, -3));
    EXPECT_EQ(plain.size, Vec2(2, 1));
    EXPECT_EQ(plain.spacing(), Vec2(0.5, 0.125));
    EXPECT_EQ(plain.n_voxels(), 32U);
    // Periods that point down and along y first.
    const VoxelGrid turned = voxel_grid(Lattice({0, -1}, {2, 0}), {0.5, -3}, {4, 8});
    EXPECT_EQ(turned.corner, Vec2(0.5, -4));
    EXPECT_EQ(turned.size, Vec2(2, 1));
}

TEST(VoxelGrid, TakesARectangularRepetitionOfHexagons) {
    const Lattice hexagonal({1, 0}, {0.5, std::sqrt(0.75)});
    const VoxelGrid grid = voxel_grid(hexagonal.repeated(1, 2), {0, 0}, {10, 10});
    EXPECT_NEAR(grid.size.x(), 1, 1e-15);
    EXPECT_NEAR(grid.size.y(), 2 * std::sqrt(0.75), 1e-15);
    EXPECT_THAT(grid_refusal<InvalidInput>(hexagonal, {10, 10}),
                HasSubstr("periods along x and y"));
}

TEST(VoxelGrid, RefusesCountsOutOfRange) {
    const Lattice unit = Lattice::rectangle(1, 1);
    EXPECT_THAT(grid_refusal<InvalidInput>(unit, {1, 8}), HasSubstr("at least 2"));
    EXPECT_THAT(grid_refusal<InvalidInput>(unit, {8, -8}), HasSubstr("at least 2"));
    EXPECT_THAT(grid_refusal<LimitExceeded>(unit, {1 << 20, 1 << 20}), HasSubstr("at most 2^28"));
    EXPECT_THAT(grid_refusal<LimitExceeded>(unit, {(1 << 20) + 1, 2}), HasSubstr("at most 2^28"));
    EXPECT_EQ(grid_refusal<Error>(unit, {1 << 14, 1 << 14}), "");
}

TEST(VoxelGrid, DefaultsToSixteenVoxelsAlongACell) {
    EXPECT_EQ(default_voxels(Lattice::rectangle(1, 1), 100), (VoxelCounts{160, 160}));
    EXPECT_EQ(default_voxels(Lattice::rectangle(2, 1), 200), (VoxelCounts{320, 160}));
    EXPECT_EQ(default_voxels(Lattice::rectangle(1e6, 1), 1), (VoxelCounts{16000, 2}));
}

}  // namespace
}  // namespace pcvt::plane
