#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mesher/cells/cell_materials.hpp"
#include "mesher/cells/elastic_constants.hpp"

namespace pcvt {

/// The name of the material of cells without phases.
inline constexpr const char* kOneMaterial = "GRAINS";

/// A material by its name, in files that of a phase.
struct NamedConstants {
    std::string name;
    ElasticConstants constants;
    /// The file that has them, for people; empty: none.
    std::string source = {};

    friend bool operator==(const NamedConstants&, const NamedConstants&) = default;
};

/// A material of a file, by the name that it has there.
struct FileMaterial {
    std::string name;
    std::string file;
    ElasticConstants constants = {};
    /// Why no phase can have it, with the remedy; empty: one can.
    std::string fault = {};
};

/// The elastic constants that a user gives for the materials of a run.
struct ElasticChoices {
    /// All materials have the same constants, the default of a format.
    bool are_same = false;
    std::vector<NamedConstants> materials = {};
    /// The materials of files, of which the phases take those of their names, unless `materials`
    /// have them. Cells without phases take the only one of a file, whatever its name is.
    std::vector<FileMaterial> of_files = {};

    bool are_given() const { return !materials.empty() || !of_files.empty(); }
    bool empty() const { return !are_same && !are_given(); }
};

/// Reads materials with blanks or line ends between them: `NAME:E,NU`, `NAME:C11,C12,C44` or
/// `NAME:C11,C12,C13,C33,C44` each; or only the word `same`.
///
/// Example usage:
///     const ElasticChoices choices = parse_elastic_choices("matrix:3.5,0.35 fibre:70,0.2");
///
/// @throws InvalidInput with the entry and the remedy.
ElasticChoices parse_elastic_choices(std::string_view text);

/// @throws InvalidInput  if all materials are the same, and some are given.
void require_one_choice(const ElasticChoices& choices);

/// Requires that each material with constants, but for those of files, is one of the phases, and
/// none of them is missing: kOneMaterial without phases. Names differ by more than their case.
/// @throws InvalidInput naming the material, or with the fault of that of a file.
void require_materials_of(const ElasticChoices& choices, const std::vector<std::string>& phases);

/// Requires a choice where several phases would get the same constants without one.
/// @throws InvalidInput naming the phases.
void require_choice(const ElasticChoices& choices, const std::vector<std::string>& phases);

/// The materials of the cells with their constants, in the order of the phases.
/// @param standard  the constants of all materials where the user gave none.
std::vector<NamedConstants> chosen_materials(const ElasticChoices& choices,
                                             const CellMaterials& cells,
                                             const ElasticConstants& standard);

}  // namespace pcvt
