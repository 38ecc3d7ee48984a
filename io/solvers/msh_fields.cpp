#include "io/solvers/msh_fields.hpp"

#include <algorithm>
#include <array>

#include "io/solvers/msh_rows.hpp"

namespace pcvt {
namespace {

constexpr std::array<std::string_view, 8> kSections{"$MeshFormat",  "$PhysicalNames", "$Entities",
                                                    "$Nodes",       "$Elements",      "$Periodic",
                                                    "$ElementData", "$NodeData"};

/// Whether the words of a section are those of a view with another name than those of pcvt. The
/// first word is the number of names.
/// @param has_orbits  whether the file states the orbits of its sites.
bool is_other_view(const std::string& section, const std::vector<FileWord>& words,
                   bool has_orbits) {
    if (!section.ends_with("Data")) return false;
    if (words.size() < 2) return true;
    return words[1].text != "\"cell_id\"" && !(has_orbits && words[1].text == "\"orbit\"");
}

/// Whether a row of $Comments states orbits of sites.
template <class Words>
bool states_orbits(const std::string& section, const Words& words) {
    return section == "$Comments" && words.size() > 1 && words[0] == "pcvt" &&
           words[1] == "site_orbits";
}

}  // namespace

std::optional<FileFields> msh_fields(const std::string& name, std::string_view text) {
    FileFields fields{.name = name};
    MshRows rows(name, text);
    bool has_orbits = false;
    while (rows.next_filled()) {
        const std::string section(rows.words().front());
        const std::string end = "$End" + section.substr(1);
        std::vector<FileWord> words;
        while (rows.next_row().front() != end) {
            for (const std::string_view word : rows.words()) words.push_back({word, rows.line()});
            has_orbits = has_orbits || states_orbits(section, rows.words());
        }
        const bool known =
            std::find(kSections.begin(), kSections.end(), section) != kSections.end();
        if (!known || is_other_view(section, words, has_orbits)) continue;
        std::vector<FileWord>& part = fields.parts[section];
        part.insert(part.end(), words.begin(), words.end());
    }
    return fields;
}

}  // namespace pcvt
