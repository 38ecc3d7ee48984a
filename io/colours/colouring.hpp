#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/colours/palette.hpp"
#include "mesher/base/choices.hpp"
#include "mesher/cells/cell_materials.hpp"
#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

/// The quantity that the colours of a tile show.
enum class Colouring {
    kSides,
    kSize,
    kCells,
    kDensity,
    kPhase,
    kOrbit,
    kTag,
    kFaces,
    kOrientation
};

/// The quantity that a run must have besides its tile, so that colours can show it.
enum class ColouringNeed { kNothing, kDensity, kPhases, kOrbits, kTags, kOrientations };

/// One colour of a tile.
struct ColourClass {
    Colour colour;
    /// For materials: "sides_6". Different in each class.
    std::string name;
    /// For legends: "6 sides: 93"; empty if the colour has no meaning of its own.
    std::string label;
};

/// The name of the class of cells with six sides, whose sites pictures mark by a small dot only.
inline constexpr const char* kRegularClass = "sides_6";

/// The colours of a tile. Cells, pieces of cells and grains are coloured by their site, and the
/// vertices of Delaunay triangles are their sites.
struct TileColours {
    /// For each face the index of its class; of Delaunay triangles, for each vertex.
    std::vector<int> class_of;
    std::vector<ColourClass> classes;
    /// Follows the title of a picture: " by size; h = sqrt(area / n)".
    std::string explanation;
};

/// Quantities of sites 0 to n - 1 of one period that colours may show.
struct SiteQuantities {
    /// Empty where the density is uniform.
    std::span<const double> densities = {};
    /// Null: none.
    const CellMaterials* materials = nullptr;
    /// The orbit of each site under the symmetry of the run; empty without one.
    std::span<const int> orbits = {};
};

/// Computes the colours of a tile.
using TileColourer = TileColours(const plane::Tile& tile, const SiteQuantities& quantities);

/// By the number of sides of each cell, or by the valence of each site.
TileColourer colours_by_sides;
/// By the size sqrt(area) / h of each cell, h = sqrt(area of the tile / n); by a third of the area
/// of the triangles at each site. Up to kValueClasses classes of one ratio, the least of 2^(1/16),
/// 2^(1/8), 2^(1/4), ... that suffices.
TileColourer colours_by_size;
/// Neighbouring cells or sites differ; the colours have no other meaning.
TileColourer colours_by_cells;
/// By the density at each site, in classes as by size.
TileColourer colours_by_density;
/// By the phase of each cell; from kCellColours phases on, colours repeat.
TileColourer colours_by_phase;
/// One class for each orbit of sites; neighbouring cells of different orbits have different
/// colours.
TileColourer colours_by_orbit;
/// By the tag of each cell, which is its phase, in a run with inclusions.
TileColourer colours_by_tag;

/// By the orientation of each cell, as a cubic crystal: pole_colour().
TileColourer colours_by_orientation;

/// The colours of faces or sites of these classes, 0 ... kCellColours - 1, which have no other
/// meaning.
TileColours cell_classes(std::vector<int> class_of);

/// One row of the table of colourings.
struct ColouringRow {
    Colouring colouring;
    const char* word;
    /// PCVT_COLOUR_SIDES, ... of pcvt.h.
    int abi_value;
    ColouringNeed needs;
    /// Whether colours are classes of values. Such cells have dark edges and no dots.
    bool shows_values;
    /// Of a tile in the plane; null for cells in space only, which cell_colours() colours.
    TileColourer* colours;
    bool in_plane = true;
    bool in_space = false;
};

/// In the order of the enumerators.
inline constexpr std::array kColourings{ColouringRow{.colouring = Colouring::kSides,
                                                     .word = "sides",
                                                     .abi_value = 1,
                                                     .needs = ColouringNeed::kNothing,
                                                     .shows_values = false,
                                                     .colours = colours_by_sides},
                                        ColouringRow{.colouring = Colouring::kSize,
                                                     .word = "size",
                                                     .abi_value = 2,
                                                     .needs = ColouringNeed::kNothing,
                                                     .shows_values = true,
                                                     .colours = colours_by_size,
                                                     .in_space = true},
                                        ColouringRow{.colouring = Colouring::kCells,
                                                     .word = "cells",
                                                     .abi_value = 3,
                                                     .needs = ColouringNeed::kNothing,
                                                     .shows_values = false,
                                                     .colours = colours_by_cells,
                                                     .in_space = true},
                                        ColouringRow{.colouring = Colouring::kDensity,
                                                     .word = "density",
                                                     .abi_value = 4,
                                                     .needs = ColouringNeed::kDensity,
                                                     .shows_values = true,
                                                     .colours = colours_by_density},
                                        ColouringRow{.colouring = Colouring::kPhase,
                                                     .word = "phase",
                                                     .abi_value = 5,
                                                     .needs = ColouringNeed::kPhases,
                                                     .shows_values = false,
                                                     .colours = colours_by_phase,
                                                     .in_space = true},
                                        ColouringRow{.colouring = Colouring::kOrbit,
                                                     .word = "orbit",
                                                     .abi_value = 6,
                                                     .needs = ColouringNeed::kOrbits,
                                                     .shows_values = false,
                                                     .colours = colours_by_orbit},
                                        ColouringRow{.colouring = Colouring::kTag,
                                                     .word = "tag",
                                                     .abi_value = 7,
                                                     .needs = ColouringNeed::kTags,
                                                     .shows_values = false,
                                                     .colours = colours_by_tag},
                                        ColouringRow{.colouring = Colouring::kFaces,
                                                     .word = "faces",
                                                     .abi_value = 8,
                                                     .needs = ColouringNeed::kNothing,
                                                     .shows_values = false,
                                                     .colours = nullptr,
                                                     .in_plane = false,
                                                     .in_space = true},
                                        ColouringRow{.colouring = Colouring::kOrientation,
                                                     .word = "orientation",
                                                     .abi_value = 9,
                                                     .needs = ColouringNeed::kOrientations,
                                                     .shows_values = false,
                                                     .colours = colours_by_orientation,
                                                     .in_space = true}};

constexpr const ColouringRow& colouring_row(Colouring colouring) {
    return kColourings[static_cast<std::size_t>(colouring)];
}

/// Returns the colours of a tile.
///
/// Example usage:
///     const TileColours colours = tile_colours(tile, Colouring::kSides, {});
///     const Colour first = colours.classes[colours.class_of[0]].colour;
///
/// @throws InternalError if the colouring shows a quantity that is not there.
TileColours tile_colours(const plane::Tile& tile, Colouring colouring,
                         const SiteQuantities& quantities);

/// Returns the colouring of pictures where the user leaves the choice: the phases, if there are
/// some, else the orientations; grains one by one; the sizes of cells where there is a density;
/// else the numbers of sides.
Colouring default_picture_colouring(const plane::Tile& tile, const SiteQuantities& quantities);

}  // namespace pcvt
