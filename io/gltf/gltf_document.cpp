#include "io/gltf/gltf_document.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "io/bytes/bad_file.hpp"
#include "io/bytes/base64.hpp"
#include "io/gltf/gltf_container.hpp"

namespace pcvt {
namespace {

constexpr std::string_view kMagic = "glTF";
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;
/// Keeps sums and products of two counts far below 2^64.
constexpr std::size_t kMaxCount = std::numeric_limits<std::uint32_t>::max() / 2;

enum ComponentType { kByte = 5121, kShort = 5123, kInt = 5125, kFloat = 5126 };

/// Reads a little-endian number of `width` bytes.
std::uint32_t little_endian(const void* data, std::size_t width) {
    const auto* bytes = static_cast<const unsigned char*>(data);
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < width; ++k) value |= std::uint32_t{bytes[k]} << (8 * k);
    return value;
}

std::size_t component_width(int component_type) {
    switch (component_type) {
        case kByte:
            return 1;
        case kShort:
            return 2;
        case kInt:
        case kFloat:
            return 4;
        default:
            return 0;
    }
}

constexpr std::string_view kBase64Mark = ";base64,";

/// Returns the JSON without the base64 texts of its data URIs, which parses much faster. `taken`
/// receives the texts; #k, which is not valid base64, replaces taken[k].
std::string without_base64(std::string_view text, std::vector<std::string_view>& taken) {
    std::string json;
    while (!text.empty()) {
        const std::size_t mark = text.find(kBase64Mark);
        const std::size_t begin =
            mark == std::string_view::npos ? text.size() : mark + kBase64Mark.size();
        json += text.substr(0, begin);
        text.remove_prefix(begin);
        const std::size_t length = base64_length(text);
        if (length == 0 || !text.substr(length).starts_with('"')) continue;
        json += '#' + std::to_string(taken.size());
        taken.push_back(text.substr(0, length));
        text.remove_prefix(length);
    }
    return json;
}

}  // namespace

void GltfDocument::throw_bad_file(const std::string& complaint) const {
    throw BadFile(path_ + ": " + complaint);
}

void GltfDocument::throw_unusable(const std::string& complaint) const {
    throw UnusableFile(path_ + ": " + complaint);
}

const Json& GltfDocument::member(const Json& object, const std::string& key) {
    static const Json kNull;
    const Json* found = object.find(key);
    return found == nullptr ? kNull : *found;
}

std::vector<double> GltfDocument::number_list(const Json& value, std::size_t n) {
    std::vector<double> result;
    if (!value.is_array() || value.size() != n) return result;
    for (const Json& number : value) {
        if (!number.is_number()) return {};
        result.push_back(number.get<double>());
    }
    return result;
}

std::vector<double> GltfDocument::vector_list(const Json& rows, std::size_t n) {
    std::vector<double> result;
    for (const Json& row : rows) {
        const std::vector<double> vector = number_list(row, n);
        if (vector.empty()) return {};
        result.insert(result.end(), vector.begin(), vector.end());
    }
    return result;
}

std::size_t GltfDocument::count(const Json& number, const std::string& name) const {
    if (!number.is_number_unsigned() || number.get<std::uint64_t>() > kMaxCount) {
        throw_bad_file("'" + name + "' of a glTF object is not a count; export the file again");
    }
    return number.get<std::size_t>();
}

std::size_t GltfDocument::count_in(const Json& object, const std::string& key) const {
    if (!object.contains(key))
        throw_bad_file("a glTF object lacks '" + key + "'; export the file again");
    return count(member(object, key), key);
}

std::size_t GltfDocument::count_in(const Json& object, const std::string& key,
                                   std::size_t otherwise) const {
    return object.contains(key) ? count_in(object, key) : otherwise;
}

const Json& GltfDocument::entry(const std::string& table, std::size_t index) const {
    const Json& entries = member(root_, table);
    if (!entries.is_array() || index >= entries.size() || !entries[index].is_object()) {
        throw_bad_file("there is no entry " + std::to_string(index) + " in '" + table +
                       "'; export the file again");
    }
    return entries[index];
}

std::string GltfDocument::material_name(const Json& primitive) const {
    if (!primitive.contains("material")) return "";
    const Json& name = member(entry("materials", count_in(primitive, "material")), "name");
    return name.is_string() ? std::string(name.text()) : "";
}

GltfDocument::Elements GltfDocument::elements(std::size_t accessor, const std::string& type,
                                              std::size_t width) const {
    // The accessor gives the size of its elements.
    const std::string name = "accessor " + std::to_string(accessor);
    const Json& object = entry("accessors", accessor);
    if (object.contains("sparse")) throw_bad_file(name + " is sparse; export plain accessors");
    if (member(object, "type") != type) throw_bad_file(name + " does not hold " + type + "s");
    const int component_type = static_cast<int>(count_in(object, "componentType"));
    const std::size_t element_size = width * component_width(component_type);
    if (element_size == 0) throw_bad_file(name + " has a component type that pcvt does not read");
    // The buffer view gives their position and stride in a buffer.
    const Json& view = entry("bufferViews", count_in(object, "bufferView"));
    const std::size_t buffer = count_in(view, "buffer");
    if (buffer >= buffers_.size()) throw_bad_file("there is no buffer " + std::to_string(buffer));
    const std::size_t view_offset = count_in(view, "byteOffset", 0);
    const std::size_t view_length = count_in(view, "byteLength");
    const std::size_t stride = count_in(view, "byteStride", element_size);
    const std::size_t offset = count_in(object, "byteOffset", 0);
    const std::size_t n = count_in(object, "count");
    // The view lies inside its buffer, and the elements lie inside the view.
    if (view_offset + view_length > buffers_[buffer].size()) {
        throw_bad_file("a buffer view of " + name + " leaves its buffer; the file is damaged");
    }
    if (n == 0 || stride < element_size || offset + (n - 1) * stride + element_size > view_length) {
        throw_bad_file(name + " leaves its buffer view; the file is damaged");
    }
    const char* data = buffers_[buffer].data() + view_offset + offset;
    return {reinterpret_cast<const unsigned char*>(data), n, stride, component_type};
}

std::vector<float> GltfDocument::floats(std::size_t accessor, std::size_t width) const {
    const Elements from =
        elements(accessor, width == 1 ? "SCALAR" : "VEC" + std::to_string(width), width);
    if (from.component_type != kFloat) {
        throw_bad_file("accessor " + std::to_string(accessor) + " does not hold floats");
    }
    std::vector<float> numbers;
    numbers.reserve(from.n * width);
    for (std::size_t k = 0; k < from.n * width; ++k) {
        const unsigned char* data = from.data + k / width * from.stride + k % width * sizeof(float);
        numbers.push_back(Eigen::numext::bit_cast<float>(little_endian(data, sizeof(float))));
        if (!std::isfinite(numbers.back())) {
            throw_bad_file("element " + std::to_string(k / width) + " of accessor " +
                           std::to_string(accessor) + " is not finite");
        }
    }
    return numbers;
}

std::vector<int> GltfDocument::indices(std::size_t accessor, std::size_t limit) const {
    const Elements from = elements(accessor, "SCALAR", 1);
    if (from.component_type == kFloat) {
        throw_bad_file("accessor " + std::to_string(accessor) + " does not hold indices");
    }
    const std::size_t width = component_width(from.component_type);
    std::vector<int> numbers;
    numbers.reserve(from.n);
    for (std::size_t k = 0; k < from.n; ++k) {
        const std::uint32_t index = little_endian(from.data + k * from.stride, width);
        if (index >= limit) {
            throw_bad_file("index " + std::to_string(index) + " in accessor " +
                           std::to_string(accessor) + " is beyond the last vertex, " +
                           std::to_string(limit - 1));
        }
        numbers.push_back(static_cast<int>(index));
    }
    return numbers;
}

void GltfDocument::parse_json(std::string_view text) {
    try {
        root_ = Json::parse(text);
    } catch (const JsonFault& fault) {
        if (fault.kind() != JsonFault::Kind::kSyntax) throw_bad_file(fault.what());
        const std::string_view before = text.substr(0, fault.byte());
        const auto line = 1 + std::count(before.begin(), before.end(), '\n');
        throw BadFile(path_ + ":" + std::to_string(line) +
                      ": not JSON; give a .gltf or .glb file that is complete");
    }
    if (member(member(root_, "asset"), "version") != "2.0") throw_bad_file("not glTF 2.0");
    if (root_.contains("extensionsRequired")) {
        throw_bad_file("requires a glTF extension; export without compression or quantisation");
    }
}

/// Parses the JSON chunk; returns the binary chunk, empty if there is none.
std::string_view GltfDocument::split_binary(std::string_view bytes) {
    // The header holds version and length of the file.
    const auto number = [&](std::size_t at) { return little_endian(bytes.data() + at, 4); };
    if (bytes.size() < kGlbHeaderSize || number(4) != kGlbVersion || number(8) != bytes.size()) {
        throw_bad_file("not a complete GLB file of version 2; copy or export it again");
    }
    // The JSON is the first chunk, the buffer is the first binary chunk after it.
    std::string_view json;
    std::string_view binary;
    for (std::size_t at = kGlbHeaderSize; at < bytes.size();) {
        if (bytes.size() - at < kGlbChunkHeaderSize ||
            bytes.size() - at - kGlbChunkHeaderSize < number(at)) {
            throw_bad_file("a GLB chunk leaves the file; copy or export it again");
        }
        const bool first = at == kGlbHeaderSize;
        const std::string_view chunk = bytes.substr(at + kGlbChunkHeaderSize, number(at));
        if (first && number(at + 4) == kJsonChunk) json = chunk;
        if (!first && binary.empty() && number(at + 4) == kBinaryChunk) binary = chunk;
        at += kGlbChunkHeaderSize + chunk.size();
    }
    if (json.empty()) throw_bad_file("the first GLB chunk is not JSON; copy or export it again");
    parse_json(json);
    return binary;
}

/// Returns the base64 text that without_base64() replaced by `text`, if that is a mark #k; else
/// `text` itself.
std::string_view GltfDocument::base64_of(std::string_view text) const {
    std::size_t k = 0;
    if (!text.starts_with('#')) return text;
    const auto [stop, fault] = std::from_chars(text.data() + 1, text.data() + text.size(), k);
    const bool known =
        fault == std::errc() && stop == text.data() + text.size() && k < base64_.size();
    return known ? base64_[k] : text;
}

void GltfDocument::load_buffer(const Json& buffer, std::size_t index,
                               std::string_view binary_chunk) {
    const std::size_t length = count_in(buffer, "byteLength");
    const Json& uri = member(buffer, "uri");
    // The first buffer of a .glb file is its binary chunk; every other buffer is a data URI.
    std::string_view bytes;
    if (uri.is_null() && index == 0) {
        bytes = binary_chunk;
    } else if (uri.is_string()) {
        const auto& text = uri.text();
        const std::size_t mark = text.find(kBase64Mark);
        if (!text.starts_with("data:") || mark == std::string::npos) {
            throw_bad_file(
                "keeps its buffer in another file; export it with embedded buffers or as .glb");
        }
        if (!decode_base64(base64_of(std::string_view(text).substr(mark + kBase64Mark.size())),
                           decoded_.emplace_back())) {
            throw_bad_file("the base64 of its buffer is damaged");
        }
        bytes = decoded_.back();
    }
    // Bytes beyond byteLength are padding.
    if (bytes.size() < length)
        throw_bad_file("its buffer is shorter than byteLength; the file is damaged");
    buffers_.push_back(bytes.substr(0, length));
}

GltfDocument::GltfDocument(const EncodedFile& file) : path_(file.path) {
    std::string_view binary_chunk;
    if (file.bytes.starts_with(kMagic)) {
        binary_chunk = split_binary(file.bytes);
    } else {
        parse_json(without_base64(file.bytes, base64_));
    }
    const std::size_t n = member(root_, "buffers").size();
    for (std::size_t k = 0; k < n; ++k) load_buffer(entry("buffers", k), k, binary_chunk);
    base64_.clear();
}

}  // namespace pcvt
