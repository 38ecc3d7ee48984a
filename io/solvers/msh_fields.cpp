#include "io/solvers/msh_fields.hpp"

#include <algorithm>
#include <array>

#include "io/solvers/msh_rows.hpp"

namespace pcvt {
namespace {

constexpr std::array<std::string_view, 8> kSections{"$MeshFormat",  "$PhysicalNames", "$Entities",
                                                    "$Nodes",       "$Elements",      "$Periodic",
                                                    "$ElementData", "$NodeData"};

/// Whether the words of a section are those of a view with another name than "cell_id". The first
/// word is the number of names.
bool is_other_view(const std::string& section, const std::vector<FileWord>& words) {
    return section.ends_with("Data") && (words.size() < 2 || words[1].text != "\"cell_id\"");
}

}  // namespace

std::optional<FileFields> msh_fields(const std::string& name, std::string_view text) {
    FileFields fields{.name = name};
    MshRows rows(name, text);
    while (rows.next_filled()) {
        const std::string section(rows.words().front());
        const std::string end = "$End" + section.substr(1);
        std::vector<FileWord> words;
        while (rows.next_row().front() != end) {
            for (const std::string_view word : rows.words()) words.push_back({word, rows.line()});
        }
        const bool known =
            std::find(kSections.begin(), kSections.end(), section) != kSections.end();
        if (!known || is_other_view(section, words)) continue;
        std::vector<FileWord>& part = fields.parts[section];
        part.insert(part.end(), words.begin(), words.end());
    }
    return fields;
}

}  // namespace pcvt
