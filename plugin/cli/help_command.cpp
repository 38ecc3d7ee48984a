#include "plugin/cli/help_command.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <array>
#include <vector>

#include "io/bytes/nearest_word.hpp"
#include "io/bytes/text.hpp"
#include "io/formats/formats.hpp"
#include "mesher/base/choices.hpp"
#include "mesher/base/error.hpp"
#include "plugin/cli/manual/manual_page.hpp"
#include "plugin/cli/manual/shell_completion.hpp"
#include "plugin/cli/option_list.hpp"
#include "plugin/cli/options/option_values.hpp"
#include "plugin/job/version.hpp"

namespace pcvt::cli {
namespace {

constexpr const char* kFunctions =
    "sin cos tan asin acos atan atan2 sinh cosh tanh asinh acosh\n"
    "atanh exp ln log log2 log10 sqrt abs sign rint min max sum avg";
constexpr const char* kConstants = "pi _pi _e";

std::string density_help() {
    return std::string(
               "--density FORMULA: cells are small where the density is large. The density is\n"
               "positive and periodic; the spacing of the sites follows density^(-1/4).\n\n"
               "Variables:\n"
               "  x y  position in length units\n"
               "  u v  position along the two period vectors, from 0 to 1\n"
               "Constants:\n"
               "  ") +
           kConstants +
           "  (_pi is pi, _e is 2.71828)\n"
           "Functions:\n  " +
           std::string(kFunctions).replace(std::string(kFunctions).find('\n'), 1, "\n  ") +
           "\n  (ln and log are natural; min, max, sum and avg take any number of values)\n"
           "Operators:\n"
           "  + - * / ^  < <= == != >= >  && ||  CONDITION ? A : B\n\n"
           "--density FILE.png: a picture laid over the domain; --density-range LO,HI sets the\n"
           "densities of black and of white. pcvt reads no other format of pictures, and at most\n"
           "2^24 pixels, 16384 along a side.\n\n"
           "Examples:\n"
           "  pcvt mesh --sites 2000 --density '1 + 99 * exp(-((v - 0.5) / 0.1)^2)' -o ridge.svg\n"
           "  pcvt mesh --sites 2000 --density '2 + sin(2 * pi * u)' -o wave.svg\n"
           "  pcvt mesh --sites 2000 --density photo.png --density-range 1,0.01 -o photo.svg\n";
}

std::string formats_help() {
    std::string text = "The extension of -o FILE chooses the format.\n\n";
    for (const Format& format : formats()) {
        text += "  " + std::string(format.extension) +
                std::string(8 - format.extension.size(), ' ') + std::string(format.description) +
                (format.is_readable() ? "; pcvt check reads it" : "") + "\n";
    }
    text +=
        "\nWith three period vectors .vtu and .foam hold polyhedra, .msh, .inp and, with "
        "--mesh delaunay\nor grains, .vtu tetrahedra, .obj, .ply, .glb, .om and .stl surfaces, and "
        ".txt "
        "\"x y z\"\na line. With --mesh grains .foam holds tetrahedra, and .stl the surfaces of "
        "grains.\n";
    return text + "\nExample:\n  pcvt mesh --sites 300 --mesh grains -o tile.msh -o tile.svg\n";
}

/// Refuses a topic that is not among the words.
[[noreturn]] void refuse_topic(const std::string& topic, const std::vector<std::string>& words,
                               const std::string& remedy) {
    const std::string meant = nearest_word(topic, words);
    throw InvalidInput("help " + in_quotes(topic) + ": unknown; " +
                       (meant.empty() ? remedy : "did you mean " + meant + "?"));
}

std::string topic_text(const CLI::App& app, const std::string& topic) {
    if (topic.empty()) {
        // app.help() returns the help of the command that was parsed, which is `help`.
        return app.get_formatter()->make_help(&app, app.get_name(), CLI::AppFormatMode::Normal);
    }
    if (topic == "density") return density_help();
    if (topic == "formats") return formats_help();
    std::vector<std::string> topics;
    for (const CLI::App* command : app.get_subcommands(nullptr)) {
        if (command->get_name() == topic) return command->help("pcvt");
        topics.push_back(command->get_name());
    }
    topics.insert(topics.end(), {"density", "formats"});
    refuse_topic(topic, topics, "take a command, density or formats");
}

std::string man_text(const CLI::App& app, const std::string& name) {
    const std::vector<CommandWords> commands = option_tables(app);
    std::vector<std::string> names;
    for (const CommandWords& command : commands) {
        if (command.name == name) {
            const bool is_pcvt = name.empty();
            return manual_page(commands, command, version(),
                               is_pcvt ? std::vector<ManualSection>{{"Formats", formats_help()},
                                                                    {"Densities", density_help()}}
                                       : std::vector<ManualSection>{});
        }
        names.push_back(command.name);
    }
    refuse_topic(name, names, "--man takes a command, or none");
}

std::string mesh_options_json(const std::vector<CommandWords>& commands) {
    const CommandWords* const mesh =
        find_row(commands, [](const CommandWords& command) { return command.name == "mesh"; });
    return options_json(mesh->options);
}

/// A text that programs read; a row of a table of choices.
struct TextRow {
    const char* word;
    int abi_value;
    std::string (*text)(const std::vector<CommandWords>& commands);
};
constexpr std::array kShells{TextRow{"bash", 0, bash_completion},
                             TextRow{"zsh", 1, zsh_completion}};
constexpr std::array kForms{TextRow{"json", 0, mesh_options_json}};

template <class Table>
std::string chosen_text(const std::string& option, const std::string& word, const Table& table,
                        const CLI::App& app, const HelpOptions& options) {
    if (options.man || !options.topic.empty()) {
        throw InvalidInput(option + " takes neither a topic nor --man; leave them out");
    }
    return chosen_row(option, word, table).text(option_tables(app));
}

constexpr const char* kTopics = "mesh|pattern|study|check|density|formats";

}  // namespace

std::string formula_words() {
    return std::string("functions: ") + kFunctions + ";\nconstants: " + kConstants;
}

void add_help_options(CLI::App& app, HelpOptions& options) {
    app.add_option("TOPIC", options.topic, "a command, density or formats")
        ->type_name("")
        ->option_text(kTopics);
    app.add_flag("--man", options.man, "the page of a command, or of pcvt, for man");
    app.add_option("--completion", options.shell, "the script that completes the command line")
        ->type_name(listed_words(kShells, "|", "|"));
    app.add_option("--options", options.form,
                   "the options of pcvt mesh for programs: words, fields of pcvt.h, dimensions\n"
                   "and formats of each")
        ->type_name(listed_words(kForms, "|", "|"));
}

std::string help_text(const CLI::App& app, const HelpOptions& options) {
    if (!options.shell.empty()) {
        return chosen_text("--completion", options.shell, kShells, app, options);
    }
    if (!options.form.empty()) return chosen_text("--options", options.form, kForms, app, options);
    return options.man ? man_text(app, options.topic) : topic_text(app, options.topic);
}

}  // namespace pcvt::cli
