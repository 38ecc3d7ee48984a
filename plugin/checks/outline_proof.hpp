#pragma once

#include <string>
#include <vector>

#include "mesher/plane/interfaces/inclusion.hpp"

namespace pcvt::checks {

/// A directed edge with an inclusion on its left, in the frame of its shape.
struct OutlineEdge {
    plane::Vec2 from;
    plane::Vec2 to;
    /// Edges are sorted by this: their order along the outline.
    double place = 0;
};

/// Proves that edges are the chords of one closed polygon round a shape, and sorts them. The
/// corners of a polygon are among its nodes, and its chords lie on the sides. The nodes of a circle
/// or an ellipse lie on one curve with the same centre and axes, which is larger by one factor.
///
/// Example usage:
///     prove_outline(Circle{{0, 0}, 0.2}, edges, 1e-9, "shapes.txt:3: ");
///
/// @param near   positions may differ by this much, length units.
/// @param where  the beginning of a message.
/// @throws NotATile
void prove_outline(const plane::Shape& shape, std::vector<OutlineEdge>& edges, double near,
                   const std::string& where);

/// " at (0.5, 0.25)".
std::string place_in_words(const plane::Vec2& p);

}  // namespace pcvt::checks
