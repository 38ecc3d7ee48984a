#include "io/run_files/site_reader.hpp"

#include <algorithm>

#include "io/bytes/input_file.hpp"
#include "io/bytes/text.hpp"
#include "mesher/base/site_id.hpp"

namespace pcvt {
namespace {

/// How messages name the coordinates of a site.
template <int Dimension>
struct Words;
template <>
struct Words<2> {
    static constexpr const char* kSite = "a site has 2 coordinates";
    static constexpr const char* kForm = "\"x y\"";
};
template <>
struct Words<3> {
    static constexpr const char* kSite = "a site in space has 3 coordinates";
    static constexpr const char* kForm = "\"x y z\"";
};

template <int Dimension>
using Site = Eigen::Matrix<double, Dimension, 1>;

template <int Dimension>
Site<Dimension> parse_site(const LineScanner& scanner, const std::vector<std::string_view>& words) {
    std::vector<double> numbers;
    for (const std::string_view word : words) numbers.push_back(scanner.number(word));
    if (numbers.size() != Dimension) {
        const bool is_of_space = Dimension == 2 && numbers.size() == 3;
        scanner.throw_bad_file(std::string(Words<Dimension>::kSite) + ", this line has " +
                               std::to_string(numbers.size()) + "; write " +
                               Words<Dimension>::kForm +
                               (is_of_space ? ", or give three periods" : ""));
    }
    return Site<Dimension>(numbers.data());
}

/// Calls visit(site, its line) for each site until it returns false; returns whether it never did.
template <int Dimension, class Visit>
bool for_each_site(const std::string& name, std::string_view text, const Visit& visit) {
    refuse_binary(name, text,
                  std::string("give a text with ") + Words<Dimension>::kForm + " a line");
    LineScanner scanner(name, text);
    while (scanner.next()) {
        const std::vector<std::string_view> words = scanner.words_before_comment();
        if (words.empty()) continue;
        if (!visit(parse_site<Dimension>(scanner, words), scanner.line())) return false;
    }
    return true;
}

template <int Dimension>
bool are_read_back(const std::string& name, std::string_view text,
                   const Eigen::Matrix<double, Dimension, Eigen::Dynamic>& sites) {
    Eigen::Index n = 0;
    const bool same =
        for_each_site<Dimension>(name, text, [&](const Site<Dimension>& site, int /*line*/) {
            return n < sites.cols() && site == sites.col(n++);
        });
    return same && n == sites.cols();
}

template <int Dimension>
BadFile with_lines(const SiteFileOf<Dimension>& file, const DuplicateSites& duplicate) {
    const auto line = [&file](SiteId s) { return std::to_string(file.lines[std::size_t(s)]); };
    const std::string first = line(duplicate.first());
    const std::string second = line(duplicate.second());
    const std::string place = file.name + ":" + second + ": ";
    const std::string how = " modulo the lattice, to 1e-9 of the spacing";
    const bool same = file.points.col(duplicate.first()) == file.points.col(duplicate.second());
    const std::string remedy =
        std::string(same ? "" : ", or give the periods by --period or --lattice") +
        ", or add --duplicates drop";
    const auto& pairs = duplicate.pairs();
    if (pairs.size() == 1) {
        return BadFile(place + "the site coincides with the site of line " + first + how +
                       "; remove one" + remedy);
    }
    return BadFile(place + std::to_string(pairs.size()) + " sites coincide with earlier ones" +
                   how + ": " + coincidence_list(pairs, [&](int s) { return "line " + line(s); }) +
                   "; remove them" + remedy);
}

}  // namespace

template <int Dimension>
SiteFileOf<Dimension> parse_sites(const std::string& name, std::string_view text) {
    SiteFileOf<Dimension> file{name, {}, {}};
    std::vector<Site<Dimension>> sites;
    for_each_site<Dimension>(name, text, [&](const Site<Dimension>& site, int line) {
        sites.push_back(site);
        file.lines.push_back(line);
        return true;
    });
    if (sites.empty()) {
        throw BadFile(name + ": holds no site; give one " + Words<Dimension>::kForm + " a line");
    }
    file.points.resize(Dimension, static_cast<Eigen::Index>(sites.size()));
    std::copy(sites.begin(), sites.end(), file.points.colwise().begin());
    return file;
}

template <int Dimension>
SiteFileOf<Dimension> read_sites(const std::string& path) {
    if (path == "-") return parse_sites<Dimension>("standard input", read_standard_input());
    return parse_sites<Dimension>(path, read_whole_file(path, kSiteInput));
}

template SiteFile parse_sites<2>(const std::string& name, std::string_view text);
template SpaceSiteFile parse_sites<3>(const std::string& name, std::string_view text);
template SiteFile read_sites<2>(const std::string& path);
template SpaceSiteFile read_sites<3>(const std::string& path);

bool reads_back(const std::string& name, std::string_view text, const Eigen::Matrix2Xd& sites) {
    return are_read_back<2>(name, text, sites);
}

bool reads_back(const std::string& name, std::string_view text, const Eigen::Matrix3Xd& sites) {
    return are_read_back<3>(name, text, sites);
}

BadFile duplicate_lines(const SiteFile& file, const DuplicateSites& duplicate) {
    return with_lines(file, duplicate);
}

BadFile duplicate_lines(const SpaceSiteFile& file, const DuplicateSites& duplicate) {
    return with_lines(file, duplicate);
}

}  // namespace pcvt
