#pragma once

#include <cstdint>
#include <deque>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "io/tiles/encoded_file.hpp"

namespace pcvt {

/// A glTF 2.0 file that carries its own buffers, `.gltf` or `.glb`: JSON and numbers, no meaning
/// yet.
///
/// Whatever the bytes are, each member either returns what is asked for or throws BadFile naming
/// the file: no index, length or type of the file is believed before it is checked.
class GltfDocument {
   public:
    using Json = nlohmann::json;

    /// @param file  must outlive the document.
    /// @throws BadFile also where the file refers to other files, or requires an extension.
    explicit GltfDocument(const EncodedFile& file);

    const Json& root() const { return root_; }

    /// Entry `index` of the table `name` of the root ("nodes", "meshes", ...).
    const Json& entry(const std::string& table, std::size_t index) const;
    /// `number` as an index or a count; `name` is for the message.
    std::size_t count(const Json& number, const std::string& name) const;
    /// object[key] likewise.
    std::size_t count_in(const Json& object, const std::string& key) const;
    std::size_t count_in(const Json& object, const std::string& key, std::size_t otherwise) const;

    /// object[key]; null where the object lacks it, or is none. Never a copy: a copy of deeply
    /// nested JSON, unlike all else here, would take the depth of the file from the stack.
    static const Json& member(const Json& object, const std::string& key);

    /// The numbers of an accessor of floats with `width` components, one after the other; all
    /// finite.
    std::vector<float> floats(std::size_t accessor, std::size_t width) const;
    /// The numbers of an accessor of indices, each below `limit`.
    std::vector<int> indices(std::size_t accessor, std::size_t limit) const;

    /// Throws BadFile `file: complaint`.
    [[noreturn]] void throw_bad_file(const std::string& complaint) const;

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
    /// While buffers are loaded: base64 of the file, taken out before the JSON was parsed.
    std::vector<std::string_view> base64_;
    Json root_;
    std::vector<std::string_view> buffers_;
    /// What the base64 of buffers was decoded to.
    std::deque<std::string> decoded_;
};

}  // namespace pcvt
