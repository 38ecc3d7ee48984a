#pragma once

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace pcvt::testing {

/// The two chunks of a GLB file, parsed without any of the code under test.
struct Glb {
    nlohmann::json json;
    std::string binary;
};

inline std::uint32_t word_at(const std::string& bytes, std::size_t at) {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + at, sizeof word);
    return word;
}

inline Glb split_glb(const std::string& bytes) {
    const std::size_t json_size = word_at(bytes, 12);
    return {nlohmann::json::parse(bytes.substr(20, json_size)), bytes.substr(28 + json_size)};
}

inline std::string join_glb(std::string json, const std::string& binary) {
    json.append((4 - json.size() % 4) % 4, ' ');
    const auto word = [](std::size_t number) {
        const auto narrow = static_cast<std::uint32_t>(number);
        return std::string(reinterpret_cast<const char*>(&narrow), sizeof narrow);
    };
    return "glTF" + word(2) + word(28 + json.size() + binary.size()) + word(json.size()) + "JSON" +
           json + word(binary.size()) + std::string("BIN\0", 4) + binary;
}

/// The floats of an accessor.
inline std::vector<float> accessor_floats(const Glb& glb, std::size_t accessor, std::size_t width) {
    const auto& object = glb.json["accessors"][accessor];
    const auto& view = glb.json["bufferViews"][object["bufferView"].get<std::size_t>()];
    std::vector<float> floats(object["count"].get<std::size_t>() * width);
    const std::size_t at = view.value("byteOffset", 0u) + object.value("byteOffset", 0u);
    std::memcpy(floats.data(), glb.binary.data() + at, floats.size() * sizeof(float));
    return floats;
}

}  // namespace pcvt::testing
