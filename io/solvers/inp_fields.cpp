#include "io/solvers/inp_fields.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "io/bytes/text.hpp"

namespace pcvt {
namespace {

/// The beginnings of the names of the sets that pcvt writes.
constexpr std::array<std::string_view, 14> kSets{
    "CELL_",    "SEAM_",          "WALL_",         "FIXED",        "EALL",
    "NALL",     "GRAIN_BOUNDARY", "TRIPLE_POINTS", "TRIPLE_LINES", "QUADRUPLE_POINTS",
    "CONTROL_", "SIDE_",          "EDGE_",         "CORNER_"};
/// The beginnings of the cards that follow from the materials of a file, where it states them.
constexpr std::array<std::string_view, 4> kMaterialCards{
    "*ELSET,ELSET=PHASE_", "*SURFACE,NAME=PHASE_", "*ORIENTATION,", "*SOLIDSECTION,"};

/// The beginning of the cards that follow from the orbits of a file, where it states them.
constexpr std::string_view kOrbitCard = "*ELSET,ELSET=ORBIT_";

/// Returns a card in upper case and without blanks, as the solver reads it.
std::string card_name(const std::vector<std::string_view>& words) {
    std::string card;
    for (const std::string_view word : words) card += word;
    card = upper_case(card);
    const std::size_t type = card.find("TYPE=CPS");
    if (type != std::string::npos) card.replace(type, 8, "TYPE=CPE");
    return card;
}

bool is_set(const std::string& card) {
    return card.starts_with("*NSET,") || card.starts_with("*ELSET,");
}

/// Whether the order of the members of a set counts.
bool is_ordered(const std::string& card) { return card.ends_with(",UNSORTED"); }

/// Whether a card begins the sides of elements; their order counts.
bool is_surface(const std::string& card) { return card.starts_with("*SURFACE,"); }

bool is_nodes(const std::string& card) { return card.starts_with("*NODE,") || card == "*NODE"; }

bool follows_from_materials(const std::string& card) {
    return std::any_of(kMaterialCards.begin(), kMaterialCards.end(),
                       [&](std::string_view name) { return card.starts_with(name); });
}

/// The key of a line that is a comment of pcvt; else empty.
std::string_view comment_key(const std::vector<std::string_view>& words) {
    return words.size() > 2 && words[0] == "**" && words[1] == "pcvt" ? words[2] : "";
}

/// The names of the sets of nodes and of sides on a hole.
void add_hole_sets(std::string_view hole, std::vector<std::string>& sets) {
    const std::string name = upper_case(hole);
    if (std::find(sets.begin(), sets.end(), name) != sets.end()) return;
    sets.push_back(name);
    sets.push_back(name + "_SIDES,TYPE=ELEMENT");
}

/// Whether the tile determines the data of a card.
bool follows_from_tile(const std::string& card, const std::vector<std::string>& hole_sets) {
    if (is_set(card) || is_surface(card)) {
        const std::string_view name = std::string_view(card).substr(card.find('=') + 1);
        if (std::find(hole_sets.begin(), hole_sets.end(), name) != hole_sets.end()) return true;
        return std::any_of(kSets.begin(), kSets.end(),
                           [&](std::string_view set) { return name.starts_with(set); });
    }
    return is_nodes(card) || card.starts_with("*ELEMENT") || card == "*EQUATION";
}

void append_words(std::string_view text, int line, std::vector<FileWord>& words) {
    while (!text.empty()) {
        const std::size_t length = std::min(text.find(','), text.size());
        if (length > 0) words.push_back({text.substr(0, length), line});
        text.remove_prefix(std::min(length + 1, text.size()));
    }
}

/// Sorts the members of a set, and removes repetitions.
void normalise_set(std::vector<FileWord>& words) {
    const auto less = [](const FileWord& s, const FileWord& t) {
        return s.text.size() != t.text.size() ? s.text.size() < t.text.size() : s.text < t.text;
    };
    std::stable_sort(words.begin(), words.end(), less);
    const auto same = [](const FileWord& s, const FileWord& t) { return s.text == t.text; };
    words.erase(std::unique(words.begin(), words.end(), same), words.end());
}

}  // namespace

std::string upper_case(std::string_view text) {
    std::string word(text);
    for (char& c : word) {
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    }
    return word;
}

std::optional<FileFields> inp_fields(const std::string& name, std::string_view text) {
    FileFields fields{.name = name};
    LineScanner scanner(name, text);
    std::vector<FileWord>* words = nullptr;
    // The positions of nodes are proved as those of the tile; those of control nodes are not among
    // them.
    bool numbers_alone = false;
    bool has_materials = false;
    bool has_orbits = false;
    std::vector<std::string> hole_sets;
    while (scanner.next()) {
        const std::string_view key = comment_key(scanner.words());
        has_materials = has_materials || key == "phases" || key == "angles";
        has_orbits = has_orbits || key == "site_orbits";
        if (key == "hole" && scanner.words().size() > 3) {
            add_hole_sets(scanner.words()[3], hole_sets);
        }
        if (scanner.words().empty() || scanner.words().front().starts_with("**")) continue;
        if (scanner.words().front().front() == '*') {
            const std::string card = card_name(scanner.words());
            const bool follows = follows_from_tile(card, hole_sets) ||
                                 (has_materials && follows_from_materials(card)) ||
                                 (has_orbits && card.starts_with(kOrbitCard));
            words = follows ? &fields.parts[card] : nullptr;
            numbers_alone = is_nodes(card) && card.find("CONTROL_") == std::string::npos;
        } else if (words != nullptr) {
            const std::size_t before = words->size();
            for (const std::string_view word : scanner.words()) {
                append_words(word, scanner.line(), *words);
            }
            if (numbers_alone && words->size() > before) words->resize(before + 1);
        }
    }
    for (auto& [card, members] : fields.parts) {
        if (is_set(card) && !is_ordered(card)) normalise_set(members);
    }
    return fields;
}

}  // namespace pcvt
