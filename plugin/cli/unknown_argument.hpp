#pragma once

#include <span>
#include <string>

namespace CLI {
class App;
}

namespace pcvt::cli {

/// Returns the message about the first argument that no option and no command of `app` took: its
/// problem and its remedy.
///
///   catch (const CLI::ExtrasError&) {
///       throw InvalidInput(unknown_argument(app, {argv, argc}));
///   }
///
/// @pre app.remaining(true) is not empty.
/// @param arguments  the whole command line.
std::string unknown_argument(const CLI::App& app, std::span<const char* const> arguments);

}  // namespace pcvt::cli
