#include "plugin/cli/options/number_texts.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "plugin/cli/options/option_values.hpp"
#include "plugin/job/number_options.hpp"

namespace pcvt::cli {
namespace {

void add_row(CLI::App& app, const NumberRow& row, NumberTexts& texts) {
    app.add_option(row.option, texts[row.option], row.help)->type_name(row.form)->group(row.group);
}

}  // namespace

void add_number(CLI::App& app, const std::string& name, NumberTexts& texts) {
    add_row(app, *find_number_option(name), texts);
}

void add_other_numbers(CLI::App& app, NumberTexts& texts) {
    for (const NumberRow& row : number_options()) {
        if (app.get_option_no_throw(row.option) == nullptr) add_row(app, row, texts);
    }
}

void read_numbers(const CLI::App& app, const NumberTexts& texts, Job& job) {
    for (const NumberRow& row : number_options()) {
        if (app.count(row.option) == 0) continue;
        const std::string& text = texts.at(row.option);
        set_number(row, job,
                   row.is_whole() ? whole_number(row.option, text, row.lowest, row.highest)
                                  : positive_number(row.option, text));
    }
}

}  // namespace pcvt::cli
