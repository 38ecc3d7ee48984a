#pragma once

#include <string>
#include <vector>

#include "plugin/cli/exit_code.hpp"

namespace CLI {
class App;
}

namespace pcvt::cli {

/// The options of `pcvt check` as they were typed; empty where they were not.
struct CheckOptions {
    std::vector<std::string> files;
    std::string period;
    std::string lattice;
    std::string tolerance;
    std::string cvt;
    std::string areas;
    std::string volumes;
    std::string inclusions;
    std::string density;
    std::string density_range;
};

/// Gives `app` the options, its description and its examples; parsing fills `options`.
void add_check_options(CLI::App& app, CheckOptions& options);

/// Proves or refutes each file, one line each: proofs on standard output, refutations on standard
/// error.
/// @param app  the one that add_check_options was given, after parsing.
/// @returns kBadInput where one was refuted.
ExitCode run_check(const CLI::App& app, const CheckOptions& options);

}  // namespace pcvt::cli
