#include "io/graphics/seam_json.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "io/bytes/json.hpp"
#include "io/bytes/text.hpp"
#include "io/forms/note_table.hpp"

namespace pcvt {
namespace {

constexpr int kSeamVersion = 1;

/// Appends `values` as a JSON list without line breaks.
template <class Values>
void append_list(std::string& text, const Values& values) {
    text += '[';
    for (const auto value : values) {
        if (text.back() != '[') text += ", ";
        append_number(text, value);
    }
    text += ']';
}

/// Appends a named list of rows, one row per line.
template <class Rows, class ToNumbers>
void append_rows(std::string& text, const char* key, const Rows& rows, ToNumbers to_numbers) {
    text += std::string("  \"") + key + "\": [";
    const char* separator = "\n    ";
    for (const auto& row : rows) {
        text += separator;
        append_list(text, to_numbers(row));
        separator = ",\n    ";
    }
    text += "\n  ],\n";
}

void append_sites(std::string& text, const std::vector<SiteId>& sites) {
    text += "  \"sites\": [";
    for (std::size_t k = 0; k < sites.size(); ++k) {
        if (k > 0) text += ',';
        text += k % kSitesALine == 0 ? "\n    " : " ";
        append_number(text, sites[k]);
    }
    text += "\n  ]\n";
}

/// Reads the parts of a seam and names the part that is invalid.
class SeamDecoder {
   public:
    SeamDecoder(const std::string& name, const Json& json) : name_(name), json_(json) {}

    [[noreturn]] void throw_bad_file(const std::string& complaint) const {
        throw BadFile(name_ + ": " + complaint + "; write the file again with pcvt");
    }

    const Json& at(const char* key) const {
        const Json* found = json_.find(key);
        if (found == nullptr) throw_bad_file(std::string("the key \"") + key + "\" is missing");
        return *found;
    }

    const Json& list(const Json& json, const char* key) const {
        if (!json.is_array())
            throw_bad_file(std::string("\"") + key + "\" does not hold lists as it should");
        return json;
    }

    int integer(const Json& json, const char* key) const {
        using Limits = std::numeric_limits<int>;
        // The conversion to a signed number would wrap one of 2^63 or more.
        const bool small = !json.is_number_unsigned() || json.get<std::uint64_t>() <= Limits::max();
        const std::int64_t value = json.is_number_integer() && small
                                       ? json.get<std::int64_t>()
                                       : std::int64_t{Limits::max()} + 1;
        if (value < Limits::min() || value > Limits::max()) {
            throw_bad_file(std::string("\"") + key +
                           "\" holds a value that is not a 32-bit integer");
        }
        return static_cast<int>(value);
    }

    template <std::size_t kWidth>
    std::vector<std::array<int, kWidth>> rows(const char* key) const {
        std::vector<std::array<int, kWidth>> result;
        for (const Json& row : list(at(key), key)) {
            if (list(row, key).size() != kWidth) {
                throw_bad_file(std::string("an entry of \"") + key + "\" does not have " +
                               std::to_string(kWidth) + " numbers");
            }
            auto& numbers = result.emplace_back();
            for (std::size_t k = 0; k < kWidth; ++k) numbers[k] = integer(row[k], key);
        }
        return result;
    }

    plane::Vec2 vector(const Json& json) const {
        const bool good =
            json.is_array() && json.size() == 2 && json[0].is_number() && json[1].is_number();
        if (!good) throw_bad_file("\"lattice\" is not [[ax, ay], [bx, by]]");
        return {json[0].get<double>(), json[1].get<double>()};
    }

    plane::Lattice lattice() const {
        const Json& json = list(at("lattice"), "lattice");
        if (json.size() != 2) throw_bad_file("\"lattice\" is not [[ax, ay], [bx, by]]");
        try {
            return {vector(json[0]), vector(json[1])};
        } catch (const BadFile&) {
            throw;
        } catch (const InvalidInput& fault) {
            throw BadFile(name_ + ": " + fault.what());
        }
    }

   private:
    const std::string& name_;
    const Json& json_;
};

Json parse_json(const std::string& name, std::string_view text) {
    try {
        return Json::parse(text);
    } catch (const JsonFault& fault) {
        const std::string_view before = text.substr(0, fault.byte());
        const auto line = 1 + std::count(before.begin(), before.end(), '\n');
        throw BadFile(name + ":" + std::to_string(line) +
                      ": is not valid JSON; write the file again with pcvt");
    }
}

}  // namespace

std::string encode_seam(const plane::Tile& tile) {
    const plane::Vec2& a = tile.lattice.a();
    const plane::Vec2& b = tile.lattice.b();
    std::string text = "{\n  \"format\": \"pcvt seam\",\n  \"version\": ";
    append_number(text, kSeamVersion);
    text += ",\n  \"kind\": \"" + file_word(tile.kind) + "\",\n  \"lattice\": [";
    append_list(text, a);
    text += ", ";
    append_list(text, b);
    text += "],\n  \"index_base\": 0,\n";
    append_rows(text, "vertex_pairs", tile.vertex_pairs, [](const plane::VertexPair& p) {
        return std::array{p.v, p.w, p.offset.i, p.offset.j};
    });
    append_rows(text, "edge_pairs", tile.edge_pairs, [](const plane::EdgePair& p) {
        return std::array{p.v0, p.v1, p.w0, p.w1, p.offset.i, p.offset.j};
    });
    append_sites(text, faces_have_sites(tile.kind) ? tile.face_site : tile.vertex_site);
    return text + "}\n";
}

Seam decode_seam(const std::string& name, std::string_view text) {
    // Check the format before its content.
    const Json json = parse_json(name, text);
    const SeamDecoder decoder(name, json);
    if (decoder.at("format") != "pcvt seam") decoder.throw_bad_file("it is not a pcvt seam file");
    if (decoder.at("version") != kSeamVersion) decoder.throw_bad_file("its version is not 1");
    if (decoder.at("index_base") != 0) decoder.throw_bad_file("its index base is not 0");
    // Kind and lattice.
    const Json& word = decoder.at("kind");
    const auto kind = word.is_string() ? plane::mesh_kind_of_file_word(word.text()) : std::nullopt;
    if (!kind) decoder.throw_bad_file("its kind is none of cells, triangles and grains");
    Seam seam{.kind = *kind, .lattice = decoder.lattice()};
    // Pairs and sites.
    for (const auto& [v, w, i, j] : decoder.rows<4>("vertex_pairs")) {
        seam.vertex_pairs.push_back({v, w, {i, j}});
    }
    for (const auto& [v0, v1, w0, w1, i, j] : decoder.rows<6>("edge_pairs")) {
        seam.edge_pairs.push_back({.v0 = v0, .v1 = v1, .w0 = w0, .w1 = w1, .offset = {i, j}});
    }
    for (const Json& site : decoder.list(decoder.at("sites"), "sites")) {
        seam.sites.push_back(decoder.integer(site, "sites"));
    }
    return seam;
}

}  // namespace pcvt
