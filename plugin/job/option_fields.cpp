#include "plugin/job/option_fields.hpp"

#include <algorithm>
#include <array>

#include "mesher/base/choices.hpp"
#include "plugin/job/number_options.hpp"

namespace pcvt {
namespace {

/// The fields of an option that every job can have.
struct CommonRow {
    std::string_view option;
    std::string_view fields;
};
constexpr std::array kCommon{CommonRow{"--sites", "n_sites sites"},
                             CommonRow{"--input", "sites"},
                             CommonRow{"--seed", "seed"},
                             CommonRow{"--duplicates", "duplicates"},
                             CommonRow{"--period", "lattice lattice3"},
                             CommonRow{"--lattice", "lattice lattice3"},
                             CommonRow{"--start", "start"},
                             CommonRow{"--solver", "solver"},
                             CommonRow{"--threads", "n_threads"},
                             CommonRow{"--mesh", "kind"},
                             CommonRow{"--report", "report"},
                             CommonRow{"--force", "replace"}};

/// The words of a text with blanks between them.
std::vector<std::string_view> split(std::string_view text) {
    std::vector<std::string_view> words;
    while (!text.empty()) {
        words.push_back(text.substr(0, text.find(' ')));
        text.remove_prefix(std::min(text.size(), words.back().size() + 1));
    }
    return words;
}

}  // namespace

const FeatureRow* find_field(std::string_view field) {
    return find_row(features(), [&](const FeatureRow& row) {
        const std::vector<std::string_view> fields = split(row.fields);
        return std::find(fields.begin(), fields.end(), field) != fields.end();
    });
}

std::vector<std::string_view> option_fields(std::string_view option) {
    if (const FeatureRow* row = find_option(option)) return split(row->fields);
    if (const NumberRow* row = find_number_option(option)) return {row->field};
    const auto* const row =
        find_row(kCommon, [&](const CommonRow& common) { return common.option == option; });
    return row == nullptr ? std::vector<std::string_view>() : split(row->fields);
}

}  // namespace pcvt
