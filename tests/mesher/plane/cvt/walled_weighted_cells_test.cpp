#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "mesher/cells/empty_cells.hpp"
#include "mesher/cells/target_areas.hpp"
#include "mesher/plane/cvt/cell_areas.hpp"
#include "mesher/plane/cvt/walled_area_cvt.hpp"
#include "mesher/plane/cvt/weighted_cells.hpp"
#include "mesher/plane/mesh/cell_measures.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/mesh/walled_mesh.hpp"
#include "mesher/plane/symmetry/walled_sites.hpp"
#include "tests/support/cvt_options.hpp"
#include "tests/support/hidden_sites.hpp"

namespace pcvt::plane {
namespace {

using ::testing::ElementsAre;
using testing::kAllWalls;

/// Sites between walls with weights, length^2.
struct WeightedChannel {
    Lattice lattice = Lattice::rectangle(1, 1);
    Walls walls = Walls::kY;
    Points points;
    Eigen::VectorXd weights;
};

WalledCvt computed(const WeightedChannel& input) {
    return walled_weighted_cells(input.lattice, input.walls, input.points, input.weights, {});
}

/// The areas of the cells between the walls.
Eigen::VectorXd areas_between_walls(const PeriodicDelaunay& torus, const WalledDomain& domain) {
    const auto areas = cell_table(part_between_walls(cell_mesh(torus), domain)).measure;
    return Eigen::Map<const Eigen::VectorXd>(areas.data(), std::ssize(areas));
}

/// The sites between walls that the diagram of all sites and mirror images lacks.
std::vector<SiteId> lacking_between_walls(const WeightedChannel& input) {
    const SymmetricSites start = walled_sites(input.lattice, input.walls, input.points);
    Eigen::VectorXd weights(start.sites.n_sites());
    for (SiteId s = 0; s < weights.size(); ++s) weights[s] = input.weights[start.orbit[s]];
    std::vector<SiteId> lacking;
    for (const SiteId s : testing::lacking_sites(start.sites, weights)) {
        if (s < input.points.cols()) lacking.push_back(s);
    }
    return lacking;
}

/// Requires the cells that are computed from scratch, or the sites that have none.
/// @returns the number of sites without cells.
std::size_t compare_with_copies(const WeightedChannel& input) {
    const std::vector<SiteId> lacking = lacking_between_walls(input);
    try {
        const WalledCvt cvt = computed(input);
        EXPECT_THAT(lacking, ElementsAre());
        const Eigen::VectorXd wanted =
            power_cell_areas(input.lattice, input.walls, input.points, input.weights).area;
        const Eigen::VectorXd areas = areas_between_walls(cvt.torus.delaunay, cvt.domain);
        EXPECT_EQ(areas.size(), wanted.size());
        EXPECT_LE((areas - wanted).cwiseAbs().maxCoeff(), 1e-8 * input.lattice.area());
    } catch (const EmptyCells& error) {
        EXPECT_EQ(error.sites(), lacking);
    }
    return lacking.size();
}

// Law 3 between walls; the areas are those of cells that are computed from scratch.
TEST(WalledWeightedCells, SlowTheyEndAtTheWallsOrAreNamed) {
    std::mt19937_64 random(5);
    int n_visible = 0;
    int n_hidden = 0;
    int n_several = 0;
    for (int k = 0; k < 600; ++k) {
        SCOPED_TRACE("input " + std::to_string(k));
        WeightedChannel input{.walls = kAllWalls[std::size_t(k) % 3], .points = {}, .weights = {}};
        input.lattice = Lattice::rectangle(1, std::array{1.0, 0.1, 20.0}[std::size_t(k / 3) % 3]);
        const int n = 1 + k % 12;
        input.points = uniform_points(input.lattice, n, random());
        const double size = 0.1 * double(1 + random() % 16);
        input.weights = testing::drawn_weights(input.lattice, n, size, random);
        const std::size_t lacking = compare_with_copies(input);
        n_visible += lacking == 0;
        n_hidden += lacking > 0;
        n_several += lacking > 1;
        if (HasFailure()) return;
    }
    EXPECT_GT(n_visible, 100);
    EXPECT_GT(n_hidden, 100);
    EXPECT_GT(n_several, 20);
}

TEST(WalledWeightedCells, WeightsOfARunWithAreasGiveItsCellsAgain) {
    const Lattice lattice = Lattice::rectangle(2, 1);
    for (const Walls walls : kAllWalls) {
        SCOPED_TRACE(walls_row(walls).word);
        const Eigen::VectorXd areas =
            scaled_areas(draw_areas(parse_area_law("gamma:0.3"), 50, 5), 50, lattice.area());
        const WalledAreaCvt run = compute_walled_area_cvt(
            lattice, walls, WallCells::kWhole, uniform_points(lattice, 50, 2),
            {.areas = areas, .run = {.max_iterations = 3}});
        const Points points = points_between_walls(run.torus.delaunay, run.domain);
        const WalledCvt again =
            computed({lattice, walls, points, run.torus.delaunay.weights().head(50)});
        const Eigen::VectorXd before = areas_between_walls(run.torus.delaunay, run.domain);
        const Eigen::VectorXd after = areas_between_walls(again.torus.delaunay, again.domain);
        EXPECT_LE((after - before).cwiseAbs().maxCoeff(), 1e-12);
        EXPECT_LE((after - areas).cwiseAbs().maxCoeff(), 1e-10);
        EXPECT_NEAR(again.torus.run.energy, run.torus.run.energy, 1e-12);
    }
}

TEST(WalledWeightedCells, AHiddenSiteIsNamedOnceForAllItsImages) {
    for (const Walls walls : kAllWalls) {
        WeightedChannel input{.walls = walls, .points = Points(2, 3), .weights = {}};
        input.points << 0.5, 0.6, 0.4, 0.5, 0.5, 0.5;
        input.weights = Eigen::Vector3d(0.2, 0, 0);
        EXPECT_EQ(compare_with_copies(input), 2u);
    }
}

TEST(WalledWeightedCells, WeightsAreFiniteAndOneASite) {
    WeightedChannel input{.points = uniform_points(Lattice::rectangle(1, 1), 3, 1),
                          .weights = Eigen::VectorXd::Zero(6)};
    EXPECT_THROW(computed(input), InvalidInput);
    for (const double wrong :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        input.weights = Eigen::Vector3d(0, wrong, 0);
        EXPECT_THROW(computed(input), InvalidInput);
    }
    input.weights = Eigen::Vector3d::Zero();
    input.points(1, 2) = 1.5;
    EXPECT_THROW(computed(input), InvalidInput);
}

}  // namespace
}  // namespace pcvt::plane
