#include "io/voxels/damask_material.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "io/bytes/text.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/portable/portable_angles.hpp"

namespace pcvt {
namespace {

constexpr const char* kHead =
    "# The materials of the cells in the .vti file beside it, for DAMASK 3, written by pcvt.\n";
constexpr const char* kStandard =
    "# pcvt knows no material laws: each phase has the elastic constants of aluminium in Pa\n"
    "# (J. Vallin et al., Journal of Applied Physics 35, 1964, 1825); replace them by yours.\n";
constexpr const char* kGiven =
    "# Each phase has the elastic constants that the user gave, in the same unit; DAMASK takes "
    "Pa.\n";
constexpr const char* kHomogenizations =
    "# O: unit quaternions of Bunge's angles, P = -1.\n"
    "homogenization:\n"
    "  direct:\n"
    "    N_constituents: 1\n"
    "    mechanical: {type: pass}\n"
    "\n"
    "phase:\n";

constexpr const char* kCubicLattice = "    lattice: cF\n";
/// DAMASK requires the ratio of the axes, but linear elasticity does not depend on it.
constexpr const char* kHexagonalLattice = "    lattice: hP\n    c/a: 1.633\n";
constexpr const char* kMechanical =
    "    mechanical:\n"
    "      output: [F, P]\n"
    "      elastic: {type: Hooke, ";
constexpr const char* kAluminium = "C_11: 107.3e+9, C_12: 60.8e+9, C_44: 28.3e+9";

constexpr const char* kHomogenization = "direct";

/// DAMASK refuses quaternions whose length differs from 1 by more.
constexpr double kUnitLength = 1e-8;

/// Appends a number that YAML takes for one: with a decimal point.
void append_real(std::string& text, double value) {
    std::string number;
    append_number(number, value);
    if (number.find('.') == std::string::npos) {
        number.insert(std::min(number.find('e'), number.size()), ".0");
    }
    text += number;
}

/// Appends the elastic law of a phase; that of aluminium without constants.
void append_law(std::string& text, const ElasticConstants& constants) {
    const bool is_given = !constants.numbers.empty();
    const bool is_hexagonal = is_given && !constants.is_isotropic() && !constants.is_cubic();
    text += is_hexagonal ? kHexagonalLattice : kCubicLattice;
    text += kMechanical;
    if (!is_given) {
        text += kAluminium;
    } else {
        const Stiffness c = stiffness_of(constants);
        const auto append = [&text](const char* key, double value) {
            text += key;
            append_real(text, value);
        };
        append("C_11: ", c.c11);
        append(", C_12: ", c.c12);
        if (is_hexagonal) {
            append(", C_13: ", c.c13);
            append(", C_33: ", c.c33);
        }
        append(", C_44: ", c.c44);
    }
    text += "}\n";
}

std::string phase_of(const CellMaterials& materials, int cell) {
    if (materials.site_phase.empty()) return kOnlyPhase;
    return materials.phase_names[materials.site_phase[cell]];
}

Quaternion orientation_of(const CellMaterials& materials, int cell) {
    if (materials.site_orientation.empty()) return {1, 0, 0, 0};
    return damask_quaternion(materials.site_orientation[cell]);
}

/// Reads the entries line by line.
class MaterialReader {
   public:
    MaterialReader(const std::string& name, std::string_view text)
        : text_(text), lines_(name, text) {
        refuse_binary(name, text, "give the file as pcvt writes it");
    }

    std::vector<DamaskEntry> read() {
        while (next()) {
            if (column() <= 2 && section_ == "homogenization:") require_one_constituent();
            if (column() == 0) {
                section_ = words()[0];
                add_once(section_, sections_);
            } else if (section_ == "material:") {
                read_entry();
            } else if (column() == 2 && words()[0].ends_with(':')) {
                const std::string_view key = words()[0].substr(0, words()[0].size() - 1);
                if (section_ == "phase:") add_once(key, phases_);
                if (section_ != "homogenization:") continue;
                add_once(key, homogenizations_);
                lacks_number_ = words().size() == 1;
            } else if (section_ == "homogenization:" && words()[0] == "N_constituents:") {
                if (words().size() != 2 || words()[1] != "1" || !lacks_number_) {
                    lines_.throw_bad_file("cells have one constituent each; write 1, once");
                }
                lacks_number_ = false;
            }
        }
        require_one_constituent();
        return std::move(entries_);
    }

   private:
    const std::vector<std::string_view>& words() const { return lines_.words(); }

    /// Readers of YAML differ in which of two entries of one name they take.
    void add_once(std::string_view name, std::set<std::string, std::less<>>& names) const {
        if (names.emplace(name).second) return;
        lines_.throw_bad_file(in_quotes(name) + " is there twice; remove one");
    }

    /// A homogenization in several lines must state its number of constituents.
    void require_one_constituent() const {
        if (!lacks_number_) return;
        lines_.throw_bad_file(
            "the homogenization above lacks its N_constituents; add the line "
            "'N_constituents: 1' to it");
    }

    /// Skips empty lines and comments.
    bool next() {
        while (lines_.next()) {
            checkpoint_each(lines_.line());
            if (!words().empty() && words()[0].front() != '#' && words()[0] != "---") return true;
        }
        return false;
    }

    /// The number of blanks before the first word.
    std::size_t column() const {
        const auto begin = static_cast<std::size_t>(words()[0].data() - text_.data());
        const std::size_t end_of_line = text_.substr(0, begin).find_last_of("\r\n");
        return end_of_line == std::string_view::npos ? begin : begin - end_of_line - 1;
    }

    /// Requires the next line of an entry to begin with `key`; returns the words behind it.
    std::vector<std::string_view> values(std::initializer_list<std::string_view> key) {
        const bool found =
            words().size() >= key.size() && std::equal(key.begin(), key.end(), words().begin());
        if (!found) refuse();
        return {words().begin() + static_cast<std::ptrdiff_t>(key.size()), words().end()};
    }
    std::vector<std::string_view> next_values(std::initializer_list<std::string_view> key) {
        if (!next()) refuse();
        return values(key);
    }

    [[noreturn]] void refuse() const {
        lines_.throw_bad_file("entry " + std::to_string(entries_.size()) +
                              " of material has another form than pcvt writes; write the file "
                              "again with pcvt");
    }

    std::string known(const std::vector<std::string_view>& words,
                      const std::set<std::string, std::less<>>& names, const char* section) const {
        if (words.size() != 1) refuse();
        if (names.contains(words[0])) return std::string(words[0]);
        lines_.throw_bad_file(in_quotes(words[0]) + " is not among the entries of " + section +
                              " above; add it there");
    }

    void read_entry() {
        known(values({"-", "homogenization:"}), homogenizations_, "homogenization");
        next_values({"constituents:"});
        DamaskEntry entry{.phase = known(next_values({"-", "phase:"}), phases_, "phase"),
                          .orientation = {}};
        const auto share = next_values({"v:"});
        if (share.size() != 1 || lines_.number(share[0]) != 1) {
            lines_.throw_bad_file(
                "the only constituent of a cell has another share v than 1.0; "
                "write 1.0");
        }
        const auto parts = next_values({"O:"});
        if (parts.size() != entry.orientation.size()) refuse();
        double squares = 0;
        for (std::size_t k = 0; k < parts.size(); ++k) {
            entry.orientation[k] = component(parts[k], k);
            squares += entry.orientation[k] * entry.orientation[k];
        }
        if (!(std::abs(std::sqrt(squares) - 1) <= kUnitLength)) {
            lines_.throw_bad_file("the quaternion has not the length 1; correct it");
        }
        entries_.push_back(std::move(entry));
    }

    /// A component in a list: `[1.0,`, `0.0,`, `0.0,`, `0.0]`.
    double component(std::string_view word, std::size_t k) const {
        const bool opens = k == 0;
        const char end = k + 1 == std::tuple_size_v<Quaternion> ? ']' : ',';
        if (word.size() < 3 || opens != word.starts_with('[') || !word.ends_with(end)) refuse();
        word.remove_prefix(opens ? 1 : 0);
        word.remove_suffix(1);
        return lines_.number(word);
    }

    std::string_view text_;
    LineScanner lines_;
    std::string_view section_;
    std::set<std::string, std::less<>> sections_;
    std::set<std::string, std::less<>> phases_;
    std::set<std::string, std::less<>> homogenizations_;
    std::vector<DamaskEntry> entries_;
    bool lacks_number_ = false;
};

}  // namespace

Quaternion damask_quaternion(const BungeAngles& angles) {
    const CosSin sigma = cos_sin_of_degrees((angles.phi1 + angles.phi2) / 2);
    const CosSin delta = cos_sin_of_degrees((angles.phi1 - angles.phi2) / 2);
    const auto [c, s] = cos_sin_of_degrees(angles.Phi / 2);
    Quaternion q{c * sigma.cos, s * delta.cos, s * delta.sin, c * sigma.sin};
    if (q[0] >= 0) return q;
    for (double& part : q) part = -part;
    return q;
}

std::string encode_damask_material(int n_cells, const CellMaterials& materials,
                                   const ElasticChoices& choices) {
    const bool are_given = choices.are_given();
    std::string text = std::string(kHead) + (are_given ? kGiven : kStandard) + kHomogenizations;
    const bool one_phase = materials.site_phase.empty();
    for (const NamedConstants& phase : chosen_materials(choices, materials, {})) {
        text += "  " + (one_phase ? std::string(kOnlyPhase) : phase.name) + ":\n";
        append_law(text, phase.constants);
    }
    text += "\nmaterial:\n";
    for (int cell = 0; cell < n_cells; ++cell) {
        checkpoint_each(cell);
        text += std::string("  - homogenization: ") + kHomogenization +
                "\n    constituents:\n      - phase: " + phase_of(materials, cell) +
                "\n        v: 1.0\n        O: ";
        const char* separator = "[";
        for (const double part : orientation_of(materials, cell)) {
            text += separator;
            append_real(text, part);
            separator = ", ";
        }
        text += "]\n";
    }
    return text;
}

std::vector<DamaskEntry> decode_damask_material(const std::string& name, std::string_view text) {
    return MaterialReader(name, text).read();
}

void compare_damask_material(const std::string& name, const std::vector<DamaskEntry>& entries,
                             int n_cells, const CellMaterials& materials) {
    if (static_cast<int>(entries.size()) != n_cells) {
        throw BadFile(name + ": has " + std::to_string(entries.size()) +
                      " materials, but there are " + std::to_string(n_cells) +
                      " cells; write the file again with pcvt");
    }
    for (int cell = 0; cell < n_cells; ++cell) {
        const DamaskEntry& entry = entries[cell];
        if (entry.phase == phase_of(materials, cell) &&
            entry.orientation == orientation_of(materials, cell)) {
            continue;
        }
        throw BadFile(name + ": material " + std::to_string(cell) +
                      " is not that of its cell; write the file again with pcvt");
    }
}

}  // namespace pcvt
