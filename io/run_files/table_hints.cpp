#include "io/run_files/table_hints.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "io/bytes/text.hpp"
#include "mesher/portable/decimal_text.hpp"

namespace pcvt {
namespace {

constexpr std::string_view kBoxRemedy = ", and give the sides of the box as the period";
/// Blanks and apostrophes in UTF-8, and the blank of Latin-1, that separate thousands.
constexpr std::array<std::string_view, 7> kThousands{
    " ", "'", "\xE2\x80\x99", "\xC2\xA0", "\xE2\x80\xAF", "\xE2\x80\x89", "\xA0"};
/// Fortran writes 0.5D+02.
constexpr std::array<std::string_view, 2> kFortranExponents{"D", "d"};
/// The minus sign and the dash of printed numbers.
constexpr std::array<std::string_view, 2> kMinusSigns{"\xE2\x88\x92", "\xE2\x80\x93"};

bool is_decimal(std::string text) {
    std::replace(text.begin(), text.end(), ',', '.');
    double value = 0;
    const char* const end = text.data() + text.size();
    return !text.empty() && read_decimal(text.data(), end, value).ptr == end;
}

template <class Words>
std::string replaced(std::string_view text, const Words& words, std::string_view by) {
    std::string result(text);
    for (const std::string_view word : words) {
        for (std::size_t at = 0; (at = result.find(word, at)) != std::string::npos;) {
            result.replace(at, word.size(), by);
        }
    }
    return result;
}

bool is_whole(std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// Whether the lines below the number of atoms are those of an XYZ file: a comment, and rows of a
/// symbol and three coordinates.
bool is_xyz(TableLines lines) {
    if (!is_whole(lines.content()) || !lines.next()) return false;
    if (lines.content().find("Properties=") != std::string_view::npos) return true;
    if (!lines.next()) return false;
    std::vector<std::string_view> fields;
    split_fields(lines.content(), Separator::kBlanks, fields);
    return fields.size() == 4 && !is_decimal(std::string(fields[0])) &&
           std::all_of(fields.begin() + 1, fields.end(),
                       [](std::string_view field) { return is_decimal(std::string(field)); });
}

/// Whether the first line is the title of a data file of LAMMPS, or below a comment its number of
/// atoms.
bool is_lammps_data(std::string_view first) {
    std::vector<std::string_view> fields;
    split_fields(first, Separator::kBlanks, fields);
    return first.starts_with("LAMMPS ") ||
           (fields.size() == 2 && is_whole(fields[0]) && fields[1] == "atoms");
}

}  // namespace

void refuse_atom_files(const TableLines& first) {
    std::string complaint;
    if (first.content().starts_with("ITEM:")) {
        complaint =
            "a LAMMPS dump; keep the names of columns behind ITEM: ATOMS and the lines below, "
            "leave out the rest";
    } else if (is_lammps_data(first.content())) {
        complaint =
            "a LAMMPS data file; keep only the lines below Atoms, name the columns of the "
            "coordinates, such as " +
            first.name() + ":3,4";
    } else if (is_xyz(first)) {
        complaint =
            "an XYZ file; leave out its first two lines, name the columns of the "
            "coordinates, such as " +
            first.name() + ":2,3";
    }
    if (!complaint.empty()) first.refuse(first.line(), complaint + std::string(kBoxRemedy));
}

std::string number_remedy(std::string_view field) {
    const auto is_number_with = [&](const auto& words, std::string_view by) {
        const std::string text = replaced(field, words, by);
        return text != field && is_decimal(text);
    };
    if (is_number_with(kThousands, "")) return "; write no separators of thousands";
    if (is_number_with(kMinusSigns, "-")) return "; write a hyphen as the minus sign";
    if (is_number_with(kFortranExponents, "e")) return "; write e before the exponent, as in 1.5e3";
    return {};
}

}  // namespace pcvt
