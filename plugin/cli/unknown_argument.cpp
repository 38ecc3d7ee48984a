#include "plugin/cli/unknown_argument.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <string_view>
#include <vector>

#include "io/bytes/nearest_word.hpp"
#include "io/bytes/text.hpp"

namespace pcvt::cli {
namespace {

/// The word as printable text without quotes.
std::string shown(std::string_view word) {
    const std::string quoted = in_quotes(word);
    return quoted.substr(1, quoted.size() - 2);
}

bool is_option(std::string_view word) {
    return word.size() > 1 && word[0] == '-' && (word[1] < '0' || word[1] > '9') && word[1] != '.';
}

std::string_view without_dashes(std::string_view word) {
    return word.substr(std::min(word.find_first_not_of('-'), word.size()));
}

/// The names of the options that the help of a command lists, without the dashes.
std::vector<std::string> option_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        if (option->get_group().empty()) continue;
        names.insert(names.end(), option->get_lnames().begin(), option->get_lnames().end());
    }
    return names;
}

std::string invocation(const CLI::App& command) {
    return command.get_parent() == nullptr ? "pcvt" : "pcvt " + command.get_name();
}

/// The remedy: the nearest word, or else the help.
std::string remedy(const CLI::App& command, const std::string& meant) {
    return meant.empty() ? "; see " + invocation(command) + " --help"
                         : "; did you mean " + meant + "?";
}

std::string unknown_option(const CLI::App& command, const std::string& word) {
    const std::string name = word.substr(0, word.find('='));
    const std::string meant = nearest_word(without_dashes(name), option_names(command));
    return "unknown option " + shown(name) + remedy(command, meant.empty() ? meant : "--" + meant);
}

/// An argument that no command precedes.
std::string unknown_command(const CLI::App& app, const std::string& word) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands(nullptr)) {
        names.push_back(command->get_name());
        if (!is_option(word)) continue;
        if (command->get_option_no_throw(word.substr(0, word.find('='))) != nullptr) {
            return word + " is an option of a command; write pcvt " + command->get_name() + " " +
                   word;
        }
    }
    if (is_option(word)) return unknown_option(app, word);
    return "unknown command " + shown(word) + remedy(app, nearest_word(word, names));
}

/// The last option before the argument `word`; nullptr if there is none.
const CLI::Option* option_before(const CLI::App& command, const std::string& word,
                                 std::span<const char* const> arguments) {
    const CLI::Option* last = nullptr;
    for (const char* argument : arguments) {
        if (argument == word) break;
        if (is_option(argument)) last = command.get_option_no_throw(argument);
    }
    return last;
}

/// A word that is not an option, and that no option before it takes.
std::string stray_word(const CLI::App& command, const std::string& word,
                       std::span<const char* const> arguments) {
    const std::string head = shown(word) + ": ";
    const CLI::Option* before = option_before(command, word, arguments);
    const std::string name = before == nullptr ? "" : before->get_name();
    if (name == "-o") return head + "give each file its own -o";
    if (name == "--mesh") return head + "give each kind its own --mesh";
    if (name == "--density") return head + "put the formula of --density in quotes";
    if (before != nullptr && before->get_type_name().find(',') != std::string::npos) {
        return head + "write the value of " + name + " without blanks, as " +
               before->get_type_name();
    }
    return head + "unknown; see " + invocation(command) + " --help";
}

}  // namespace

std::string unknown_argument(const CLI::App& app, std::span<const char* const> arguments) {
    if (!app.remaining().empty()) return unknown_command(app, app.remaining().front());
    const CLI::App& command = *app.get_subcommands().front();
    const std::string word = command.remaining(true).front();
    return is_option(word) ? unknown_option(command, word) : stray_word(command, word, arguments);
}

}  // namespace pcvt::cli
