#include "io/page/html_writer.hpp"

#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/page/page_parts.hpp"
#include "io/tiles/finite.hpp"
#include "mesher/tile/tile_valence.hpp"

namespace pcvt {
namespace {

constexpr int kVersion = 1;

/// Appends `values` as a JSON list.
template <class Values>
void append_list(std::string& text, const Values& values) {
    text += '[';
    for (const auto value : values) {
        if (text.back() != '[') text += ',';
        append_number(text, value);
    }
    text += ']';
}

void append_points(std::string& text, const std::vector<Vec2>& points) {
    text += '[';
    for (const Vec2& p : points) {
        if (text.back() != '[') text += ',';
        append_number(text, p.x());
        text += ',';
        append_number(text, p.y());
    }
    text += ']';
}

/// Appends a list of `n` lists, one a line.
template <class ToNumbers>
void append_rows(std::string& text, int n, ToNumbers to_numbers) {
    text += '[';
    for (int k = 0; k < n; ++k) {
        text += k == 0 ? "\n" : ",\n";
        append_list(text, to_numbers(k));
    }
    text += ']';
}

void append_key(std::string& text, const char* key) {
    text += ",\n\"";
    text += key;
    text += "\": ";
}

/// Returns the JSON string of a text, with escapes for quotes, controls and what is a mark in HTML.
std::string json_string(std::string_view text) {
    constexpr std::string_view kHexDigits = "0123456789abcdef";
    constexpr std::string_view kEscaped = "\"\\<>&";
    std::string json = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x20 && kEscaped.find(c) == std::string_view::npos) {
            json += c;
        } else {
            json += "\\u00";
            json += kHexDigits[byte / 16];
            json += kHexDigits[byte % 16];
        }
    }
    return json + '"';
}

std::string html_text(std::string_view text) {
    constexpr std::array<std::pair<char, std::string_view>, 4> kEntities{
        {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}}};
    std::string html;
    for (const char c : text) {
        std::string_view written(&c, 1);
        for (const auto& [mark, entity] : kEntities) {
            if (c == mark) written = entity;
        }
        html += written;
    }
    return html;
}

std::string page_data(const Tile& tile, std::span<const double> densities,
                      const std::string& name) {
    const bool owned = faces_have_sites(tile.kind);
    std::string text = "{\"format\": \"pcvt page\", \"version\": ";
    append_number(text, kVersion);
    append_key(text, "name");
    text += json_string(name);
    append_key(text, "graded");
    text += densities.empty() ? "false" : "true";
    append_key(text, "kind");
    text += json_string(file_word(tile.kind));
    append_key(text, "lattice");
    append_rows(text, 2, [&](int k) { return k == 0 ? tile.lattice.a() : tile.lattice.b(); });
    append_key(text, "points");
    append_points(text, tile.points);
    append_key(text, "faces");
    append_rows(text, tile.n_faces(), [&](int f) { return tile.faces[f]; });
    append_key(text, "sites");
    append_list(text, owned ? tile.face_site : tile.vertex_site);
    append_key(text, "sides");
    append_list(text, owned ? cell_sides(tile) : vertex_valences(tile));
    append_key(text, "site_points");
    append_points(text, tile.site_points);
    append_key(text, "densities");
    append_list(text, densities);
    append_key(text, "vertex_pairs");
    append_rows(text, static_cast<int>(tile.vertex_pairs.size()), [&](int k) {
        const VertexPair& p = tile.vertex_pairs[static_cast<std::size_t>(k)];
        return std::array{p.v, p.w, p.offset.i, p.offset.j};
    });
    append_key(text, "edge_pairs");
    append_rows(text, static_cast<int>(tile.edge_pairs.size()), [&](int k) {
        const EdgePair& p = tile.edge_pairs[static_cast<std::size_t>(k)];
        return std::array{p.v0, p.v1, p.w0, p.w1, p.offset.i, p.offset.j};
    });
    return text + "}";
}

/// Returns the page with its marks replaced. Replaced parts are not searched for marks.
std::string fill_page(const std::string& title, const std::string& data) {
    const std::array<std::pair<std::string_view, std::string_view>, 4> parts{
        {{"@TITLE@", title}, {"@STYLE@", kPageStyle}, {"@DATA@", data}, {"@SCRIPT@", kPageScript}}};
    std::string page;
    std::string_view rest = kPageHtml;
    while (true) {
        std::size_t nearest = std::string_view::npos;
        const std::pair<std::string_view, std::string_view>* next = nullptr;
        for (const auto& part : parts) {
            const std::size_t at = rest.find(part.first);
            if (at < nearest) {
                nearest = at;
                next = &part;
            }
        }
        page += rest.substr(0, nearest);
        if (next == nullptr) return page;
        page += next->second;
        rest.remove_prefix(nearest + next->first.size());
    }
}

}  // namespace

std::vector<EncodedFile> encode_html(const Tile& tile, const std::string& path) {
    return encode_graded_html(tile, {}, path);
}

std::vector<EncodedFile> encode_graded_html(const Tile& tile,
                                            std::span<const double> site_densities,
                                            const std::string& path) {
    require_finite(tile);
    const std::string name = std::filesystem::path(path).filename().string();
    return only_file(path, fill_page(html_text(name), page_data(tile, site_densities, name)));
}

}  // namespace pcvt
