#include "io/voxels/vti_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "io/bytes/little_endian.hpp"
#include "io/bytes/text.hpp"
#include "io/bytes/xml_scanner.hpp"
#include "io/voxels/cell_fields.hpp"
#include "io/voxels/vtk_array.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

using Event = XmlScanner::Event;

/// Reads the tags of one file.
class VtiFile {
   public:
    VtiFile(const std::string& name, std::string_view text) : scanner_(name, text) {}

    VoxelFile read() {
        if (scanner_.next() != Event::kBegin || scanner_.element() != "VTKFile" ||
            scanner_.attribute("type") != "ImageData") {
            throw BadFile(scanner_.name() + ": is not a VTKFile with ImageData; give a VTI");
        }
        read_form();
        for (Event event = scanner_.next(); event != Event::kNothing; event = scanner_.next()) {
            if (event == Event::kEnd) continue;
            if (scanner_.element() == "ImageData") {
                read_grid();
            } else if (scanner_.element() == "Piece") {
                require_one_piece();
            } else if (scanner_.element() == "DataArray") {
                read_array();
            } else {
                section_ = std::string(scanner_.element());
            }
        }
        if (!has_grid_ || labels_.empty()) {
            throw BadFile(scanner_.name() +
                          ": lacks the array material of the cells of an image; "
                          "export the file with it");
        }
        take_image();
        return std::move(file_);
    }

   private:
    [[noreturn]] void refuse(const std::string& complaint) const {
        scanner_.throw_bad_file(scanner_.line(), complaint);
    }

    std::string_view value(std::string_view key) const {
        const auto found = scanner_.attribute(key);
        if (!found) refuse("the tag lacks " + std::string(key) + "; add it");
        return *found;
    }

    template <std::size_t n>
    std::array<double, n> numbers(std::string_view key) const {
        const std::vector<std::string_view> words = words_of(value(key));
        if (words.size() != n) refuse(std::string(key) + " has not its numbers; correct it");
        std::array<double, n> found;
        try {
            std::transform(words.begin(), words.end(), found.begin(), parse_number);
        } catch (const InvalidInput& fault) {
            refuse(fault.what());
        }
        return found;
    }

    void read_form() {
        if (value("byte_order") != "LittleEndian") {
            refuse("the bytes are not little-endian; export the file so");
        }
        const std::string_view header = scanner_.attribute("header_type").value_or("UInt32");
        if (header != "UInt32" && header != "UInt64") {
            refuse("header_type is neither UInt32 nor UInt64; correct it");
        }
        form_.header_size = header == "UInt64" ? 8 : 4;
        const auto compressor = scanner_.attribute("compressor");
        form_.is_compressed = compressor.has_value();
        if (form_.is_compressed && compressor != "vtkZLibDataCompressor") {
            refuse("the data are not compressed by zlib; export the file so, or uncompressed");
        }
    }

    void read_grid() {
        if (has_grid_) refuse("there is a second image; give a file with one");
        const auto extent = numbers<6>("WholeExtent");
        const auto origin = numbers<3>("Origin");
        const auto spacing = numbers<3>("Spacing");
        if (extent[0] != 0 || extent[2] != 0 || extent[4] != 0) {
            refuse("the extent does not begin at 0; export it so");
        }
        space::VoxelGrid& grid = grid_;
        grid.counts = {count(extent[1]), count(extent[3]), count(extent[5])};
        if (double(grid.counts.x) * grid.counts.y * grid.counts.z > kMostVoxels) {
            refuse("there are more than 2^28 voxels; give a smaller image");
        }
        grid.corner = {origin[0], origin[1], origin[2]};
        grid.size = {spacing[0] * grid.counts.x, spacing[1] * grid.counts.y,
                     spacing[2] * grid.counts.z};
        // The range of period vectors.
        for (const double size : {grid.size.x(), grid.size.y()}) {
            if (size >= 1e-60 && size <= 1e60) continue;
            refuse("the spacing is not positive, or out of range; correct it");
        }
        if (scanner_.attribute("Direction") &&
            numbers<9>("Direction") != std::array<double, 9>{1, 0, 0, 0, 1, 0, 0, 0, 1}) {
            refuse("the image is turned; export it with its rows along x and y");
        }
        if (!(spacing[2] > 0) || !std::isfinite(spacing[2] + origin[2])) {
            refuse("the layer has no thickness; correct Spacing");
        }
        is_plain_layer_ = origin[2] == 0 && spacing[2] == spacing[0];
        extent_ = value("WholeExtent");
        grid_line_ = scanner_.line();
        has_grid_ = true;
    }

    int count(double number) const {
        if (number >= 1 && number <= kMostVoxelsOfARow && number == static_cast<int>(number)) {
            return static_cast<int>(number);
        }
        refuse("the extent is not one of voxels from 1 to 2^20; correct it");
    }

    void require_one_piece() {
        if (!has_grid_ || has_piece_ || value("Extent") != extent_) {
            refuse("the piece is not the whole image; merge the pieces");
        }
        has_piece_ = true;
    }

    void read_array() {
        const std::string name(scanner_.attribute("Name").value_or(""));
        const std::string_view type = scanner_.attribute("type").value_or("");
        const std::size_t width = type == "Int32" ? 4 : 8;
        const int line = scanner_.line();
        const bool is_material = section_ == "CellData" && name == "material";
        if (is_material) require_material_form(type);
        const bool is_field = section_ == "FieldData" && fields_.begin(scanner_);
        // VTK may nest elements with ranges in an array; its text is the longest one.
        std::string_view text;
        for (int depth = 1; depth > 0;) {
            const Event event = scanner_.next();
            if (depth == 1 && scanner_.text().size() > text.size()) text = scanner_.text();
            depth += event == Event::kBegin ? 1 : -1;
        }
        if (is_material) read_material(text, width, line);
        if (is_field) fields_.end(text);
    }

    void require_material_form(std::string_view type) const {
        if (!has_piece_ || !labels_.empty()) {
            refuse("the array material is there twice, or outside of the piece; correct it");
        }
        if (scanner_.attribute("format") != "binary" || (type != "Int32" && type != "Int64")) {
            refuse("the array material is not Int32 or Int64 in binary form, inline; export it so");
        }
        const auto n_voxels = static_cast<double>(grid_.n_voxels());
        if (number_attribute(scanner_, "NumberOfComponents").value_or(1) != 1 ||
            number_attribute(scanner_, "NumberOfTuples").value_or(n_voxels) != n_voxels) {
            refuse("the array material states another size than one number a voxel; correct it");
        }
    }

    /// The number of voxels in a layer along x and y.
    std::size_t n_in_layer() const { return grid_.n_voxels() / grid_.counts.z; }

    /// The first layer along z that is not equal to the first; 0 if all are equal.
    /// @param bytes  of all layers, `n_bytes` each.
    static std::size_t other_layer(std::string_view bytes, std::size_t n_bytes) {
        const std::string_view first = bytes.substr(0, n_bytes);
        for (std::size_t begin = n_bytes; begin < bytes.size(); begin += n_bytes) {
            checkpoint();
            if (bytes.substr(begin, n_bytes) != first) return begin / n_bytes;
        }
        return 0;
    }

    void read_material(std::string_view text, std::size_t width, int line) {
        std::string bytes;
        if (!decode_vtk_array(text, form_, grid_.n_voxels() * width, bytes)) {
            scanner_.throw_bad_file(line,
                                    "the array material is damaged, or has not one number a "
                                    "voxel; write the file again");
        }
        const std::size_t n_bytes = n_in_layer() * width;
        other_layer_ = other_layer(bytes, n_bytes);
        material_line_ = line;
        // Equal layers are held once.
        if (other_layer_ == 0) bytes.resize(n_bytes);
        labels_.reserve(bytes.size() / width);
        for (std::size_t k = 0; k < bytes.size(); k += width) {
            checkpoint_each(static_cast<long>(k));
            const auto value =
                static_cast<std::int64_t>(little_endian(std::string_view(bytes).substr(k, width)));
            // In 32 bits, the highest bit is the sign.
            const bool fits = width == 4 || (value >= 0 && value <= plane::kMostSites);
            labels_.push_back(fits ? static_cast<std::int32_t>(value) : -1);
        }
    }

    /// Takes the image as one of the plane or of space, with its cells.
    void take_image() {
        const bool is_in_space = fields_.empty() ? other_layer_ > 0 : fields_.are_in_space();
        if (is_in_space) {
            take_image_of_space();
        } else {
            take_image_of_plane();
        }
    }

    void take_image_of_space() {
        const double thickness = grid_.size.z();
        if (!(thickness >= 1e-60 && thickness <= 1e60)) {
            scanner_.throw_bad_file(grid_line_,
                                    "the spacing is not positive, or out of range; correct it");
        }
        if (other_layer_ == 0) {
            const std::size_t n = labels_.size();
            labels_.reserve(grid_.n_voxels());
            for (std::size_t k = n; k < grid_.n_voxels(); ++k) labels_.push_back(labels_[k - n]);
        }
        file_.space = SpaceVoxels{.image = {.grid = grid_, .site = std::move(labels_)}};
        if (!fields_.empty()) file_.space->cells = fields_.cells_in_space(scanner_.name());
    }

    void take_image_of_plane() {
        if (other_layer_ > 0) {
            scanner_.throw_bad_file(
                material_line_, "layer " + std::to_string(other_layer_) +
                                    " along z is not equal to layer 0; give an image of the plane");
        }
        file_.image = {.grid = {.corner = grid_.corner.head<2>(),
                                .size = grid_.size.head<2>(),
                                .counts = grid_.counts},
                       .site = std::move(labels_)};
        if (fields_.empty()) return;
        if (!is_plain_layer_) {
            scanner_.throw_bad_file(grid_line_,
                                    "the layer is not at z = 0, or not as thick as a voxel is "
                                    "wide; correct Origin and Spacing");
        }
        file_.cells = fields_.cells(scanner_.name());
    }

    XmlScanner scanner_;
    std::string section_;
    std::string extent_;
    CellFields fields_;
    VoxelFile file_ = {};
    VtkArrayForm form_;
    space::VoxelGrid grid_ = {};
    /// The sites of the voxels of all layers, or of one if they are equal.
    std::vector<SiteId> labels_;
    /// As other_layer().
    std::size_t other_layer_ = 0;
    int material_line_ = 1;
    /// The layer lies at z = 0 and is as thick as a voxel is wide.
    bool is_plain_layer_ = false;
    int grid_line_ = 1;
    bool has_grid_ = false;
    bool has_piece_ = false;
};

}  // namespace

VoxelFile decode_vti(const std::vector<EncodedFile>& files) {
    const EncodedFile& vti = files.front();
    refuse_binary(vti.path, vti.bytes, "export it with inline data");
    VoxelFile file = VtiFile(vti.path, vti.bytes).read();
    if (files.size() > 1) {
        file.materials = decode_damask_material(files[1].path, files[1].bytes);
    }
    return file;
}

namespace {

/// Proves the voxels of the plane or of space.
template <class Image, class Cells>
VoxelProof prove_image(const std::vector<EncodedFile>& files, const VoxelFile& file,
                       const Image& image, const std::optional<Cells>& cells) {
    const SiteId most = *std::max_element(image.site.begin(), image.site.end());
    const int n_cells = cells            ? cells->n_cells()
                        : file.materials ? static_cast<int>(file.materials->size())
                                         : most + 1;
    if (!cells) require_voxel_ids(image, n_cells);
    if (file.materials && static_cast<int>(file.materials->size()) != n_cells) {
        throw BadFile(files[1].path + ": has " + std::to_string(file.materials->size()) +
                      " materials, but there are " + std::to_string(n_cells) +
                      " cells; write the file again with pcvt");
    }
    if (cells) return prove_voxels(image, *cells);
    return {.n_cells = n_cells, .unseen = unseen_cells(image.site, n_cells), .largest_excess = 0};
}

}  // namespace

VoxelProof prove_voxel_file(const std::vector<EncodedFile>& files, const VoxelFile& file) {
    if (file.space) return prove_image(files, file, file.space->image, file.space->cells);
    return prove_image(files, file, file.image, file.cells);
}

}  // namespace pcvt
