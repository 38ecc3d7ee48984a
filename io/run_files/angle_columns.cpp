#include "io/run_files/angle_columns.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "io/bytes/text.hpp"

namespace pcvt {
namespace {

using Columns = std::array<std::size_t, 3>;

/// Words of names such as "Avg_Euler_Angles_0" or "Mean Orientation phi1".
constexpr std::array<std::string_view, 9> kAngleWords{
    "orientation", "average", "angles", "eulers", "angle", "euler", "mean", "bunge", "avg"};
constexpr std::array<std::string_view, 3> kMeanWords{"average", "mean", "avg"};
constexpr std::array<std::string_view, 4> kRadianWords{"radians", "radian", "rad", "rads"};
constexpr std::array<std::string_view, 4> kDegreeWords{"degrees", "degree", "deg", "degs"};

template <class Words>
bool holds(const Words& words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

/// Removes the last of `words` that ends `name`, and says whether there is one.
template <class Words>
bool remove_end(std::string& name, const Words& words) {
    for (const std::string_view word : words) {
        if (!name.ends_with(word)) continue;
        name.resize(name.size() - word.size());
        return true;
    }
    return false;
}

/// Whether a name consists of the words of angles, or of none.
bool consists_of_words(std::string name) {
    while (!name.empty()) {
        if (!remove_end(name, kAngleWords)) return false;
    }
    return true;
}

/// The name of a column as an angle: "EulerAngles_0" has the role 0 of the numbered angles with the
/// stem "eulerangles".
struct AngleName {
    std::string stem;
    /// The numbered angles begin at 0 or 1, or are called phi1, Phi and phi2.
    enum class Style { kFromZero, kFromOne, kPhi } style = Style::kPhi;
    std::size_t role = 0;
};
using Style = AngleName::Style;

/// Returns the angles that a column may be; a name with the digit 1 or 2 has two styles.
std::vector<AngleName> angle_names(const TableColumn& column) {
    std::string name = comparable_name(column.name);
    if (!remove_end(name, kRadianWords)) remove_end(name, kDegreeWords);
    std::string behind;
    while (remove_end(name, kMeanWords)) behind += "mean";
    constexpr std::array<std::string_view, 3> kRoles{"phi1", "phi", "phi2"};
    for (std::size_t role = 0; role < kRoles.size(); ++role) {
        if (!name.ends_with(kRoles[role])) continue;
        const std::string stem = name.substr(0, name.size() - kRoles[role].size());
        if (consists_of_words(stem)) return {{stem + behind, Style::kPhi, role}};
    }
    if (name.empty() || name.find("euler") == std::string::npos) return {};
    const char digit = name.back();
    name.pop_back();
    if (digit < '0' || digit > '3' || !consists_of_words(name)) return {};
    const auto number = static_cast<std::size_t>(digit - '0');
    std::vector<AngleName> names;
    if (number < 3) names.push_back({name + behind, Style::kFromZero, number});
    if (number > 0) names.push_back({name + behind, Style::kFromOne, number - 1});
    return names;
}

/// All triples of columns whose names are those of the three angles.
std::vector<Columns> angle_triples(const TableScanner& scanner) {
    struct Triple {
        AngleName name;
        std::array<std::optional<std::size_t>, 3> columns;
    };
    std::vector<Triple> triples;
    for (std::size_t k = 0; k < scanner.n_columns(); ++k) {
        for (const AngleName& name : angle_names(scanner.header()[k])) {
            const auto known = std::find_if(triples.begin(), triples.end(), [&](const Triple& t) {
                return t.name.stem == name.stem && t.name.style == name.style;
            });
            Triple& triple =
                known == triples.end() ? triples.emplace_back(Triple{name, {}}) : *known;
            if (triple.columns[name.role]) {
                scanner.refuse_header("columns " + std::to_string(*triple.columns[name.role] + 1) +
                                      " and " + std::to_string(k + 1) +
                                      " have the name of one angle; rename one");
            }
            triple.columns[name.role] = k;
        }
    }
    std::vector<Columns> complete;
    for (const Triple& triple : triples) {
        const auto& c = triple.columns;
        if (c[0] && c[1] && c[2]) complete.push_back({*c[0], *c[1], *c[2]});
    }
    return complete;
}

Columns only_triple(const TableScanner& scanner, const TableName& name) {
    const std::vector<Columns> triples = angle_triples(scanner);
    if (triples.size() == 1) return triples.front();
    if (triples.empty()) {
        scanner.refuse_header("the header has no columns phi1, Phi and phi2; name the columns, " +
                              with_columns(name, name.prefix, "COLUMN,COLUMN,COLUMN") + ", of " +
                              scanner.listed_columns());
    }
    std::string columns;
    for (const std::size_t k : triples.front()) {
        columns += (columns.empty() ? "" : ",") + scanner.typed(k);
    }
    scanner.refuse_header(
        "both " + scanner.label(triples[0][0]) + " and " + scanner.label(triples[1][0]) +
        " begin three angles; name three, such as " + with_columns(name, name.prefix, columns));
}

/// The unit that the header states for a column.
std::optional<AngleUnit> stated_unit(const TableScanner& scanner, std::size_t column) {
    const TableColumn& header = scanner.header()[column];
    const std::string unit = comparable_name(header.unit);
    std::string name = comparable_name(header.name);
    if (holds(kRadianWords, unit) || remove_end(name, kRadianWords)) return AngleUnit::kRadians;
    if (holds(kDegreeWords, unit) || remove_end(name, kDegreeWords)) return AngleUnit::kDegrees;
    if (unit.empty()) return std::nullopt;
    scanner.refuse_header(scanner.label(column) + " has the unit " + in_quotes(header.unit) +
                          "; give angles in deg or rad");
}

AngleUnit unit_of(const TableScanner& scanner, const TableName& name, const Columns& columns) {
    std::optional<AngleUnit> unit;
    if (name.prefix == "rad") unit = AngleUnit::kRadians;
    if (name.prefix == "deg") unit = AngleUnit::kDegrees;
    if (!scanner.has_header()) return unit.value_or(AngleUnit::kGuessed);
    const std::optional<AngleUnit> first = stated_unit(scanner, columns[0]);
    for (const std::size_t column : columns) {
        if (stated_unit(scanner, column) == first) continue;
        scanner.refuse_header(scanner.label(columns[0]) + " and " + scanner.label(column) +
                              " do not have the same unit; state one for all three angles");
    }
    if (unit && first && unit != first) {
        scanner.refuse_header("the header states another unit of the angles than " + name.prefix +
                              ":; correct one of them");
    }
    return unit ? *unit : first.value_or(AngleUnit::kGuessed);
}

}  // namespace

AngleColumns find_angles(TableScanner& scanner, const TableName& name) {
    AngleColumns angles;
    if (!name.columns.empty()) {
        if (name.columns.size() != angles.columns.size()) {
            scanner.refuse_header(
                "an orientation has 3 angles, " + std::to_string(name.columns.size()) +
                (name.columns.size() == 1 ? " column is" : " columns are") + " named; write " +
                with_columns(name, name.prefix, "COLUMN,COLUMN,COLUMN"));
        }
        const std::vector<std::size_t> chosen = scanner.choose(name.columns);
        std::copy(chosen.begin(), chosen.end(), angles.columns.begin());
    } else if (scanner.has_header()) {
        angles.columns = only_triple(scanner, name);
    }
    angles.unit = unit_of(scanner, name, angles.columns);
    return angles;
}

}  // namespace pcvt
