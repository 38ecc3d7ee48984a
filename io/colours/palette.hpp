#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace pcvt {

// All colours of one legend differ by at least 15 (CIE 1976) for readers with normal sight,
// protanopia and deuteranopia.

/// A colour in sRGB, components 0-1.
struct Colour {
    double r;
    double g;
    double b;
};

/// The colour of a cell with this number of sides, or of a site with this number of triangles.
///
/// Hexagons are pale and neutral, so that the others stand out. Fewer sides are blue and more sides
/// are orange, darker the further from six: hue and lightness each distinguish them, also for the
/// colour-blind. Three and fewer share a colour, and so do nine and more.
Colour side_colour(int sides);

/// The most classes of values that a legend distinguishes.
inline constexpr int kValueClasses = 6;
/// The colour of a value, for example of a size: 0 is the least, blue, 1 the largest, pale
/// yellow; lightness rises all the way.
Colour value_colour(double share);

/// Enough for neighbouring cells on a torus to differ.
inline constexpr int kCellColours = 7;
/// The colour k = 0 ... kCellColours - 1 of cells whose colours have no meaning.
Colour cell_colour(int k);

/// Every seam has fewer classes of translations, or repeats colours.
inline constexpr int kSeamColours = 6;
/// The colour of the class k of translations. Legible on white and on black, and different from all
/// colours of cells.
Colour seam_colour(std::size_t k);

/// The colours of hexagons that the border of a panel cuts, and of cells that are clipped there;
/// they appear beside the colours of the sides.
inline constexpr const char* kCutHexagon = "#d9c9a0";
inline constexpr const char* kBorderCell = "#a9c3b4";

/// The relative luminance of a colour: 0 black, 1 white.
double luminance(Colour srgb);

/// The colour of "#rrggbb"; `nullopt` for another text.
std::optional<Colour> colour_of_hex(std::string_view text);

/// The same colour as linear light, which glTF requires.
Colour linear(Colour srgb);

/// "#rrggbb"
std::string hex(Colour colour);

}  // namespace pcvt
