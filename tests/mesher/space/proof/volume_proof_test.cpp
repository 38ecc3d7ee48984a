#include "mesher/space/proof/volume_proof.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "mesher/space/cvt/volume_cvt.hpp"
#include "mesher/space/mesh/cell_sites.hpp"
#include "mesher/space/proof/polyhedral_proof.hpp"
#include "tests/support/space_cells.hpp"
#include "tests/support/space_lattices.hpp"
#include "tests/support/space_weights.hpp"

namespace pcvt::space {
namespace {

constexpr double kLeast = 1e-9;

/// A proved tile of power cells of prescribed volumes.
struct Grains {
    VolumeCvtResult result;
    PolyhedralMesh mesh;
    Points sites;
    PolyhedralProof proof;

    VolumeComparison compare(const Eigen::VectorXd& wanted, bool with_sites = true,
                             double least = kLeast) const {
        return compare_volumes({.mesh = mesh,
                                .sites = with_sites ? sites : Points(3, 0),
                                .weights = result.delaunay.weights,
                                .rounding = proof.tolerance},
                               wanted, least);
    }
};

Grains grains(const Lattice& lattice, const Points& points, double spread, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto n = static_cast<int>(points.cols());
    const Eigen::VectorXd volumes = testing::lognormal_volumes(n, spread, lattice.volume(), random);
    VolumeCvtResult result = compute_volume_cvt(lattice, points, {.volumes = volumes});
    const PeriodicDelaunay& regular = result.delaunay;
    const CellComplex complex = cell_complex(regular.sites, regular.tetrahedra, regular.weights);
    std::vector<Offset> images;
    PolyhedralMesh mesh = polyhedral_mesh(regular.sites, complex, Vec3::Zero(), &images);
    Points sites = sites_of_cells(complex, images);
    const PolyhedralProof proof = prove_polyhedra(mesh);
    prove_cell_sites(mesh, sites, regular.weights);
    return {std::move(result), std::move(mesh), std::move(sites), proof};
}

const Lattice& thin() {
    static const Lattice lattice({1, 0, 0}, {0.2, 0.05, 0}, {0.1, 0.3, 0.9});
    return lattice;
}

// Law 1: the cells have the volumes of brute force, and their own targets, within 1e-9 of the mean.
TEST(VolumeProof, FindsTheVolumesOfTheCells) {
    for (int n = 1; n <= 10; ++n) {
        for (const Lattice& lattice : {testing::kCube, thin()}) {
            const Grains cells = grains(lattice, uniform_points(lattice, n, n), 0.5, n);
            const VolumeComparison found = cells.compare(cells.result.targets);
            EXPECT_LE(found.error, 1.01e-10) << n;
            const double own = cells.result.targets[found.cell] / (lattice.volume() / n);
            EXPECT_DOUBLE_EQ(found.tolerance, kLeast * std::max(1.0, own)) << n;
            const auto twin = testing::brute_force_energy(cells.result.delaunay.sites,
                                                          cells.result.delaunay.weights);
            const Eigen::VectorXd volumes =
                Eigen::Map<const Eigen::VectorXd>(twin.volumes.data(), n);
            EXPECT_LE(cells.compare(volumes).error, 1e-12) << n;
            EXPECT_LE(cells.compare(volumes, false).error, 1e-12) << n;
        }
    }
}

// Law 2.
TEST(VolumeProof, RefutesExchangedVolumes) {
    const Grains cells = grains(testing::kCube, uniform_points(testing::kCube, 60, 1), 0.35, 1);
    Eigen::VectorXd wanted = cells.result.targets;
    for (int s = 0; s < 60; ++s) {
        std::swap(wanted[s], wanted[(s + 1) % 60]);
        const VolumeComparison found = cells.compare(wanted);
        EXPECT_GT(found.error, found.tolerance);
        EXPECT_TRUE(found.cell == s || found.cell == (s + 1) % 60) << found.cell;
        std::swap(wanted[s], wanted[(s + 1) % 60]);
    }
    wanted[7] += 2 * kLeast / 60;
    EXPECT_EQ(cells.compare(wanted).cell, 7);
    EXPECT_GT(cells.compare(wanted).error, kLeast);
}

/// Cells in the cube, of which five have sites at this distance from that of another, in units of
/// h.
Grains grains_with_pairs(int n, double distance, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    Points points = uniform_points(testing::kCube, n, seed);
    for (int s = 0; s < n; s += n / 5) {
        const Vec3 way = Vec3(testing::random_number(random), 1, testing::random_number(random));
        points.col(s + 1) = points.col(s) + distance / std::cbrt(n) * way.normalized();
    }
    return grains(testing::kCube, points, 0.35, seed);
}

// The volumes of the polyhedra differ by rounding from those that the run measures by tetrahedra:
// by no more than the tolerance grants, and by no less than a thousandth of it, which would grant
// too much.
TEST(VolumeProof, GrantsWhatRoundingChangesBetweenNearSites) {
    for (const double distance : {1e-4, 1e-6, 1e-7}) {
        double nearest = 0;
        for (int seed = 0; seed < 20; ++seed) {
            const Grains cells = grains_with_pairs(40, distance, seed);
            const VolumeComparison found = cells.compare(cells.result.cell_volumes, true, 0);
            EXPECT_LE(found.error, found.tolerance) << distance << " " << seed;
            nearest = std::max(nearest, found.error / found.tolerance);
            const VolumeComparison targets = cells.compare(cells.result.targets);
            EXPECT_LE(targets.error, targets.tolerance) << distance << " " << seed;
        }
        EXPECT_GT(nearest, 1e-3) << distance;
    }
}

// The tolerance of a cell does not depend on other cells.
TEST(VolumeProof, GrantsNothingToCellsOfOtherSites) {
    const Grains cells = grains_with_pairs(40, 1e-6, 3);
    Eigen::VectorXd wanted = cells.result.targets;
    wanted[0] += 1e-5 / 40;
    EXPECT_EQ(cells.compare(wanted).cell, 0);
    EXPECT_GT(cells.compare(wanted).error, cells.compare(wanted).tolerance);
    wanted = cells.result.targets;
    wanted[5] += 2 * kLeast / 40;
    EXPECT_EQ(cells.compare(wanted).cell, 5);
}

}  // namespace
}  // namespace pcvt::space
