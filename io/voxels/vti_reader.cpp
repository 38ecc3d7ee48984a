#include "io/voxels/vti_reader.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <map>

#include "io/bytes/base64.hpp"
#include "io/bytes/text.hpp"
#include "io/bytes/xml_scanner.hpp"
#include "io/voxels/zlib_blocks.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

using Event = XmlScanner::Event;

constexpr std::string_view kBlanks = " \t\r\n";

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

std::vector<std::string_view> split(std::string_view text) {
    std::vector<std::string_view> words;
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        checkpoint_each(static_cast<long>(words.size()));
        const std::size_t length = std::min(text.find_first_of(kBlanks), text.size());
        words.push_back(text.substr(0, length));
        text.remove_prefix(length);
    }
    return words;
}

std::uint64_t little_endian(std::string_view bytes) {
    std::uint64_t value = 0;
    for (std::size_t k = 0; k < bytes.size(); ++k) {
        value |= std::uint64_t{static_cast<unsigned char>(bytes[k])} << 8 * k;
    }
    return value;
}

/// The length in base64 of `n_bytes` bytes, padded to complete groups of four digits.
std::size_t n_digits(std::size_t n_bytes) { return (n_bytes + 2) / 3 * 4; }

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
                read_array(section_);
            } else {
                section_ = std::string(scanner_.element());
            }
        }
        if (!has_grid_ || file_.image.site.empty()) {
            throw BadFile(scanner_.name() +
                          ": lacks the array material of the cells of an image; "
                          "export the file with it");
        }
        take_cells();
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
        const std::vector<std::string_view> words = split(value(key));
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
        header_size_ = scanner_.attribute("header_type") == "UInt64" ? 8 : 4;
        const auto compressor = scanner_.attribute("compressor");
        is_compressed_ = compressor.has_value();
        if (is_compressed_ && compressor != "vtkZLibDataCompressor") {
            refuse("the data are not compressed by zlib; export the file so, or uncompressed");
        }
    }

    void read_grid() {
        if (has_grid_) refuse("there is a second image; give a file with one");
        const auto extent = numbers<6>("WholeExtent");
        const auto origin = numbers<3>("Origin");
        const auto spacing = numbers<3>("Spacing");
        if (extent[0] != 0 || extent[2] != 0 || extent[4] != 0 || extent[5] != 1) {
            refuse("the extent is not that of one layer of voxels from 0; export it so");
        }
        VoxelGrid& grid = file_.image.grid;
        grid.counts = {count(extent[1]), count(extent[3])};
        if (double(grid.counts.x) * grid.counts.y > kMostVoxels) {
            refuse("there are more than 2^28 voxels; give a smaller image");
        }
        grid.corner = {origin[0], origin[1]};
        grid.size = {spacing[0] * grid.counts.x, spacing[1] * grid.counts.y};
        // The range of period vectors.
        for (const double size : {grid.size.x(), grid.size.y()}) {
            if (size >= 1e-60 && size <= 1e60) continue;
            refuse("the spacing is not positive, or out of range; correct it");
        }
        extent_ = value("WholeExtent");
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

    void read_array(const std::string& section) {
        const std::string name(scanner_.attribute("Name").value_or(""));
        const std::string form(scanner_.attribute("format").value_or("ascii"));
        const std::string type(scanner_.attribute("type").value_or(""));
        const bool is_material = section == "CellData" && name == "material";
        const int line = scanner_.line();
        if (is_material && (!has_piece_ || !file_.image.site.empty())) {
            refuse("the array material is there twice, or outside of the piece; correct it");
        }
        if (is_material && (form != "binary" || (type != "Int32" && type != "Int64"))) {
            refuse("the array material is not Int32 or Int64 in binary form, inline; export it so");
        }
        // VTK may nest elements with ranges in an array; its text is the longest one.
        std::string_view text;
        for (int depth = 1; depth > 0;) {
            const Event event = scanner_.next();
            if (depth == 1 && scanner_.text().size() > text.size()) text = scanner_.text();
            depth += event == Event::kBegin ? 1 : -1;
        }
        if (is_material) {
            read_material(trimmed(text), type == "Int32" ? 4 : 8, line);
        } else if (section == "FieldData" && form == "ascii") {
            fields_[name] = {line, text};
        }
    }

    void read_material(std::string_view text, std::size_t width, int line) {
        const std::size_t n_bytes = file_.image.grid.n_voxels() * width;
        std::string bytes;
        const bool whole =
            is_compressed_ ? unpack(text, n_bytes, bytes) : decode_plain(text, n_bytes, bytes);
        if (!whole) {
            scanner_.throw_bad_file(line,
                                    "the array material is damaged, or has not one number a "
                                    "voxel; write the file again");
        }
        file_.image.site.reserve(file_.image.grid.n_voxels());
        for (std::size_t k = 0; k < n_bytes; k += width) {
            checkpoint_each(static_cast<long>(k));
            const auto value =
                static_cast<std::int64_t>(little_endian(std::string_view(bytes).substr(k, width)));
            // Of 32 bits, the sign is that of the highest bit.
            const bool fits = width == 4 || (value >= 0 && value <= kMostSites);
            file_.image.site.push_back(fits ? static_cast<std::int32_t>(value) : -1);
        }
    }

    /// A header with the number of bytes, then the bytes.
    bool decode_plain(std::string_view text, std::size_t n_bytes, std::string& bytes) const {
        if (text.size() != n_digits(n_bytes + header_size_)) return false;
        if (!decode_base64(text, bytes) || bytes.size() != n_bytes + header_size_) return false;
        if (little_endian(std::string_view(bytes).substr(0, header_size_)) != n_bytes) return false;
        bytes.erase(0, header_size_);
        return true;
    }

    /// The header and the blocks of compressed data (append_compressed() in vti_writer.cpp).
    bool unpack(std::string_view text, std::size_t n_bytes, std::string& bytes) const {
        std::string header;
        if (text.size() < n_digits(header_size_)) return false;
        if (!decode_base64(text.substr(0, n_digits(header_size_)), header)) return false;
        const auto entry = [&](std::size_t k) {
            return little_endian(std::string_view(header).substr(k * header_size_, header_size_));
        };
        if (header.size() < header_size_ || entry(0) > text.size()) return false;
        const auto n_blocks = static_cast<std::size_t>(entry(0));
        const std::size_t header_digits = n_digits((3 + n_blocks) * header_size_);
        if (text.size() < header_digits) return false;
        if (!decode_base64(text.substr(0, header_digits), header)) return false;
        const std::uint64_t block_size = entry(1);
        const std::uint64_t last_size = entry(2) == 0 ? block_size : entry(2);
        std::string packed;
        if (!decode_base64(text.substr(header_digits), packed)) return false;
        std::string_view rest = packed;
        for (std::size_t b = 0; b < n_blocks; ++b) {
            checkpoint();
            const std::uint64_t size = b + 1 == n_blocks ? last_size : block_size;
            const std::uint64_t packed_size = entry(3 + b);
            if (size > n_bytes - bytes.size() || packed_size > rest.size()) return false;
            if (!zlib_decompress(rest.substr(0, packed_size), size, bytes)) return false;
            rest.remove_prefix(packed_size);
        }
        return rest.empty() && bytes.size() == n_bytes;
    }

    /// The numbers of an array of the field data; empty if there is none.
    std::vector<double> field(const std::string& name) const {
        const auto found = fields_.find(name);
        if (found == fields_.end()) return {};
        std::vector<double> values;
        try {
            for (const std::string_view word : split(found->second.text)) {
                values.push_back(parse_number(word));
            }
        } catch (const InvalidInput& fault) {
            scanner_.throw_bad_file(found->second.line, fault.what());
        }
        return values;
    }

    void take_cells() {
        const std::vector<double> lattice = field("PeriodicLattice");
        const std::vector<double> sites = field("SitePositions");
        const std::vector<double> weights = field("SiteWeights");
        const std::vector<double> metric = field("Metric");
        if (sites.empty()) return;
        const auto refuse_field = [&](const std::string& name, const std::string& complaint) {
            const auto found = fields_.find(name);
            throw BadFile(scanner_.name() + ":" +
                          std::to_string(found == fields_.end() ? 1 : found->second.line) + ": " +
                          complaint);
        };
        const std::size_t n = sites.size() / 2;
        if (lattice.size() != 4)
            refuse_field("PeriodicLattice", "the sites lack a lattice; add it");
        if (sites.size() != 2 * n) refuse_field("SitePositions", "a site lacks its y; add it");
        if (!metric.empty() && metric.size() != 2) {
            refuse_field("Metric", "the metric has not a ratio and an angle; correct it");
        }
        if (!weights.empty() && weights.size() != n) {
            refuse_field("SiteWeights", "there is not one weight a site; correct them");
        }
        try {
            const Lattice periods({lattice[0], lattice[1]}, {lattice[2], lattice[3]});
            const Points points = Eigen::Map<const Points>(sites.data(), 2, Eigen::Index(n));
            // Refuses too many sites, and sites that coincide or lie too far away.
            const Sites checked(periods, points);
            file_.cells =
                VoxelCells{.lattice = periods,
                           .sites = points,
                           .weights = Eigen::Map<const Eigen::VectorXd>(
                               weights.data(), Eigen::Index(weights.size())),
                           .metric = metric.empty() ? Metric() : Metric(metric[0], metric[1])};
        } catch (const BadFile&) {
            throw;
        } catch (const InvalidInput& fault) {
            refuse_field("SitePositions", fault.what());
        }
    }

    struct Field {
        int line = 1;
        std::string_view text = {};
    };

    XmlScanner scanner_;
    std::string section_;
    std::string extent_;
    std::map<std::string, Field> fields_;
    VoxelFile file_ = {};
    std::size_t header_size_ = 4;
    bool is_compressed_ = false;
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

VoxelProof prove_voxel_file(const std::vector<EncodedFile>& files, const VoxelFile& file) {
    const SiteId most = *std::max_element(file.image.site.begin(), file.image.site.end());
    const int n_cells = file.cells       ? file.cells->n_cells()
                        : file.materials ? static_cast<int>(file.materials->size())
                                         : most + 1;
    if (!file.cells) require_voxel_ids(file.image, n_cells);
    if (file.materials && static_cast<int>(file.materials->size()) < n_cells) {
        throw BadFile(files[1].path + ": has " + std::to_string(file.materials->size()) +
                      " materials, but there are " + std::to_string(n_cells) +
                      " cells; write the file again with pcvt");
    }
    if (file.cells) return prove_voxels(file.image, *file.cells);
    return {.n_cells = n_cells, .unseen = unseen_cells(file.image, n_cells), .largest_excess = 0};
}

}  // namespace pcvt
