#include "plugin/cli/options/option_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "io/bytes/text.hpp"
#include "io/forms/tile_file.hpp"
#include "mesher/base/error.hpp"
#include "plugin/job/job.hpp"

namespace pcvt::cli {
namespace {

[[noreturn]] void throw_bad_value(const std::string& option, const std::string& text,
                                  const std::string& what) {
    throw InvalidInput(option + " " + (text.empty() ? "''" : text) + ": " + what);
}

/// The value of a string of digits; 2^64 - 1 if it is larger than that.
/// @returns false unless `text` consists of digits.
bool read_digits(std::string_view text, std::uint64_t& value) {
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
    const auto is_digit = [](char c) { return '0' <= c && c <= '9'; };
    if (text.empty() || !std::all_of(text.begin(), text.end(), is_digit)) return false;
    value = 0;
    for (const char c : text) {
        const auto digit = static_cast<std::uint64_t>(c - '0');
        value = value > (kMost - digit) / 10 ? kMost : 10 * value + digit;
    }
    return true;
}

/// One number. Puts the option's name in front of the message of a fault.
double number(const std::string& option, const std::string& text, std::string_view word) {
    try {
        return parse_number(word);
    } catch (const InvalidInput& error) {
        throw_bad_value(option, text, error.what());
    }
}

std::vector<double> numbers(const std::string& option, const std::string& text, std::size_t count,
                            const std::string& form) {
    std::vector<double> values;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        values.push_back(number(option, text, std::string_view(text).substr(begin, end - begin)));
        begin = end + 1;
    }
    if (values.size() != count) {
        throw_bad_value(option, text,
                        std::to_string(values.size()) + " of " + std::to_string(count) +
                            " numbers; give " + form);
    }
    return values;
}

/// The lattice. Puts the option's name in front of the message of a fault.
plane::Lattice make_lattice(const std::string& option, const std::string& text,
                            const plane::Vec2& a, const plane::Vec2& b) {
    try {
        plane::Lattice lattice(a, b);
        reduce(lattice);
        return lattice;
    } catch (const InvalidInput& error) {
        throw_bad_value(option, text, error.what());
    }
}

/// The lattice with these coordinates of its period vectors, in the same way.
space::Lattice make_space_lattice(const std::string& option, const std::string& text,
                                  const std::vector<double>& numbers) {
    const Eigen::Map<const Eigen::Matrix3d> periods(numbers.data());
    try {
        space::Lattice lattice(periods.col(0), periods.col(1), periods.col(2));
        reduce(lattice);
        return lattice;
    } catch (const InvalidInput& error) {
        throw_bad_value(option, text, error.what());
    }
}

}  // namespace

int whole_number(const std::string& option, const std::string& text, int lowest, int highest) {
    std::uint64_t value = 0;
    const std::string form =
        "give a whole number from " + std::to_string(lowest) + " to " + std::to_string(highest);
    if (!read_digits(text, value)) throw_bad_value(option, text, "not a whole number; " + form);
    if (value < static_cast<std::uint64_t>(lowest))
        throw_bad_value(option, text, "too small; " + form);
    if (value > static_cast<std::uint64_t>(highest)) {
        throw LimitExceeded(option + " " + text + ": too large for pcvt; " + form);
    }
    return static_cast<int>(value);
}

std::uint64_t seed_number(const std::string& option, const std::string& text) {
    std::uint64_t value = 0;
    if (!read_digits(text, value) ||
        (value == std::numeric_limits<std::uint64_t>::max() && text != "18446744073709551615")) {
        throw_bad_value(option, text,
                        "not a seed; give a whole number from 0 to 18446744073709551615");
    }
    return value;
}

double positive_number(const std::string& option, const std::string& text) {
    const double value = number(option, text, text);
    if (!(value > 0))
        throw_bad_value(option, text, "not above 0; give a positive number, such as 1e-6");
    return value;
}

plane::Vec2 point(const std::string& option, const std::string& text) {
    const std::vector<double> xy = numbers(option, text, 2, "X,Y");
    return {xy[0], xy[1]};
}

space::Vec3 space_point(const std::string& option, const std::string& text) {
    const std::vector<double> xyz = numbers(option, text, 3, "X,Y,Z");
    return {xyz[0], xyz[1], xyz[2]};
}

plane::Lattice rectangle_lattice(const std::string& option, const std::string& text) {
    const std::vector<double> sides = numbers(option, text, 2, "W,H, such as 1,1");
    if (!(sides[0] > 0) || !(sides[1] > 0)) {
        throw_bad_value(option, text, "a side is not above 0; give two positive lengths");
    }
    return make_lattice(option, text, {sides[0], 0}, {0, sides[1]});
}

plane::Lattice vector_lattice(const std::string& option, const std::string& text) {
    const std::vector<double> ab = numbers(option, text, 4, "AX,AY,BX,BY, such as 1,0,0.5,1");
    return make_lattice(option, text, {ab[0], ab[1]}, {ab[2], ab[3]});
}

space::Lattice box_lattice(const std::string& option, const std::string& text) {
    const std::vector<double> sides = numbers(option, text, 3, "W,H,D");
    for (const double side : sides) {
        if (!(side > 0)) throw_bad_value(option, text, "a side is not above 0; give W,H,D");
    }
    return make_space_lattice(option, text, {sides[0], 0, 0, 0, sides[1], 0, 0, 0, sides[2]});
}

space::Lattice space_lattice(const std::string& option, const std::string& text) {
    return make_space_lattice(option, text, numbers(option, text, 9, "AX,AY,AZ,BX,BY,BZ,CX,CY,CZ"));
}

Repetition repetition(const std::string& option, const std::string& text, int n_periods) {
    std::array<std::uint64_t, 3> copies{1, 1, 1};
    std::string rest = text;
    bool is_read = true;
    for (int k = 0; k < n_periods; ++k) {
        const std::size_t cross = k + 1 < n_periods ? rest.find('x') : rest.size();
        is_read = is_read && cross != std::string::npos &&
                  read_digits(rest.substr(0, cross), copies[k]) && copies[k] > 0;
        rest.erase(0, is_read ? cross + 1 : 0);
    }
    if (!is_read) {
        throw_bad_value(option, text,
                        n_periods == 3
                            ? "not of the form IxJxK; give three whole numbers from 1 on, such as "
                              "2x2x2"
                            : "not of the form IxJ; give two whole numbers from 1 on, such as 2x3");
    }
    if (*std::max_element(copies.begin(), copies.end()) > std::uint64_t{kMostPeriods}) {
        throw LimitExceeded(option + " " + text + ": more than " + std::to_string(kMostPeriods) +
                            " periods in a row; repeat less often");
    }
    return {static_cast<int>(copies[0]), static_cast<int>(copies[1]), static_cast<int>(copies[2])};
}

std::array<double, 2> coriolis_parameter(const std::string& option, const std::string& text) {
    const bool has_beta = text.find(',') != std::string::npos;
    const std::vector<double> values =
        numbers(option, text, has_beta ? 2 : 1, "F or F,BETA, such as 1e-4 or 1e-4,2e-11");
    return {values[0], has_beta ? values[1] : 0};
}

VoxelCounts voxel_counts(const std::string& option, const std::string& text) {
    const bool has_layers = std::count(text.begin(), text.end(), ',') == 2;
    const std::vector<double> counts = numbers(option, text, has_layers ? 3 : 2,
                                               "NX,NY or NX,NY,NZ, such as 256,256 or 256,256,16");
    for (std::size_t k = 0; k < counts.size(); ++k) {
        const int least = k < 2 ? kLeastVoxels : 1;
        if (counts[k] == std::floor(counts[k]) && counts[k] >= least &&
            counts[k] <= kMostVoxelsOfARow) {
            continue;
        }
        throw_bad_value(option, text,
                        "NX and NY are whole numbers from 2 to 1048576, and NZ one from 1; correct "
                        "them");
    }
    return {static_cast<int>(counts[0]), static_cast<int>(counts[1]),
            has_layers ? static_cast<int>(counts[2]) : 1};
}

}  // namespace pcvt::cli
