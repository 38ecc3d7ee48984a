#include "io/openfoam/foam_scanner.hpp"

#include <algorithm>
#include <utility>

#include "io/bytes/char_set.hpp"
#include "io/bytes/text.hpp"
#include "io/forms/tile_file.hpp"

namespace pcvt {
namespace {

constexpr CharSet kPunctuation("(){};");
constexpr CharSet kBlanks(" \t\r\n\v\f");
constexpr CharSet kEndOfWord("(){}; \t\r\n\v\f\"");

/// Returns the length of the comment at the beginning of `text`; 0 if there is none.
std::size_t comment_length(std::string_view text) {
    if (text.starts_with("//")) return std::min(text.find('\n'), text.size());
    if (!text.starts_with("/*")) return 0;
    const std::size_t end = text.find("*/");
    return end == std::string_view::npos ? text.size() : end + 2;
}

}  // namespace

FoamScanner::FoamScanner(std::string name, std::string_view text)
    : FoamScanner(std::move(name), text, 1) {
    expect("FoamFile");
    expect("{");
    for (std::string_view key = next(); key != "}"; key = next()) {
        if (key.empty()) throw_bad_file("the header does not end; give the whole file");
        if (key == "format" && next() != "ascii") {
            throw_bad_file("the format is not ascii; write the mesh with writeFormat ascii");
        }
        skip_entry();
    }
}

void FoamScanner::skip_blanks() {
    while (true) {
        std::size_t n = 0;
        while (n < rest_.size() && kBlanks.holds(rest_[n])) line_ += rest_[n++] == '\n' ? 1 : 0;
        rest_.remove_prefix(n);
        const std::size_t length = comment_length(rest_);
        if (length == 0) return;
        line_ += static_cast<int>(std::count(rest_.begin(), rest_.begin() + length, '\n'));
        rest_.remove_prefix(length);
    }
}

std::string_view FoamScanner::next() {
    skip_blanks();
    if (rest_.empty()) return {};
    std::size_t length = 1;
    if (rest_[0] == '"') {
        const std::size_t end = rest_.find('"', 1);
        length = end == std::string_view::npos ? rest_.size() : end + 1;
    } else if (!kPunctuation.holds(rest_[0])) {
        length = kEndOfWord.find_in(rest_);
    }
    const std::string_view token = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return token;
}

void FoamScanner::expect(std::string_view token) {
    const std::string_view found = next();
    if (found == token) return;
    throw_bad_file((found.empty() ? "the file ends" : "there is " + in_quotes(found)) + " where " +
                   in_quotes(token) + " should stand; give a file of an OpenFOAM case");
}

int FoamScanner::integer() {
    try {
        return parse_integer(next());
    } catch (const InvalidInput& fault) {
        throw_bad_file(fault.what());
    }
}

double FoamScanner::number() {
    try {
        return parse_number(next());
    } catch (const InvalidInput& fault) {
        throw_bad_file(fault.what());
    }
}

void FoamScanner::skip_entry() {
    for (std::string_view token = next(); token != ";"; token = next()) {
        if (token.empty() || token == "}") throw_bad_file("an entry does not end; close it with ;");
    }
}

int FoamScanner::begin_list() {
    const int n = integer();
    if (n < 0 || static_cast<std::size_t>(n) > rest_.size()) {
        throw_bad_file("a list of " + std::to_string(n) +
                       " does not fit the file; give the whole file");
    }
    expect("(");
    return n;
}

void FoamScanner::throw_bad_file(const std::string& complaint) const {
    throw BadFile(name_ + ":" + std::to_string(line_) + ": " + complaint);
}

}  // namespace pcvt
