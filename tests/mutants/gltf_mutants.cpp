#include <array>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/mutants/mutated_formats.hpp"
#include "tests/support/glb.hpp"

namespace pcvt::testing {
namespace {

using Json = nlohmann::json;

/// Bytes of a .glb file before and behind its JSON.
constexpr std::size_t kHead = 20;
constexpr std::size_t kChunkHead = 8;

/// Returns the name of a value: its path without the numbers of list entries.
std::string name_of(const Json::json_pointer& pointer) {
    std::string name;
    std::string part;
    for (const char c : pointer.to_string() + "/") {
        if (c != '/') {
            part += c;
            continue;
        }
        const bool is_number = part.find_first_not_of("0123456789") == std::string::npos;
        if (!is_number) name += (name.empty() ? "" : ".") + part;
        part.clear();
    }
    return name;
}

/// One value of the JSON, and the rows that hold it.
class JsonMutants {
   public:
    JsonMutants(const BaseFile& base, bool is_binary) : base_(base), is_binary_(is_binary) {
        if (is_binary) {
            Glb glb = split_glb(base.files[0].bytes);
            json_ = std::move(glb.json);
            binary_ = std::move(glb.binary);
        } else {
            json_ = Json::parse(base.files[0].bytes);
        }
    }

    std::vector<Mutant> mutants() {
        visit(json_, Json::json_pointer());
        std::vector<Mutant> mutants = mutants_of(fields_, kDigit);
        mutants.insert(mutants.end(), rows_.begin(), rows_.end());
        return mutants;
    }

    const Json& json() const { return json_; }

   private:
    Files files_of(const Json& json) const {
        const std::string text = json.dump();
        return with_bytes(base_.files, 0, is_binary_ ? join_glb(text, binary_) : text + "\n");
    }

    void visit(const Json& value, const Json::json_pointer& at) {
        if (value.is_structured()) {
            std::size_t k = 0;
            for (const auto& [key, child] : value.items()) {
                visit(child, value.is_array() ? at / k : at / key);
                if (value.is_array()) add_rows(at, k, value.size());
                ++k;
            }
            return;
        }
        const std::string name = name_of(at);
        // The text of the buffer is binary data.
        if (name == "buffers.uri") return;
        const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
        fields_.push_back({name, text, [this, at](const std::string& changed) {
                               Json json = json_;
                               const bool is_string = json[at].is_string();
                               const Json parsed =
                                   is_string ? Json(changed) : Json::parse(changed, nullptr, false);
                               json[at] = parsed.is_discarded() ? Json(changed) : parsed;
                               return files_of(json);
                           }});
    }

    void add_rows(const Json::json_pointer& list, std::size_t k, std::size_t n) {
        const std::string name = name_of(list) + " row";
        rows_.push_back({name, "delete", [this, list, k] {
                             Json json = json_;
                             json[list].erase(k);
                             return files_of(json);
                         }});
        rows_.push_back({name, "duplicate", [this, list, k] {
                             Json json = json_;
                             Json& rows = json[list];
                             const Json row = rows[k];
                             rows.insert(rows.begin() + static_cast<std::ptrdiff_t>(k), row);
                             return files_of(json);
                         }});
        if (k + 1 == n || json_[list][k] == json_[list][k + 1]) return;
        rows_.push_back({name, "swap", [this, list, k] {
                             Json json = json_;
                             std::swap(json[list][k], json[list][k + 1]);
                             return files_of(json);
                         }});
    }

    const BaseFile& base_;
    bool is_binary_;
    Json json_;
    std::string binary_;
    std::vector<Field> fields_;
    std::vector<Mutant> rows_;
};

/// Returns the names of the components of the numbers of each accessor.
std::map<std::size_t, std::vector<std::string>> accessor_names(const Json& json) {
    std::map<std::size_t, std::vector<std::string>> names;
    const std::array<const char*, 3> parts{".x", ".y", ".z"};
    const auto note = [&](std::size_t accessor, const std::string& name) {
        const std::string type = json["accessors"][accessor]["type"];
        const std::size_t width = type == "SCALAR" ? 1 : type == "VEC2" ? 2 : 3;
        names[accessor].clear();
        for (std::size_t k = 0; k < width; ++k) {
            names[accessor].push_back(width == 1 ? name : name + parts[k]);
        }
    };
    for (const Json& mesh : json["meshes"]) {
        const std::string of = mesh["name"] == "outlines" ? "outlines " : "";
        for (const Json& primitive : mesh["primitives"]) {
            note(primitive["indices"], of + "index");
            for (const auto& [key, accessor] : primitive["attributes"].items()) {
                note(accessor, of + key);
            }
        }
    }
    const Json& periodic = json["nodes"][0]["extras"]["periodic"];
    for (const char* key : {"sitePositions", "siteWeights"}) {
        if (periodic.contains(key)) note(periodic[key], key);
    }
    return names;
}

std::vector<Field> buffer_fields(const BaseFile& base, const Json& json) {
    std::vector<Field> fields;
    const std::size_t head = kHead + kChunkHead + word_at(base.files[0].bytes, 12);
    for (const auto& [k, names] : accessor_names(json)) {
        const Json& accessor = json["accessors"][k];
        const Json& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
        const std::size_t at = head + view.value("byteOffset", std::size_t{0}) +
                               accessor.value("byteOffset", std::size_t{0});
        const int component = accessor["componentType"];
        const Binary type = component == 5126   ? Binary::kFloat32
                            : component == 5123 ? Binary::kUint16
                                                : Binary::kUint32;
        const std::size_t n = accessor["count"].get<std::size_t>() * names.size();
        const auto more = binary_fields(base.files, 0, at, n, type, names);
        fields.insert(fields.end(), more.begin(), more.end());
    }
    return fields;
}

/// The results keep the JSON that they refer to.
std::vector<Mutant> mutants_of_json(const BaseFile& base, bool is_binary) {
    const auto json = std::make_shared<JsonMutants>(base, is_binary);
    std::vector<Mutant> mutants = json->mutants();
    for (Mutant& mutant : mutants) {
        mutant.files = [json, files = mutant.files] { return files(); };
    }
    return mutants;
}

}  // namespace

std::vector<Mutant> gltf_mutants(const BaseFile& base) { return mutants_of_json(base, false); }

std::vector<Mutant> glb_mutants(const BaseFile& base) {
    std::vector<Mutant> mutants = mutants_of_json(base, true);
    const Json json = split_glb(base.files[0].bytes).json;
    for (const Mutant& mutant : mutants_of(buffer_fields(base, json), kDigit)) {
        mutants.push_back(mutant);
    }
    const std::vector<std::string> head{"glb header"};
    for (const Mutant& mutant :
         mutants_of(binary_fields(base.files, 0, 4, 3, Binary::kUint32, head), kDigit)) {
        mutants.push_back(mutant);
    }
    return mutants;
}

std::span<const Harmless> harmless_in_gltf() {
    static constexpr std::array kHarmless{
        Harmless{"sitePositions.x", "digit", kStretched, "voronoi power"},
        Harmless{"sitePositions.y", "digit", kStretched, "voronoi power"},
        Harmless{"sitePositions.x", "digit", kStretched, "delaunay power"},
        Harmless{"sitePositions.y", "digit", kStretched, "delaunay power"},
        Harmless{"nodes.extras.periodic.metric", "digit", kStretched, "voronoi power"},
        Harmless{"siteWeights", "digit", kStretched, "voronoi power"},
        Harmless{"siteWeights", "", kNotShown, "delaunay"},
        Harmless{"siteWeights", "", kNotShown, "grains"},
        Harmless{"nodes.extras.periodic.metric*", "", kNotShown, "delaunay"},
        Harmless{"nodes.extras.periodic.metric*", "", kNotShown, "grains"},
        Harmless{"sitePositions.x", "digit", kSingle, "voronoi short-edges"},
        Harmless{"sitePositions.y", "digit", kSingle, "voronoi short-edges"},
        Harmless{"sitePositions.x", "digit", kSingle, "grains"},
        Harmless{"sitePositions.y", "digit", kSingle, "grains"},
        Harmless{"asset.generator", "", "a file of another program proves less"},
        Harmless{"materials.pbrMetallicRoughness.*", "", "colours have no meaning for the tile"},
        Harmless{"materials.name", "", "names of colours"},
        Harmless{"materials.doubleSided", "", "how a face looks from below"},
        Harmless{"nodes.name", "word", "the name of the node of all cells"},
        Harmless{"nodes.extras.periodic.shortEdges", "", "lets joined corners lie farther off"},
        Harmless{"materials row", "swap", "names and colours of one node"},
        Harmless{"nodes.extras.periodic.vertexPairs row", "swap", "the order of pairs"},
        Harmless{"nodes.extras.periodic.vertexPairs row", "duplicate", "says the same twice"},
        Harmless{"COLOR_0.x", "", "colours have no meaning for the tile"},
        Harmless{"COLOR_0.y", "", "colours have no meaning for the tile"},
        Harmless{"COLOR_0.z", "", "colours have no meaning for the tile"},
    };
    return kHarmless;
}

}  // namespace pcvt::testing
