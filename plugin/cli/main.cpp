#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cstdio>

#include "mesher/base/error.hpp"
#include "plugin/cli/check_command.hpp"
#include "plugin/cli/help_command.hpp"
#include "plugin/cli/mesh_command.hpp"
#include "plugin/cli/mesh_job.hpp"
#include "plugin/cli/pattern_command.hpp"
#include "plugin/cli/study_command.hpp"
#include "plugin/cli/terminal/cancel_signal.hpp"
#include "plugin/cli/terminal/console.hpp"
#include "plugin/cli/terminal/malloc_tuning.hpp"
#include "plugin/cli/terminal/start_guard.hpp"
#include "plugin/cli/unknown_argument.hpp"
#include "plugin/job/version.hpp"

namespace pcvt::cli {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  pcvt mesh --sites 300 -o tile.obj -o tile.svg\n"
    "  pcvt mesh --input sites.txt --lattice 1,0,0.37,0.81 --mesh delaunay -o tile.glb\n"
    "  pcvt pattern --sites 56 -o pattern.svg\n"
    "  pcvt study fig11 -o results/\n"
    "  pcvt check tile.obj tile.glb\n\n";

/// The parser of the whole command line and the options that it fills.
struct CommandLine {
    CLI::App app{"Periodic centroidal Voronoi tessellations of the flat torus, as seamless tiles",
                 "pcvt"};
    CLI::App* mesh = nullptr;
    CLI::App* pattern = nullptr;
    CLI::App* study = nullptr;
    CLI::App* check = nullptr;
    CLI::App* help = nullptr;
    MeshOptions mesh_options;
    MeshOptions pattern_options;
    StudyOptions study_options;
    CheckOptions check_options;
    HelpOptions help_options;
};

void describe(CommandLine& line) {
    CLI::App& app = line.app;
    app.get_formatter()->column_width(28);
    app.get_formatter()->label("SUBCOMMAND", "COMMAND");
    app.set_help_flag("--help,-h", "this text; pcvt COMMAND --help for a command");
    app.set_version_flag("--version", version(), "the version");
    app.require_subcommand(0, 1);
    line.mesh = app.add_subcommand("mesh", "sites -> optimised periodic CVT -> files");
    line.pattern = app.add_subcommand("pattern", "the best exact lattice for n -> files");
    line.study = app.add_subcommand("study", "many runs -> the paper's tables and figures");
    line.check = app.add_subcommand("check", "proves or refutes that a file is a periodic tile");
    line.help = app.add_subcommand("help", "about a command, density or formats");
    for (CLI::App* command : {line.mesh, line.pattern, line.study, line.check, line.help})
        command->set_help_flag("--help,-h", "this text");
    add_mesh_options(*line.mesh, line.mesh_options);
    add_pattern_options(*line.pattern, line.pattern_options);
    add_study_options(*line.study, line.study_options);
    add_check_options(*line.check, line.check_options);
    add_help_options(*line.help, line.help_options);
    app.footer(std::string(kExamples) + exit_code_help());
}

/// The parser of the command that was given; that of the whole line if none was given.
const CLI::App& chosen(const CommandLine& line) {
    for (const CLI::App* command : {line.mesh, line.pattern, line.study, line.check, line.help}) {
        if (command->parsed()) return *command;
    }
    return line.app;
}

/// The name of the command and a blank, or nothing.
std::string command_name(const CommandLine& line) {
    return &chosen(line) == &line.app ? "" : chosen(line).get_name() + " ";
}

ExitCode run_chosen(const CommandLine& line) {
    if (line.mesh->parsed()) {
        const Job job = make_job(*line.mesh, line.mesh_options);
        end_start_guard();
        return run_mesh(job, line.mesh_options);
    }
    if (line.pattern->parsed()) {
        const Job job = make_pattern_job(*line.pattern, line.pattern_options);
        end_start_guard();
        return run_mesh(job, line.pattern_options);
    }
    if (line.study->parsed()) {
        const StudyRequest request = make_study_request(*line.study, line.study_options);
        end_start_guard();
        return run_study_command(request, line.study_options);
    }
    if (line.check->parsed()) return run_check(*line.check, line.check_options);
    print(help_text(line.app, line.help_options));
    return ExitCode::kDone;
}

ExitCode run(int argc, const char* const* argv) {
    CommandLine line;
    describe(line);
    try {
        line.app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        print(chosen(line).help(&chosen(line) == &line.app ? "" : "pcvt"));
        return ExitCode::kDone;
    } catch (const CLI::CallForVersion&) {
        print(std::string("pcvt ") + version() + "\n");
        return ExitCode::kDone;
    } catch (const CLI::ExtrasError&) {
        throw InvalidInput(unknown_argument(line.app, {argv, static_cast<std::size_t>(argc)}));
    } catch (const CLI::ParseError& error) {
        throw InvalidInput(std::string(error.what()) + "; see pcvt " + command_name(line) +
                           "--help");
    }
    return run_chosen(line);
}

}  // namespace
}  // namespace pcvt::cli

int main(int argc, char** argv) {
    pcvt::cli::begin_main();
    pcvt::cli::ignore_signals_of_writes();
    pcvt::cli::keep_freed_memory();
    try {
        return static_cast<int>(pcvt::cli::run(argc, argv));
    } catch (...) {
        const pcvt::cli::Failure failure = pcvt::cli::describe_failure(std::current_exception());
        std::fprintf(stderr, "%s\n", failure.line.data());
        return static_cast<int>(failure.code);
    }
}
