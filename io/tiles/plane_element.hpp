#pragma once

#include <array>

namespace pcvt {

/// The state of the plane that the elements of a solver's file assume.
enum class PlaneElement { kStrain, kStress };

/// One row of the table of choices (mesher/base/choices.hpp): the word is how Abaqus and CalculiX
/// begin the name of the element type.
struct PlaneElementRow {
    PlaneElement element;
    const char* word;
    int abi_value;
};
inline constexpr std::array kPlaneElements{PlaneElementRow{PlaneElement::kStrain, "CPE", 0},
                                           PlaneElementRow{PlaneElement::kStress, "CPS", 1}};

}  // namespace pcvt
