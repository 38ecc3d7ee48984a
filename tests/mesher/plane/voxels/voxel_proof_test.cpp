#include "mesher/plane/voxels/voxel_proof.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "mesher/cells/target_areas.hpp"
#include "mesher/plane/cvt/area_cvt.hpp"
#include "mesher/plane/proof/validate.hpp"

namespace pcvt::plane {
namespace {

using ::testing::HasSubstr;

struct Example {
    VoxelImage image;
    VoxelCells cells;
};

Example example(const Metric& metric, VoxelCounts counts) {
    const Lattice lattice = Lattice::rectangle(2, 1);
    const Lattice round = metric.to_round(lattice);
    const Eigen::VectorXd areas =
        scaled_areas(draw_areas(parse_area_law("lognormal:0.5"), 40, 1), 40, lattice.area());
    const auto result = compute_area_cvt(round, uniform_points(round, 40, 2), {.areas = areas});
    VoxelCells cells{.lattice = lattice,
                     .sites = Points(2, 40),
                     .weights = result.delaunay.weights(),
                     .metric = metric};
    for (SiteId s = 0; s < 40; ++s) {
        cells.sites.col(s) = metric.from_round(result.delaunay.sites().position(s));
    }
    return {voxel_image(result.delaunay, metric, voxel_grid(lattice, {5, 0.25}, counts), 1), cells};
}

std::string proof_refusal(const Example& example) {
    try {
        prove_voxels(example.image, example.cells);
    } catch (const NotATile& fault) {
        return fault.what();
    }
    return "";
}

TEST(VoxelProof, HoldsForImages) {
    for (const double ratio : {1.0, 3.0}) {
        const Example good = example(Metric(ratio, 20), {200, 100});
        const VoxelProof proof = prove_voxels(good.image, good.cells);
        EXPECT_EQ(proof.n_cells, 40);
        EXPECT_TRUE(proof.unseen.empty());
        EXPECT_LT(proof.largest_excess, 1e-12);
    }
}

TEST(VoxelProof, HoldsForCloseSitesFarFromTheOrigin) {
    const Lattice lattice = Lattice::rectangle(2, 1);
    Points points = uniform_points(lattice, 40, 2);
    points.col(1) = points.col(0) + Vec2(5e-10, 0);
    // The line between the cells of the first two lies far from both sites.
    const Eigen::VectorXd areas =
        scaled_areas(draw_areas(parse_area_law("lognormal:0.5"), 40, 1), 40, lattice.area());
    const auto result = compute_area_cvt(lattice, points, {.areas = areas});
    // In the second case the two sites are one after rounding.
    for (const Vec2& far : {Vec2(1e5, 0), Vec2(1e7, 0)}) {
        VoxelCells cells{
            .lattice = lattice, .sites = Points(2, 40), .weights = result.delaunay.weights()};
        for (SiteId s = 0; s < 40; ++s) {
            cells.sites.col(s) = result.delaunay.sites().position(s) + far;
        }
        const VoxelGrid grid = voxel_grid(lattice, far, {400, 200});
        VoxelImage image = voxel_image(result.delaunay, {}, grid, 1);
        EXPECT_NO_THROW(prove_voxels(image, cells));
        // Other lines are as exact as ever.
        const auto voxel =
            std::find_if(image.site.begin() + 1, image.site.end(), [](SiteId s) { return s > 1; });
        *voxel = *voxel == 2 ? 3 : 2;
        EXPECT_NE(proof_refusal({image, cells}), "");
    }
}

TEST(VoxelProof, NamesTheVoxelThatIsNotOfItsCell) {
    Example bad = example(Metric(3, 20), {200, 100});
    const SiteId here = bad.image.site[1234];
    bad.image.site[1234] = (here + 20) % 40;
    EXPECT_EQ(proof_refusal(bad), "voxel 34,6 names cell " + std::to_string((here + 20) % 40) +
                                      ", but its centre lies in cell " + std::to_string(here));
}

TEST(VoxelProof, RefusesIdsThatNoCellHas) {
    for (const int id : {-1, 40}) {
        Example bad = example({}, {20, 10});
        bad.image.site.back() = id;
        EXPECT_THAT(proof_refusal(bad), HasSubstr("voxel 19,9 names cell " + std::to_string(id)));
    }
}

TEST(VoxelProof, NeedsTheWeightsTheMetricAndThePeriods) {
    const Example good = example(Metric(3, 20), {200, 100});
    Example bad = good;
    bad.cells.weights.setZero();
    EXPECT_NE(proof_refusal(bad), "");
    bad = good;
    bad.cells.metric = Metric(3, -20);
    EXPECT_NE(proof_refusal(bad), "");
    bad = good;
    bad.image.grid.corner.x() += 0.1;
    EXPECT_NE(proof_refusal(bad), "");
    bad = good;
    bad.image.grid.size.x() = 1;
    EXPECT_THAT(proof_refusal(bad), HasSubstr("periods"));
}

TEST(VoxelProof, NamesTheCellsThatAreSmallerThanAVoxel) {
    const Example coarse = example({}, {4, 4});
    const VoxelProof proof = prove_voxels(coarse.image, coarse.cells);
    EXPECT_GE(proof.unseen.size(), 24U);
    for (const SiteId s : proof.unseen)
        EXPECT_THAT(coarse.image.site, ::testing::Not(::testing::Contains(s)));
}

}  // namespace
}  // namespace pcvt::plane
