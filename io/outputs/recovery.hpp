#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pcvt {

/// Completes or takes back the sets that runs left unfinished when they were killed, and removes
/// the temporary files of dead runs, in the folders of `paths` and in the folders above them as far
/// as the paths name them. Sets of living runs, and files of other users, stay as they are.
/// Call it before the first look at a target.
///
/// Example usage:
///     recover_unfinished({"out/tile.obj"});
///     require_writable("out/tile.obj", false);
///
/// @returns one line for each set that was completed or taken back.
/// @throws OutputError if a set can be neither completed nor taken back.
std::vector<std::string> recover_unfinished(const std::vector<std::string>& paths);

/// Returns the journal of a dead run whose set contains one of the files; nothing if there is none.
/// Changes nothing.
std::optional<std::string> unfinished_set_of(const std::vector<std::string>& paths);

}  // namespace pcvt
