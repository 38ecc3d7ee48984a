#include "io/openfoam/foam_fields.hpp"

#include "io/openfoam/foam_scanner.hpp"
#include "io/openfoam/foam_text.hpp"

namespace pcvt {

std::optional<FileFields> foam_fields(const std::string& name, std::string_view text) {
    if (name.find(kMeshFolder) == std::string::npos &&
        text.find(kCaseNote) == std::string_view::npos) {
        return std::nullopt;
    }
    FileFields fields{.name = name};
    // The scanner checks the header; the words begin there.
    FoamScanner scanner = FoamScanner::from_header(name, text);
    std::vector<FileWord>& words = fields.parts["the file"];
    for (std::string_view word = scanner.next(); !word.empty(); word = scanner.next()) {
        words.push_back({word, scanner.line()});
    }
    return fields;
}

}  // namespace pcvt
