#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pcvt {

/// Returns a text with entities for the marks of HTML.
std::string html_text(std::string_view text);

/// Returns a page with its marks replaced. Replaced parts are not searched for marks.
///
///     filled_page("<h1>@TITLE@</h1>", {{"@TITLE@", html_text(name)}})
std::string filled_page(std::string_view page,
                        const std::vector<std::pair<std::string_view, std::string>>& parts);

}  // namespace pcvt
