#include "plugin/checks/outline_proof.hpp"

#include <algorithm>
#include <cmath>

#include "io/bytes/readable_number.hpp"
#include "mesher/plane/proof/validate.hpp"

namespace pcvt::checks {
namespace {

class OutlineProof {
   public:
    OutlineProof(const plane::Shape& shape, std::vector<OutlineEdge>& edges, double near,
                 const std::string& where)
        : shape_(shape), edges_(edges), near_(near), where_(where) {}

    void prove() {
        const auto* polygon = std::get_if<plane::Polygon>(&shape_);
        for (OutlineEdge& outline : edges_) {
            outline.place = polygon != nullptr ? place_on_polygon(*polygon, outline)
                                               : place_on_ellipse(outline);
        }
        std::sort(edges_.begin(), edges_.end(),
                  [](const OutlineEdge& x, const OutlineEdge& y) { return x.place < y.place; });
        if (edges_.size() < 3) refute("its outline is not closed by edges of cells");
        for (std::size_t m = 0; m < edges_.size(); ++m) {
            const plane::Vec2& next = edges_[(m + 1) % edges_.size()].from;
            if ((next - edges_[m].to).norm() > near_) {
                refute("its outline is not closed by edges of cells" +
                       place_in_words(edges_[m].to));
            }
        }
        if (polygon != nullptr) {
            require_corners(*polygon);
        } else {
            require_nodes();
        }
    }

   private:
    [[noreturn]] void refute(const std::string& what) const { throw NotATile(where_ + what); }

    /// The side of the polygon on which an edge lies, and the fraction of that side.
    double place_on_polygon(const plane::Polygon& polygon, const OutlineEdge& outline) const {
        for (std::size_t m = 0; m < polygon.size(); ++m) {
            const plane::Vec2 side = polygon[(m + 1) % polygon.size()] - polygon[m];
            const plane::Vec2 along = side.normalized();
            const plane::Vec2 p = outline.from - polygon[m];
            const plane::Vec2 q = outline.to - polygon[m];
            const bool is_on = std::abs(plane::cross(along, p)) <= near_ &&
                               std::abs(plane::cross(along, q)) <= near_ &&
                               along.dot(p) >= -near_ && along.dot(q) <= side.norm() + near_ &&
                               along.dot(q - p) > 0;
            const double share = along.dot(p + q) / 2 / side.norm();
            if (is_on) return static_cast<double>(m) + std::clamp(share, 0.0, 1.0);
        }
        refute("an edge lies off its sides" + place_in_words(outline.from));
    }

    /// Each corner of the polygon is the begin of an edge.
    void require_corners(const plane::Polygon& polygon) const {
        for (const plane::Vec2& corner : polygon) {
            const bool found =
                std::any_of(edges_.begin(), edges_.end(), [&](const OutlineEdge& outline) {
                    return (outline.from - corner).norm() <= near_;
                });
            if (!found) refute("its corner" + place_in_words(corner) + " is not a vertex");
        }
    }

    plane::EllipseAxes axes() const {
        const auto* circle = std::get_if<plane::Circle>(&shape_);
        return circle != nullptr ? ellipse_axes(*circle)
                                 : ellipse_axes(std::get<plane::Ellipse>(shape_));
    }
    /// The ellipse becomes the unit circle.
    static plane::Vec2 in_disc(const plane::EllipseAxes& ellipse, const plane::Vec2& p) {
        const plane::Vec2 d = p - ellipse.centre;
        return {d.dot(ellipse.along) / ellipse.a, plane::cross(ellipse.along, d) / ellipse.b};
    }

    /// The angle of the edge's middle.
    double place_on_ellipse(const OutlineEdge& outline) const {
        const plane::EllipseAxes ellipse = axes();
        const plane::Vec2 p = in_disc(ellipse, outline.from);
        const plane::Vec2 q = in_disc(ellipse, outline.to);
        if (!(plane::cross(p, q) > 0)) {
            refute("an edge lies across its outline" + place_in_words(outline.from));
        }
        return std::atan2((p + q).y(), (p + q).x());
    }

    /// All points where the outline turns have one distance from the centre, in units of the axes.
    void require_nodes() const {
        const plane::EllipseAxes ellipse = axes();
        double radius = 0;
        for (const OutlineEdge& outline : edges_) {
            radius = std::max(radius, in_disc(ellipse, outline.from).norm());
        }
        for (std::size_t m = 0; m < edges_.size(); ++m) {
            const plane::Vec2& before = edges_[(m + edges_.size() - 1) % edges_.size()].from;
            const plane::Vec2& here = edges_[m].from;
            const plane::Vec2 chord = edges_[m].to - before;
            const double turn = plane::cross(chord, before - here) / chord.norm();
            const double off = (radius - in_disc(ellipse, here).norm()) * ellipse.b;
            if (off <= near_ || std::abs(turn) <= near_) continue;
            refute("a node of its outline" + place_in_words(here) + " lies " + figure(off) +
                   " inside of the others");
        }
    }

    const plane::Shape& shape_;
    std::vector<OutlineEdge>& edges_;
    double near_;
    const std::string& where_;
};

}  // namespace

std::string place_in_words(const plane::Vec2& p) {
    return " at (" + figure(p.x()) + ", " + figure(p.y()) + ")";
}

void prove_outline(const plane::Shape& shape, std::vector<OutlineEdge>& edges, double near,
                   const std::string& where) {
    OutlineProof(shape, edges, near, where).prove();
}

}  // namespace pcvt::checks
