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

    friend bool operator==(const NamedConstants&, const NamedConstants&) = default;
};

/// The elastic constants that a user gives for the materials of a run.
struct ElasticChoices {
    /// All materials have the same constants, the default of a format.
    bool are_same = false;
    std::vector<NamedConstants> materials = {};

    bool empty() const { return !are_same && materials.empty(); }
};

/// Reads materials with blanks or line ends between them: `NAME:E,NU`, `NAME:C11,C12,C44` or
/// `NAME:C11,C12,C13,C33,C44` each; or only the word `same`.
///
/// Example usage:
///     const ElasticChoices choices = parse_elastic_choices("matrix:3.5,0.35 fibre:70,0.2");
///
/// @throws InvalidInput with the entry and the remedy.
ElasticChoices parse_elastic_choices(std::string_view text);

/// Requires that each material with constants is one of the phases, and none of them is missing:
/// kOneMaterial without phases. Names differ by more than their case.
/// @throws InvalidInput naming the material.
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
