#include "io/solvers/msh_fields.hpp"

#include <algorithm>
#include <array>

#include "io/solvers/msh_rows.hpp"
#include "mesher/base/cancellable_sort.hpp"

namespace pcvt {
namespace {

constexpr std::array<std::string_view, 8> kSections{"$MeshFormat",  "$PhysicalNames", "$Entities",
                                                    "$Nodes",       "$Elements",      "$Periodic",
                                                    "$ElementData", "$NodeData"};

/// The view of the nodes of tetrahedra inside of cells, in quotes.
constexpr std::string_view kNodeViewName = "\"periodic_node\"";

/// Whether the words of a section are those of a view with another name than those of pcvt. The
/// first word is the number of names.
/// @param has_orbits  whether the file states the orbits of its sites.
bool is_other_view(const std::string& section, const std::vector<FileWord>& words,
                   bool has_orbits) {
    if (!section.ends_with("Data")) return false;
    if (words.size() < 2) return true;
    return words[1].text != "\"cell_id\"" && words[1].text != kNodeViewName &&
           !(has_orbits && words[1].text == "\"orbit\"");
}

/// Whether a row of $Comments states orbits of sites.
template <class Words>
bool states_orbits(const std::string& section, const Words& words) {
    return section == "$Comments" && words.size() > 1 && words[0] == "pcvt" &&
           words[1] == "site_orbits";
}

/// The values of a view begin behind its tags, which are rows of one word.
std::size_t begin_of_values(const std::vector<FileWord>& words) {
    std::size_t k = 1;
    while (k < words.size() && words[k].line != words[k - 1].line) ++k;
    return k == words.size() ? k : k - 1;
}

/// Sorts the values of a view by their numbers; leaves it as it is unless all have two words.
void sort_values(std::vector<FileWord>& words) {
    const std::size_t begin = begin_of_values(words);
    std::vector<std::array<FileWord, 2>> rows;
    for (std::size_t k = begin; k + 1 < words.size(); k += 2) {
        if (words[k].line != words[k + 1].line) return;
        rows.push_back({words[k], words[k + 1]});
    }
    cancellable_stable_sort(rows.begin(), rows.end(), [](const auto& s, const auto& t) {
        const std::string_view one = s[0].text;
        const std::string_view other = t[0].text;
        return one.size() == other.size() ? one < other : one.size() < other.size();
    });
    for (std::size_t k = 0; k < rows.size(); ++k) {
        words[begin + 2 * k] = rows[k][0];
        words[begin + 2 * k + 1] = rows[k][1];
    }
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
        if (section.ends_with("Data")) sort_values(words);
        std::vector<FileWord>& part = fields.parts[section];
        part.insert(part.end(), words.begin(), words.end());
    }
    return fields;
}

}  // namespace pcvt
