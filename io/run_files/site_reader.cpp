#include "io/run_files/site_reader.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "io/bytes/input_file.hpp"
#include "io/bytes/text.hpp"
#include "io/run_files/table_reader.hpp"
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
    static constexpr const char* kColumns = "X,Y";
};
template <>
struct Words<3> {
    static constexpr const char* kSite = "a site in space has 3 coordinates";
    static constexpr const char* kForm = "\"x y z\"";
    static constexpr const char* kColumns = "X,Y,Z";
};

template <int Dimension>
using Site = Eigen::Matrix<double, Dimension, 1>;

/// The columns of the coordinates.
template <int Dimension>
using Columns = std::array<std::size_t, Dimension>;

/// The only column whose name begins or ends with a letter, such as "Centroid x" or "Xc".
std::optional<std::size_t> column_with_letter(const TableScanner& scanner, char letter) {
    std::optional<std::size_t> found;
    for (std::size_t k = 0; k < scanner.n_columns(); ++k) {
        const std::string column = comparable_name(scanner.header()[k].name);
        if (!column.starts_with(letter) && !column.ends_with(letter)) continue;
        if (found) return std::nullopt;
        found = k;
    }
    return found;
}

/// Refuses a header without columns x, y and z; names those that may hold the coordinates.
template <int Dimension>
[[noreturn]] void refuse_no_coordinates(const TableScanner& scanner, const TableName& name,
                                        const std::string& missing) {
    std::string columns;
    for (const char letter : std::string_view("xyz").substr(0, Dimension)) {
        const std::optional<std::size_t> found = column_with_letter(scanner, letter);
        if (!found) {
            columns = Words<Dimension>::kColumns;
            break;
        }
        columns += (columns.empty() ? "" : ",") + scanner.typed(*found);
    }
    scanner.refuse_header("the header has no column " + missing +
                          "; name the columns of the coordinates, " +
                          with_columns(name, "", columns) + ", of " + scanner.listed_columns());
}

/// Returns the columns x, y and z of a header.
template <int Dimension>
Columns<Dimension> coordinate_columns(const TableScanner& scanner, const TableName& name) {
    constexpr std::array<const char*, 3> kNames{"x", "y", "z"};
    Columns<Dimension> columns{};
    for (std::size_t k = 0; k < Dimension; ++k) {
        const std::optional<std::size_t> found = scanner.find(kNames[k]);
        if (!found) refuse_no_coordinates<Dimension>(scanner, name, kNames[k]);
        columns[k] = *found;
    }
    if (Dimension == 2 && scanner.find("z")) {
        scanner.refuse_header(
            "the header has a column z; give three periods, or name two columns, " +
            with_columns(name, "", Words<Dimension>::kColumns));
    }
    return columns;
}

/// Returns the unit that the header states for all coordinates; empty without one.
template <int Dimension>
std::string coordinate_unit(const TableScanner& scanner, const Columns<Dimension>& columns) {
    if (!scanner.has_header()) return {};
    const TableColumn& first = scanner.header()[columns[0]];
    for (const std::size_t column : columns) {
        const TableColumn& other = scanner.header()[column];
        if (other.unit == first.unit) continue;
        scanner.refuse_header("columns " + comparable_name(first.name) + " and " +
                              comparable_name(other.name) +
                              " do not have the same unit; state one for all coordinates");
    }
    return first.unit;
}

/// Returns the columns of the coordinates; nothing if a row consists of them.
template <int Dimension>
std::optional<Columns<Dimension>> site_columns(TableScanner& scanner, const TableName& name) {
    if (scanner.n_columns() == 0) return std::nullopt;
    if (name.columns.empty()) {
        if (!scanner.has_header()) return std::nullopt;
        return coordinate_columns<Dimension>(scanner, name);
    }
    if (name.columns.size() != Dimension) {
        const std::size_t n = name.columns.size();
        scanner.refuse_header(std::string(Words<Dimension>::kSite) + ", " + std::to_string(n) +
                              (n == 1 ? " column is" : " columns are") + " named; write " +
                              with_columns(name, "", Words<Dimension>::kColumns));
    }
    const std::vector<std::size_t> chosen = scanner.choose(name.columns);
    Columns<Dimension> columns{};
    std::copy(chosen.begin(), chosen.end(), columns.begin());
    return columns;
}

/// Reads the site of a row that has its coordinates only.
template <int Dimension>
Site<Dimension> parse_row(TableScanner& scanner) {
    Site<Dimension> site;
    const std::size_t n = scanner.fields().size();
    for (std::size_t k = 0; k < n; ++k) {
        const double coordinate = scanner.number(k);
        if (k < Dimension) site[static_cast<Eigen::Index>(k)] = coordinate;
    }
    if (n != Dimension) {
        const bool is_of_space = Dimension == 2 && n == 3;
        scanner.refuse(std::string(Words<Dimension>::kSite) + ", this line has " +
                       std::to_string(n) + "; write " + Words<Dimension>::kForm +
                       (is_of_space ? ", or give three periods" : "") +
                       (n > Dimension ? std::string(", or name the columns, ") + scanner.name() +
                                            (Dimension == 2 ? ":1,2" : ":1,2,3")
                                      : ""));
    }
    return site;
}

/// Calls visit(site, its line) for each site until it returns false; returns whether it never did.
/// Sets the unit of the coordinates before.
template <int Dimension, class Visit>
bool for_each_site(const TableName& name, std::string_view text, std::string& unit,
                   const Visit& visit) {
    const std::string file = name.path == "-" ? "standard input" : name.path;
    refuse_binary(file, text,
                  std::string("give a text with ") + Words<Dimension>::kForm + " a line");
    TableScanner scanner(file, text);
    const std::optional<Columns<Dimension>> columns = site_columns<Dimension>(scanner, name);
    unit = columns ? coordinate_unit<Dimension>(scanner, *columns) : "";
    while (scanner.next()) {
        Site<Dimension> site;
        if (columns) {
            for (int k = 0; k < Dimension; ++k)
                site[k] = scanner.number((*columns)[std::size_t(k)]);
        } else {
            site = parse_row<Dimension>(scanner);
        }
        if (!visit(site, scanner.line())) return false;
    }
    return true;
}

template <int Dimension>
bool are_read_back(const std::string& name, std::string_view text,
                   const Eigen::Matrix<double, Dimension, Eigen::Dynamic>& sites) {
    Eigen::Index n = 0;
    std::string unit;
    const bool same = for_each_site<Dimension>(
        {.path = name}, text, unit, [&](const Site<Dimension>& site, int /*line*/) {
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
SiteFileOf<Dimension> parse_sites(const TableName& name, std::string_view text) {
    SiteFileOf<Dimension> file{name.path == "-" ? "standard input" : name.path, {}, {}, {}};
    std::vector<Site<Dimension>> sites;
    for_each_site<Dimension>(name, text, file.unit, [&](const Site<Dimension>& site, int line) {
        sites.push_back(site);
        file.lines.push_back(line);
        return true;
    });
    if (sites.empty()) {
        throw BadFile(file.name + ": holds no site; give one " + Words<Dimension>::kForm +
                      " a line");
    }
    file.points.resize(Dimension, static_cast<Eigen::Index>(sites.size()));
    std::copy(sites.begin(), sites.end(), file.points.colwise().begin());
    return file;
}

template <int Dimension>
SiteFileOf<Dimension> read_sites(const TableName& name) {
    return parse_sites<Dimension>(
        name, name.path == "-" ? read_standard_input() : read_whole_file(name.path, kSiteInput));
}

template SiteFile parse_sites<2>(const TableName& name, std::string_view text);
template SpaceSiteFile parse_sites<3>(const TableName& name, std::string_view text);
template SiteFile read_sites<2>(const TableName& name);
template SpaceSiteFile read_sites<3>(const TableName& name);

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
