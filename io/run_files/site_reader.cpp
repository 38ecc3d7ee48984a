#include "io/run_files/site_reader.hpp"

#include <algorithm>

#include "io/bytes/input_file.hpp"
#include "io/bytes/text.hpp"

namespace pcvt {
namespace {

Vec2 parse_site(const LineScanner& scanner, const std::vector<std::string_view>& words) {
    std::vector<double> numbers;
    for (const std::string_view word : words) numbers.push_back(scanner.number(word));
    if (numbers.size() != 2) {
        scanner.throw_bad_file("a site has 2 coordinates, this line has " +
                               std::to_string(numbers.size()) + "; write \"x y\"" +
                               (numbers.size() == 3 ? ", or give three periods" : ""));
    }
    return {numbers[0], numbers[1]};
}

/// Calls visit(site, its line) for each site until it returns false; returns whether it never did.
template <class Visit>
bool for_each_site(const std::string& name, std::string_view text, const Visit& visit) {
    refuse_binary(name, text, "give a text with \"x y\" a line");
    LineScanner scanner(name, text);
    while (scanner.next()) {
        const std::vector<std::string_view> words = scanner.words_before_comment();
        if (words.empty()) continue;
        if (!visit(parse_site(scanner, words), scanner.line())) return false;
    }
    return true;
}

}  // namespace

SiteFile parse_sites(const std::string& name, std::string_view text) {
    SiteFile file{name, {}, {}};
    std::vector<Vec2> sites;
    for_each_site(name, text, [&](const Vec2& site, int line) {
        sites.push_back(site);
        file.lines.push_back(line);
        return true;
    });
    if (sites.empty()) throw BadFile(name + ": holds no site; give one \"x y\" a line");
    file.points.resize(2, static_cast<Eigen::Index>(sites.size()));
    std::copy(sites.begin(), sites.end(), file.points.colwise().begin());
    return file;
}

bool reads_back(const std::string& name, std::string_view text, const Points& sites) {
    Eigen::Index n = 0;
    const bool same = for_each_site(name, text, [&](const Vec2& site, int /*line*/) {
        return n < sites.cols() && site == sites.col(n++);
    });
    return same && n == sites.cols();
}

SiteFile read_sites(const std::string& path) {
    if (path == "-") return parse_sites("standard input", read_standard_input());
    return parse_sites(path, read_whole_file(path, kSiteInput));
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
