#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pcvt {

/// A phase of a polycrystal, and its target share of the area, or volume.
struct PhaseFraction {
    std::string name;
    /// Above 0; the fractions of all phases sum to 1.
    double fraction = 0;

    friend bool operator==(const PhaseFraction&, const PhaseFraction&) = default;
};

/// The sum of fractions may miss 1 by this much, as three times 0.333 does; then they are scaled.
inline constexpr double kFractionRounding = 1e-3;
inline constexpr int kMostPhases = 1000;
/// The longest name of a material that CalculiX and Abaqus read, less the prefixes in files.
inline constexpr int kLongestPhaseName = 60;

/// Reads `NAME:FRACTION,NAME:FRACTION,...`. Names consist of letters, digits, _ and -, and differ
/// by more than their case, because solvers do not see that.
///
/// Example usage:
///
///     const std::vector<PhaseFraction> phases = parse_phases("ferrite:0.3,martensite:0.7");
///
/// @throws InvalidInput with the entry and the remedy.
std::vector<PhaseFraction> parse_phases(std::string_view text);

/// Reads `NAME,NAME,...`, phases without fractions: those of given sites.
/// @throws InvalidInput as require_phase_names() does.
std::vector<PhaseFraction> named_phases(std::string_view text);

/// Requires names that parse_phases() accepts.
/// @throws InvalidInput naming the first wrong one.
void require_phase_names(const std::vector<std::string>& names);

/// Checks names and fractions as parse_phases() does.
/// @returns the phases with fractions that sum to 1.
std::vector<PhaseFraction> checked_phases(std::vector<PhaseFraction> phases);

}  // namespace pcvt
