#include "mesher/cells/elastic_choices.hpp"

#include <algorithm>
#include <optional>

#include "mesher/base/error.hpp"
#include "mesher/cells/phase_fractions.hpp"
#include "mesher/portable/decimal_text.hpp"

namespace pcvt {
namespace {

constexpr std::string_view kSame = "same";
constexpr std::string_view kBlanks = " \t\r\n";

char lower_case(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// The text without the blanks round colons and commas, "a : 1, 0.3" is "a:1,0.3"; ends of lines
/// are kept, because they separate materials.
std::string joined_entries(std::string_view text) {
    constexpr std::string_view kMarks = ":,";
    const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
    const auto is_mark = [&](char c) { return kMarks.find(c) != std::string_view::npos; };
    std::string joined;
    for (const char c : text) {
        if (is_blank(c) && !joined.empty() && is_mark(joined.back())) continue;
        while (is_mark(c) && !joined.empty() && is_blank(joined.back())) joined.pop_back();
        joined += c;
    }
    return joined;
}

/// Solvers do not see case.
bool have_one_name(std::string_view s, std::string_view t) {
    return std::equal(s.begin(), s.end(), t.begin(), t.end(),
                      [](char p, char q) { return lower_case(p) == lower_case(q); });
}

[[noreturn]] void refuse(std::string_view entry, const std::string& complaint) {
    std::string quoted(entry.substr(0, 60));
    for (char& c : quoted) {
        if (c < ' ' || c > '~') c = '?';
    }
    throw InvalidInput("'" + quoted + "': " + complaint);
}

std::vector<double> parse_constants(std::string_view entry, std::string_view text) {
    std::vector<double> numbers;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t comma = std::min(text.find(',', begin), text.size());
        const char* const end = text.data() + comma;
        double number = 0;
        const auto [stop, error] = read_decimal(text.data() + begin, end, number);
        if (error != std::errc{} || stop != end) {
            refuse(entry,
                   "not the constants of a material; write NAME:E,NU, such as steel:210000,0.3");
        }
        numbers.push_back(number);
        begin = comma + 1;
    }
    return numbers;
}

NamedConstants parse_material(std::string_view entry) {
    const std::size_t colon = entry.find(':');
    if (colon == std::string_view::npos) {
        refuse(entry, "no material; write NAME:E,NU, or same for the same constants in all phases");
    }
    NamedConstants material{.name = std::string(entry.substr(0, colon)), .constants = {}};
    try {
        require_phase_names({material.name});
        material.constants = checked_constants(parse_constants(entry, entry.substr(colon + 1)));
    } catch (const InvalidInput& fault) {
        if (std::string_view(fault.what()).starts_with('\'')) throw;
        refuse(entry, fault.what());
    }
    return material;
}

const NamedConstants* find_material(const ElasticChoices& choices, std::string_view name) {
    const auto found = std::find_if(
        choices.materials.begin(), choices.materials.end(),
        [&](const NamedConstants& material) { return have_one_name(material.name, name); });
    return found == choices.materials.end() ? nullptr : &*found;
}

/// Whether the cells have no phases, and the only material of a file is theirs.
bool is_the_only_one(const ElasticChoices& choices, std::string_view name) {
    return name == kOneMaterial && choices.materials.empty() && choices.of_files.size() == 1;
}

/// The constants of a phase; `nullopt` if neither the user nor a file gives them.
std::optional<NamedConstants> find_constants(const ElasticChoices& choices,
                                             const std::string& name) {
    if (const NamedConstants* const given = find_material(choices, name)) {
        return NamedConstants{name, given->constants};
    }
    const FileMaterial* found = nullptr;
    for (const FileMaterial& material : choices.of_files) {
        if (!have_one_name(material.name, name) && !is_the_only_one(choices, name)) continue;
        if (found != nullptr) {
            throw InvalidInput("--material: " + name + " is in " + found->file +
                               (found->file == material.file
                                    ? " twice, because case does not matter"
                                    : " and in " + material.file) +
                               "; remove one");
        }
        found = &material;
    }
    if (found == nullptr) return std::nullopt;
    if (!found->fault.empty()) throw InvalidInput(found->fault);
    const bool is_named = have_one_name(found->name, name);
    return NamedConstants{name, found->constants,
                          (is_named ? "" : found->name + " of ") + found->file};
}

std::string listed(const std::vector<std::string>& names) {
    constexpr std::size_t kMostListed = 8;
    std::string text;
    for (std::size_t k = 0; k < std::min(names.size(), kMostListed); ++k) {
        text += (k == 0 ? "" : ", ") + names[k];
    }
    return names.size() > kMostListed ? text + ", ..." : text;
}

std::vector<std::string> material_names(const std::vector<std::string>& phases) {
    return phases.empty() ? std::vector<std::string>{kOneMaterial} : phases;
}

}  // namespace

ElasticChoices parse_elastic_choices(std::string_view text) {
    ElasticChoices choices;
    const std::string joined = joined_entries(text);
    text = joined;
    while (true) {
        text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
        if (text.empty()) break;
        const std::string_view entry = text.substr(0, text.find_first_of(kBlanks));
        text.remove_prefix(entry.size());
        if (entry == kSame) {
            choices.are_same = true;
            continue;
        }
        NamedConstants material = parse_material(entry);
        if (find_material(choices, material.name) != nullptr) {
            refuse(entry, "the material is given twice, because case does not matter; remove one");
        }
        choices.materials.push_back(std::move(material));
    }
    if (choices.empty()) refuse(text, "no material; write NAME:E,NU, or same");
    require_one_choice(choices);
    return choices;
}

void require_one_choice(const ElasticChoices& choices) {
    if (!choices.are_same || !choices.are_given()) return;
    throw InvalidInput(std::string("same and ") +
                       (choices.materials.empty() ? "FILE" : "NAME:...") +
                       " exclude each other; leave one of them out");
}

void require_materials_of(const ElasticChoices& choices, const std::vector<std::string>& phases) {
    if (!choices.are_given()) return;
    const std::vector<std::string> names = material_names(phases);
    for (const NamedConstants& material : choices.materials) {
        const bool is_known = std::any_of(names.begin(), names.end(), [&](const std::string& name) {
            return have_one_name(name, material.name);
        });
        if (is_known) continue;
        throw InvalidInput("--material " + material.name +
                           ": no material of the files has this name; take one of " +
                           listed(names));
    }
    for (const std::string& name : names) {
        if (find_constants(choices, name)) continue;
        std::vector<std::string> of_files;
        for (const FileMaterial& material : choices.of_files) of_files.push_back(material.name);
        throw InvalidInput(
            "the phase " + name + " has no elastic constants; add --material " + name + ":E,NU" +
            (of_files.empty() ? ""
                              : ", or take one of the names in " + choices.of_files.front().file +
                                    ": " + listed(of_files)));
    }
}

void require_choice(const ElasticChoices& choices, const std::vector<std::string>& phases) {
    if (!choices.empty() || phases.size() < 2) return;
    throw InvalidInput("--job elastic would give the phases " + listed(phases) +
                       " the same elastic constants; add --material NAME:E,NU (or "
                       "NAME:C11,C12,C44) for each of them, or --material same");
}

std::vector<NamedConstants> chosen_materials(const ElasticChoices& choices,
                                             const CellMaterials& cells,
                                             const ElasticConstants& standard) {
    std::vector<NamedConstants> materials;
    for (const std::string& name : material_names(cells.phase_names)) {
        materials.push_back(find_constants(choices, name).value_or(NamedConstants{name, standard}));
    }
    return materials;
}

}  // namespace pcvt
