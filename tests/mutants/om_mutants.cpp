#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>

#include "tests/mutants/mutated_formats.hpp"
#include "tests/support/glb.hpp"

namespace pcvt::testing {
namespace {

constexpr unsigned kEnd = 0x001c;
constexpr unsigned kIsNamed = 0x0002;
constexpr unsigned kPositions = 0x5600;

/// Walks over the chunks of a file of OpenMesh and names their numbers.
class OmFields {
   public:
    explicit OmFields(const BaseFile& base) : base_(base), bytes_(base.files[0].bytes) {}

    std::vector<Field> fields() {
        at_ = 4;
        n_vertices_ = word_at(bytes_, 4);
        n_faces_ = word_at(bytes_, 8);
        n_halfedges_ = 2 * word_at(bytes_, 12);
        add(3, Binary::kUint32, {"header.count"});
        while (read_chunk()) {
        }
        return std::move(fields_);
    }

   private:
    void add(std::size_t n, Binary type, const std::vector<std::string>& names) {
        const auto more = binary_fields(base_.files, 0, at_, n, type, names);
        fields_.insert(fields_.end(), more.begin(), more.end());
        at_ += n * width_of(type);
    }

    bool read_chunk() {
        std::uint16_t header = 0;
        if (at_ + sizeof header > bytes_.size()) {
            throw std::runtime_error("an OpenMesh file without its last chunk");
        }
        std::memcpy(&header, bytes_.data() + at_, sizeof header);
        add(1, Binary::kUint16, {"chunk header"});
        if (header == kEnd) return false;
        const std::array<Binary, 3> integers{Binary::kUint8, Binary::kUint16, Binary::kInt32};
        const Binary handle = integers[std::min<std::size_t>(header >> 14, 2)];
        if ((header & kIsNamed) != 0) {
            read_property();
        } else if (header == kPositions) {
            add(3 * n_vertices_, Binary::kFloat64, {"position.x", "position.y", "position.z"});
        } else if ((header & 0x1ff) == 0xe0) {
            add(n_vertices_, handle, {"vertex.halfedge"});
        } else if ((header & 0x1ff) == 0xf8) {
            add(3 * n_halfedges_, handle, {"halfedge.next", "halfedge.vertex", "halfedge.face"});
        } else if ((header & 0x1ff) == 0xe8) {
            add(n_faces_, handle, {"face.halfedge"});
        } else {
            throw std::runtime_error("an unknown chunk of OpenMesh");
        }
        return true;
    }

    std::string read_text() {
        const auto length = static_cast<unsigned char>(bytes_[at_]);
        const std::string text = bytes_.substr(at_ + 1, length);
        at_ += 1 + length;
        return text;
    }

    void read_property() {
        const std::size_t name_at = at_ + 1;
        const std::string name = read_text();
        fields_.push_back({"property.name", name, [this, name_at, name](const std::string&) {
                               std::string bytes = base_.files[0].bytes;
                               bytes[name_at + name.size() - 1] ^= 1;
                               return with_bytes(base_.files, 0, bytes);
                           }});
        read_text();
        const std::size_t size = word_at(bytes_, at_);
        add(1, Binary::kUint32, {"property.size"});
        constexpr std::array<std::string_view, 4> kLists{"pcvt_lattice", "pcvt_sites",
                                                         "pcvt_site_weights", "pcvt_metric"};
        if (std::find(kLists.begin(), kLists.end(), name) != kLists.end()) {
            add(1, Binary::kUint32, {name + ".length"});
            add((size - 4) / 8, Binary::kFloat64, {name});
        } else {
            add(size / 4, Binary::kInt32, {name});
        }
    }

    const BaseFile& base_;
    std::string bytes_;
    std::size_t at_ = 0;
    std::size_t n_vertices_ = 0;
    std::size_t n_faces_ = 0;
    std::size_t n_halfedges_ = 0;
    std::vector<Field> fields_;
};

}  // namespace

std::vector<Mutant> om_mutants(const BaseFile& base) {
    const auto walk = std::make_shared<OmFields>(base);
    std::vector<Mutant> mutants = mutants_of(walk->fields(), kDigit);
    for (Mutant& mutant : mutants) {
        mutant.files = [walk, files = mutant.files] { return files(); };
    }
    return mutants;
}

std::span<const Harmless> harmless_in_om() {
    static constexpr std::array kHarmless{
        Harmless{"pcvt_site_weights", "", kNotShown, "delaunay"},
        Harmless{"pcvt_site_weights", "", kNotShown, "grains"},
        Harmless{"pcvt_metric", "", kNotShown, "delaunay"},
        Harmless{"pcvt_metric", "", kNotShown, "grains"},
        Harmless{"chunk header", "", "bits of a type that is fixed by the version"},
        Harmless{"vertex.halfedge", "", "another halfedge that leaves the vertex"},
        Harmless{"pcvt_sites", "+1", "lets corners that were joined lie farther off"},
        Harmless{"pcvt_sites", "digit", "lets corners that were joined lie farther off"},
        Harmless{"pcvt_sites", "exchange", "the length of removed edges, the same"},
        Harmless{"face.halfedge", "", "another halfedge of the face"},
        Harmless{"property.name", "", "without pcvt_sites the file is one of an earlier version"},
        Harmless{"position.x", "", "a vertex inside of a grain; the mesh is another one", "grains"},
        Harmless{"position.y", "", "a vertex inside of a grain; the mesh is another one", "grains"},
    };
    return kHarmless;
}

}  // namespace pcvt::testing
