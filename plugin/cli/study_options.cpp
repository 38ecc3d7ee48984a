#include "plugin/cli/study_options.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <limits>
#include <thread>

#include "mesher/base/error.hpp"
#include "mesher/plane/geometry/sites.hpp"
#include "plugin/cli/options/option_values.hpp"

namespace pcvt::cli {
namespace {

constexpr int kMostRuns = 1'000'000'000;
constexpr int kMostShards = 1'000'000;
/// Numbers of sites in the help.
constexpr std::size_t kLongestList = 20;

constexpr const char* kStudyExamples =
    "Examples:\n"
    "  pcvt study table1\n"
    "      the paper's Table I, printed; with -o table1.csv also as a file\n"
    "  pcvt study fig11 -o results/\n"
    "      the folder results gets fig11.csv, fig11-patterns.csv, fig11-runs.csv, fig11.svg,\n"
    "      fig11-shares.svg and fig11.html, a page that shows them\n"
    "  pcvt study fig11 --sites 8,9,12 --runs 1000 --seed 7 -o mine.csv -o mine.svg\n"
    "      other numbers of sites; writes mine-patterns.csv, ... beside mine.csv\n"
    "  pcvt study fig11 --shard 2/4 -o part2.csv\n"
    "  pcvt study fig11 --merge part1.csv part2.csv part3.csv part4.csv -o results/\n"
    "      four machines share the runs; the merged files are those of the unsplit study\n";

/// "8,9,11", or "1,...,64" where the numbers are all of a long range.
std::string in_short(const std::vector<int>& numbers) {
    const std::string last = std::to_string(numbers.back());
    const bool is_range = std::adjacent_find(numbers.begin(), numbers.end(), [](int a, int b) {
                              return b != a + 1;
                          }) == numbers.end();
    if (is_range && numbers.size() > kLongestList) {
        return std::to_string(numbers.front()) + ",...," + last;
    }
    std::string text;
    for (const int number : numbers) text += (text.empty() ? "" : ",") + std::to_string(number);
    return text;
}

/// Two lines for each study: its description and its defaults.
std::string recipes_help() {
    std::size_t width = 0;
    for (const StudyRecipe& recipe : study_recipes()) width = std::max(width, recipe.name.size());
    std::string text = "Studies, with the defaults of --sites and --runs:\n";
    for (const StudyRecipe& recipe : study_recipes()) {
        const Study& standard = recipe.standard;
        text += "  " + recipe.name + std::string(width + 2 - recipe.name.size(), ' ') +
                recipe.description + "\n" + std::string(width + 4, ' ') + in_short(standard.sites) +
                "; " + std::to_string(standard.runs) + ", seed " + std::to_string(standard.seed) +
                "\n";
    }
    return text;
}

std::string study_names(const char* separator) {
    std::string names;
    for (const StudyRecipe& recipe : study_recipes()) {
        names += (names.empty() ? "" : separator) + recipe.name;
    }
    return names;
}

std::vector<int> site_numbers(const std::string& text) {
    std::vector<int> numbers;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        numbers.push_back(
            whole_number("--sites", text.substr(begin, end - begin), 1, plane::kMostSites));
        begin = end + 1;
    }
    return numbers;
}

StudyShard shard_number(const std::string& text) {
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos) {
        throw InvalidInput("--shard " + text + ": not of the form i/N; give such as 2/4");
    }
    const int count = whole_number("--shard", text.substr(slash + 1), 1, kMostShards);
    const int index = whole_number("--shard", text.substr(0, slash), 1, kMostShards);
    if (index > count) {
        throw InvalidInput("--shard " + text + ": beyond the last part; give 1/" +
                           std::to_string(count) + " to " + std::to_string(count) + "/" +
                           std::to_string(count));
    }
    return {index, count};
}

void refuse_beside_merge(const CLI::App& app) {
    for (const char* name : {"--sites", "--runs", "--seed", "--shard"}) {
        if (app.count(name) > 0) {
            throw InvalidInput(std::string(name) +
                               " comes from the files that --merge reads; remove it");
        }
    }
}

}  // namespace

void add_study_options(CLI::App& app, StudyOptions& options) {
    const auto add = [&app](const char* name, std::string& value, const char* form,
                            const char* description) {
        app.add_option(name, value, description)->type_name(form);
    };
    app.option_defaults()->group("Study");
    add("STUDY", options.name, "", "one of the studies below");
    app.get_option("STUDY")->option_text(study_names("|"));
    add("--sites", options.sites, "N,N,...", "numbers of sites [the paper's, see below]");
    add("--runs", options.runs, "R", "random starts for each number of sites [see below]");
    add("--seed", options.seed, "S",
        "run r starts from the random sites of seed S + r [see below]");
    add("--shard", options.shard, "i/N", "only part i of N parts: the table of its runs");
    app.add_option("--merge", options.merge, "the shards of one study, in any order")
        ->type_name("FILE")
        ->option_text("FILE ...");
    add("--threads", options.threads, "N", "runs at a time; fig7 has always one [all cores]");
    app.option_defaults()->group("Output");
    app.add_option("-o", options.outputs,
                   "repeatable; FILE.csv: the tables, FILE.svg: the\n"
                   "pictures, FILE.html: a page with both, a folder: all")
        ->type_name("FILE")
        ->option_text("FILE|FOLDER/")
        ->allow_extra_args(false);
    app.add_flag("--force", options.force, "replace existing files");
    app.add_flag("--quiet", options.quiet, "no table and no progress");
    app.footer(recipes_help() + "\n" + kStudyExamples);
}

StudyRequest make_study_request(const CLI::App& app, const StudyOptions& options) {
    if (app.count("STUDY") == 0) {
        throw InvalidInput("no study; take one of " + study_names(", "));
    }
    StudyRequest request;
    request.study = find_study_recipe(options.name).standard;
    if (app.count("--merge") > 0) refuse_beside_merge(app);
    if (app.count("--sites") > 0) request.study.sites = site_numbers(options.sites);
    if (app.count("--runs") > 0) {
        request.study.runs = whole_number("--runs", options.runs, 1, kMostRuns);
    }
    if (app.count("--seed") > 0) request.study.seed = seed_number("--seed", options.seed);
    if (app.count("--shard") > 0) request.shard = shard_number(options.shard);
    request.n_threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    if (app.count("--threads") > 0) {
        request.n_threads = whole_number("--threads", options.threads, 1, kMostThreads);
    }
    return request;
}

}  // namespace pcvt::cli
