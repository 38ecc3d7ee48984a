#include "io/run_files/site_reader.hpp"

#include <algorithm>

#include "io/bytes/text.hpp"

namespace pcvt {
namespace {

/// Returns the words of the current line before the first #.
std::vector<std::string_view> words_before_comment(const LineScanner& scanner) {
    std::vector<std::string_view> words;
    for (const std::string_view word : scanner.words()) {
        const std::size_t comment = word.find('#');
        if (comment != 0) words.push_back(word.substr(0, comment));
        if (comment != std::string_view::npos) break;
    }
    return words;
}

Vec2 parse_site(const LineScanner& scanner, const std::vector<std::string_view>& words) {
    std::vector<double> numbers;
    for (const std::string_view word : words) numbers.push_back(scanner.number(word));
    if (numbers.size() != 2) {
        scanner.throw_bad_file("a site has 2 coordinates, this line has " +
                               std::to_string(numbers.size()) + "; write \"x y\"");
    }
    return {numbers[0], numbers[1]};
}

}  // namespace

SiteFile parse_sites(const std::string& name, std::string_view text) {
    refuse_binary(name, text, "give a text with \"x y\" a line");
    SiteFile file{name, {}, {}};
    std::vector<Vec2> sites;
    LineScanner scanner(name, text);
    while (scanner.next()) {
        const std::vector<std::string_view> words = words_before_comment(scanner);
        if (words.empty()) continue;
        sites.push_back(parse_site(scanner, words));
        file.lines.push_back(scanner.line());
    }
    if (sites.empty()) throw BadFile(name + ": holds no site; give one \"x y\" a line");
    file.points.resize(2, static_cast<Eigen::Index>(sites.size()));
    std::copy(sites.begin(), sites.end(), file.points.colwise().begin());
    return file;
}

SiteFile read_sites(const std::string& path) {
    const std::string name = path == "-" ? "standard input" : path;
    return parse_sites(name, read_whole_file(path, true));
}

BadFile duplicate_lines(const SiteFile& file, const DuplicateSites& duplicate) {
    const int first = file.lines[static_cast<std::size_t>(duplicate.first())];
    const int second = file.lines[static_cast<std::size_t>(duplicate.second())];
    const bool same = file.points.col(duplicate.first()) == file.points.col(duplicate.second());
    return BadFile(file.name + ":" + std::to_string(second) +
                   ": the site coincides with the site of line " + std::to_string(first) +
                   " modulo the lattice, to 1e-9 of the spacing; remove one" +
                   (same ? "" : ", or give the periods by --period or --lattice"));
}

}  // namespace pcvt
