#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/bytes/bad_file.hpp"
#include "io/voxels/vti_reader.hpp"
#include "io/voxels/vti_writer.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;

struct SpaceExample {
    space::VoxelImage image;
    space::VoxelCells cells;
};

/// Equal weights leave the cells as they are.
SpaceExample space_example(int n, VoxelCounts counts, double weight = 0) {
    const space::Lattice lattice = space::Lattice::box(3, 1, 2);
    const auto delaunay =
        space::periodic_delaunay(space::Sites(lattice, uniform_points(lattice, n, 2)));
    space::VoxelCells cells{.lattice = lattice, .sites = delaunay.sites.positions()};
    if (weight != 0) cells.weights = Eigen::VectorXd::Constant(n, weight);
    const space::VoxelGrid grid = voxel_grid(lattice, {0.1, -7, 50}, counts);
    return {voxel_image(delaunay, {}, grid, 1), cells};
}

TEST(SpaceVti, IsReadBack) {
    // The last image has several blocks.
    for (const VoxelCounts counts : {VoxelCounts{2, 2, 2}, {7, 5, 3}, {90, 60, 40}}) {
        for (const double weight : {0.0, 0.25}) {
            const SpaceExample e = space_example(30, counts, weight);
            const auto files = encode_space_vti(e.image, e.cells, {}, {}, "dir.x/t.vti");
            ASSERT_EQ(files.size(), 2U);
            EXPECT_EQ(files[1].path, "dir.x/t.material.yaml");
            const VoxelFile file = decode_vti(files);
            ASSERT_TRUE(file.space.has_value());
            EXPECT_TRUE(file.image.site.empty());
            EXPECT_EQ(file.space->image.site, e.image.site);
            EXPECT_EQ(file.space->image.grid.counts, counts);
            EXPECT_EQ(file.space->image.grid.corner, e.image.grid.corner);
            EXPECT_EQ(file.space->image.grid.spacing(), e.image.grid.spacing());
            const space::VoxelCells& cells = file.space->cells.value();
            EXPECT_EQ(cells.sites, e.cells.sites);
            EXPECT_EQ(cells.weights, e.cells.weights);
            EXPECT_EQ(cells.lattice.periods(), e.cells.lattice.periods());
            EXPECT_EQ(file.materials.value().size(), 30U);
            EXPECT_LT(prove_voxel_file(files, file).largest_excess, 1e-12);
        }
    }
}

/// One site has equal layers, which are layers of space all the same.
TEST(SpaceVti, EqualLayersOfSpaceAreReadBack) {
    const SpaceExample e = space_example(1, {4, 3, 5});
    const auto files = encode_space_vti(e.image, e.cells, {}, {}, "t.vti");
    const VoxelFile file = decode_vti(files);
    ASSERT_TRUE(file.space.has_value());
    EXPECT_EQ(file.space->image.site, std::vector<SiteId>(60, 0));
    EXPECT_EQ(prove_voxel_file(files, file).n_cells, 1);
}

std::vector<EncodedFile> without_sites(std::vector<EncodedFile> files) {
    std::string& bytes = files[0].bytes;
    const std::size_t begin = bytes.find("<FieldData>");
    bytes.erase(begin, bytes.find("<Piece") - begin);
    return files;
}

TEST(SpaceVti, LayersThatDifferAreSpaceWithoutSites) {
    const SpaceExample e = space_example(9, {8, 4, 6});
    const auto files = without_sites(encode_space_vti(e.image, e.cells, {}, {}, "t.vti"));
    const VoxelFile file = decode_vti(files);
    ASSERT_TRUE(file.space.has_value());
    EXPECT_FALSE(file.space->cells.has_value());
    EXPECT_EQ(file.space->image.site, e.image.site);
    EXPECT_EQ(prove_voxel_file(files, file).n_cells, 9);
}

std::string space_refusal(const std::vector<EncodedFile>& files) {
    try {
        prove_voxel_file(files, decode_vti(files));
    } catch (const InvalidInput& fault) {
        return fault.what();
    }
    return "";
}

TEST(SpaceVti, DamageIsRefused) {
    const SpaceExample e = space_example(5, {6, 4, 8}, 0.5);
    const auto good = encode_space_vti(e.image, e.cells, {}, {}, "t.vti");
    EXPECT_EQ(space_refusal(good), "");
    const auto changed = [&](const std::string& from, const std::string& to) {
        auto files = good;
        const std::size_t at = files[0].bytes.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        files[0].bytes.replace(at, from.size(), to);
        return space_refusal(files);
    };
    EXPECT_THAT(changed("0.25 0.25\" Direction", "0.25 0.26\" Direction"), HasSubstr("periods"));
    EXPECT_THAT(changed("0.25 0.25\" Direction", "0.25 -0.25\" Direction"),
                HasSubstr("t.vti:4: the layer has no thickness"));
    EXPECT_THAT(changed("0.25 0.25\" Direction", "0.25 1e70\" Direction"),
                HasSubstr("t.vti:4: the spacing"));
    EXPECT_THAT(changed("-7 50\" Spacing", "-7 50.9\" Spacing"), HasSubstr("its centre lies in"));
    EXPECT_THAT(changed("\"SitePositions\" NumberOfTuples=\"5\" NumberOfComponents=\"3\"",
                        "\"SitePositions\" NumberOfTuples=\"5\" NumberOfComponents=\"2\""),
                HasSubstr("t.vti:11: the array SitePositions has not as many numbers"));
    EXPECT_THAT(changed("NumberOfTuples=\"3\" NumberOfComponents=\"3\" format=\"ascii\">\n3 0 0",
                        "NumberOfTuples=\"2\" NumberOfComponents=\"2\" format=\"ascii\">\n3 0 0 1"),
                HasSubstr("t.vti:6: the array PeriodicLattice has not as many numbers"));
    EXPECT_THAT(
        changed(
            "NumberOfTuples=\"3\" NumberOfComponents=\"3\" format=\"ascii\">\n3 0 0\n0 1 0\n0 0 2",
            "NumberOfTuples=\"2\" NumberOfComponents=\"3\" format=\"ascii\">\n3 0 0\n0 1 0"),
        HasSubstr("t.vti:6: the lattice has not three vectors"));
    EXPECT_THAT(
        changed(
            "NumberOfTuples=\"3\" NumberOfComponents=\"3\" format=\"ascii\">\n3 0 0\n0 1 0\n0 0 2",
            "NumberOfTuples=\"2\" NumberOfComponents=\"2\" format=\"ascii\">\n3 0\n0 1"),
        HasSubstr("t.vti:6: the lattice and the sites have not equally many"));
    EXPECT_THAT(changed("\n3 0 0\n", "\n0 1 0\n"), HasSubstr("t.vti:11: "));
    EXPECT_THAT(changed("\"SiteWeights\" NumberOfTuples=\"5\" NumberOfComponents=\"1\" "
                        "format=\"ascii\">\n0.5\n",
                        "\"SiteWeights\" NumberOfTuples=\"4\" NumberOfComponents=\"1\" "
                        "format=\"ascii\">\n"),
                HasSubstr("there is not one weight a site"));
    EXPECT_THAT(changed("Name=\"SiteWeights\" NumberOfTuples=\"5\" NumberOfComponents=\"1\"",
                        "Name=\"SiteWeights\" NumberOfTuples=\"5\" NumberOfComponents=\"3\""),
                HasSubstr("has not the type, format or size"));
    EXPECT_THAT(changed("</FieldData>",
                        "<DataArray type=\"Float64\" Name=\"Metric\" NumberOfTuples=\"1\" "
                        "NumberOfComponents=\"2\" format=\"ascii\">2 30</DataArray></FieldData>"),
                HasSubstr("the metric has not a ratio and an axis"));
    auto files = good;
    files[1].bytes.erase(files[1].bytes.rfind("  - homogenization"));
    EXPECT_THAT(space_refusal(files), HasSubstr("t.material.yaml: has 4 materials"));
}

TEST(SpaceVti, EveryChangedDigitOfTheVoxelsIsFound) {
    const SpaceExample e = space_example(5, {6, 4, 3});
    const auto good = encode_space_vti(e.image, e.cells, {}, {}, "t.vti");
    const std::size_t begin = good[0].bytes.find("binary\">\n") + 9;
    const std::size_t end = good[0].bytes.find('\n', begin);
    for (std::size_t at = begin; at < end; ++at) {
        auto files = good;
        char& digit = files[0].bytes[at];
        digit = digit == 'A' ? 'B' : 'A';
        std::vector<SiteId> found = e.image.site;
        try {
            found = decode_vti(files).space->image.site;
            prove_voxel_file(files, decode_vti(files));
        } catch (const InvalidInput&) {
            continue;
        }
        // Bits of the padding belong to no byte.
        EXPECT_EQ(found, e.image.site) << at;
    }
}

}  // namespace
}  // namespace pcvt
