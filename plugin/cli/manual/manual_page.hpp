#pragma once

#include <string>
#include <vector>

#include "plugin/cli/manual/option_table.hpp"

namespace pcvt::cli {

/// A part of a page whose lines are kept as they are.
struct ManualSection {
    std::string title;
    std::string text;
};

/// Returns the page of a command in the language of man(7), section 1.
///
///   print(manual_page(tables, tables[1], "0.2.0", {}));
///
/// @param commands  all tables of option_tables(); the page refers to the other pages.
/// @param command   one of them.
/// @param sections  added behind the options.
std::string manual_page(const std::vector<CommandWords>& commands, const CommandWords& command,
                        const std::string& version, const std::vector<ManualSection>& sections);

}  // namespace pcvt::cli
