#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/colours/palette.hpp"
#include "mesher/plane/geometry/lattice.hpp"

namespace pcvt {

/// Maps a drawing in length units, y upwards, to the canvas in pixels, y downwards.
class SvgFrame {
   public:
    /// Fits the points into about 800 x 800 pixels, at most 1600 along the longer side.
    /// @param points two or more, not all equal.
    explicit SvgFrame(const std::vector<plane::Vec2>& points);

    plane::Vec2 pixel(const plane::Vec2& point) const;
    /// Pixels per length unit.
    double scale() const { return scale_; }
    /// The size of the drawing with its margin, in pixels.
    double width() const { return size_.x(); }
    double height() const { return size_.y(); }

   private:
    plane::Vec2 low_;
    double scale_;
    plane::Vec2 size_;
};

/// Appends a number of pixels with at most three decimals, never with an exponent, never -0.
/// @pre |value| < 10^12.
void append_pixels(std::string& text, double value);

/// Builds the attribute `d` of an SVG path from points in length units.
class SvgPath {
   public:
    explicit SvgPath(const SvgFrame& frame) : frame_(frame) {}

    SvgPath& move(const plane::Vec2& point) { return add('M', point); }
    SvgPath& line(const plane::Vec2& point) { return add('L', point); }
    SvgPath& close();
    /// Adds a line without length, which round caps draw as a disc as wide as the stroke.
    SvgPath& dot(const plane::Vec2& point);

    bool empty() const { return text_.empty(); }
    /// Returns a <path> with these attributes; several if one would exceed the limits of XML
    /// parsers.
    std::string element(const std::string& attributes) const;

   private:
    SvgPath& add(char command, const plane::Vec2& point);

    const SvgFrame& frame_;
    std::string text_;
};

/// Returns ` name="value"` with a number of pixels.
std::string svg_attribute(const std::string& name, double pixels);
/// Returns the attributes of a line, the width in pixels.
std::string svg_stroke(const std::string& colour, double width);

/// The colour of text and of lines that are not part of a drawing, on a light background.
inline constexpr const char* kSvgInk = "#1c1f26";

/// Classes of elements that svg_head() recolours on a dark background: text, lines in the colour of
/// text, and the lines of a grid.
inline constexpr const char* kSvgTextClass = " class=\"ink\"";
inline constexpr const char* kSvgLineClass = " class=\"rule\"";
inline constexpr const char* kSvgGridClass = " class=\"grid\"";

/// Returns the first lines of a picture: its size in pixels, its title and its background. Without
/// a background, the page shows through, and the elements of the classes above become light where
/// the reader prefers dark pages.
std::string svg_head(const std::string& title, double width, double height,
                     const std::optional<Colour>& background = {});

/// Returns the first line of the group that holds the text of a picture.
std::string svg_text_group();

/// Returns a <text> at a position in pixels; &, < and > in the text are escaped.
std::string svg_text(const plane::Vec2& place, const std::string& text,
                     const std::string& attributes);

/// The size of text without another size, in pixels.
inline constexpr double kSvgFontSize = 13;

/// Returns a bound on the width of a text in pixels, in every common sans-serif font; DejaVu Sans
/// and Verdana are the widest of them.
double svg_text_width(const std::string& text, double font_size);
double svg_bold_text_width(const std::string& text, double font_size);

}  // namespace pcvt
