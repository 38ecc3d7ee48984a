#include "plugin/cli/not_yet.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>

#include "mesher/error.hpp"

namespace pcvt::cli {
namespace {

constexpr const char* kLaterOptions[] = {"--size", "--order", "--short-edges", "--budget",
                                         "--shard"};

}  // namespace

void add_later_options(CLI::App& app) {
    for (const char* name : kLaterOptions) {
        // An empty group keeps an option out of the help.
        app.add_option(name)->expected(0, 1)->group("");
    }
}

void refuse_later_options(const CLI::App& app) {
    for (const char* name : kLaterOptions) {
        if (app.count(name) > 0) {
            throw InvalidInput(std::string(name) + " is not available yet; leave it out");
        }
    }
}

void refuse_later_value(const std::string& option, const std::string& value,
                        std::initializer_list<const char*> later) {
    if (std::find(later.begin(), later.end(), value) != later.end()) {
        throw InvalidInput(option + " " + value + " is not available yet; take another");
    }
}

}  // namespace pcvt::cli
