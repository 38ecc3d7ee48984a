#include "plugin/cli/manual/option_table.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>

namespace pcvt::cli {
namespace {

std::vector<std::string> alternatives(const std::string& form) {
    return form.empty() ? std::vector<std::string>() : CLI::detail::split(form, '|');
}

/// Whether the word consists of digits and of letters from `first` to `last`.
bool is_word_of(const std::string& word, char first, char last) {
    return std::all_of(word.begin(), word.end(),
                       [=](char c) { return (c >= first && c <= last) || (c >= '0' && c <= '9'); });
}

/// Whether an alternative of a form is typed as it is there. A placeholder is in capitals.
bool is_literal(const std::string& word) { return is_word_of(word, 'a', 'z'); }

/// Whether all alternatives are typed as they are, in capitals: CPE|CPS.
bool are_capital_words(const std::vector<std::string>& words) {
    return words.size() > 1 && std::all_of(words.begin(), words.end(), [](const auto& word) {
               return is_word_of(word, 'A', 'Z');
           });
}

OptionWords words_of(const CLI::Option& option) {
    OptionWords words;
    words.is_argument = option.get_positional();
    if (words.is_argument) {
        words.names.push_back(option.get_single_name());
    } else {
        for (const std::string& name : option.get_snames()) words.names.push_back("-" + name);
        for (const std::string& name : option.get_lnames()) words.names.push_back("--" + name);
    }
    const bool takes_value = option.get_items_expected_max() > 0;
    words.form = !option.get_option_text().empty() ? option.get_option_text()
                 : takes_value                     ? option.get_type_name()
                                                   : "";
    words.description = option.get_description();
    words.group = option.get_group();
    words.is_repeatable = option.get_items_expected_max() > 1;
    return words;
}

CommandWords table_of(const CLI::App& app, const std::string& name) {
    CommandWords command{name, app.get_description(), {}, app.get_footer()};
    for (const CLI::Option* option : app.get_options()) {
        if (!option->get_group().empty()) command.options.push_back(words_of(*option));
    }
    return command;
}

}  // namespace

std::vector<std::string> OptionWords::words() const {
    std::vector<std::string> found = alternatives(form);
    if (are_capital_words(found)) return found;
    std::erase_if(found,
                  [](const auto& word) { return !is_literal(word.substr(0, word.find(':'))); });
    return found;
}

std::vector<std::string> OptionWords::values() const {
    std::vector<std::string> found = words();
    std::erase_if(found, [](const auto& word) { return word.find(':') != std::string::npos; });
    return found;
}

bool OptionWords::takes_file() const {
    return form.find("FILE") != std::string::npos || (is_argument && names.front() == "FILE");
}

std::string first_clause(const std::string& description) {
    std::string text = description.substr(0, description.find_first_of(";["));
    std::replace(text.begin(), text.end(), '\n', ' ');
    while (text.ends_with(' ')) text.pop_back();
    return text;
}

std::vector<CommandWords> option_tables(const CLI::App& app) {
    std::vector<CommandWords> tables{table_of(app, "")};
    for (const CLI::App* command : app.get_subcommands(nullptr)) {
        tables.push_back(table_of(*command, command->get_name()));
    }
    return tables;
}

}  // namespace pcvt::cli
