#include "mesher/plane/cvt/weighted_cells.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "mesher/cells/empty_cells.hpp"
#include "mesher/cells/target_areas.hpp"
#include "mesher/plane/cvt/area_cvt.hpp"
#include "mesher/plane/mesh/cell_measures.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/power/power_mirrors.hpp"
#include "mesher/plane/proof/generated_tile.hpp"
#include "mesher/plane/tile/build_tile.hpp"
#include "tests/support/clipped_power_cells.hpp"
#include "tests/support/hidden_sites.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/special_sites.hpp"

namespace pcvt::plane {
namespace {

using testing::drawn_weights;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::lacking_sites;
using testing::lattices;
using testing::random_lattice;

/// Sites with weights, length^2.
struct WeightedSites {
    Lattice lattice = Lattice::rectangle(1, 1);
    Points points;
    Eigen::VectorXd weights;
};

/// Random sites, of which every third input has some on the seam.
WeightedSites random_weighted_sites(int k, std::mt19937_64& random) {
    const auto named = lattices();
    const Lattice lattice =
        k % 2 == 0 ? random_lattice(random) : named[std::size_t(k / 2) % named.size()].lattice;
    const int n = k % 10 == 9 ? 20 + k % 60 : 1 + k % 8;
    Points points = uniform_points(lattice, n, random());
    for (int s = 0; s < n && k % 3 == 0; s += 2) {
        Vec2 u = lattice.to_lattice(points.col(s));
        u[s / 2 % 2] = double(random() % 3) - 1;
        points.col(s) = lattice.to_position(u);
    }
    return {lattice, points, drawn_weights(lattice, n, 0.1 * double(1 + random() % 12), random)};
}

std::vector<SiteId> empty_cells(const WeightedSites& input) {
    try {
        weighted_cells(input.lattice, input.points, input.weights, {});
    } catch (const EmptyCells& error) {
        return error.sites();
    }
    return {};
}

std::string weighted_fault(const WeightedSites& input) {
    try {
        weighted_cells(input.lattice, input.points, input.weights, {});
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "";
}

Eigen::VectorXd measured(const PeriodicDelaunay& delaunay) {
    const std::vector<double> areas = cell_table(cell_mesh(delaunay)).measure;
    return Eigen::Map<const Eigen::VectorXd>(areas.data(), std::ssize(areas));
}

double largest_difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return (a - b).cwiseAbs().maxCoeff();
}

std::vector<std::array<SiteId, 3>> corners_of(const TorusTriangulation& t) {
    std::vector<std::array<SiteId, 3>> corners;
    for (int h = 0; h < t.n_halfedges(); h += 3) {
        std::array<SiteId, 3> sites{t.corner(h).site, t.corner(h + 1).site, t.corner(h + 2).site};
        std::sort(sites.begin(), sites.end());
        corners.push_back(sites);
    }
    std::sort(corners.begin(), corners.end());
    return corners;
}

// Law 1, also where sites are cocircular, on the seam or on one line.
TEST(WeightedCells, AreTheVoronoiCellsWhereWeightsAreEqual) {
    for (const auto& [name, sites] : testing::special_sites()) {
        const Lattice& lattice = sites.lattice();
        Points points(2, sites.n_sites());
        for (SiteId s = 0; s < sites.n_sites(); ++s) points.col(s) = sites.position(s);
        const PeriodicDelaunay voronoi(sites);
        const Eigen::VectorXd areas = measured(voronoi);
        for (const double w : {0.0, -1.0 / 3, 1e3}) {
            SCOPED_TRACE(name);
            const Eigen::VectorXd weights = Eigen::VectorXd::Constant(sites.n_sites(), w);
            const CvtResult result = weighted_cells(lattice, points, weights, {});
            EXPECT_EQ(corners_of(result.delaunay.triangulation()),
                      corners_of(voronoi.triangulation()));
            EXPECT_LE(largest_difference(measured(result.delaunay), areas), 1e-13 * lattice.area());
            EXPECT_EQ(result.run.iterations, 0);
            EXPECT_EQ(result.delaunay.weights(), weights);
        }
    }
}

// Laws 2 and 3; the cells that come about are those of half-planes.
TEST(WeightedCells, SlowRandomInputsGiveTheCellsOfHalfPlanesOrNameTheHiddenSites) {
    std::mt19937_64 random(1);
    int n_visible = 0;
    int n_several = 0;
    for (int k = 0; k < 1500; ++k) {
        SCOPED_TRACE("input " + std::to_string(k));
        const WeightedSites input = random_weighted_sites(k, random);
        const Sites sites(input.lattice, input.points);
        if (sites.duplicates().first >= 0) continue;
        const std::vector<SiteId> lacking = lacking_sites(sites, input.weights);
        ASSERT_EQ(lacking_sites(sites, input.weights, power_mirrors), lacking);
        ASSERT_LT(lacking.size(), 20u);
        ASSERT_EQ(empty_cells(input), lacking);
        n_several += lacking.size() > 1;
        if (!lacking.empty()) continue;
        ++n_visible;
        const CvtResult result = weighted_cells(input.lattice, input.points, input.weights, {});
        const Eigen::VectorXd areas = measured(result.delaunay);
        const auto clipped = testing::clipped_power_cells(sites, input.weights);
        double energy = 0;
        for (SiteId s = 0; s < sites.n_sites(); ++s) {
            const testing::PolygonMoments moments = testing::polygon_moments(clipped[s]);
            energy += moments.second;
            ASSERT_NEAR(areas[s], moments.area, 1e-8 * input.lattice.area());
        }
        ASSERT_NEAR(result.run.energy, energy, 1e-10 * energy);
        const double heavier = 0.75 * input.lattice.area();
        const CvtResult same = weighted_cells(input.lattice, input.points,
                                              (input.weights.array() + heavier).matrix(), {});
        ASSERT_LE(largest_difference(measured(same.delaunay), areas), 1e-9 * input.lattice.area());
        ASSERT_NEAR(same.run.energy, result.run.energy, 1e-10 * energy);
    }
    EXPECT_GT(n_visible, 500);
    EXPECT_GT(n_several, 100);
}

// Law 2 to the last bit: these sums have no rounding.
TEST(WeightedCells, AHugeNumberThatIsAddedToAllWeightsChangesNoBit) {
    std::mt19937_64 random(2);
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {1, 2, 3, 7, 60}) {
            SCOPED_TRACE(name + " n = " + std::to_string(n));
            WeightedSites input{lattice, uniform_points(lattice, n, random()), {}};
            // Whole multiples of 2^-20 of a power of two near to the mean area.
            const double unit = std::exp2(std::floor(std::log2(lattice.area() / n)) - 20);
            input.weights.resize(n);
            for (double& w : input.weights) w = unit * double(random() % (1U << 12));
            const CvtResult result = weighted_cells(lattice, input.points, input.weights, {});
            for (const double offset : {std::exp2(40) * unit, -std::exp2(51) * unit}) {
                const Eigen::VectorXd moved = (input.weights.array() + offset).matrix();
                const CvtResult same = weighted_cells(lattice, input.points, moved, {});
                EXPECT_EQ(same.delaunay.weights(), moved);
                EXPECT_EQ(corners_of(same.delaunay.triangulation()),
                          corners_of(result.delaunay.triangulation()));
                EXPECT_EQ(same.run.energy, result.run.energy);
                EXPECT_EQ(measured(same.delaunay), measured(result.delaunay));
            }
        }
    }
}

TEST(WeightedCells, OneSiteHasACellWithAnyWeight) {
    for (const auto& [name, lattice] : lattices()) {
        for (const double w : {-1e100, -1.0, 0.0, 1e-300, 1e6, 1e100}) {
            const WeightedSites input{lattice, Points::Constant(2, 1, 0.3),
                                      Eigen::VectorXd::Constant(1, w)};
            EXPECT_EQ(weighted_fault(input), "") << name << " " << w;
        }
    }
}

TEST(WeightedCells, HugeWeightsHideTheOthersOrAreRefused) {
    for (const auto& [name, lattice] : lattices()) {
        WeightedSites input{lattice, uniform_points(lattice, 4, 1), {}};
        for (const double w : {1e20, 1e100, 1e130}) {
            input.weights = Eigen::Vector4d(-w, w / 2, -1, 1);
            EXPECT_THAT(empty_cells(input), ElementsAre(0, 2, 3)) << name;
        }
        for (const double w : {1e170, 1e300, 1.7e308}) {
            input.weights = Eigen::Vector4d(-w, w / 2, -1, 1);
            EXPECT_EQ(weighted_fault(input),
                      "the weights are too large for the periods; scale them");
        }
    }
}

TEST(WeightedCells, AtMostTwentySitesWithoutCellsAreNamed) {
    // One heavy site hides all others, each of which only it hides.
    for (const int n : {20, 21, 60}) {
        WeightedSites input{Lattice::rectangle(1, 1),
                            uniform_points(Lattice::rectangle(1, 1), n, 7),
                            Eigen::VectorXd::Zero(n)};
        input.weights[3] = 10;
        const std::vector<SiteId> hidden = empty_cells(input);
        EXPECT_EQ(hidden.size(), std::size_t(std::min(20, n - 1)));
        EXPECT_TRUE(std::is_sorted(hidden.begin(), hidden.end()));
        EXPECT_EQ(std::count(hidden.begin(), hidden.end(), 3), 0);
        EXPECT_THAT(weighted_fault(input),
                    HasSubstr(n == 20 ? "the cells of 19 sites are empty, the first that of site 0,"
                                      : "the cells of 20 sites or more are empty, the first that "
                                        "of site "));
    }
}

TEST(WeightedCells, AHiddenSiteIsNamedInOneSentence) {
    WeightedSites input{Lattice::rectangle(1, 1), Points(2, 2), Eigen::VectorXd(2)};
    input.points << 0.5, 0.6, 0.5, 0.5;
    input.weights << 0.2, 0;
    EXPECT_THAT(empty_cells(input), ElementsAre(1));
    EXPECT_EQ(weighted_fault(input),
              "the cell of site 1 is empty, because its weight is too small beside those of the "
              "neighbours; leave such sites out, or give larger weights");
}

TEST(WeightedCells, WeightsAreFiniteAndOneASite) {
    WeightedSites input{Lattice::rectangle(1, 1), uniform_points(Lattice::rectangle(1, 1), 3, 1),
                        Eigen::VectorXd::Zero(2)};
    const std::string count = "there are 2 weights for 3 sites; give one for each site";
    EXPECT_EQ(weighted_fault(input), count);
    EXPECT_THROW(walled_weighted_cells(input.lattice, Walls::kY, input.points, input.weights, {}),
                 InvalidInput);
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), kInfinity, -kInfinity}) {
        input.weights = Eigen::Vector3d(0, wrong, 0);
        EXPECT_EQ(weighted_fault(input), "a weight is not finite; correct it");
    }
}

TEST(WeightedCells, WeightsOfARunWithAreasGiveItsCellsAgain) {
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {1, 2, 5, 8, 200}) {
            SCOPED_TRACE(name + " n = " + std::to_string(n));
            const Eigen::VectorXd areas =
                scaled_areas(draw_areas(parse_area_law("lognormal:0.42"), n, 5), n, lattice.area());
            const AreaCvtResult run =
                compute_area_cvt(lattice, uniform_points(lattice, n, 2),
                                 {.areas = areas, .run = {.max_iterations = 3}});
            Points points(2, n);
            for (SiteId s = 0; s < n; ++s) points.col(s) = run.delaunay.sites().position(s);
            const CvtResult again = weighted_cells(lattice, points, run.delaunay.weights(), {});
            const double tolerance = 1e-12 * lattice.area();
            EXPECT_LE(largest_difference(measured(again.delaunay), areas), 100 * tolerance);
            EXPECT_LE(largest_difference(measured(again.delaunay), measured(run.delaunay)),
                      tolerance);
            // That of the run is the energy of cells of exactly these areas.
            EXPECT_NEAR(again.run.energy, run.run.energy, 1e-10 * run.run.energy);
        }
    }
}

TEST(WeightedCells, EveryMeshIsATile) {
    std::mt19937_64 random(3);
    for (const auto& [name, lattice] : lattices()) {
        const CvtResult result = weighted_cells(lattice, uniform_points(lattice, 40, 3),
                                                drawn_weights(lattice, 40, 0.05, random), {});
        for (const MeshKind kind : {MeshKind::kVoronoi, MeshKind::kDelaunay, MeshKind::kGrains}) {
            SCOPED_TRACE(name);
            EXPECT_NO_THROW(
                verify_generated_tile(build_tile(result.delaunay, {.kind = kind}).tile));
        }
    }
}

TEST(WeightedCells, EveryBitIsTheSameForAnyNumberOfThreads) {
    std::mt19937_64 random(4);
    const Lattice lattice({1, 0}, {0.37, 0.81});
    const Points points = uniform_points(lattice, 20'000, 1);
    const Eigen::VectorXd weights = drawn_weights(lattice, 20'000, 0.001, random);
    const CvtResult one = weighted_cells(lattice, points, weights, {.n_threads = 1});
    for (const int n_threads : {2, 3}) {
        const CvtResult several =
            weighted_cells(lattice, points, weights, {.n_threads = n_threads});
        EXPECT_EQ(one.run.energy, several.run.energy);
        EXPECT_EQ(one.run.residual, several.run.residual);
        EXPECT_EQ(one.run.rms_residual, several.run.rms_residual);
        EXPECT_EQ(measured(one.delaunay), measured(several.delaunay));
    }
}

}  // namespace
}  // namespace pcvt::plane
