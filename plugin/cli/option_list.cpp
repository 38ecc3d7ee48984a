#include "plugin/cli/option_list.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "io/bytes/json_writer.hpp"
#include "io/formats/formats.hpp"
#include "plugin/cli/mesh_options.hpp"
#include "plugin/job/features.hpp"
#include "plugin/job/job_start.hpp"
#include "plugin/job/number_options.hpp"
#include "plugin/job/option_fields.hpp"

namespace pcvt::cli {
namespace {

/// A word that an option takes.
struct Word {
    std::string word;
    /// In pcvt.h.
    std::optional<int> number = {};
    bool in_plane = true;
    bool in_space = true;
};

template <class Table>
std::vector<Word> words_of(const Table& table) {
    std::vector<Word> words;
    for (const auto& row : table) {
        if (row.abi_value == kNotOffered) continue;
        words.push_back({row.word, row.abi_value});
        if constexpr (requires { row.in_plane; }) words.back().in_plane = row.in_plane;
        if constexpr (requires { row.in_space; }) words.back().in_space = row.in_space;
    }
    return words;
}

/// An option with words that have numbers, or that are not for space.
struct ChoiceRow {
    std::string_view option;
    std::vector<Word> (*words)();
};
constexpr std::array kChoices{
    ChoiceRow{"--colour", [] { return words_of(kColourings); }},
    ChoiceRow{"--duplicates", [] { return words_of(kDuplicates); }},
    ChoiceRow{"--element", [] { return words_of(kPlaneElements); }},
    ChoiceRow{"--glb-nodes", [] { return words_of(kGltfNodes); }},
    ChoiceRow{"--job", [] { return words_of(kSolverJobs); }},
    ChoiceRow{"--mesh", [] { return words_of(plane::kMeshKinds); }},
    ChoiceRow{"--outline", [] { return words_of(kOutlines); }},
    ChoiceRow{"--period", [] { return std::vector<Word>{{.word = "auto", .in_space = false}}; }},
    ChoiceRow{"--solver", [] { return words_of(kSolvers); }},
    ChoiceRow{"--start", [] { return words_of(start_rows()); }},
    ChoiceRow{"--surface", [] { return words_of(kSurfaceForms); }},
    ChoiceRow{"--symmetry", [] { return words_of(plane::kPlaneGroups); }},
    ChoiceRow{"--wall-cells", [] { return words_of(kWallCells); }},
    ChoiceRow{"--walls", [] { return words_of(std::span(kWalls).subspan<1>()); }}};

const ChoiceRow* find_choice(std::string_view option) {
    return find_row(kChoices, [option](const ChoiceRow& row) { return row.option == option; });
}

/// The words of a table of choices, or those in the form.
std::vector<Word> words_of_option(const OptionWords& option) {
    if (const ChoiceRow* row = find_choice(option.names.back())) return row->words();
    std::vector<Word> words;
    for (const std::string& word : option.words()) words.push_back({word});
    return words;
}

/// "; best: plane only" for the words that a dimension lacks, or nothing.
std::string mark_words(const ChoiceRow* choice, bool Word::*in_dimension, const char* only) {
    if (choice == nullptr) return "";
    std::string words;
    for (const Word& word : choice->words()) {
        if (!(word.*in_dimension)) words += (words.empty() ? "; " : ", ") + word.word;
    }
    return words.empty() ? words : words + ": " + only;
}

/// "; plane only", "; best: plane only", or nothing.
std::string mark(const std::string& option) {
    const FeatureRow* const feature = find_option(option);
    if (feature != nullptr && !feature->in_space) return "; plane only";
    if (feature != nullptr && !feature->in_plane) return "; space only";
    const ChoiceRow* const choice = find_choice(option);
    return mark_words(choice, &Word::in_space, "plane only") +
           mark_words(choice, &Word::in_plane, "space only");
}

/// The extensions of the formats whose files take an option; nothing for an option of the run.
std::optional<std::vector<std::string_view>> formats_with(const FeatureRow* feature) {
    if (feature == nullptr || feature->taken == nullptr) return {};
    std::vector<std::string_view> extensions;
    for (const Format& format : formats()) {
        if (feature->taken(format, false) || feature->taken(format, true))
            extensions.push_back(format.extension);
    }
    return extensions;
}

void append_words(JsonWriter& json, const std::vector<Word>& words, bool in_plane, bool in_space) {
    json.list("words", words, [&](const Word& word) {
        json.begin_object();
        json.member("word", word.word);
        json.member("number", word.number);
        json.member("plane", in_plane && word.in_plane);
        json.member("space", in_space && word.in_space);
        json.end();
    });
}

void append_option(JsonWriter& json, const OptionWords& option) {
    const FeatureRow* const feature = find_option(option.names.back());
    const bool in_plane = feature == nullptr || feature->in_plane;
    const bool in_space = feature == nullptr || feature->in_space;
    json.member("form", option.form);
    append_words(json, words_of_option(option), in_plane, in_space);
    json.member("plane", in_plane);
    json.member("space", in_space);
    json.member("fields", option_fields(option.names.back()));
    json.member("number", find_number_option(option.names.back()) != nullptr);
    json.member("formats", formats_with(feature));
    json.member("help", first_clause(option.description));
}

}  // namespace

void mark_dimensions(CLI::App& app) {
    constexpr std::size_t kWidth = 72;
    for (CLI::Option* option : app.get_options()) {
        std::string text = option->get_description();
        std::string ending = mark(option->get_name());
        const std::size_t last_line = text.rfind('\n') + 1;
        if (!ending.empty() && text.size() - last_line + ending.size() > kWidth) ending[1] = '\n';
        option->description(text + ending);
    }
}

std::string options_json(const std::vector<OptionWords>& options) {
    std::string text;
    JsonWriter json(text);
    json.begin_object(kJsonLines);
    for (const OptionWords& option : options) {
        if (option.names.back() == "--help") continue;
        json.object(option.names.back(), [&] { append_option(json, option); });
    }
    json.end();
    return text + "\n";
}

}  // namespace pcvt::cli
