#include "mesher/plane/symmetry/symmetric_sites.hpp"

#include <gtest/gtest.h>

#include "mesher/base/error.hpp"
#include "tests/support/symmetry.hpp"

namespace pcvt::plane {
namespace {

using testing::expect_symmetric;
using testing::fitting_lattice;

/// n general orbits, one on each mirror, and all centres.
OrbitPlan full_plan(const SpecialPositions& special, int n) {
    return {n, std::vector<int>(special.mirrors.size(), 1),
            std::vector<bool>(special.centres.size(), true)};
}

// Law (1).
TEST(SymmetricSites, AreOrbitsToTheLastBit) {
    for (const PlaneGroupRow& row : kPlaneGroups) {
        const PlaneGroup group(row.name, fitting_lattice(row.name));
        const SpecialPositions special = special_positions(group);
        for (const int n : {1, 2, 5, 12}) {
            const OrbitPlan plan = full_plan(special, n);
            const SymmetricSites sites = random_sites(group, plan, 3);
            EXPECT_EQ(sites.sites.n_sites(), n_sites(group, special, plan));
            expect_symmetric(sites, sites.sites);
            const auto on_mirrors = std::count_if(sites.orbits.begin(), sites.orbits.end(),
                                                  [](const auto& o) { return o.freedom == 1; });
            EXPECT_EQ(on_mirrors, std::ssize(special.mirrors)) << row.word;
            const auto centres = std::count_if(sites.orbits.begin(), sites.orbits.end(),
                                               [](const auto& o) { return o.freedom == 0; });
            EXPECT_EQ(centres, std::ssize(special.centres)) << row.word;
        }
    }
}

TEST(SymmetricSites, AreTheImagesOfGivenPoints) {
    const PlaneGroup group(PlaneGroupName::kPmm, Lattice::rectangle(2, 4));
    Points points(2, 4);
    points << 0.3, 0.5, 1, 0.2,  //
        0.7, 2, 0, 1e-12;
    const SymmetricSites sites = orbits_of(group, points);
    std::vector<int> freedom;
    for (const SiteOrbit& orbit : sites.orbits) freedom.push_back(orbit.freedom);
    EXPECT_EQ(freedom, (std::vector{2, 1, 0, 1}));
    EXPECT_EQ(sites.sites.n_sites(), 4 + 2 + 1 + 2);
    EXPECT_EQ(sites.sites.position(sites.orbits[3].representative).y(), 0);
    expect_symmetric(sites, sites.sites);
}

TEST(SymmetricSites, ReadBackFromAllTheirRepresentatives) {
    for (const PlaneGroupRow& row : kPlaneGroups) {
        const PlaneGroup group(row.name, fitting_lattice(row.name));
        const SymmetricSites sites = random_sites(group, full_plan(special_positions(group), 3), 5);
        // The last site of each orbit instead of the first.
        Points points(2, std::ssize(sites.orbits));
        for (SiteId s = 0; s < sites.sites.n_sites(); ++s) {
            points.col(sites.orbit[s]) = sites.sites.position(s);
        }
        const SymmetricSites again = orbits_of(group, points);
        ASSERT_EQ(again.orbits.size(), sites.orbits.size()) << row.word;
        for (std::size_t k = 0; k < sites.orbits.size(); ++k) {
            EXPECT_EQ(again.orbits[k].freedom, sites.orbits[k].freedom) << row.word;
            EXPECT_EQ(again.orbits[k].n_sites, sites.orbits[k].n_sites) << row.word;
        }
    }
}

TEST(SymmetricSites, OfOneOrbitTwiceAreRefused) {
    const PlaneGroup group(PlaneGroupName::kPm, Lattice::rectangle(1, 1));
    Points points(2, 2);
    points << 0.25, 0.25, 0.125, 0.875;
    EXPECT_THROW(orbits_of(group, points), DuplicateSites);
}

TEST(SymmetricSites, NumberedByColumnsAreTheSameOrbits) {
    const PlaneGroup group(PlaneGroupName::kP6m, fitting_lattice(PlaneGroupName::kP6m));
    const SymmetricSites sites = random_sites(group, full_plan(special_positions(group), 9), 1);
    const SymmetricSites sorted = numbered_by_columns(sites);
    expect_symmetric(sorted, sorted.sites);
    for (SiteId s = 0; s < sorted.sites.n_sites(); ++s) {
        const SiteOrbit& orbit = sorted.orbits[sorted.orbit[s]];
        EXPECT_EQ(sorted.ties[s].representative, orbit.representative);
        EXPECT_EQ(sorted.orbit[orbit.representative], sorted.orbit[s]);
    }
}

TEST(SymmetricSites, NeedAPlanThatFits) {
    const PlaneGroup group(PlaneGroupName::kPm, Lattice::rectangle(1, 1));
    EXPECT_THROW(random_sites(group, {1, {}, {}}, 0), InvalidInput);
    EXPECT_THROW(random_sites(group, {0, {0, 0}, {}}, 0), InvalidInput);
    EXPECT_THROW(random_sites(group, {1 << 28, {0, 0}, {}}, 0), InvalidInput);
}

}  // namespace
}  // namespace pcvt::plane
