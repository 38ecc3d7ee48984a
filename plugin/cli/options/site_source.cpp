#include "plugin/cli/options/site_source.hpp"

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "mesher/base/error.hpp"
#include "plugin/cli/options/option_values.hpp"

namespace pcvt::cli {

void require_one_lattice(const CLI::App& app) {
    if (app.count("--period") == 0 || app.count("--lattice") == 0) return;
    throw InvalidInput("--period and --lattice exclude each other; remove one");
}

Duplicates chosen_duplicates(const CLI::App& app, const std::string& word) {
    if (app.count("--duplicates") == 0) return Duplicates::kRefuse;
    if (app.count("--input") == 0 && app.count("--fixed") == 0) {
        throw InvalidInput(
            "--duplicates is for sites of a file; add --input FILE, or leave it out");
    }
    return chosen_row("--duplicates", word, kDuplicates).duplicates;
}

void require_one_site_source(const CLI::App& app, const std::string& input) {
    const bool drawn = app.count("--sites") > 0;
    const bool from_file = app.count("--input") > 0;
    if (drawn && from_file) {
        throw InvalidInput("--sites and --input exclude each other; remove one");
    }
    if (!drawn && !from_file) throw InvalidInput("no sites; give --sites N or --input FILE");
    if (from_file && input.empty()) {
        throw InvalidInput("--input: the name is empty; give a file, or - for standard input");
    }
}

void refuse_beside_input(const CLI::App& app, std::initializer_list<const char*> names) {
    if (app.count("--input") == 0) return;
    for (const char* name : names) {
        if (app.count(name) == 0) continue;
        throw InvalidInput(std::string(name) +
                           " is for random sites, but --input gives them; remove one");
    }
}

}  // namespace pcvt::cli
