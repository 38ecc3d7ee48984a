#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/text.hpp"
#include "mesher/cells/cell_materials.hpp"
#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

/// Appends the lines in which files of pcvt state materials, each behind `mark`:
///
///   phases NAME NAME ...        the names, once
///   site_phases K K ...         the indices of the phases of the next sites, counted from 0
///   angles phi1 Phi phi2        of the next site, degrees
///
/// Example usage:
///     append_materials(text, "** pcvt ", materials);
///     if (take_material(scanner, words[2], values, file.materials)) return;
void append_materials(std::string& text, std::string_view mark, const CellMaterials& materials);

/// Reads the words after a key; returns whether the key is one of those above.
/// @throws BadFile if they are malformed.
bool take_material(const LineScanner& scanner, std::string_view key,
                   std::span<const std::string_view> words, CellMaterials& materials);

/// Requires one phase, and one orientation, for each of the sites, where there are any.
/// @param name  of the file, for the message of BadFile.
void require_materials(const std::string& name, const CellMaterials& materials,
                       std::int64_t n_sites);

/// Faces that follow each other, to the first one of the next run, with the material `name`.
struct MaterialRun {
    std::string name;
    int first_face;
};

/// Returns the phases of the cells of sites 0 ... n - 1 that the names of materials show,
/// `phase_steel` for the phase steel, as in files that are coloured by phase.
///
/// Example usage:
///     file.shown = shown_phases(file.tile, {{"phase_soft", 0}, {"phase_hard", 20}});
///
/// @param materials  by rising first faces.
/// @returns  without phases where a face has no material or one with another name, a site has no
///           face, or two faces of a site have different materials.
CellMaterials shown_phases(const plane::Tile& tile, const std::vector<MaterialRun>& materials);

}  // namespace pcvt
