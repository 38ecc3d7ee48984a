#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "io/colours/palette.hpp"
#include "mesher/plane/geometry/lattice.hpp"
#include "mesher/torus/walls.hpp"

namespace pcvt {

/// An image, row by row from the top; three bytes a pixel, red, green, blue.
struct RgbImage {
    int width;
    int height;
    std::vector<unsigned char> rgb;
};

/// A colour as 0xrrggbb.
using PackedColour = std::uint32_t;
PackedColour packed(Colour colour);

/// A canvas whose left edge continues at its right edge, and its top at its bottom, unless these
/// edges are walls.
///
/// Example usage:
///     PeriodicCanvas canvas(256, 128, Walls::kNone);
///     canvas.add_polygon(corners, 0xf3efe4);
///     canvas.add_stroke(corners[0], corners[1], 1.5, 0x565c68);
///     const RgbImage image = canvas.render();
///
/// Positions are in pixels, x to the right, y down, anywhere in the plane. Later shapes cover
/// earlier ones. Each pixel is the mean of 4 x 4 samples. Laws, tested by number:
///   (1) Shapes moved by a whole number of pixels give the image rolled by that number.
///   (2) Shapes moved by whole widths and heights give the same image.
///   (3) The parts of shapes beyond a wall do not show.
/// Laws (1) and (2) hold for moves that cross no wall.
class PeriodicCanvas {
   public:
    PeriodicCanvas(int width, int height, Walls walls);

    /// Adds a polygon, filled by the even-odd rule.
    void add_polygon(std::span<const plane::Vec2> corners, PackedColour colour);
    /// Adds a line with round ends; a disc if both ends are equal.
    void add_stroke(const plane::Vec2& from, const plane::Vec2& to, double width,
                    PackedColour colour);

    /// Returns the image. Samples that no shape covers take the colour to their left, which fills
    /// gaps by rounding between shapes; an empty canvas is white.
    RgbImage render() const;

   private:
    struct Shape {
        std::size_t first_corner;
        std::size_t n_corners;
        /// Negative: a polygon.
        double radius;
        PackedColour colour;
    };

    /// A shape on a row of pixels, and the number of heights that its corners lie below it.
    struct Touch {
        int shape;
        int period;
    };

    std::vector<std::vector<Touch>> touches() const;
    void paint_row(const Shape& shape, double y, std::span<PackedColour> samples,
                   std::vector<double>& crossings) const;

    int width_;
    int height_;
    Walls walls_;
    std::vector<Shape> shapes_;
    std::vector<plane::Vec2> corners_;
};

}  // namespace pcvt
