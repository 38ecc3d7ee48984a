#include "mesher/cells/set_names.hpp"

#include <algorithm>
#include <array>

#include "mesher/base/error.hpp"

namespace pcvt {
namespace {

constexpr std::array<SetName, 19> kSetNames{
    {{kAllNodesSet, SetForm::kWord, "all nodes"},
     {kAllElementsSet, SetForm::kWord, "all elements"},
     {kFixedSet, SetForm::kWord, "the node that holds the tile"},
     {kControlSet, SetForm::kNumber, "a node whose displacement is the mean strain"},
     {kGrainBoundarySet, SetForm::kWord, "the boundaries of the cells"},
     {kTriplePointsSet, SetForm::kWord, "the corners of the cells"},
     {kTripleLinesSet, SetForm::kWord, "the edges of the cells"},
     {kQuadruplePointsSet, SetForm::kWord, "the corners of the cells"},
     {kCellSet, SetForm::kNumber, "the elements of a cell"},
     {kPhaseSet, SetForm::kPhase, "the elements of a phase"},
     {kOrbitSet, SetForm::kNumber, "the cells of an orbit"},
     {kOrientationSet, SetForm::kNumber, "the orientation of a cell"},
     {kSeamSet, SetForm::kOffset, "a part of the seam"},
     {kSideSet, SetForm::kOffset, "a side of the box"},
     {kEdgeSet, SetForm::kOffset, "an edge of the box"},
     {kCornerSet, SetForm::kOffset, "a corner of the box"},
     {kBackPatch, SetForm::kWord, "a side of the layer of cells"},
     {kFrontPatch, SetForm::kWord, "a side of the layer of cells"},
     {kDomainSet, SetForm::kWord, "the whole domain"}}};

std::string in_lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return lower;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_number(std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), is_digit);
}

/// Whether a text is a list of integers with _ between them: 1_-1.
bool is_offset(std::string_view text) {
    while (true) {
        const std::size_t end = std::min(text.find('_'), text.size());
        std::string_view number = text.substr(0, end);
        if (number.starts_with('-')) number.remove_prefix(1);
        if (!is_number(number)) return false;
        if (end == text.size()) return true;
        text.remove_prefix(end + 1);
    }
}

/// Whether a rest of a name completes a word of this form.
bool completes(std::string_view rest, SetForm form, const std::vector<std::string>& names) {
    switch (form) {
        case SetForm::kWord:
            return rest.empty();
        case SetForm::kNumber:
            return is_number(rest);
        case SetForm::kOffset:
            return is_offset(rest);
        case SetForm::kPhase:
            return std::any_of(names.begin(), names.end(), [&](const std::string& phase) {
                return in_lower_case(phase) == rest;
            });
    }
    return false;
}

bool is_wall(std::string_view lower) { return find_wall_side(lower) != nullptr; }

}  // namespace

std::string seam_name(std::span<const int> offset) {
    std::string name(kSeamSet.substr(0, kSeamSet.size() - 1));
    for (const int number : offset) name += "_" + std::to_string(number);
    return name;
}

std::span<const SetName> set_names() { return kSetNames; }

std::optional<std::string> set_with_name(std::string_view name,
                                         const std::vector<std::string>& names) {
    const std::string lower = in_lower_case(name);
    for (const auto& [word, form, meaning] : kSetNames) {
        if (!lower.starts_with(word)) continue;
        if (!completes(std::string_view(lower).substr(word.size()), form, names)) continue;
        return lower + ", " + std::string(meaning);
    }
    if (is_wall(lower)) return lower + ", a wall";
    if (!lower.ends_with(kSidesSuffix)) return std::nullopt;
    const std::string wall = lower.substr(0, lower.size() - kSidesSuffix.size());
    if (is_wall(wall) || completes(wall, SetForm::kPhase, names)) {
        return lower + ", the sides of elements on a wall";
    }
    return std::nullopt;
}

void require_free_name(const std::string& kind, const std::string& name,
                       const std::vector<std::string>& names) {
    const std::optional<std::string> set = set_with_name(name, names);
    if (!set) return;
    throw InvalidInput(kind + " " + name + " has the name of a set in files (" + *set +
                       "); rename it");
}

}  // namespace pcvt
