#include "io/page/page_text.hpp"

#include <array>

namespace pcvt {

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
