#pragma once

#include <array>
#include <optional>

#include "mesher/cells/cell_materials.hpp"
#include "mesher/cells/cell_table.hpp"

namespace pcvt {

/// The disorientation of two cubic crystals, degrees: the least angle of a rotation that turns the
/// axes of one into those of the other, over the 24 rotations of the cube for each (Mackenzie
/// 1958). It is at most 62.8. Below 1e-5 degrees its error is up to 1e-6.
double cubic_disorientation(const BungeAngles& one, const BungeAngles& other);

/// The disorientations across the boundaries between crystals. Laws, tested by number:
///   (1) They are those over all 24 x 24 pairs of symmetric orientations.
///   (2) Of orientations without a texture they have Mackenzie's distribution, with the mean 40.7.
struct Misorientations {
    /// The width of a class, degrees.
    static constexpr double kClass = 2.5;
    static constexpr int kClasses = 26;

    /// The number of boundaries with disorientations from k kClass on, but below (k + 1) kClass.
    std::array<int, kClasses> counts{};
    /// The number of all boundaries; at least one.
    int n_boundaries = 0;
    /// Degrees.
    double mean = 0;
    double largest = 0;
};

/// Each edge, or face, between two cells of one phase counts once, as the boundary of two cubic
/// crystals. Cells that touch their own images have no boundary there.
///
/// Example usage:
///     if (const auto found = misorientations(table, materials)) print(found->mean);
///
/// @returns no value without orientations, and where no two cells of one phase are neighbours.
std::optional<Misorientations> misorientations(const CellTable& cells,
                                               const CellMaterials& materials);

}  // namespace pcvt
