#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/bytes/bad_file.hpp"
#include "io/voxels/vti_reader.hpp"
#include "io/voxels/vti_writer.hpp"
#include "mesher/cells/target_areas.hpp"
#include "mesher/plane/cvt/area_cvt.hpp"
#include "mesher/plane/proof/validate.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;

struct Example {
    plane::VoxelImage image;
    plane::VoxelCells cells;
};

Example example(int n, plane::VoxelCounts counts) {
    const plane::Lattice lattice = plane::Lattice::rectangle(3, 1);
    const Eigen::VectorXd areas =
        scaled_areas(draw_areas(parse_area_law("lognormal:0.42"), n, 1), n, lattice.area());
    const auto result = compute_area_cvt(lattice, uniform_points(lattice, n, 2), {.areas = areas});
    plane::VoxelCells cells{
        .lattice = lattice, .sites = plane::Points(2, n), .weights = result.delaunay.weights()};
    for (SiteId s = 0; s < n; ++s) cells.sites.col(s) = result.delaunay.sites().position(s);
    return {voxel_image(result.delaunay, {}, voxel_grid(lattice, {0.1, -7}, counts), 1), cells};
}

TEST(Vti, IsReadBack) {
    // The last image has several blocks.
    for (const plane::VoxelCounts counts : {plane::VoxelCounts{2, 2}, {7, 5}, {600, 300}}) {
        const Example e = example(30, counts);
        const auto files = encode_vti(e.image, e.cells, {}, {}, "dir.x/t.vti");
        ASSERT_EQ(files.size(), 2U);
        EXPECT_EQ(files[1].path, "dir.x/t.material.yaml");
        const VoxelFile file = decode_vti(files);
        EXPECT_EQ(file.image.site, e.image.site);
        EXPECT_EQ(file.image.grid.counts, counts);
        EXPECT_EQ(file.image.grid.corner, e.image.grid.corner);
        EXPECT_EQ(file.image.grid.spacing(), e.image.grid.spacing());
        EXPECT_EQ(file.cells.value().sites, e.cells.sites);
        EXPECT_EQ(file.cells.value().weights, e.cells.weights);
        EXPECT_EQ(file.materials.value().size(), 30U);
        EXPECT_LT(prove_voxel_file(files, file).largest_excess, 1e-12);
    }
}

/// As VTK and DAMASK write images: without sites, in other types.
std::string plain_image(const std::string& type, const std::string& header,
                        const std::string& data) {
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"0.1\" "
           "byte_order=\"LittleEndian\"" +
           header +
           ">\n<ImageData WholeExtent=\"0 2 0 2 0 1\" Origin=\"0 0 0\" Spacing=\"1 1 1\">\n"
           "<Piece Extent=\"0 2 0 2 0 1\">\n<PointData>\n</PointData>\n<CellData "
           "Scalars=\"material\">\n"
           "<DataArray type=\"" +
           type + "\" Name=\"material\" format=\"binary\">\n  " + data +
           "\n</DataArray>\n</CellData>\n</Piece>\n</ImageData>\n</VTKFile>\n";
}

TEST(Vti, PlainImagesOfOtherProgramsAreRead) {
    // struct.pack("<I4i", 16, 0, 1, 2, 1) and struct.pack("<Q4q", 32, 0, 1, 2, 1) in base64.
    const std::string narrow = "EAAAAAAAAAABAAAAAgAAAAEAAAA=";
    const std::string wide = "IAAAAAAAAAAAAAAAAAAAAAEAAAAAAAAAAgAAAAAAAAABAAAAAAAAAA==";
    for (const auto& [type, header, data] :
         {std::tuple{"Int32", "", narrow}, std::tuple{"Int64", " header_type=\"UInt64\"", wide}}) {
        const std::vector<EncodedFile> files = {{"t.vti", plain_image(type, header, data)}};
        const VoxelFile file = decode_vti(files);
        EXPECT_THAT(file.image.site, ::testing::ElementsAre(0, 1, 2, 1));
        EXPECT_FALSE(file.cells.has_value());
        EXPECT_EQ(prove_voxel_file(files, file).n_cells, 3);
    }
}

std::string refusal(const std::vector<EncodedFile>& files) {
    try {
        prove_voxel_file(files, decode_vti(files));
    } catch (const InvalidInput& fault) {
        return fault.what();
    }
    return "";
}

TEST(Vti, DamageIsRefused) {
    const Example e = example(5, {6, 4});
    const auto good = encode_vti(e.image, e.cells, {}, {}, "t.vti");
    EXPECT_EQ(refusal(good), "");
    const auto changed = [&](const std::string& from, const std::string& to) {
        auto files = good;
        const std::size_t at = files[0].bytes.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        files[0].bytes.replace(at, from.size(), to);
        return refusal(files);
    };
    EXPECT_THAT(changed("type=\"ImageData\"", "type=\"PolyData\""), HasSubstr("give a VTI"));
    EXPECT_THAT(changed("LittleEndian", "BigEndian"), HasSubstr("t.vti:3: the bytes"));
    EXPECT_THAT(changed("vtkZLibDataC", "vtkLZ4DataC"), HasSubstr("zlib"));
    EXPECT_THAT(changed("WholeExtent=\"0 6", "WholeExtent=\"1 6"),
                HasSubstr("t.vti:4: the extent"));
    EXPECT_THAT(changed("WholeExtent=\"0 6", "WholeExtent=\"0 7"), HasSubstr("piece"));
    EXPECT_THAT(changed("Spacing=\"", "Spacing=\"-"), HasSubstr("spacing"));
    EXPECT_THAT(changed("0.25 0.5\" Direction", "0.26 0.5\" Direction"), HasSubstr("periods"));
    EXPECT_THAT(changed("0.25 0.5\" Direction", "0.25 0.6\" Direction"), HasSubstr("as thick"));
    EXPECT_THAT(changed("0\" Spacing", "1\" Spacing"), HasSubstr("not at z = 0"));
    EXPECT_THAT(changed("Direction=\"1 0 0 0 1", "Direction=\"0 1 0 1 0"), HasSubstr("turned"));
    EXPECT_THAT(changed("format=\"binary\"", "format=\"appended\""), HasSubstr("inline"));
    EXPECT_THAT(changed("\"Int32\"", "\"Float32\""), HasSubstr("Int32 or Int64"));
    EXPECT_THAT(changed("\"Int32\"", "\"Int64\""), HasSubstr("damaged"));
    EXPECT_THAT(changed("Name=\"material\"", "Name=\"grain\""),
                HasSubstr("lacks the array material"));
    EXPECT_THAT(changed("Origin=\"0.1 -7", "Origin=\"0.9 -7"), HasSubstr("its centre lies in"));
    EXPECT_THAT(changed("header_type=\"UInt64\"", "header_type=\"UInt32\""), HasSubstr("damaged"));
    EXPECT_THAT(changed("UInt64", "Float32"), HasSubstr("header_type"));
    EXPECT_THAT(changed("\"Int32\"", "\"Int32\" NumberOfTuples=\"23\""), HasSubstr("one number a"));
    EXPECT_THAT(changed("\"Int32\"", "\"Int32\" NumberOfComponents=\"2\""),
                HasSubstr("one number a"));
    auto files = good;
    files[1].bytes.erase(files[1].bytes.rfind("  - homogenization"));
    EXPECT_THAT(refusal(files), HasSubstr("t.material.yaml: has 4 materials"));
}

TEST(Vti, ArraysOfSitesHaveTheFormThatTheirTagsState) {
    const Example e = example(5, {6, 4});
    const auto good = encode_vti(e.image, e.cells, {}, {}, "t.vti");
    for (const std::string name : {"PeriodicLattice", "SitePositions", "SiteWeights"}) {
        const auto changed = [&](const std::string& from, const std::string& to) {
            auto files = good;
            std::string& bytes = files[0].bytes;
            const std::size_t line = bytes.rfind('<', bytes.find("Name=\"" + name));
            const std::size_t at = bytes.find(from, line);
            EXPECT_LT(at, bytes.find('>', line)) << from;
            bytes.replace(at, from.size(), to);
            return refusal(files);
        };
        const auto refused = HasSubstr("the array " + name + " has not ");
        EXPECT_THAT(changed("Float64", "Float32"), refused);
        EXPECT_THAT(changed("type", "kind"), refused);
        EXPECT_THAT(changed("ascii", "asci"), refused);
        EXPECT_THAT(changed("NumberOfComponents=\"", "NumberOfComponents=\"1"), refused);
        EXPECT_THAT(changed("NumberOfTuples=\"", "NumberOfTuples=\"1"), refused);
        EXPECT_THAT(changed("NumberOfTuples", "Tuples"), refused);
        EXPECT_THAT(changed("NumberOfTuples=\"", "NumberOfTuples=\"x"), HasSubstr("'x"));
        if (name == "SiteWeights") continue;
        EXPECT_THAT(changed(name, "Other"), HasSubstr("has not both of the arrays"));
    }
}

TEST(Vti, EveryChangedDigitOfTheVoxelsIsFound) {
    const Example e = example(5, {6, 4});
    const auto good = encode_vti(e.image, e.cells, {}, {}, "t.vti");
    const std::size_t begin = good[0].bytes.find("binary\">\n") + 9;
    const std::size_t end = good[0].bytes.find('\n', begin);
    for (std::size_t at = begin; at < end; ++at) {
        auto files = good;
        char& digit = files[0].bytes[at];
        digit = digit == 'A' ? 'B' : 'A';
        std::vector<SiteId> found = e.image.site;
        try {
            found = decode_vti(files).image.site;
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
