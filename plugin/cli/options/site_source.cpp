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
    if (app.count("--input") + app.count("--centroids") + app.count("--fixed") == 0) {
        throw InvalidInput(
            "--duplicates is for sites of a file; add --input FILE, or leave it out");
    }
    return chosen_row("--duplicates", word, kDuplicates).duplicates;
}

namespace {

/// The option that names a file of points; null if there is none.
const char* file_option(const CLI::App& app) {
    for (const char* name : {"--input", "--centroids"}) {
        if (app.count(name) > 0) return name;
    }
    return nullptr;
}

}  // namespace

void require_one_site_source(const CLI::App& app, const std::string& input) {
    const bool drawn = app.count("--sites") > 0;
    const char* const file = file_option(app);
    if (app.count("--centroids") > 0 && app.count("--input") > 0) {
        throw InvalidInput("--input and --centroids exclude each other; remove one");
    }
    if (drawn && file != nullptr) {
        throw InvalidInput(std::string("--sites and ") + file + " exclude each other; remove one");
    }
    if (!drawn && file == nullptr) throw InvalidInput("no sites; give --sites N or --input FILE");
    if (file != nullptr && input.empty()) {
        throw InvalidInput(std::string(file) +
                           ": the name is empty; give a file, or - for standard input");
    }
}

void refuse_beside_input(const CLI::App& app, std::initializer_list<const char*> names) {
    const char* const file = file_option(app);
    if (file == nullptr) return;
    for (const char* name : names) {
        if (app.count(name) == 0) continue;
        throw InvalidInput(std::string(name) + " is for random sites, but " + file +
                           " gives them; remove one");
    }
}

}  // namespace pcvt::cli
