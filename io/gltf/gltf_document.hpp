#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "io/bytes/json.hpp"

namespace pcvt {

/// The mode of a primitive of triangles. Points and lines have smaller modes, strips and fans of
/// triangles have larger ones.
inline constexpr std::size_t kGltfTriangles = 4;

/// A glTF 2.0 file with embedded buffers, `.gltf` or `.glb`: its JSON and its numbers, without
/// their meaning for a tile.
///
/// For arbitrary bytes, each member either returns a valid result or throws BadFile naming the
/// file: every index, length and type in the file is checked before it is used.
class GltfDocument {
   public:
    /// @param file  must outlive the document.
    /// @throws BadFile also if the file refers to other files or requires an extension.
    explicit GltfDocument(const EncodedFile& file);

    const Json& root() const { return root_; }
    const std::string& path() const { return path_; }

    /// Returns entry `index` of the list `table` of the root ("nodes", "meshes", ...).
    const Json& entry(const std::string& table, std::size_t index) const;
    /// Returns `number` as an index or a count; a message calls it `name`.
    std::size_t count(const Json& number, const std::string& name) const;
    /// Returns object[key] as an index or a count; `otherwise` if the object lacks the key.
    std::size_t count_in(const Json& object, const std::string& key) const;
    std::size_t count_in(const Json& object, const std::string& key, std::size_t otherwise) const;
    /// Returns the name of the material of a primitive; "" if it has none.
    std::string material_name(const Json& primitive) const;

    /// Returns object[key]; null if `object` lacks the key or is not an object.
    static const Json& member(const Json& object, const std::string& key);
    /// Returns extras.periodic of a node; null if it has none.
    static const Json& periodic(const Json& node) {
        return member(member(node, "extras"), "periodic");
    }
    /// Returns the numbers of a list of n numbers; none if `value` has another form.
    static std::vector<double> number_list(const Json& value, std::size_t n);
    /// Returns the numbers of a list of lists of n numbers, one list after the other; none if
    /// `rows` has another form.
    static std::vector<double> vector_list(const Json& rows, std::size_t n);
    /// Whether pcvt wrote the file, and no other program since.
    bool is_own() const { return member(member(root_, "asset"), "generator") == "pcvt"; }

    /// Returns the numbers of an accessor of floats, element by element with `width` components
    /// each; all are finite.
    std::vector<float> floats(std::size_t accessor, std::size_t width) const;
    /// Returns the numbers of an accessor of indices; all are below `limit`.
    std::vector<int> indices(std::size_t accessor, std::size_t limit) const;

    /// Throws BadFile `file: complaint`.
    [[noreturn]] void throw_bad_file(const std::string& complaint) const;
    /// @throws UnusableFile  in the same form.
    [[noreturn]] void throw_unusable(const std::string& complaint) const;

   private:
    /// The bytes of an accessor: element k begins at data + k * stride.
    struct Elements {
        const unsigned char* data;
        std::size_t n;
        std::size_t stride;
        int component_type;
    };

    void parse_json(std::string_view text);
    std::string_view split_binary(std::string_view bytes);
    std::string_view base64_of(std::string_view text) const;
    void load_buffer(const Json& buffer, std::size_t index, std::string_view binary_chunk);
    Elements elements(std::size_t accessor, const std::string& type, std::size_t width) const;

    std::string path_;
    /// While buffers are loaded: the base64 texts, which are removed before the JSON is parsed.
    std::vector<std::string_view> base64_;
    Json root_;
    std::vector<std::string_view> buffers_;
    /// The decoded bytes of buffers in base64; `buffers_` points into them.
    std::deque<std::string> decoded_;
};

}  // namespace pcvt
