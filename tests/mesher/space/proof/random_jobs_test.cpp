#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "mesher/space/delaunay/mirror_diagram.hpp"
#include "mesher/space/energy/energy_pass.hpp"
#include "tests/support/exact_delaunay.hpp"
#include "tests/support/random_space_sites.hpp"
#include "tests/support/space_laws.hpp"
#include "tests/support/space_moves.hpp"

namespace pcvt::space {
namespace {

/// The largest number of sites for which a build is compared with full copies, and for which
/// integers prove it.
constexpr int kMostCopied = 9;
constexpr int kMostProved = 40;

/// PCVT_SPACE_JOBS=N runs N jobs, PCVT_SPACE_SEED=S others.
std::uint64_t setting(const char* name, std::uint64_t usual) {
    const char* const text = std::getenv(name);
    return text != nullptr ? std::strtoull(text, nullptr, 10) : usual;
}

Energy energy_in_frame(const PeriodicDelaunay& delaunay, const Frame& frame) {
    Workers workers(1);
    Energy energy;
    EnergySums().run(delaunay.tetrahedra, delaunay.sites.coordinates(), frame, workers, energy);
    return energy;
}

/// The lengths of the shortest edge at each site, in the frame.
std::vector<double> nearest_distances(const PeriodicDelaunay& delaunay, const Frame& frame) {
    std::vector<double> nearest(std::size_t(delaunay.sites.n_sites()),
                                std::numeric_limits<double>::infinity());
    const Points& coordinates = delaunay.sites.coordinates();
    for (int t = 0; t < delaunay.tetrahedra.n_tetrahedra(); ++t) {
        const Tetrahedron corners = delaunay.tetrahedra.tetrahedron(t);
        for (const Corner& one : corners) {
            for (const Corner& other : corners) {
                if (one == other) continue;
                const Vec3 edge = image(coordinates, other).at - image(coordinates, one).at;
                nearest[one.site] = std::min(nearest[one.site], frame.to_position(edge).norm());
            }
        }
    }
    return nearest;
}

/// @param closest  the shortest edge over h: the direction of a face between two sites this close,
///                 which is rounded relative to h, is known up to 2^-53 / closest.
void expect_equal_energies(const Energy& energy, const Energy& fresh, const Frame& frame,
                           double closest) {
    EXPECT_NEAR(energy.value / fresh.value, 1, 1e-12);
    EXPECT_NEAR(energy.mass.sum() / frame.volume(), 1, 1e-12);
    const double relative = 1e-11 / std::min(closest, 1.0);
    EXPECT_GT(energy.mass.minCoeff(), -relative * frame.volume());
    const double length = std::sqrt(fresh.value / frame.volume());
    EXPECT_LT((energy.gradient - fresh.gradient).cwiseAbs().maxCoeff(),
              relative * frame.volume() * length);
}

/// Expects that the triangulation is the periodic Delaunay triangulation of its sites, and that of
/// a new build.
void expect_delaunay_of_a_new_build(const PeriodicDelaunay& moved, const PeriodicDelaunay& fresh) {
    EXPECT_EQ(testing::canonical_tetrahedra(moved.tetrahedra),
              testing::canonical_tetrahedra(fresh.tetrahedra));
    const Points& coordinates = moved.sites.coordinates();
    testing::expect_torus(moved.tetrahedra, coordinates);
    if (moved.sites.n_sites() > kMostProved) return;
    EXPECT_EQ(testing::delaunay_fault(moved.tetrahedra, coordinates,
                                      gram_of(moved.sites.reduction().reduced)),
              "");
}

void expect_equal_to_full_copies(const PeriodicDelaunay& delaunay) {
    const int n = delaunay.sites.n_sites();
    if (n > kMostCopied) return;
    const TorusTetrahedra copies(n, full_copies_diagram(delaunay.sites).tetrahedra);
    EXPECT_EQ(testing::canonical_tetrahedra(delaunay.tetrahedra),
              testing::canonical_tetrahedra(copies));
}

/// Compares the derivatives for one site with differences of new builds.
/// Steps are proportional to the distance of the nearest site, since the third derivative of F
/// grows with its inverse.
void expect_gradient_of_differences(const PeriodicDelaunay& delaunay, const Energy& energy,
                                    const Frame& frame, SiteId site) {
    const Sites& sites = delaunay.sites;
    const double nearest = nearest_distances(delaunay, frame)[site];
    const double length = std::sqrt(energy.value / frame.volume());
    // Closer to another site, differences of F that show in its digits are too long.
    if (nearest < 1e-3 * length) return;
    const double step = 1e-4 * nearest;
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 move = snapped_displacement(frame.to_lattice(step * Vec3::Unit(axis)));
        const auto value = [&](double sign) {
            Points u = sites.coordinates();
            u.col(site) += sign * move;
            return energy_in_frame(periodic_delaunay({sites.lattice(), sites.reduction(), u}),
                                   frame)
                .value;
        };
        const double derivative =
            energy.gradient.segment<3>(MovingTetrahedra::kNumbersPerSite * site)
                .dot(frame.to_position(move));
        EXPECT_NEAR(derivative, (value(1) - value(-1)) / 2, 1e-6 * frame.volume() * length * step);
    }
}

/// The energy of moving sites with the sites numbered as they were given.
Energy in_given_numbering(const MovingTetrahedra& moving, const Energy& energy) {
    Energy given = energy;
    for (SiteId s = 0; s < moving.n_sites(); ++s) {
        const SiteId number = moving.original_id(s);
        given.gradient.segment<3>(MovingTetrahedra::kNumbersPerSite * number) =
            energy.gradient.segment<3>(MovingTetrahedra::kNumbersPerSite * s);
        given.mass[number] = energy.mass[s];
    }
    return given;
}

/// Expects that a triangulation which has moved, and its energy, equal those of a new build.
/// @returns the new build.
PeriodicDelaunay expect_equal_to_a_new_build(const MovingTetrahedra& moving, const Energy& energy) {
    MovingTetrahedra copy = moving;
    const PeriodicDelaunay moved = copy.release();
    PeriodicDelaunay fresh = periodic_delaunay(moved.sites);
    expect_delaunay_of_a_new_build(moved, fresh);
    const std::vector<double> nearest = nearest_distances(fresh, moving.frame());
    const double closest = *std::min_element(nearest.begin(), nearest.end()) / moving.spacing();
    expect_equal_energies(in_given_numbering(moving, energy),
                          energy_in_frame(fresh, moving.frame()), moving.frame(), closest);
    return fresh;
}

/// One job: a build, and its triangulation through jumps.
void run_job(std::mt19937_64& random) {
    const auto [name, sites] = testing::random_space_sites(random);
    SCOPED_TRACE(name);
    MovingTetrahedra moving(sites);
    Workers workers(1);
    EnergyPass pass(moving, workers);
    Energy energy;
    ASSERT_TRUE(pass.evaluate(energy));
    expect_equal_to_full_copies(expect_equal_to_a_new_build(moving, energy));
    std::string moves;
    for (int jump = 0; jump < 4; ++jump) {
        const auto move = testing::random_space_move(moving, energy, random);
        moves += " " + move.name + ";";
        SCOPED_TRACE(moves);
        if (!moving.step(move.direction, 1, workers)) continue;
        const bool evaluated = pass.evaluate(energy);
        // Two sites may have met.
        EXPECT_TRUE(evaluated || move.name == "meeting" || move.name == "to a grid");
        if (evaluated && random() % 4 != 0) {
            moving.settle();
        } else {
            moving.step_back();
            ASSERT_TRUE(pass.evaluate(energy));
        }
        const PeriodicDelaunay fresh = expect_equal_to_a_new_build(moving, energy);
        if (jump < 3) continue;
        const auto site = SiteId(random() % std::uint64_t(sites.n_sites()));
        const Frame& frame = moving.frame();
        expect_gradient_of_differences(fresh, energy_in_frame(fresh, frame), frame, site);
    }
}

TEST(RandomSpaceJobs, SlowEqualNewBuildsThatIntegersProve) {
    const std::uint64_t n_jobs = setting("PCVT_SPACE_JOBS", 16);
    const std::uint64_t seed = setting("PCVT_SPACE_SEED", 1);
    for (std::uint64_t job = 0; job < n_jobs; ++job) {
        SCOPED_TRACE("job " + std::to_string(job));
        std::seed_seq words{seed, job};
        std::mt19937_64 random(words);
        run_job(random);
    }
}

}  // namespace
}  // namespace pcvt::space
