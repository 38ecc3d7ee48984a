#pragma once

#include <string>

namespace CLI {
class App;
}

namespace pcvt::cli {

/// Lets `app` accept the options that later versions will have, unseen in its help.
void add_later_options(CLI::App& app);

/// @throws InvalidInput "... is not available yet" for the first of them that was given.
void refuse_later_options(const CLI::App& app);

/// @throws InvalidInput "OPTION VALUE is not available yet" where `value` is one of `later`.
void refuse_later_value(const std::string& option, const std::string& value,
                        std::initializer_list<const char*> later);

}  // namespace pcvt::cli
