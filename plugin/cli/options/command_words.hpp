#pragma once

#include <string>

namespace CLI {
class App;
}

namespace pcvt::cli {

/// Returns the command with its options in the order of its help: "mesh --sites 400 --retry 20".
/// Files that it reads are there by their names, without folders. Files that it writes and options
/// that change no result (--threads, --quiet, --force) are left out, so that runs with one result
/// have the same words.
///
/// Example usage:
///     job.command = command_words(app);
///
/// @param app  after parsing.
std::string command_words(const CLI::App& app);

}  // namespace pcvt::cli
