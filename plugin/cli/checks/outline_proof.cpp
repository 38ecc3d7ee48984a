#include "plugin/cli/checks/outline_proof.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/proof/validate.hpp"
#include "plugin/cli/terminal/console.hpp"

namespace pcvt::cli {
namespace {

class OutlineProof {
   public:
    OutlineProof(const Shape& shape, std::vector<OutlineEdge>& edges, double near,
                 const std::string& where)
        : shape_(shape), edges_(edges), near_(near), where_(where) {}

    void prove() {
        const auto* polygon = std::get_if<Polygon>(&shape_);
        for (OutlineEdge& outline : edges_) {
            outline.place = polygon != nullptr ? place_on_polygon(*polygon, outline)
                                               : place_on_ellipse(outline);
        }
        std::sort(edges_.begin(), edges_.end(),
                  [](const OutlineEdge& x, const OutlineEdge& y) { return x.place < y.place; });
        if (edges_.size() < 3) refute("its outline is not closed by edges of cells");
        for (std::size_t m = 0; m < edges_.size(); ++m) {
            const Vec2& next = edges_[(m + 1) % edges_.size()].from;
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
    double place_on_polygon(const Polygon& polygon, const OutlineEdge& outline) const {
        for (std::size_t m = 0; m < polygon.size(); ++m) {
            const Vec2 side = polygon[(m + 1) % polygon.size()] - polygon[m];
            const Vec2 along = side.normalized();
            const Vec2 p = outline.from - polygon[m];
            const Vec2 q = outline.to - polygon[m];
            const bool is_on = std::abs(cross(along, p)) <= near_ &&
                               std::abs(cross(along, q)) <= near_ && along.dot(p) >= -near_ &&
                               along.dot(q) <= side.norm() + near_ && along.dot(q - p) > 0;
            const double share = along.dot(p + q) / 2 / side.norm();
            if (is_on) return static_cast<double>(m) + std::clamp(share, 0.0, 1.0);
        }
        refute("an edge lies off its sides" + place_in_words(outline.from));
    }

    /// Each corner of the polygon is the begin of an edge.
    void require_corners(const Polygon& polygon) const {
        for (const Vec2& corner : polygon) {
            const bool found =
                std::any_of(edges_.begin(), edges_.end(), [&](const OutlineEdge& outline) {
                    return (outline.from - corner).norm() <= near_;
                });
            if (!found) refute("its corner" + place_in_words(corner) + " is no vertex");
        }
    }

    EllipseAxes axes() const {
        const auto* circle = std::get_if<Circle>(&shape_);
        return circle != nullptr ? ellipse_axes(*circle) : ellipse_axes(std::get<Ellipse>(shape_));
    }
    /// The ellipse becomes the unit circle.
    static Vec2 in_disc(const EllipseAxes& ellipse, const Vec2& p) {
        const Vec2 d = p - ellipse.centre;
        return {d.dot(ellipse.along) / ellipse.a, cross(ellipse.along, d) / ellipse.b};
    }

    /// The angle of the edge's middle.
    double place_on_ellipse(const OutlineEdge& outline) const {
        const EllipseAxes ellipse = axes();
        const Vec2 p = in_disc(ellipse, outline.from);
        const Vec2 q = in_disc(ellipse, outline.to);
        if (!(cross(p, q) > 0)) {
            refute("an edge lies across its outline" + place_in_words(outline.from));
        }
        return std::atan2((p + q).y(), (p + q).x());
    }

    /// All points where the outline turns have one distance from the centre, in units of the axes.
    void require_nodes() const {
        const EllipseAxes ellipse = axes();
        double radius = 0;
        for (const OutlineEdge& outline : edges_) {
            radius = std::max(radius, in_disc(ellipse, outline.from).norm());
        }
        for (std::size_t m = 0; m < edges_.size(); ++m) {
            const Vec2& before = edges_[(m + edges_.size() - 1) % edges_.size()].from;
            const Vec2& here = edges_[m].from;
            const Vec2 chord = edges_[m].to - before;
            const double turn = cross(chord, before - here) / chord.norm();
            const double off = (radius - in_disc(ellipse, here).norm()) * ellipse.b;
            if (off <= near_ || std::abs(turn) <= near_) continue;
            refute("a node of its outline" + place_in_words(here) + " lies " + figure(off) +
                   " inside of the others");
        }
    }

    const Shape& shape_;
    std::vector<OutlineEdge>& edges_;
    double near_;
    const std::string& where_;
};

}  // namespace

std::string place_in_words(const Vec2& p) {
    return " at (" + figure(p.x()) + ", " + figure(p.y()) + ")";
}

void prove_outline(const Shape& shape, std::vector<OutlineEdge>& edges, double near,
                   const std::string& where) {
    OutlineProof(shape, edges, near, where).prove();
}

}  // namespace pcvt::cli
