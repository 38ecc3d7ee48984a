#pragma once

#include <string>
#include <vector>

#include "plugin/cli/manual/option_table.hpp"

namespace pcvt::cli {

/// Marks in the help of each option whether it is for the plane or for space only, and which of its
/// words are for the plane only, as the tables of features and choices say.
///
/// Example usage:
///   add_mesh_options(app, options);
///   mark_dimensions(app);  // --walls: "...; plane only", --start: "...; best: plane only"
void mark_dimensions(CLI::App& app);

/// Returns the options of a command as one JSON object, from which plugin/words makes the words of
/// all hosts. An option is a member with its name and these members:
///
///   form     of its value, "W,H|auto"; "" for an option without one
///   words    a list of {word, its number in pcvt.h or null, plane, space}
///   plane    whether runs in the plane have the option; `space`: those in space
///   fields   a list of fields of pcvt.h
///   formats  a list of the extensions whose files take it, null for an option of the run
///   help     one sentence
///
/// Example usage:
///   print(options_json(option_tables(app)[1].options));
std::string options_json(const std::vector<OptionWords>& options);

}  // namespace pcvt::cli
