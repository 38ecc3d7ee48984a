#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pcvt {

/// Returns the number of single-character edits (insert, delete, replace, or swap two neighbours)
/// that turn `a` into `b`.
int edit_distance(std::string_view a, std::string_view b);

/// Returns the one of `words` that a user probably meant by `word`: within two edits, and within
/// one edit per two characters of `word`. Among equally near ones, a word that begins with `word`
/// wins. If no word is that near, the only one that begins with `word`, of three characters or
/// more, is meant. Returns an empty string if no word, or more than one, is meant.
///
/// Example usage:
///     const std::string meant = nearest_word("lbgfs", {"lbfgs", "lloyd", "newton"});
///     if (!meant.empty()) throw InvalidInput("lbgfs: unknown; did you mean " + meant + "?");
std::string nearest_word(std::string_view word, const std::vector<std::string>& words);

}  // namespace pcvt
