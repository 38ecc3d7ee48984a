#include "mesher/space/voxels/voxel_proof.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "mesher/base/law_violation.hpp"
#include "tests/support/space_lattices.hpp"

namespace pcvt::space {
namespace {

using ::testing::HasSubstr;

struct ProofCase {
    VoxelImage image;
    VoxelCells cells;
};

ProofCase proof_case(VoxelCounts counts, int n = 40, const Lattice& lattice = Lattice::box(2, 1, 1),
                     const Vec3& origin = {5, 0.25, -1}) {
    const auto delaunay = periodic_delaunay(Sites(lattice, uniform_points(lattice, n, 2)));
    return {voxel_image(delaunay, {}, voxel_grid(lattice, origin, counts), 1),
            {.lattice = lattice, .sites = wrapped_positions(delaunay.sites, origin)}};
}

std::string refuted(const ProofCase& c) {
    try {
        prove_voxels(c.image, c.cells);
    } catch (const NotATile& fault) {
        return fault.what();
    }
    return "";
}

TEST(VoxelProofInSpace, HoldsForImages) {
    for (const auto& [name, lattice] : testing::space_lattices()) {
        if (lattice.a().norm() * lattice.b().norm() * lattice.c().norm() >
            lattice.volume() * (1 + 1e-12)) {
            continue;
        }
        for (const int n : {1, 2, 5, 60}) {
            for (const VoxelCounts counts : {VoxelCounts{2, 2, 2}, {9, 17, 31}, {64, 5, 8}}) {
                const ProofCase good = proof_case(counts, n, lattice, lattice.a() * 0.3);
                const VoxelProof proof = prove_voxels(good.image, good.cells);
                EXPECT_EQ(proof.n_cells, n);
                EXPECT_LT(proof.largest_excess, 1e-12) << name;
            }
        }
    }
    EXPECT_TRUE(prove_voxels(proof_case({60, 30, 30}).image, proof_case({60, 30, 30}).cells)
                    .unseen.empty());
}

TEST(VoxelProofInSpace, HoldsInTheMetricOfTheCells) {
    const Lattice lattice = Lattice::box(2, 1, 1);
    for (const double ratio : {0.1, 4.0, 100.0}) {
        const Metric metric(ratio, {1, 1, 3});
        const auto delaunay = periodic_delaunay(
            Sites(metric.to_round(lattice), metric.to_round(uniform_points(lattice, 40, 2))));
        const VoxelGrid grid = voxel_grid(lattice, {5, 0.25, -1}, {30, 24, 17});
        ProofCase c{voxel_image(delaunay, {}, grid, 1, metric),
                    {.lattice = lattice,
                     .sites = metric.from_round(delaunay.sites, lattice).positions(),
                     .metric = metric}};
        EXPECT_EQ(refuted(c), "");
        c.cells.metric = Metric(1.2 * ratio > 100 ? 80 : 1.2 * ratio, metric.axis());
        EXPECT_THAT(refuted(c), HasSubstr("its centre lies in cell"));
    }
}

TEST(VoxelProofInSpace, HoldsForLatticesWhoseCentresTie) {
    const auto delaunay = periodic_delaunay(
        Sites(testing::kCube, testing::cubic_points(testing::Cubic::kFaceCentred, 2)));
    const VoxelCells cells{.lattice = testing::kCube, .sites = delaunay.sites.positions()};
    for (const VoxelCounts counts : {VoxelCounts{4, 4, 4}, {8, 8, 8}, {12, 12, 12}}) {
        const VoxelGrid grid = voxel_grid(testing::kCube, {0, 0, 0}, counts);
        EXPECT_NO_THROW(prove_voxels(voxel_image(delaunay, {}, grid, 1), cells));
    }
}

TEST(VoxelProofInSpace, NamesEveryVoxelThatIsNotOfItsCell) {
    const ProofCase good = proof_case({20, 11, 9});
    std::mt19937_64 random(1);
    for (int k = 0; k < 200; ++k) {
        ProofCase bad = good;
        const std::size_t at = random() % bad.image.site.size();
        const SiteId here = bad.image.site[at];
        const auto other = static_cast<SiteId>((here + 1 + random() % 39) % 40);
        bad.image.site[at] = other;
        EXPECT_EQ(refuted(bad), "voxel " + std::to_string(at % 20) + "," +
                                    std::to_string(at / 20 % 11) + "," + std::to_string(at / 220) +
                                    " names cell " + std::to_string(other) +
                                    ", but its centre lies in cell " + std::to_string(here));
    }
}

TEST(VoxelProofInSpace, RefusesIdsThatNoCellHas) {
    for (const int id : {-1, 40}) {
        ProofCase bad = proof_case({20, 10, 6});
        bad.image.site.back() = id;
        EXPECT_EQ(refuted(bad),
                  "voxel 19,9,5 names cell " + std::to_string(id) + ", but the cells are 0 to 39");
    }
}

TEST(VoxelProofInSpace, NeedsTheCornerThePeriodsAndTheWeights) {
    const ProofCase good = proof_case({40, 20, 20});
    for (int axis = 0; axis < 3; ++axis) {
        ProofCase bad = good;
        bad.image.grid.corner[axis] += 0.1;
        EXPECT_THAT(refuted(bad), HasSubstr("its centre lies in cell"));
        bad = good;
        bad.image.grid.size[axis] *= 1.5;
        EXPECT_THAT(refuted(bad), HasSubstr("periods"));
    }
    ProofCase bad = good;
    bad.cells.weights = Eigen::VectorXd::Zero(40);
    EXPECT_EQ(refuted(bad), "");
    bad.cells.weights[7] = 0.02;
    EXPECT_THAT(refuted(bad), HasSubstr("but its centre lies in cell 7"));
}

/// Lattices that are not boxes, but have a sublattice that is.
TEST(VoxelProofInSpace, HoldsForBoxesOfSeveralDomains) {
    const double side = std::sqrt(3.0);
    const std::vector<std::pair<Lattice, Lattice>> pairs{
        {Lattice({0, 1, 1}, {1, 0, 1}, {1, 1, 0}), Lattice::box(2, 2, 2)},
        {Lattice({1, 0, 0}, {0.5, side / 2, 0}, {0, 0, 1.6}), Lattice::box(1, side, 1.6)},
        {Lattice({0.1, 0.1, 0}, {0, 0.2, 0}, {0, 0, 3}), Lattice::box(0.4, 0.6, 3)}};
    for (const auto& [lattice, box] : pairs) {
        for (const int n : {1, 2, 7, 50}) {
            const auto delaunay = periodic_delaunay(Sites(lattice, uniform_points(lattice, n, 3)));
            const VoxelGrid grid = voxel_grid(box, {0.3, -2, 7}, {20, 15, 24});
            const VoxelCells cells{.lattice = lattice, .sites = delaunay.sites.positions()};
            EXPECT_NO_THROW(prove_voxels(voxel_image(delaunay, {}, grid, 1), cells)) << n;
        }
    }
}

/// Positions in files are rounded where the origin is far.
TEST(VoxelProofInSpace, HoldsFarFromTheOrigin) {
    for (const double far : {1e5, 1e7}) {
        ProofCase c = proof_case({40, 20, 20}, 40, Lattice::box(2, 1, 1), {far, -far, 3});
        EXPECT_NO_THROW(prove_voxels(c.image, c.cells));
        const SiteId here = c.image.site[1234];
        c.image.site[1234] = here == 2 ? 3 : 2;
        EXPECT_NE(refuted(c), "");
    }
}

TEST(VoxelProofInSpace, NamesTheCellsThatAreSmallerThanAVoxel) {
    const ProofCase coarse = proof_case({3, 3, 2});
    const VoxelProof proof = prove_voxels(coarse.image, coarse.cells);
    EXPECT_GE(proof.unseen.size(), 22U);
    for (const SiteId s : proof.unseen)
        EXPECT_THAT(coarse.image.site, ::testing::Not(::testing::Contains(s)));
}

}  // namespace
}  // namespace pcvt::space
