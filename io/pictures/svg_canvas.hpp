#pragma once

#include <string>
#include <vector>

#include "mesher/lattice/lattice.hpp"

namespace pcvt {

/// Maps a drawing in length units, y upwards, to the canvas in pixels, y downwards.
class SvgFrame {
   public:
    /// Fits the points into about 800 x 800 pixels, at most 1600 along the longer side.
    /// @param points two or more, not all equal.
    explicit SvgFrame(const std::vector<Vec2>& points);

    Vec2 pixel(const Vec2& point) const;
    /// Pixels per length unit.
    double scale() const { return scale_; }
    /// The size of the drawing with its margin, in pixels.
    double width() const { return size_.x(); }
    double height() const { return size_.y(); }

   private:
    Vec2 low_;
    double scale_;
    Vec2 size_;
};

/// Appends a number of pixels with at most three decimals, never with an exponent, never -0.
/// @pre |value| < 10^12.
void append_pixels(std::string& text, double value);

/// Builds the attribute `d` of an SVG path from points in length units.
class SvgPath {
   public:
    explicit SvgPath(const SvgFrame& frame) : frame_(frame) {}

    SvgPath& move(const Vec2& point) { return add('M', point); }
    SvgPath& line(const Vec2& point) { return add('L', point); }
    SvgPath& close();
    /// Adds a line without length, which round caps draw as a disc as wide as the stroke.
    SvgPath& dot(const Vec2& point);

    bool empty() const { return text_.empty(); }
    /// Returns a <path> with these attributes; several if one would exceed the limits of XML
    /// parsers.
    std::string element(const std::string& attributes) const;

   private:
    SvgPath& add(char command, const Vec2& point);

    const SvgFrame& frame_;
    std::string text_;
};

/// Returns ` name="value"` with a number of pixels.
std::string svg_attribute(const std::string& name, double pixels);

/// Returns the first lines of a picture: its size in pixels, its title and a white background.
std::string svg_head(const std::string& title, double width, double height);

/// Returns a <text> at a position in pixels; &, < and > in the text are escaped.
std::string svg_text(const Vec2& place, const std::string& text, const std::string& attributes);

/// Returns the number of characters of a text in UTF-8.
std::size_t n_characters(const std::string& text);

}  // namespace pcvt
