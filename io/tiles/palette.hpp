#pragma once

#include <string>

namespace pcvt {

/// A colour in sRGB, components 0-1.
struct Colour {
    double r;
    double g;
    double b;
};

/// The colour of a cell with so many sides, or of a site with so many triangles.
///
/// Hexagons are pale and neutral, so that the others stand out. Fewer sides are blue and more sides
/// are orange, darker the further from six: hue and lightness each tell them apart, also for the
/// colour-blind. Three and fewer share a colour, and so do nine and more.
Colour side_colour(int sides);

/// The colour of a cell by its size: 0 is the smallest, blue, 1 the largest, pale yellow;
/// lightness rises all the way.
Colour size_colour(double share);

/// The same colour as linear light, which glTF asks for.
Colour linear(Colour srgb);

/// "#rrggbb"
std::string hex(Colour colour);

}  // namespace pcvt
