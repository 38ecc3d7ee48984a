#include "io/run_files/orientation_reader.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/bytes/input_file.hpp"
#include "io/bytes/text.hpp"
#include "io/run_files/angle_columns.hpp"

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

std::vector<BungeAngles> parse_orientations(const TableName& name, std::string_view text) {
    refuse_binary(name.path, text, "give a text with \"phi1 Phi phi2\" a line");
    TableScanner scanner(name.path, text);
    std::vector<BungeAngles> orientations;
    AngleColumns found;
    if (scanner.n_columns() > 0) found = find_angles(scanner, name);
    const bool are_unnamed = name.columns.empty() && !scanner.has_header();
    while (scanner.next()) {
        if (are_unnamed && scanner.fields().size() != found.columns.size()) {
            scanner.refuse("an orientation has 3 angles, this line has " +
                           std::to_string(scanner.fields().size()) +
                           "; write \"phi1 Phi phi2\", or name three columns, " +
                           with_columns(name, name.prefix, "1,2,3"));
        }
        orientations.push_back(parse_angles(scanner, found));
    }
    if (orientations.empty()) {
        throw BadFile(name.path + ": holds no orientation; give one \"phi1 Phi phi2\" a line");
    }
    if (found.unit == AngleUnit::kGuessed && look_like_radians(orientations)) {
        throw BadFile(name.path +
                      ": no angle is above 2 pi and no Phi above pi, so the angles look like "
                      "radians; take --orientations rad:FILE, or deg:FILE if they are degrees");
    }
    return orientations;
}

std::vector<BungeAngles> read_orientations(const TableName& name) {
    return parse_orientations(name, read_whole_file(name.path, kSiteInput));
}

}  // namespace pcvt
