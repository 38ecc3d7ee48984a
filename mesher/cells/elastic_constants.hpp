#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pcvt {

/// The constants of a linear elastic material, in a unit of stress that the user chooses. Their
/// number says which ones they are, and so the symmetry of the material:
///
///   2  E, nu                    isotropic
///   3  C11, C12, C44            cubic, along the axes of the crystal
///   5  C11, C12, C13, C33, C44  the same in all directions across the axis z of the crystal, as of
///                               hexagonal crystals and of carbon fibres
///
/// Example usage:
///     const ElasticConstants titanium = checked_constants({162.4, 92, 69, 180.7, 46.7});
///     const Stiffness stiffness = stiffness_of(titanium);
struct ElasticConstants {
    std::vector<double> numbers;

    bool is_isotropic() const { return numbers.size() == 2; }
    bool is_cubic() const { return numbers.size() == 3; }

    friend bool operator==(const ElasticConstants&, const ElasticConstants&) = default;
};

/// The names of the numbers: "E", "nu".
std::span<const std::string_view> names_of(const ElasticConstants& constants);

/// @throws InvalidInput unless these are 2, 3 or 5 numbers with which every strain takes energy.
ElasticConstants checked_constants(std::vector<double> numbers);

/// "E 210000, nu 0.3"
std::string constants_text(const ElasticConstants& constants);

/// The components of the stiffness that do not follow from others, with the axis z: C22 = C11,
/// C23 = C13, C55 = C44, C66 of its own for cubic crystals.
struct Stiffness {
    double c11;
    double c12;
    double c13;
    double c33;
    double c44;
    double c66;
};

Stiffness stiffness_of(const ElasticConstants& constants);

}  // namespace pcvt
