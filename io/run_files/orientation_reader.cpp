#include "io/run_files/orientation_reader.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/bytes/input_file.hpp"
#include "io/bytes/text.hpp"

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

BungeAngles parse_angles(const LineScanner& scanner, const std::vector<std::string_view>& words,
                         AngleUnit unit) {
    const BungeAngles angles{scanner.number(words[0]), scanner.number(words[1]),
                             scanner.number(words[2])};
    try {
        if (unit != AngleUnit::kRadians) return checked_angles(angles);
        return {in_degrees(angles.phi1), in_degrees(angles.Phi), in_degrees(angles.phi2)};
    } catch (const InvalidInput& fault) {
        scanner.throw_bad_file(fault.what());
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

std::vector<BungeAngles> parse_orientations(const std::string& name, std::string_view text,
                                            AngleUnit unit) {
    refuse_binary(name, text, "give a text with \"phi1 Phi phi2\" a line");
    LineScanner scanner(name, text);
    std::vector<BungeAngles> orientations;
    while (scanner.next()) {
        const std::vector<std::string_view> words = scanner.words_before_comment();
        if (words.empty()) continue;
        if (words.size() != 3) {
            scanner.throw_bad_file("an orientation has 3 angles, this line has " +
                                   std::to_string(words.size()) + "; write \"phi1 Phi phi2\"");
        }
        orientations.push_back(parse_angles(scanner, words, unit));
    }
    if (orientations.empty()) {
        throw BadFile(name + ": holds no orientation; give one \"phi1 Phi phi2\" a line");
    }
    if (unit == AngleUnit::kGuessed && look_like_radians(orientations)) {
        throw BadFile(name +
                      ": no angle is above 2 pi and no Phi above pi, so the angles look like "
                      "radians; take --orientations rad:FILE, or deg:FILE if they are degrees");
    }
    return orientations;
}

std::vector<BungeAngles> read_orientations(const std::string& path, AngleUnit unit) {
    return parse_orientations(path, read_whole_file(path, kSiteInput), unit);
}

}  // namespace pcvt
