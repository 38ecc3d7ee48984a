#include "io/voxels/vti_writer.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>

#include "io/bytes/base64.hpp"
#include "io/bytes/little_endian.hpp"
#include "io/bytes/text.hpp"
#include "io/voxels/damask_material.hpp"
#include "io/voxels/zlib_blocks.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

/// Bytes of a block before its compression, some milliseconds of work.
constexpr std::size_t kBlockSize = std::size_t{1} << 18;

void append_in_base64(std::string& text, const std::string& bytes) {
    append_base64(text, std::vector<unsigned char>(bytes.begin(), bytes.end()));
}

/// Appends 32-bit integers, `n_layers` times, as VTK's compressed arrays: the number of blocks,
/// their size, the size of the last one if it is smaller, the sizes of all after compression; then
/// the blocks.
void append_compressed(std::string& text, const std::vector<SiteId>& values, int n_layers) {
    constexpr std::size_t kValuesOfABlock = kBlockSize / sizeof(std::int32_t);
    const std::size_t n = values.size() * static_cast<std::size_t>(n_layers);
    std::string header;
    const std::size_t n_blocks = (n + kValuesOfABlock - 1) / kValuesOfABlock;
    append_little_endian(header, n_blocks, 8);
    append_little_endian(header, kBlockSize, 8);
    append_little_endian(header, n * sizeof(std::int32_t) % kBlockSize, 8);
    std::string packed;
    for (std::size_t begin = 0; begin < n; begin += kValuesOfABlock) {
        checkpoint();
        std::string block;
        const std::size_t end = std::min(begin + kValuesOfABlock, n);
        for (std::size_t k = begin; k < end; ++k) {
            append_little_endian(block, static_cast<std::uint32_t>(values[k % values.size()]), 4);
        }
        block = zlib_compressed(block);
        append_little_endian(header, block.size(), 8);
        packed += block;
    }
    append_in_base64(text, header);
    append_in_base64(text, packed);
}

/// Appends `number` and a separator.
void append_with(std::string& text, double number, char separator) {
    append_number(text, number);
    text += separator;
}

/// Appends an array of the whole image with `width` numbers a tuple.
void append_array(std::string& text, const char* name, int width,
                  const std::vector<double>& numbers) {
    text += std::string("<DataArray type=\"Float64\" Name=\"") + name + "\" NumberOfTuples=\"" +
            std::to_string(numbers.size() / static_cast<std::size_t>(width)) +
            "\" NumberOfComponents=\"" + std::to_string(width) + "\" format=\"ascii\">\n";
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        checkpoint_each(static_cast<long>(k));
        append_with(text, numbers[k], (k + 1) % static_cast<std::size_t>(width) == 0 ? '\n' : ' ');
    }
    text += "</DataArray>\n";
}

template <class Points>
std::vector<double> all_of(const Points& points) {
    return {points.data(), points.data() + points.size()};
}

/// Appends the arrays by which a file states its cells.
void append_cells(std::string& text, const plane::VoxelCells& cells) {
    const plane::Vec2& a = cells.lattice.a();
    const plane::Vec2& b = cells.lattice.b();
    append_array(text, "PeriodicLattice", 2, {a.x(), a.y(), b.x(), b.y()});
    append_array(text, "SitePositions", 2, all_of(cells.sites));
    if (cells.weights.size() > 0) append_array(text, "SiteWeights", 1, all_of(cells.weights));
    if (!cells.metric.is_round()) {
        append_array(text, "Metric", 2, {cells.metric.ratio(), cells.metric.degrees()});
    }
}

void append_cells(std::string& text, const space::VoxelCells& cells) {
    std::vector<double> lattice;
    for (const space::Vec3& period : cells.lattice.periods()) {
        lattice.insert(lattice.end(), period.begin(), period.end());
    }
    append_array(text, "PeriodicLattice", 3, lattice);
    append_array(text, "SitePositions", 3, all_of(cells.sites));
    if (cells.weights.size() > 0) append_array(text, "SiteWeights", 1, all_of(cells.weights));
    if (!cells.metric.is_round()) {
        const space::Vec3& axis = cells.metric.axis();
        append_array(text, "Metric", 4, {cells.metric.ratio(), axis.x(), axis.y(), axis.z()});
    }
}

/// The place of the voxels of an image, as the tag of an image states it.
struct StatedGrid {
    VoxelCounts counts;
    std::array<double, 3> corner;
    std::array<double, 3> spacing;
    /// The number of times that the labels of the image are repeated along z.
    int n_repeats;
};

StatedGrid stated_grid(const plane::VoxelGrid& grid) {
    const plane::Vec2 spacing = grid.spacing();
    // A layer is as thick as a voxel is wide.
    return {grid.counts,
            {grid.corner.x(), grid.corner.y(), 0},
            {spacing.x(), spacing.y(), spacing.x()},
            grid.counts.z};
}

StatedGrid stated_grid(const space::VoxelGrid& grid) {
    const space::Vec3 spacing = grid.spacing();
    return {grid.counts,
            {grid.corner.x(), grid.corner.y(), grid.corner.z()},
            {spacing.x(), spacing.y(), spacing.z()},
            1};
}

template <class Image, class Cells>
std::string encode_image(const Image& image, const Cells& cells) {
    const StatedGrid grid = stated_grid(image.grid);
    const std::string extent = "Extent=\"0 " + std::to_string(grid.counts.x) + " 0 " +
                               std::to_string(grid.counts.y) + " 0 " +
                               std::to_string(grid.counts.z) + '"';
    std::string text =
        "<?xml version=\"1.0\"?>\n<!-- The cells of a periodic tile as voxels, written by pcvt "
        "-->\n"
        "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<ImageData Whole" +
        extent + " Origin=\"";
    for (int d = 0; d < 3; ++d) append_with(text, grid.corner[d], d == 2 ? '"' : ' ');
    text += " Spacing=\"";
    for (int d = 0; d < 3; ++d) append_with(text, grid.spacing[d], d == 2 ? '"' : ' ');
    text += " Direction=\"1 0 0 0 1 0 0 0 1\">\n<FieldData>\n";
    append_cells(text, cells);
    text += "</FieldData>\n<Piece " + extent +
            ">\n<CellData>\n<DataArray type=\"Int32\" Name=\"material\" format=\"binary\">\n";
    append_compressed(text, image.site, grid.n_repeats);
    text += "\n</DataArray>\n</CellData>\n</Piece>\n</ImageData>\n</VTKFile>\n";
    return text;
}

template <class Image, class Cells>
std::vector<EncodedFile> encode_voxels(const Image& image, const Cells& cells,
                                       const CellMaterials& materials,
                                       const ElasticChoices& elastic, const std::string& path) {
    const std::vector<std::string> paths = vti_paths(path);
    std::vector<EncodedFile> files = only_file(paths[0], encode_image(image, cells));
    files.push_back({paths[1], encode_damask_material(cells.n_cells(), materials, elastic)});
    return files;
}

}  // namespace

std::vector<std::string> vti_paths(const std::string& path) {
    return {path, std::filesystem::path(path).replace_extension(".material.yaml").string()};
}

std::vector<EncodedFile> encode_vti(const plane::VoxelImage& image, const plane::VoxelCells& cells,
                                    const CellMaterials& materials, const ElasticChoices& elastic,
                                    const std::string& path) {
    return encode_voxels(image, cells, materials, elastic, path);
}

std::vector<EncodedFile> encode_space_vti(const space::VoxelImage& image,
                                          const space::VoxelCells& cells,
                                          const CellMaterials& materials,
                                          const ElasticChoices& elastic, const std::string& path) {
    return encode_voxels(image, cells, materials, elastic, path);
}

}  // namespace pcvt
