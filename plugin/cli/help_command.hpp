#pragma once

#include <string>

namespace CLI {
class App;
}

namespace pcvt::cli {

/// The words of formulas in one line, for the help of --density.
std::string formula_words();

/// Adds the argument of `pcvt help [COMMAND|density|formats]`; parsing fills `topic`.
void add_help_options(CLI::App& app, std::string& topic);

/// Returns the text about `topic`: a command of `app`, `density` or `formats`; empty: the overview.
/// @throws InvalidInput naming the topics.
std::string help_text(const CLI::App& app, const std::string& topic);

}  // namespace pcvt::cli
