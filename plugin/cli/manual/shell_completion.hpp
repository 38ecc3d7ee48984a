#pragma once

#include <string>
#include <vector>

#include "plugin/cli/manual/option_table.hpp"

namespace pcvt::cli {

/// Returns the script that completes commands, options and their values in bash (which needs no
/// other package) or in zsh.
///
///   print(bash_completion(option_tables(app)));
std::string bash_completion(const std::vector<CommandWords>& commands);
std::string zsh_completion(const std::vector<CommandWords>& commands);

}  // namespace pcvt::cli
