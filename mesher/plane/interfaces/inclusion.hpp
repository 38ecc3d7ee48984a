#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "mesher/base/error.hpp"
#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/interfaces/mirror_image.hpp"
#include "mesher/plane/interfaces/polygon_sides.hpp"

namespace pcvt::plane {

struct Circle {
    Vec2 centre;
    double radius;
};

/// The semi-axis a lies at `degrees` from x.
struct Ellipse {
    Vec2 centre;
    double a;
    double b;
    double degrees;
};

/// One image of a closed curve; a polygon is simple. Length units.
using Shape = std::variant<Circle, Ellipse, Polygon>;

/// A shape on the torus and the number of its material.
///
/// Example usage:
///
///     const Inclusion fibre{.shape = Circle{{0.95, 0.5}, 0.2}, .tag = 1, .line = 3};
struct Inclusion {
    Shape shape;
    /// At least 1; 0 is the matrix. Inclusions may share a tag.
    int tag = 1;
    /// Where the inclusion was read, for messages.
    int line = 0;
};

/// An inclusion that cannot be meshed. The message is "line 7: complaint".
class BadInclusion : public InvalidInput {
   public:
    BadInclusion(int line, const std::string& complaint)
        : InvalidInput("line " + std::to_string(line) + ": " + complaint),
          place_(":" + std::to_string(line) + ": " + complaint) {}

    /// The message with the file of the inclusion: "shapes.txt:7: complaint".
    std::string in_file(const std::string& name) const { return name + place_; }

   private:
    std::string place_;
};

/// Circles as inclusions with one tag, on the lines 1, 2, ...
std::vector<Inclusion> circular_inclusions(const std::vector<Circle>& circles, int tag);

double shape_area(const Shape& shape);

/// The distance of p from the curve, negative inside of it.
double signed_distance(const Shape& shape, const Vec2& p);

/// How the first shape and the second one, translated, lie. Curves touch if they are nearer to each
/// other than 1e-9 of the size of the first.
ShapeRelation shape_relation(const Shape& first, const Shape& second, const Vec2& translation);

/// The image r of a shape between walls (mirror_image()).
Shape mirrored(const Shape& shape, Walls walls, int r);

Shape translated(const Shape& shape, const Vec2& translation);

/// The least and the largest coordinate of the shape along an axis (0: x, 1: y).
std::array<double, 2> extent(const Shape& shape, int axis);

/// A circle that contains the shape.
Circle bounding_circle(const Shape& shape);

/// An ellipse with the unit vector along its first semi-axis; a >= b. A circle is one as well.
struct EllipseAxes {
    Vec2 centre;
    Vec2 along;
    double a;
    double b;

    /// The point at a cos t along the first axis and b sin t along the second.
    Vec2 at_degrees(double t) const;
};
EllipseAxes ellipse_axes(const Circle& circle);
EllipseAxes ellipse_axes(const Ellipse& ellipse);

}  // namespace pcvt::plane
