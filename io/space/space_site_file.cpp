#include "io/space/space_site_file.hpp"

#include <algorithm>

#include "io/bytes/input_file.hpp"
#include "io/bytes/text.hpp"

namespace pcvt {
namespace {

Vec3 parse_site(const LineScanner& scanner, const std::vector<std::string_view>& words) {
    if (words.size() != 3) {
        scanner.throw_bad_file("a site in space has 3 coordinates, this line has " +
                               std::to_string(words.size()) + "; write \"x y z\"");
    }
    return {scanner.number(words[0]), scanner.number(words[1]), scanner.number(words[2])};
}

}  // namespace

SpaceSiteFile parse_space_sites(const std::string& name, std::string_view text) {
    refuse_binary(name, text, "give a text with \"x y z\" a line");
    SpaceSiteFile file{name, Points3(3, 0), {}};
    std::vector<Vec3> sites;
    LineScanner scanner(name, text);
    while (scanner.next()) {
        const std::vector<std::string_view> words = scanner.words_before_comment();
        if (words.empty()) continue;
        sites.push_back(parse_site(scanner, words));
        file.lines.push_back(scanner.line());
    }
    if (sites.empty()) throw BadFile(name + ": holds no site; give one \"x y z\" a line");
    file.points.resize(3, static_cast<Eigen::Index>(sites.size()));
    std::copy(sites.begin(), sites.end(), file.points.colwise().begin());
    return file;
}

SpaceSiteFile read_space_sites(const std::string& path) {
    if (path == "-") return parse_space_sites("standard input", read_standard_input());
    return parse_space_sites(path, read_whole_file(path, kSiteInput));
}

BadFile duplicate_lines(const SpaceSiteFile& file, const DuplicateSites& duplicate) {
    const int first = file.lines[static_cast<std::size_t>(duplicate.first())];
    const int second = file.lines[static_cast<std::size_t>(duplicate.second())];
    return BadFile(file.name + ":" + std::to_string(second) +
                   ": the site coincides with the site of line " + std::to_string(first) +
                   " modulo the lattice; remove one");
}

std::string encode_space_sites(const Points3& points) {
    std::string text = "# Sites written by pcvt, \"x y z\" a line\n";
    for (const auto& site : points.colwise()) {
        append_number(text, site.x());
        text += ' ';
        append_number(text, site.y());
        text += ' ';
        append_number(text, site.z());
        text += '\n';
    }
    return text;
}

}  // namespace pcvt
