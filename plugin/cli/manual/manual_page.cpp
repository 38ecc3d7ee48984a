#include "plugin/cli/manual/manual_page.hpp"

#include <algorithm>
#include <string_view>

namespace pcvt::cli {
namespace {

/// The command that shows a page and the completion, which has no page of its own.
constexpr std::string_view kWithoutPage = "help";

/// Escapes the characters that roff would replace by typographic ones.
std::string escaped(const std::string& text) {
    std::string roff;
    for (const char c : text) {
        switch (c) {
            case '\\':
                roff += "\\e";
                break;
            case '-':
                roff += "\\-";
                break;
            case '\'':
                roff += "\\(aq";
                break;
            case '`':
                roff += "\\(ga";
                break;
            case '^':
                roff += "\\(ha";
                break;
            case '~':
                roff += "\\(ti";
                break;
            default:
                roff += c;
        }
    }
    return roff;
}

/// A line of text; roff would read a leading dot as a request.
std::string text_line(const std::string& line) {
    return (line.starts_with('.') ? "\\&" : "") + escaped(line) + "\n";
}

/// Splits at line feeds, without the empty lines at both ends.
std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::size_t begin = 0;
    while (begin < text.size()) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        lines.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    while (!lines.empty() && lines.back().empty()) lines.pop_back();
    const auto first =
        std::find_if(lines.begin(), lines.end(), [](const auto& line) { return !line.empty(); });
    lines.erase(lines.begin(), first);
    return lines;
}

std::string in_capitals(std::string text) {
    for (char& c : text) {
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    }
    return text;
}

std::string heading(const std::string& title) {
    return ".SH \"" + escaped(in_capitals(title)) + "\"\n";
}

std::string paragraph(const std::string& text) {
    std::string roff;
    for (const std::string& line : lines_of(text)) {
        roff += line.empty() ? ".PP\n" : text_line(line);
    }
    return roff;
}

/// Lines as they are.
std::string verbatim(const std::string& text) {
    std::string roff = ".nf\n";
    for (const std::string& line : lines_of(text)) roff += line.empty() ? ".sp\n" : text_line(line);
    return roff + ".fi\n";
}

/// "Examples:\n  pcvt ..." becomes a section of that title.
std::string footer_sections(const std::string& footer) {
    std::string roff;
    std::string body;
    const auto close = [&] {
        if (!lines_of(body).empty()) roff += verbatim(body);
        body.clear();
    };
    const std::vector<std::string> lines = lines_of(footer);
    for (std::size_t k = 0; k < lines.size(); ++k) {
        const std::string& line = lines[k];
        const bool before_indented = k + 1 < lines.size() && lines[k + 1].starts_with(' ');
        const bool is_title = before_indented && !line.starts_with(' ') && line.ends_with(':');
        if (is_title) {
            close();
            roff += heading(line.substr(0, line.size() - 1));
        } else {
            if (roff.empty()) roff = heading("Notes");
            body += line + "\n";
        }
    }
    close();
    return roff;
}

std::string option_item(const OptionWords& option) {
    std::string head;
    for (const std::string& name : option.names) {
        head += (head.empty() ? "" : ", ") + ("\\fB" + escaped(name) + "\\fR");
    }
    if (!option.form.empty()) head += " \\fI" + escaped(option.form) + "\\fR";
    return ".TP\n" + head + "\n" + paragraph(option.description);
}

/// The options under their headings, in the order of the help.
std::string option_sections(const CommandWords& command) {
    std::vector<std::string> groups;
    for (const OptionWords& option : command.options) {
        if (std::find(groups.begin(), groups.end(), option.group) == groups.end()) {
            groups.push_back(option.group);
        }
    }
    std::string roff = heading("Options");
    for (const std::string& group : groups) {
        if (group != "Options") roff += ".SS \"" + escaped(group) + "\"\n";
        for (const OptionWords& option : command.options) {
            if (option.group == group) roff += option_item(option);
        }
    }
    return roff;
}

std::string page_name(const CommandWords& command) {
    return command.name.empty() ? "pcvt" : "pcvt-" + command.name;
}

std::string synopsis(const CommandWords& command) {
    std::string words = ".B pcvt" + (command.name.empty() ? "" : " " + command.name) + "\n";
    if (command.name.empty()) return words + "\\fICOMMAND\\fR [\\fIOPTION\\fR]...\n";
    words += "[\\fIOPTION\\fR]...";
    for (const OptionWords& option : command.options) {
        if (!option.is_argument) continue;
        words +=
            " [\\fI" + escaped(option.names[0]) + "\\fR]" + (option.is_repeatable ? "..." : "");
    }
    return words + "\n";
}

std::string command_list(const std::vector<CommandWords>& commands) {
    std::string roff = heading("Commands");
    for (const CommandWords& command : commands) {
        if (command.name.empty()) continue;
        roff += ".TP\n\\fB" + escaped(command.name) + "\\fR\n" + paragraph(command.description);
    }
    return roff;
}

std::string references(const std::vector<CommandWords>& commands, const CommandWords& own) {
    std::string roff;
    for (const CommandWords& command : commands) {
        if (command.name == own.name || command.name == kWithoutPage) continue;
        roff += (roff.empty() ? "" : ",\n") + (".BR " + escaped(page_name(command)) + " (1)");
    }
    return roff.empty() ? roff : heading("See also") + roff + "\n";
}

}  // namespace

std::string manual_page(const std::vector<CommandWords>& commands, const CommandWords& command,
                        const std::string& version, const std::vector<ManualSection>& sections) {
    std::string roff = ".TH " + escaped(in_capitals(page_name(command))) + " 1 \"\" \"pcvt " +
                       version + "\" \"pcvt\"\n";
    roff += heading("Name") + escaped(page_name(command)) + " \\- " + escaped(command.description) +
            "\n";
    roff += heading("Synopsis") + synopsis(command);
    if (command.name.empty()) roff += command_list(commands);
    roff += option_sections(command) + footer_sections(command.footer);
    for (const ManualSection& section : sections) {
        roff += heading(section.title) + verbatim(section.text);
    }
    return roff + references(commands, command);
}

}  // namespace pcvt::cli
