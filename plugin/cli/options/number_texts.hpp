#pragma once

#include <map>
#include <string>

#include "plugin/job/job.hpp"

namespace CLI {
class App;
}

namespace pcvt::cli {

/// The texts of the options that take one number (plugin/job/number_options.hpp), by their names.
using NumberTexts = std::map<std::string, std::string>;

/// Adds such an option to `app`; parsing fills its text.
///
///   add_number(app, "--tolerance", options.numbers);
///   app.parse(argc, argv);
///   read_numbers(app, options.numbers, job);
void add_number(CLI::App& app, const std::string& name, NumberTexts& texts);

/// Adds all those that `app` lacks, at the end of the groups that they belong to.
void add_other_numbers(CLI::App& app, NumberTexts& texts);

/// Sets the numbers that were given.
/// @throws InvalidInput, LimitExceeded naming the option.
void read_numbers(const CLI::App& app, const NumberTexts& texts, Job& job);

}  // namespace pcvt::cli
