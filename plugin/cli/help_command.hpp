#pragma once

#include <string>

namespace CLI {
class App;
}

namespace pcvt::cli {

/// The words of formulas in one line, for the help of --density.
std::string formula_words();

/// The options of `pcvt help`.
struct HelpOptions {
    /// A command, `density` or `formats`; empty: the overview.
    std::string topic;
    /// Whether the page of the manual is wanted.
    bool man = false;
    /// The shell whose completion is wanted; empty: none.
    std::string shell;
    /// The form in which the options of `pcvt mesh` are wanted; empty: none.
    std::string form;
};

/// Adds the arguments of `pcvt help [COMMAND|density|formats]`; parsing fills `options`.
void add_help_options(CLI::App& app, HelpOptions& options);

/// Returns the text that `pcvt help` prints.
/// @param app  the parser of the whole command line.
/// @throws InvalidInput naming the topics.
std::string help_text(const CLI::App& app, const HelpOptions& options);

}  // namespace pcvt::cli
