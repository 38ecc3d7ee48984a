#pragma once

#include <string>
#include <vector>

#include "mesher/lattice/lattice.hpp"

namespace pcvt {

/// Where a drawing in length units, y upwards, lies on the canvas in pixels, y downwards.
class SvgFrame {
   public:
    /// Fits the points into about 800 x 800 pixels, at most 1600 along the longer side.
    /// @param points two or more, not all at one place.
    explicit SvgFrame(const std::vector<Vec2>& points);

    Vec2 pixel(const Vec2& point) const;
    /// Pixels a length unit.
    double scale() const { return scale_; }
    /// Of the drawing with its margin.
    double width() const { return size_.x(); }
    double height() const { return size_.y(); }

   private:
    Vec2 low_;
    double scale_;
    Vec2 size_;
};

/// Appends a number of pixels: three decimals at most, never an exponent, never -0.
/// @pre |value| < 10^12.
void append_pixels(std::string& text, double value);

/// The `d` of an SVG path; points in length units.
class SvgPath {
   public:
    explicit SvgPath(const SvgFrame& frame) : frame_(frame) {}

    SvgPath& move(const Vec2& point) { return add('M', point); }
    SvgPath& line(const Vec2& point) { return add('L', point); }
    SvgPath& close();
    /// A path of no length: with round caps, a disc as wide as the stroke.
    SvgPath& dot(const Vec2& point);

    bool empty() const { return text_.empty(); }
    /// <path> with these attributes; several where one would be longer than XML parsers take.
    std::string element(const std::string& attributes) const;

   private:
    SvgPath& add(char command, const Vec2& point);

    const SvgFrame& frame_;
    std::string text_;
};

/// ` name="value"` with a number of pixels.
std::string svg_attribute(const std::string& name, double pixels);

/// The first lines of a picture: its size in pixels, its title and a white ground.
std::string svg_head(const std::string& title, double width, double height);

/// <text> at a place in pixels; &, < and > in the text are escaped.
std::string svg_text(const Vec2& place, const std::string& text, const std::string& attributes);

/// Of a text in UTF-8.
std::size_t n_characters(const std::string& text);

}  // namespace pcvt
