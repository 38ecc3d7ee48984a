#include "io/run_files/orientation_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "io/bytes/input_file.hpp"
#include "io/bytes/text.hpp"
#include "io/run_files/angle_columns.hpp"
#include "io/run_files/orientation_list.hpp"
#include "mesher/cells/orientations.hpp"

namespace pcvt {
namespace {

constexpr double kHalfTurn = std::numbers::pi;
constexpr double kFullTurn = 2 * std::numbers::pi;
/// Angles in radians are often rounded to three decimals or more: pi is 3.142.
constexpr double kRounding = 2e-4;
/// Angles below this also occur between the grains of a single crystal, in degrees.
constexpr double kSmallAngle = 0.2;

double in_degrees(double radians) {
    if (!(std::abs(radians) <= kFullTurn * (1 + kRounding))) {
        throw InvalidInput("an angle of an orientation is not from -2 pi to 2 pi; correct it");
    }
    return std::clamp(radians * (180 / std::numbers::pi), -360.0, 360.0);
}

BungeAngles parse_angles(TableScanner& scanner, const AngleColumns& found) {
    const BungeAngles angles{scanner.number(found.columns[0]), scanner.number(found.columns[1]),
                             scanner.number(found.columns[2])};
    try {
        if (found.unit != AngleUnit::kRadians) return checked_angles(angles);
        return {in_degrees(angles.phi1), in_degrees(angles.Phi), in_degrees(angles.phi2)};
    } catch (const InvalidInput& fault) {
        scanner.refuse(fault.what());
    }
}

/// Names of columns of weights.
constexpr std::array<std::string_view, 3> kWeightNames{"weight", "weights", "volume fraction"};

/// The columns of a table of orientations.
struct OrientationColumns {
    AngleColumns angles;
    std::optional<std::size_t> weight = {};
};

std::optional<std::size_t> find_weights(const TableScanner& scanner) {
    if (!scanner.has_header() || scanner.find("x")) return std::nullopt;
    for (const std::string_view name : kWeightNames) {
        if (const auto column = scanner.find(name)) return column;
    }
    return std::nullopt;
}

/// The name of a table whose columns are those of a list with a head.
TableName name_with_head(TableName name, const ListHead& head) {
    if (name.columns.empty()) name.columns = {"1", "2", "3", "4"};
    const char* const stated = head.unit == AngleUnit::kRadians   ? "rad"
                               : head.unit == AngleUnit::kDegrees ? "deg"
                                                                  : "";
    if (name.prefix.empty()) name.prefix = stated;
    if (*stated != '\0' && name.prefix != stated) {
        throw BadFile(name.path + ": its comments state another unit of the angles than " +
                      name.prefix + ":; correct one of them");
    }
    return name;
}

OrientationColumns find_columns(TableScanner& scanner, const TableName& name) {
    constexpr std::size_t kAngles = 3;
    if (name.columns.size() == kAngles + 1) {
        TableName of_angles = name;
        of_angles.columns.pop_back();
        const AngleColumns angles = find_angles(scanner, of_angles);
        return {angles, scanner.choose({name.columns.back()}).front()};
    }
    OrientationColumns found{find_angles(scanner, name)};
    if (name.columns.empty()) found.weight = find_weights(scanner);
    return found;
}

double parse_weight(TableScanner& scanner, std::size_t column) {
    const double weight = scanner.number(column);
    if (weight >= 0 && weight <= kLargestEntryWeight) return weight;
    scanner.refuse(column, in_quotes(scanner.fields()[column]) +
                               " is not a weight; give a number from 0 to 1e150");
}

/// Requires three words a line where no columns are named.
void require_three_words(const TableScanner& scanner, const TableName& name) {
    const std::size_t n = scanner.fields().size();
    if (n == 3) return;
    scanner.refuse("an orientation has 3 angles, this line has " + std::to_string(n) +
                   "; write \"phi1 Phi phi2\", or name three columns, " +
                   with_columns(name, name.prefix, "1,2,3") + ", or with one of weights four");
}

/// Reads the rows of a table into `table`, and requires what holds for all of them.
void read_rows(TableScanner& scanner, const TableName& name, OrientationTable& table) {
    OrientationColumns found;
    if (scanner.n_columns() > 0) found = find_columns(scanner, name);
    const bool are_unnamed = name.columns.empty() && !scanner.has_header();
    while (scanner.next()) {
        if (are_unnamed) require_three_words(scanner, name);
        table.angles.push_back(parse_angles(scanner, found.angles));
        if (found.weight) table.weights.push_back(parse_weight(scanner, *found.weight));
    }
    if (table.angles.empty()) {
        throw BadFile(name.path + ": holds no orientation; give one \"phi1 Phi phi2\" a line");
    }
    if (found.angles.unit == AngleUnit::kGuessed && look_like_radians(table.angles)) {
        throw BadFile(name.path +
                      ": no angle is above 2 pi and no Phi above pi, so the angles look like "
                      "radians; take --orientations rad:FILE, or deg:FILE if they are degrees");
    }
    table.source = name.path;
    if (!found.weight) return;
    table.source += " by " + scanner.label(*found.weight);
    if (*std::max_element(table.weights.begin(), table.weights.end()) > 0) return;
    throw BadFile(name.path + ": all weights are 0; give one orientation a positive weight");
}

}  // namespace

bool look_like_radians(std::span<const BungeAngles> angles) {
    double largest = 0;
    double largest_tilt = 0;
    for (const BungeAngles& a : angles) {
        largest_tilt = std::max(largest_tilt, std::abs(a.Phi));
        largest = std::max({largest, std::abs(a.phi1), std::abs(a.Phi), std::abs(a.phi2)});
    }
    return angles.size() >= kFewestAngles && largest <= kFullTurn * (1 + kRounding) &&
           largest_tilt <= kHalfTurn * (1 + kRounding) && largest > kSmallAngle;
}

TableName orientation_table(const std::string& text) {
    return parse_table_name(text, {"rad", "deg"});
}

OrientationTable parse_orientations(const TableName& name, std::string_view text) {
    refuse_binary(name.path, text, "give a text with \"phi1 Phi phi2\" a line");
    OrientationTable table;
    const std::optional<ListHead> head = list_head(name.path, text);
    TableScanner scanner(name.path, head ? head->rows : text);
    read_rows(scanner, head ? name_with_head(name, *head) : name, table);
    if (!head || std::ssize(table.angles) == head->n_rows) return table;
    throw BadFile(name.path + ": its head states " + std::to_string(head->n_rows) +
                  " orientations, but it has " + std::to_string(table.angles.size()) +
                  "; correct the head, or restore the missing lines");
}

OrientationTable read_orientations(const TableName& name) {
    return parse_orientations(name, read_whole_file(name.path, kSiteInput));
}

}  // namespace pcvt
