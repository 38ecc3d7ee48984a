#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace pcvt::cli {

/// An option or an argument of a command, as its help shows it.
struct OptionWords {
    /// "-o", or "-h" and "--help"; of an argument its name, "FILE".
    std::vector<std::string> names;
    /// The form of its value, "whole|box"; empty: it takes none.
    std::string form;
    std::string description;
    /// "Output"; options without a heading of their own have "Options".
    std::string group;
    bool is_argument = false;
    bool is_repeatable = false;

    /// The values in the form that begin with a word: "auto" of "X,Y|auto", "equal" and "gamma:S"
    /// of "equal|gamma:S|FILE".
    std::vector<std::string> words() const;
    /// Those of them that are words.
    std::vector<std::string> values() const;
    /// Whether the value may be a file or a folder.
    bool takes_file() const;
};

/// The first clause of a description, in one line.
std::string first_clause(const std::string& description);

/// A command with its options. The first table of a list describes `pcvt` itself.
struct CommandWords {
    /// "mesh"; of pcvt itself empty.
    std::string name;
    std::string description;
    /// Without the options that the help hides.
    std::vector<OptionWords> options;
    /// The examples, and all other text below the options.
    std::string footer;
};

/// Reads the tables out of the parser of the command line: pcvt itself, then each command.
///
///   for (const CommandWords& command : option_tables(app)) print(manual_page(command, ...));
std::vector<CommandWords> option_tables(const CLI::App& app);

}  // namespace pcvt::cli
