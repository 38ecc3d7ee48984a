#include "io/solvers/inp_sections.hpp"

#include <array>
#include <cmath>
#include <initializer_list>

#include "io/bytes/text.hpp"
#include "io/forms/note_table.hpp"
#include "io/solvers/fixed_width_numbers.hpp"
#include "io/solvers/inp_fields.hpp"
#include "mesher/base/error.hpp"
#include "mesher/cells/orientations.hpp"
#include "mesher/cells/set_names.hpp"

namespace pcvt {
namespace {

constexpr std::size_t kSetsALine = 8;

/// The set of all cells of each class that has one.
/// @param class_of  of each site.
void append_cell_sets(std::string& text, std::span<const int> class_of,
                      std::span<const std::string> set_names, std::span<const SiteId> cells) {
    const std::string cell_set = upper_case(kCellSet);
    std::vector<std::vector<SiteId>> members(set_names.size());
    for (const SiteId s : cells) members[class_of[s]].push_back(s);
    for (std::size_t p = 0; p < members.size(); ++p) {
        if (members[p].empty()) continue;
        text += "*ELSET,ELSET=" + set_names[p] + "\n";
        for (std::size_t k = 0; k < members[p].size(); ++k) {
            text += cell_set + std::to_string(members[p][k]);
            text += (k + 1) % kSetsALine == 0 || k + 1 == members[p].size() ? '\n' : ',';
        }
    }
}

void append_phase_sets(std::string& text, const CellMaterials& materials,
                       std::span<const SiteId> cells) {
    std::vector<std::string> names;
    for (const std::string& phase : materials.phase_names)
        names.push_back(upper_case(kPhaseSet) + phase);
    append_cell_sets(text, materials.site_phase, names, cells);
}

void append_orientation(std::string& text, SiteId site, const BungeAngles& angles) {
    const FixedWidthNumbers numbers(1);
    const Eigen::Matrix3d g = bunge_matrix(angles);
    text += "*ORIENTATION,NAME=" + upper_case(kOrientationSet) + std::to_string(site) + "\n";
    for (int k = 0; k < 6; ++k) {
        if (k > 0) text += ',';
        if (!numbers.append(text, g(k / 3, k % 3))) {
            throw InternalError("a cosine has no 20 characters");
        }
    }
    text += '\n';
}

constexpr const char* kGiven =
    "** Materials: the constants are those that the user gave. *ELASTIC has E, nu; TYPE=ORTHO has\n"
    "** C11, C12, C22, C13, C23, C33, C66, C55 and, on a line of its own, C44, along the axes of "
    "each\n** crystal.\n";
constexpr const char* kIsotropic =
    "** Materials: edit the constants. The default is steel in MPa, isotropic: E, nu.\n";
constexpr const char* kCubic =
    "** Materials: edit the constants. The default is iron in MPa, cubic along the axes of each\n"
    "** crystal: C11, C12, C11, C12, C12, C11, C44, C44 and, on a line of its own, C44.\n";

/// The component of the mean strain in one step that is not 0.
struct LoadCase {
    const char* name;
    int i;
    int j;
};
constexpr std::array kPlaneLoadCases{LoadCase{"e_xx = 1", 1, 1}, LoadCase{"e_yy = 1", 2, 2},
                                     LoadCase{"e_xy = 1/2", 1, 2}};
constexpr std::array kSpaceLoadCases{LoadCase{"e_xx = 1", 1, 1},   LoadCase{"e_yy = 1", 2, 2},
                                     LoadCase{"e_zz = 1", 3, 3},   LoadCase{"e_yz = 1/2", 2, 3},
                                     LoadCase{"e_xz = 1/2", 1, 3}, LoadCase{"e_xy = 1/2", 1, 2}};

/// The rounding that the width of a number allows, over its last digit.
constexpr double kUlpsOfConstants = 1 << 10;

/// Appends a constant with a decimal point, in the width that solvers read.
void append_constant(std::string& text, double value) {
    std::string number;
    const FixedWidthNumbers numbers(kUlpsOfConstants * std::abs(value));
    if (!numbers.append(number, value)) {
        throw InvalidInput(
            "an elastic constant is too small or too large for solvers; take another "
            "unit of stress");
    }
    if (number.find_first_of(".e") == std::string::npos) number += '.';
    text += number;
}

/// Appends constants with commas between them.
void append_constants(std::string& text, std::initializer_list<double> values) {
    for (const double value : values) {
        append_constant(text, value);
        text += ',';
    }
    text.back() = '\n';
}

void append_material(std::string& text, const NamedConstants& material) {
    text += "*MATERIAL,NAME=" + material.name + "\n";
    const std::vector<double>& numbers = material.constants.numbers;
    if (material.constants.is_isotropic()) {
        text += "*ELASTIC\n";
        append_constants(text, {numbers[0], numbers[1]});
        return;
    }
    const auto [c11, c12, c13, c33, c44, c66] = stiffness_of(material.constants);
    text += "*ELASTIC,TYPE=ORTHO\n";
    append_constants(text, {c11, c12, c11, c13, c13, c33, c66, c44});
    append_constants(text, {c44});
}

/// Component j of control node i is that of the mean strain, for i <= j.
void append_step(std::string& text, const LoadCase& load, int dimension) {
    const std::string last = std::to_string(dimension);
    text += std::string("** The mean strain ") + load.name + ", all other components 0.\n";
    text += "*STEP\n*STATIC\n*BOUNDARY\nFIXED,1," + last + "\n";
    for (int i = 1; i <= dimension; ++i) {
        for (int j = i; j <= dimension; ++j) {
            const bool is_load = load.i == i && load.j == j;
            const std::string component = "," + std::to_string(j);
            text += "CONTROL_" + std::to_string(i) + component + component +
                    (!is_load ? ",0."
                     : i == j ? ",1."
                              : ",0.5") +
                    "\n";
        }
    }
    text += "*EL PRINT,ELSET=EALL,GLOBAL=YES\nS,E,EVOL\n*NODE FILE";
    text += dimension == 2 ? ",OUTPUT=2D" : "";
    text += "\nU\n*EL FILE\nS,E\n*END STEP\n";
}

/// The data of a section: elements in the plane are 1 thick.
const char* section_data(int dimension) { return dimension == 2 ? "\n1.\n" : "\n"; }

/// An input begins with one of these.
constexpr const char* kMeshAlone =
    "** The mesh of a periodic tile, written by pcvt: *INCLUDE it in a job that adds a material,\n"
    "** a *SOLID SECTION for EALL or each CELL_s, and steps.";
constexpr const char* kWithSections =
    "** The mesh of a periodic tile with a section for each cell, written by pcvt: *INCLUDE it in\n"
    "** a job that adds the materials of these sections, and steps.";
constexpr const char* kWithJob =
    "** A job of linear elasticity on a periodic tile, written by pcvt, that CalculiX runs as it\n"
    "** is; its materials and steps are at the end.";

}  // namespace

std::string inp_head(const FileOptions& options) {
    return options.job != SolverJob::kNone ? kWithJob
           : options.materials != nullptr  ? kWithSections
                                           : kMeshAlone;
}

void append_inp_sites(std::string& text, std::span<const SiteId> sites) {
    for (std::size_t k = 0; k < sites.size(); ++k) {
        text += k % kSitesALine != 0 ? " " : k == 0 ? "** pcvt sites " : "\n** pcvt sites ";
        append_number(text, sites[k]);
    }
    if (!sites.empty()) text += '\n';
}

std::string inp_orbit_sets(std::span<const int> site_orbits, std::span<const SiteId> cells) {
    std::string text;
    std::vector<std::string> names;
    for (const int orbit : site_orbits) {
        if (orbit == std::ssize(names))
            names.push_back(upper_case(kOrbitSet) + std::to_string(orbit));
    }
    if (!names.empty()) append_cell_sets(text, site_orbits, names, cells);
    return text;
}

std::string inp_sections(const CellMaterials& materials, std::span<const SiteId> cells,
                         int dimension) {
    const std::string cell_set = upper_case(kCellSet);
    std::string text;
    if (!materials.site_phase.empty()) append_phase_sets(text, materials, cells);
    for (const SiteId s : cells) {
        const bool turned = !materials.site_orientation.empty();
        if (turned) append_orientation(text, s, materials.site_orientation[s]);
        text += "*SOLID SECTION,ELSET=" + cell_set + std::to_string(s) + ",MATERIAL=" +
                (materials.site_phase.empty() ? kOneMaterial
                                              : materials.phase_names[materials.site_phase[s]]);
        if (turned) text += ",ORIENTATION=" + upper_case(kOrientationSet) + std::to_string(s);
        text += section_data(dimension);
    }
    return text;
}

ElasticConstants inp_standard_constants(const CellMaterials& materials) {
    if (materials.site_orientation.empty()) return {{210000, 0.3}};
    return {{231400, 134700, 116400}};
}

std::string inp_elastic_job(const CellMaterials& materials, const ElasticChoices& choices,
                            double period, int dimension) {
    const ElasticConstants standard = inp_standard_constants(materials);
    std::string text = choices.are_given() ? kGiven : standard.is_isotropic() ? kIsotropic : kCubic;
    for (const NamedConstants& material : chosen_materials(choices, materials, standard)) {
        append_material(text, material);
    }
    if (materials.empty()) {
        text += std::string("*SOLID SECTION,ELSET=EALL,MATERIAL=") + kOneMaterial;
        text += section_data(dimension);
    }
    const bool in_plane = dimension == 2;
    text += in_plane ? "** The area of the period is " : "** The volume of the period is ";
    append_number(text, period);
    text += in_plane
                ? ", and its volume the same, because elements are 1 thick. The mean\n** stress"
                : ". The mean stress";
    text += in_plane
                ? " of a step is the sum of S x volume over that volume, which counts holes, too.\n"
                : " of a step\n** is the sum of S x volume over that volume.\n";
    for (const LoadCase& load : in_plane ? std::span<const LoadCase>(kPlaneLoadCases)
                                         : std::span<const LoadCase>(kSpaceLoadCases)) {
        append_step(text, load, dimension);
    }
    return text;
}

}  // namespace pcvt
