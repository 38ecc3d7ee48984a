#include "io/gltf/gltf_layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/forms/site_notes.hpp"

namespace pcvt {
namespace {

constexpr std::size_t kFloatComponent = 5126;
constexpr std::size_t kShortComponent = 5123;
constexpr std::size_t kAttributeTarget = 34962;
constexpr std::size_t kIndexTarget = 34963;
constexpr std::size_t kLines = 1;
/// Bounds are compared within this many ulps of the largest.
constexpr double kBoundUlps = 4;

class LayoutProof {
   public:
    explicit LayoutProof(const GltfDocument& document) : document_(document) {}

    void require() {
        read_views();
        for (std::size_t k = 0; k < size_of("accessors"); ++k) require_accessor(k);
        require_buffer();
        require_scene();
        for (std::size_t k = 1; k < size_of("nodes"); ++k) require_node(k);
        require_equal(next_mesh_, size_of("meshes"), "a mesh has no node");
        require_equal(next_material_, size_of("materials"), "a material has no primitive");
        require_all_used();
    }

   private:
    struct View {
        std::size_t offset;
        std::size_t length;
        std::size_t target;
        /// The bytes of the accessors so far.
        std::size_t filled = 0;
    };

    [[noreturn]] void throw_bad(const std::string& complaint) const {
        document_.throw_bad_file(complaint + "; write the file again with pcvt");
    }
    void require_equal(std::size_t found, std::size_t wanted, const std::string& complaint) const {
        if (found != wanted) throw_bad(complaint);
    }
    std::size_t size_of(const std::string& table) const {
        return GltfDocument::member(document_.root(), table).size();
    }
    std::string text(const Json& object, const std::string& key) const {
        const Json& value = GltfDocument::member(object, key);
        return value.is_string() ? value.text() : "";
    }

    void read_views() {
        std::size_t end = 0;
        for (std::size_t k = 0; k < size_of("bufferViews"); ++k) {
            const Json& view = document_.entry("bufferViews", k);
            require_equal(document_.count_in(view, "buffer"), 0, "a view is of another buffer");
            views_.push_back({document_.count_in(view, "byteOffset", 0),
                              document_.count_in(view, "byteLength"),
                              document_.count_in(view, "target")});
            if (view.contains("byteStride"))
                throw_bad("view " + std::to_string(k) + " has a stride");
            require_equal(views_.back().offset, end,
                          "view " + std::to_string(k) + " does not follow the view before it");
            end += (views_.back().length + 3) / 4 * 4;
        }
        end_ = end;
    }

    void require_buffer() const {
        for (std::size_t k = 0; k < views_.size(); ++k) {
            require_equal(views_[k].filled, views_[k].length,
                          "the accessors do not fill view " + std::to_string(k));
        }
        require_equal(size_of("buffers"), 1, "there is not one buffer");
        require_equal(document_.count_in(document_.entry("buffers", 0), "byteLength"), end_,
                      "the views do not fill the buffer");
    }

    void require_accessor(std::size_t k) {
        const Json& accessor = document_.entry("accessors", k);
        const std::string name = "accessor " + std::to_string(k);
        const std::size_t v = document_.count_in(accessor, "bufferView");
        if (v >= views_.size()) throw_bad(name + " has no view");
        View& view = views_[v];
        require_equal(document_.count_in(accessor, "byteOffset", 0), view.filled,
                      name + " does not follow the accessor before it");
        const std::size_t component = document_.count_in(accessor, "componentType");
        const std::string type = text(accessor, "type");
        const std::size_t n = type == "SCALAR" ? 1 : type == "VEC2" ? 2 : 3;
        view.filled +=
            document_.count_in(accessor, "count") * n * (component == kShortComponent ? 2 : 4);
        require_equal(view.target, component == kFloatComponent ? kAttributeTarget : kIndexTarget,
                      name + " has a view with another target");
        used_.push_back(0);
        has_bounds_.push_back(accessor.contains("min") || accessor.contains("max"));
    }

    void require_scene() const {
        const Json& root = document_.root();
        require_equal(size_of("scenes"), 1, "there is not one scene");
        require_equal(document_.count_in(root, "scene"), 0, "another scene is shown");
        const Json& extensions = GltfDocument::member(root, "extensionsUsed");
        if (extensions.size() != 1 || extensions[0] != "KHR_materials_unlit") {
            throw_bad("the outlines use another extension");
        }
        if (text(document_.entry("nodes", 0), "name") != "tile")
            throw_bad("node 0 is not the tile");
        const Json& translation = GltfDocument::member(document_.entry("nodes", 0), "translation");
        if (translation.size() == 3 &&
            !(translation[2].is_number() && translation[2].get<double>() == 0)) {
            throw_bad("the tile is moved along z");
        }
        const Json& nodes = GltfDocument::member(document_.entry("scenes", 0), "nodes");
        if (nodes.size() != 1 || nodes[0] != 0) throw_bad("the scene does not show only node 0");
        const Json& children = GltfDocument::member(document_.entry("nodes", 0), "children");
        require_equal(children.size() + 1, size_of("nodes"), "a node is not a child of node 0");
        for (std::size_t k = 0; k < children.size(); ++k) {
            if (children[k] != k + 1) throw_bad("the children of node 0 are not in order");
        }
    }

    void require_node(std::size_t k) {
        const Json& node = document_.entry("nodes", k);
        const std::string name = text(node, "name");
        const bool is_last = k + 1 == size_of("nodes");
        require_equal(document_.count_in(node, "mesh"), next_mesh_++, name + " has another mesh");
        if (node.contains("children")) throw_bad(name + " has children");
        if (node.contains("translation")) throw_bad(name + " has a translation");
        const Json& mesh = document_.entry("meshes", k - 1);
        if (text(mesh, "name") != name || name.empty() || (name == "outlines") != is_last) {
            throw_bad("node " + std::to_string(k) + " has not the name of its mesh");
        }
        const Json& primitives = GltfDocument::member(mesh, "primitives");
        if (!primitives.is_array() || primitives.size() == 0)
            throw_bad(name + " has no primitives");
        const bool is_cell = name.starts_with("cell_");
        if (is_cell || is_last) require_equal(primitives.size(), 1, name + " is more than one");
        for (const Json& primitive : primitives) {
            require_equal(document_.count_in(primitive, "mode", kGltfTriangles),
                          is_last ? kLines : kGltfTriangles, name + " has another mode");
            require_primitive(primitive, is_cell ? name : "");
        }
    }

    void require_primitive(const Json& primitive, const std::string& material_name) {
        const std::size_t m = document_.count_in(primitive, "material");
        require_equal(m, next_material_++, "the materials are not in order");
        const Json& material = document_.entry("materials", m);
        if (!material_name.empty() && text(material, "name") != material_name) {
            throw_bad("the material of " + material_name + " has another name");
        }
        use(document_.count_in(primitive, "indices"), false);
        const Json& attributes = GltfDocument::member(primitive, "attributes");
        if (!attributes.is_object()) throw_bad("a primitive has no attributes");
        for (const auto& [name, accessor] : attributes.members()) {
            use(document_.count(accessor, name), name == "POSITION");
        }
    }

    /// Notes that an accessor is used, and proves its bounds at the first time.
    void use(std::size_t accessor, bool is_position) {
        if (accessor >= used_.size()) throw_bad("a primitive names an accessor that is missing");
        if (++used_[accessor] > 1) return;
        if (is_position) require_bounds(accessor);
        if (is_position != has_bounds_[accessor]) {
            throw_bad("accessor " + std::to_string(accessor) +
                      (is_position ? " lacks its bounds" : " has bounds"));
        }
    }

    void require_bounds(std::size_t accessor) const {
        const std::vector<float> numbers = document_.floats(accessor, 3);
        std::array<double, 3> least{numbers[0], numbers[1], numbers[2]};
        std::array<double, 3> most = least;
        double largest = 0;
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            least[k % 3] = std::min<double>(least[k % 3], numbers[k]);
            most[k % 3] = std::max<double>(most[k % 3], numbers[k]);
            largest = std::max(largest, std::abs(double(numbers[k])));
        }
        const double allowed = kBoundUlps * double(std::numeric_limits<float>::epsilon()) * largest;
        const Json& object = document_.entry("accessors", accessor);
        require_bound(accessor, GltfDocument::member(object, "min"), least, allowed);
        require_bound(accessor, GltfDocument::member(object, "max"), most, allowed);
    }

    void require_bound(std::size_t accessor, const Json& stated, const std::array<double, 3>& found,
                       double allowed) const {
        bool same = stated.is_array() && stated.size() == found.size();
        for (std::size_t k = 0; same && k < found.size(); ++k) {
            same = stated[k].is_number() && std::abs(stated[k].get<double>() - found[k]) <= allowed;
        }
        if (same) return;
        throw_bad("the bounds of accessor " + std::to_string(accessor) + " are not its own");
    }

    void require_all_used() {
        const Json& periodic = GltfDocument::periodic(document_.entry("nodes", 0));
        for (const SiteNote& note : site_notes()) {
            const std::string member(note.member);
            const Json& value = GltfDocument::member(periodic, member);
            if (note.of_each_site && !value.is_null()) use(document_.count(value, member), false);
        }
        for (std::size_t k = 0; k < used_.size(); ++k) {
            if (used_[k] == 0) throw_bad("nothing uses accessor " + std::to_string(k));
        }
    }

    const GltfDocument& document_;
    std::vector<View> views_;
    std::size_t end_ = 0;
    /// The number of uses of each accessor, and whether it states bounds.
    std::vector<int> used_;
    std::vector<bool> has_bounds_;
    std::size_t next_mesh_ = 0;
    std::size_t next_material_ = 0;
};

}  // namespace

bool is_own_gltf(const GltfDocument& document) {
    const Json& nodes = GltfDocument::member(document.root(), "nodes");
    return document.is_own() && nodes.is_array() && nodes.size() > 0 &&
           GltfDocument::periodic(nodes[0]).contains("sitePositions");
}

void require_own_layout(const GltfDocument& document) { LayoutProof(document).require(); }

}  // namespace pcvt
