#include "io/bytes/file_fields.hpp"

#include <algorithm>

#include "io/bytes/text.hpp"

namespace pcvt {
namespace {

constexpr const char* kRemedy = "; write the file again with pcvt";

[[noreturn]] void throw_bad_field(const std::string& name, int line, const std::string& complaint) {
    throw BadFile(name + (line > 0 ? ":" + std::to_string(line) : "") + ": " + complaint + kRemedy);
}

/// Whether a word is the number `expected`, written in another way.
bool same_number(std::string_view found, std::string_view expected) {
    try {
        return parse_number(found) == parse_number(expected);
    } catch (const InvalidInput&) {
        return false;
    }
}

bool same_word(const FileWord& found, const FileWord& expected) {
    return found.text == expected.text || same_number(found.text, expected.text);
}

void compare_part(const std::string& name, const std::string& part,
                  const std::vector<FileWord>& found, const std::vector<FileWord>& expected) {
    const auto [word, wanted] =
        std::mismatch(found.begin(), found.end(), expected.begin(), expected.end(), same_word);
    if (word == found.end() && wanted == expected.end()) return;
    if (word == found.end()) {
        throw_bad_field(name, found.empty() ? 0 : found.back().line,
                        part + " ends where its tile has " + in_quotes(wanted->text));
    }
    throw_bad_field(name, word->line,
                    part + " has " + in_quotes(word->text) + " where its tile has " +
                        (wanted == expected.end() ? "nothing" : in_quotes(wanted->text)));
}

}  // namespace

void compare_fields(const FileFields& found, const FileFields& expected) {
    for (const auto& [part, words] : expected.parts) {
        const auto same = found.parts.find(part);
        if (same == found.parts.end()) throw_bad_field(found.name, 0, "lacks " + part);
        compare_part(found.name, part, same->second, words);
    }
    for (const auto& [part, words] : found.parts) {
        if (expected.parts.count(part) > 0) continue;
        throw_bad_field(found.name, words.empty() ? 0 : words.front().line,
                        part + " does not belong to its tile");
    }
}

void compare_files(const std::vector<EncodedFile>& files, const std::vector<EncodedFile>& expected,
                   FieldReader* fields) {
    for (const EncodedFile& wanted : expected) {
        const auto found = std::find_if(files.begin(), files.end(), [&](const EncodedFile& file) {
            return file.path == wanted.path;
        });
        if (found == files.end() || found->bytes == wanted.bytes) continue;
        const std::optional<FileFields> stated = fields(found->path, found->bytes);
        if (!stated) continue;
        // A note of the writer in a file that it writes without one belongs to no tile.
        const FileFields none{.name = wanted.path, .parts = {}};
        compare_fields(*stated, fields(wanted.path, wanted.bytes).value_or(none));
    }
}

}  // namespace pcvt
