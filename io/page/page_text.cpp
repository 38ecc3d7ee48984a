#include "io/page/page_text.hpp"

#include <array>

namespace pcvt {

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

std::string filled_page(std::string_view page,
                        const std::vector<std::pair<std::string_view, std::string>>& parts) {
    std::string filled;
    std::string_view rest = page;
    while (true) {
        std::size_t nearest = std::string_view::npos;
        const std::pair<std::string_view, std::string>* next = nullptr;
        for (const auto& part : parts) {
            const std::size_t at = rest.find(part.first);
            if (at < nearest) {
                nearest = at;
                next = &part;
            }
        }
        filled += rest.substr(0, nearest);
        if (next == nullptr) return filled;
        filled += next->second;
        rest.remove_prefix(nearest + next->first.size());
    }
}

}  // namespace pcvt
