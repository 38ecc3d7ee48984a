#include "plugin/cli/options/command_words.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include "io/formats/extension.hpp"

namespace pcvt::cli {
namespace {

constexpr std::array<std::string_view, 8> kLeftOut{"-o",      "--cells", "--report", "--threads",
                                                   "--quiet", "--force", "--strict", "--help"};
/// Options that take the name of a file, some of them in place of words.
constexpr std::array<std::string_view, 7> kOfFiles{
    "--input", "--centroids", "--areas", "--orientations", "--fixed", "--inclusions", "--density"};

template <std::size_t n>
bool contains(const std::array<std::string_view, n>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// The value without its folder, if it names a file. A formula may contain a slash.
std::string without_folder(const std::string& option, const std::string& value) {
    if (!contains(kOfFiles, option)) return value;
    if (option == "--density" && lower_case_extension(value) != ".png") return value;
    return std::filesystem::path(value).filename().string();
}

/// A word as a shell takes it.
std::string quoted(const std::string& word) {
    constexpr std::string_view kPlain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.,:+-/=%@#";
    if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
    std::string text = "'";
    for (const char c : word) c == '\'' ? text += "'\\''" : text += c;
    return text + "'";
}

}  // namespace

std::string command_words(const CLI::App& app) {
    std::string words = app.get_name();
    for (const CLI::Option* const option : app.get_options()) {
        const std::string name = option->get_name();
        if (option->count() == 0 || contains(kLeftOut, name)) continue;
        const bool is_flag = option->get_items_expected_max() == 0;
        for (const std::string& value : option->results()) {
            words += ' ' + name;
            if (!is_flag) words += ' ' + quoted(without_folder(name, value));
        }
    }
    return words;
}

}  // namespace pcvt::cli
