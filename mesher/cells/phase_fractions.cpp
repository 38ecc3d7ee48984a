#include "mesher/cells/phase_fractions.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "mesher/base/comma_list.hpp"
#include "mesher/base/error.hpp"
#include "mesher/portable/decimal_text.hpp"

namespace pcvt {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

bool is_name(std::string_view name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
        return is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-';
    });
}

std::string in_upper_case(std::string text) {
    for (char& c : text) {
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    }
    return text;
}

/// For a message: at most 40 characters, with question marks for unprintable bytes.
std::string in_quotes(std::string_view text) {
    std::string quoted(text.substr(0, 40));
    for (char& c : quoted) {
        if (c < ' ' || c > '~') c = '?';
    }
    return "'" + quoted + "'";
}

std::string in_words(double x) {
    std::array<char, 32> text{};
    char* const end =
        write_decimal(text.data(), text.data() + text.size(), x, std::chars_format::general, 6);
    return {text.data(), end};
}

PhaseFraction parse_phase(std::string_view entry) {
    const std::size_t colon = std::min(entry.find(':'), entry.size());
    PhaseFraction phase{.name = std::string(entry.substr(0, colon))};
    const char* const begin = entry.data() + std::min(colon + 1, entry.size());
    const char* const end = entry.data() + entry.size();
    const auto [stop, error] = read_decimal(begin, end, phase.fraction);
    if (error == std::errc{} && stop == end) return phase;
    throw InvalidInput(in_quotes(entry) +
                       " is not a phase; write NAME:FRACTION, such as ferrite:0.3");
}

}  // namespace

void require_phase_names(const std::vector<std::string>& names) {
    if (names.size() > kMostPhases) {
        throw InvalidInput("there are " + std::to_string(names.size()) + " phases; give at most " +
                           std::to_string(kMostPhases));
    }
    std::vector<std::string> known;
    for (const std::string& name : names) {
        if (!is_name(name) || name.size() > kLongestPhaseName) {
            throw InvalidInput(in_quotes(name) +
                               " is not the name of a phase; take 1 to 60 letters, digits, _ or -");
        }
        known.push_back(in_upper_case(name));
        if (std::find(known.begin(), known.end() - 1, known.back()) == known.end() - 1) continue;
        throw InvalidInput("the phase " + name +
                           " is given twice, because case does not matter; rename one");
    }
}

std::vector<PhaseFraction> checked_phases(std::vector<PhaseFraction> phases) {
    std::vector<std::string> names;
    for (const PhaseFraction& phase : phases) names.push_back(phase.name);
    require_phase_names(names);
    double sum = 0;
    for (const PhaseFraction& phase : phases) {
        if (!(phase.fraction > 0 && std::isfinite(phase.fraction))) {
            throw InvalidInput("the fraction of " + phase.name + " is " + in_words(phase.fraction) +
                               "; give a number above 0");
        }
        sum += phase.fraction;
    }
    // One ulp in excess, for sums such as 0.999.
    if (!phases.empty() && !(std::abs(sum - 1) <= kFractionRounding * (1 + 1e-9))) {
        throw InvalidInput("the fractions of the phases sum to " + in_words(sum) +
                           "; make the sum 1");
    }
    for (PhaseFraction& phase : phases) phase.fraction /= sum;
    return phases;
}

std::vector<PhaseFraction> named_phases(std::string_view text) {
    std::vector<PhaseFraction> phases;
    std::vector<std::string> names;
    for (const std::string_view name : between_commas(text)) {
        names.emplace_back(name);
        phases.push_back({.name = names.back()});
    }
    require_phase_names(names);
    return phases;
}

std::vector<PhaseFraction> parse_phases(std::string_view text) {
    std::vector<PhaseFraction> phases;
    for (const std::string_view entry : between_commas(text)) phases.push_back(parse_phase(entry));
    return checked_phases(std::move(phases));
}

}  // namespace pcvt
