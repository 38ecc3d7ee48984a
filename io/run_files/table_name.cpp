#include "io/run_files/table_name.hpp"

#include <algorithm>
#include <filesystem>

#include "mesher/base/comma_list.hpp"

namespace pcvt {
namespace {

bool is_there(const std::string& path) {
    std::error_code unknown;
    return !path.empty() && std::filesystem::exists(path, unknown);
}

}  // namespace

TableName parse_table_name(const std::string& text,
                           std::initializer_list<std::string_view> prefixes) {
    if (is_there(text)) return {.path = text};
    TableName name{.path = text};
    const std::size_t first = text.find(':');
    const std::string_view head = std::string_view(text).substr(0, std::min(first, text.size()));
    if (first != std::string::npos &&
        std::find(prefixes.begin(), prefixes.end(), head) != prefixes.end()) {
        name.prefix = head;
        name.path = text.substr(first + 1);
        if (is_there(name.path)) return name;
    }
    const std::size_t last = name.path.rfind(':');
    if (last == std::string::npos || last == 0 || last + 1 == name.path.size()) return name;
    const auto columns = between_commas(std::string_view(name.path).substr(last + 1));
    name.columns.assign(columns.begin(), columns.end());
    name.path.resize(last);
    return name;
}

std::string with_columns(const TableName& name, const std::string& prefix,
                         const std::string& columns) {
    const std::string text =
        (prefix.empty() ? "" : prefix + ":") + name.path + (columns.empty() ? "" : ":" + columns);
    const bool is_word = text.find_first_of(" ()[]{}<>&|;*?$#!~`\"\\") == std::string::npos;
    return is_word || text.find('\'') != std::string::npos ? text : "'" + text + "'";
}

}  // namespace pcvt
