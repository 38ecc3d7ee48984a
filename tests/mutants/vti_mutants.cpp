#include <array>
#include <cstring>

#include "io/bytes/base64.hpp"
#include "io/voxels/vti_writer.hpp"
#include "tests/mutants/mutated_formats.hpp"
#include "tests/mutants/xml_namer.hpp"

namespace pcvt::testing {
namespace {

constexpr std::string_view kNoCentre = "the centre of no voxel comes into another cell";
constexpr std::string_view kSameLattice = "other period vectors of the same lattice";
constexpr std::string_view kText = "text is the default";
constexpr std::string_view kOwn = "the laws of the materials are the user's";
constexpr std::string_view kNowhereElse = "the materials of the cells are stated only here";

/// Names the words of the materials by the section and the key of their line.
class YamlNamer {
   public:
    LineNames operator()(const std::vector<std::string_view>& words) {
        if (words.empty() || words[0].starts_with('#')) return {};
        const bool is_section = words[0].data()[-1] == '\n';
        if (is_section) section_ = std::string(words[0]);
        const bool is_item = words[0] == "-";
        const std::string key(words[is_item ? 1 : 0]);
        const std::string name = section_ + (is_section ? "" : " " + key);
        LineNames names{.row = name + " row", .words = {name + " key"}};
        if (is_item) names.words.insert(names.words.begin(), "");
        names.words.resize(words.size(), name);
        return names;
    }

   private:
    std::string section_;
};

/// The bytes of an image with another id of a voxel, which compress it again.
std::string with_voxel(const Files& files, std::size_t voxel, const std::string& value) {
    VoxelFile file = decode_vti(files);
    const auto id = static_cast<SiteId>(std::stoll(value));
    if (file.space) {
        file.space->image.site[voxel] = id;
        return encode_space_vti(file.space->image, file.space->cells.value(), {}, {}, files[0].path)
            .front()
            .bytes;
    }
    file.image.site[voxel] = id;
    return encode_vti(file.image, file.cells.value(), {}, {}, files[0].path).front().bytes;
}

/// The ids of the voxels.
std::vector<Field> voxel_fields(const Files& files) {
    std::vector<Field> fields;
    const VoxelFile file = decode_vti(files);
    const std::vector<SiteId>& sites = file.space ? file.space->image.site : file.image.site;
    for (std::size_t k = 0; k < sites.size(); ++k) {
        fields.push_back({"voxel", std::to_string(sites[k]), [&files, k](const std::string& value) {
                              return with_bytes(files, 0, with_voxel(files, k, value));
                          }});
    }
    return fields;
}

/// The numbers in front of the compressed voxels.
std::vector<Field> header_fields(const Files& files) {
    constexpr std::array kNames{"header blocks", "header block size", "header last block",
                                "header packed size"};
    constexpr std::size_t kBytes = kNames.size() * sizeof(std::uint64_t);
    constexpr std::size_t kDigits = (kBytes + 2) / 3 * 4;
    const std::string& text = files[0].bytes;
    const std::size_t at = text.find('\n', text.find("format=\"binary\"")) + 1;
    std::string header;
    decode_base64(text.substr(at, kDigits), header);
    std::vector<Field> fields;
    for (std::size_t k = 0; k < kNames.size(); ++k) {
        std::uint64_t number{};
        std::memcpy(&number, header.data() + k * sizeof number, sizeof number);
        fields.push_back(
            {kNames[k], std::to_string(number), [&files, at, header, k](const std::string& value) {
                 std::vector<unsigned char> bytes(header.begin(), header.end());
                 const auto other = static_cast<std::uint64_t>(std::stoll(value));
                 std::memcpy(bytes.data() + k * sizeof other, &other, sizeof other);
                 std::string digits;
                 append_base64(digits, bytes);
                 std::string changed = files[0].bytes;
                 return with_bytes(files, 0, changed.replace(at, kDigits, digits));
             }});
    }
    return fields;
}

}  // namespace

std::vector<Mutant> vti_mutants(const BaseFile& base) {
    std::vector<Mutant> mutants = text_mutants(base.files, 0, XmlNamer(), kXmlSeparators, kDigit);
    const auto append = [&](const std::vector<Mutant>& more) {
        mutants.insert(mutants.end(), more.begin(), more.end());
    };
    append(text_mutants(base.files, 1, YamlNamer(), "[]{},:", kDigit));
    append(mutants_of(voxel_fields(base.files), kDigit));
    append(mutants_of(header_fields(base.files), kDigit));
    return mutants;
}

std::span<const Harmless> harmless_in_vti() {
    static constexpr std::array kHarmless{
        Harmless{"VTKFile version*", "",
                 "the versions of the format do not differ in what it uses"},
        Harmless{"ImageData Direction key", "", "without it the rows lie along x and y, too"},
        Harmless{"ImageData Origin", "digit", kNoCentre},
        Harmless{"SitePositions value", "digit", kNoCentre},
        Harmless{"SiteWeights value", "digit", kNoCentre},
        Harmless{"Metric value", "digit", kNoCentre},
        Harmless{"PeriodicLattice value", "sign", kSameLattice},
        Harmless{"PeriodicLattice value", "exchange", kSameLattice},
        Harmless{"PeriodicLattice row", "swap", kSameLattice},
        Harmless{"PeriodicLattice format key", "", kText},
        Harmless{"SitePositions format key", "", kText},
        Harmless{"SiteWeights format key", "", kText},
        Harmless{"Metric format key", "", kText},
        Harmless{"SiteWeights NumberOfComponents key", "", "one component is the default"},
        Harmless{"header block size", "", "there is one block, of which the last size is that"},
        Harmless{"homogenization mechanical*", "", kOwn},
        Harmless{"phase elastic*", "", kOwn},
        Harmless{"phase lattice*", "", kOwn},
        Harmless{"phase mechanical*", "", kOwn},
        Harmless{"phase output*", "", kOwn},
        Harmless{"material phase", "exchange", kNowhereElse},
        Harmless{"material O", "sign", kNowhereElse},
        Harmless{"material O", "digit", kNowhereElse},
    };
    return kHarmless;
}

}  // namespace pcvt::testing
