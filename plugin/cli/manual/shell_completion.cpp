#include "plugin/cli/manual/shell_completion.hpp"

namespace pcvt::cli {
namespace {

std::string joined(const std::vector<std::string>& words, const std::string& separator) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : separator) + word;
    return text;
}

/// The names of all commands; pcvt itself has none.
std::vector<std::string> command_names(const std::vector<CommandWords>& commands) {
    std::vector<std::string> names;
    for (const CommandWords& command : commands) {
        if (!command.name.empty()) names.push_back(command.name);
    }
    return names;
}

/// The assignments of bash for the value of an option or for an argument.
std::string bash_values(const OptionWords& option) {
    return "values='" + joined(option.values(), " ") +
           "' files=" + (option.takes_file() ? "1" : "");
}

/// The branch of a command: its options, its arguments, and the values of the option before.
std::string bash_branch(const CommandWords& command, const std::string& label) {
    std::vector<std::string> names;
    std::string arguments;
    std::string cases;
    for (const OptionWords& option : command.options) {
        if (option.is_argument) {
            arguments += "        " + bash_values(option) + "\n";
            continue;
        }
        names.insert(names.end(), option.names.begin(), option.names.end());
        if (option.form.empty()) continue;
        cases += "            " + joined(option.names, "|") + ") given=1 " + bash_values(option) +
                 " ;;\n";
    }
    std::string text = "    " + label + ")\n        options='" + joined(names, " ") + "'\n";
    text += arguments;
    if (!cases.empty()) text += "        case $before in\n" + cases + "        esac\n";
    return text + "        ;;\n";
}

constexpr const char* kBashHead =
    "# Completes the command pcvt in bash. Written by `pcvt help --completion bash`.\n"
    "_pcvt() {\n"
    "    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}\n"
    "    local command= options= values= files= given= k\n"
    "    # bash takes --mesh=vor for three words.\n"
    "    if [[ $word == '=' ]]; then\n"
    "        word=\n"
    "    elif [[ $before == '=' ]]; then\n"
    "        before=${COMP_WORDS[COMP_CWORD - 2]}\n"
    "    fi\n"
    "    for ((k = 1; k < COMP_CWORD; ++k)); do\n"
    "        [[ ${COMP_WORDS[k]} == -* ]] || { command=${COMP_WORDS[k]}; break; }\n"
    "    done\n"
    "    case $command in\n";

constexpr const char* kBashTail =
    "    esac\n"
    "    # An option that takes a value is not followed by another option.\n"
    "    [[ $given || $word != -* ]] || values=$options\n"
    "    COMPREPLY=($(compgen -W \"$values\" -- \"$word\"))\n"
    "    [[ $files && ( $given || $word != -* ) ]] || return 0\n"
    "    local IFS=$'\\n'\n"
    "    COMPREPLY+=($(compgen -f -- \"$word\"))\n"
    "    compopt -o filenames 2>/dev/null\n"
    "    return 0\n"
    "}\n"
    "complete -F _pcvt pcvt\n";

/// Escapes a text for _arguments and _describe within single quotes.
std::string zsh_text(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
        if (c == '\'') {
            escaped += "'\\''";
            continue;
        }
        if (c == ':' || c == '[' || c == ']' || c == '\\') escaped += '\\';
        escaped += c;
    }
    return escaped;
}

/// ":FORM:ACTION" of _arguments.
std::string zsh_value(const OptionWords& option) {
    const std::vector<std::string> values = option.values();
    const std::string words = "(" + joined(values, " ") + ")";
    std::string action = " ";
    if (option.takes_file()) {
        action = "_files";
    } else if (!values.empty()) {
        action = words;
    }
    const std::string label = option.form.empty() ? option.names[0] : option.form;
    return ":" + zsh_text(label) + ":" + action;
}

std::string zsh_specification(const OptionWords& option) {
    if (option.is_argument)
        return "'" + std::string(option.is_repeatable ? "*" : "1") + zsh_value(option) + "'";
    std::string text;
    for (const std::string& name : option.names) {
        if (!text.empty()) text += " ";
        text += "'" + std::string(option.is_repeatable ? "*" : "") + name + "[" +
                zsh_text(first_clause(option.description)) + "]" +
                (option.form.empty() ? "" : zsh_value(option)) + "'";
    }
    return text;
}

std::string zsh_branch(const CommandWords& command) {
    std::string text = "        " + command.name + ")\n            _arguments -S";
    for (const OptionWords& option : command.options) {
        text += " \\\n                " + zsh_specification(option);
    }
    return text + " && ret=0\n            ;;\n";
}

}  // namespace

std::string bash_completion(const std::vector<CommandWords>& commands) {
    std::string text = kBashHead;
    for (const CommandWords& command : commands) {
        if (!command.name.empty()) text += bash_branch(command, command.name);
    }
    CommandWords pcvt = commands.front();
    pcvt.options.push_back({.names = {"COMMAND"},
                            .form = joined(command_names(commands), "|"),
                            .description = {},
                            .group = {},
                            .is_argument = true});
    return text + bash_branch(pcvt, "''") + kBashTail;
}

std::string zsh_completion(const std::vector<CommandWords>& commands) {
    std::string text =
        "#compdef pcvt\n"
        "# Completes the command pcvt in zsh. Written by `pcvt help --completion zsh`.\n"
        "_pcvt() {\n"
        "    local curcontext=$curcontext state line ret=1\n"
        "    local -a commands=(\n";
    for (const CommandWords& command : commands) {
        if (command.name.empty()) continue;
        text +=
            "        '" + command.name + ":" + zsh_text(first_clause(command.description)) + "'\n";
    }
    text += "    )\n    _arguments -C -S";
    for (const OptionWords& option : commands.front().options) {
        text += " \\\n        " + zsh_specification(option);
    }
    text +=
        " \\\n        '1:command:->command' '*::argument:->argument' && ret=0\n"
        "    [[ $state == command ]] && _describe command commands && ret=0\n"
        "    [[ $state == argument ]] || return ret\n"
        "    case $line[1] in\n";
    for (const CommandWords& command : commands) {
        if (!command.name.empty()) text += zsh_branch(command);
    }
    return text + "    esac\n    return ret\n}\n_pcvt \"$@\"\n";
}

}  // namespace pcvt::cli
