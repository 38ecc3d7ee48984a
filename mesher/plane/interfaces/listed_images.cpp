#include "mesher/plane/interfaces/listed_images.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/geometry/walled_domain.hpp"
#include "mesher/plane/interfaces/torus_grid.hpp"

namespace pcvt::plane {
namespace {

/// In units of the size of a shape: curves that agree this well are one.
constexpr double kSameShape = 1e-9;

/// In units of the longer reduced period: InclusionSet refuses larger shapes.
constexpr double kLargestRadius = 4;

bool agree(const Vec2& p, const Vec2& q, double tolerance) { return (p - q).norm() <= tolerance; }

bool agree(const Circle& first, const Circle& second, double tolerance) {
    return agree(first.centre, second.centre, tolerance) &&
           std::abs(first.radius - second.radius) <= tolerance;
}

bool agree(const Ellipse& first, const Ellipse& second, double tolerance) {
    const EllipseAxes one = ellipse_axes(first);
    const EllipseAxes other = ellipse_axes(second);
    // A turn by a small angle moves the curve by at most the angle times a - b.
    const double moved = std::abs(cross(one.along, other.along)) * (one.a - one.b);
    return agree(one.centre, other.centre, tolerance) && std::abs(one.a - other.a) <= tolerance &&
           std::abs(one.b - other.b) <= tolerance && moved <= tolerance;
}

bool agree(const Polygon& first, const Polygon& second, double tolerance) {
    const std::size_t n = first.size();
    if (n == 0 || second.size() != n) return false;
    // At most one corner of a valid polygon lies here.
    std::size_t start = 0;
    while (start < n && !agree(first[0], second[start], tolerance)) ++start;
    if (start == n) return false;
    for (std::size_t k = 1; k < n; ++k) {
        if (!agree(first[k], second[(start + k) % n], tolerance)) return false;
    }
    return true;
}

/// The bounding circle of a shape; none if InclusionSet refuses its numbers.
std::optional<Circle> bounds_of(const Shape& shape, const Lattice& reduced) {
    const auto* const polygon = std::get_if<Polygon>(&shape);
    if (polygon != nullptr && polygon->empty()) return std::nullopt;
    const auto* const ellipse = std::get_if<Ellipse>(&shape);
    if (ellipse != nullptr && !std::isfinite(ellipse->degrees)) return std::nullopt;
    const Circle bounds = bounding_circle(shape);
    const Vec2 u = reduced.to_lattice(bounds.centre);
    const bool is_near = u.allFinite() && u.cwiseAbs().maxCoeff() < kFarthestPeriod;
    const bool fits = bounds.radius > 0 && bounds.radius < kLargestRadius * reduced.b().norm();
    return is_near && fits ? std::optional(bounds) : std::nullopt;
}

/// The shapes that remain, with the places of their images.
class KeptShapes {
   public:
    KeptShapes(const Lattice& domain, Walls walls, int n_listed)
        : domain_(domain),
          walls_(walls),
          reduced_(reduce(mirrored_lattice(domain, walls)).reduced),
          grid_(reduced_, n_listed) {}

    void add_unless_image(const Inclusion& inclusion) {
        const std::optional<Circle> bounds = bounds_of(inclusion.shape, reduced_);
        if (!bounds) {
            add(inclusion, {0, 0});
            return;
        }
        const Vec2 u = reduced_.to_lattice(bounds->centre);
        const Wrapped x = wrap(u.x());
        const Wrapped y = wrap(u.y());
        const Offset whole{x.whole, y.whole};
        bool is_image = false;
        // Bounding circles of curves that agree have centres that agree nearly as well.
        const double reach = 2 * kSameShape * bounds->radius;
        grid_.visit({x.fraction, y.fraction}, reach, [&](int k, Offset offset) {
            is_image = is_image || is_image_of(k, offset + whole - whole_[k], inclusion);
        });
        if (is_image) return;
        grid_.add(static_cast<int>(kept_.size()), {x.fraction, y.fraction});
        add(inclusion, whole);
    }

    std::vector<Inclusion> take() { return std::move(kept_); }

   private:
    void add(const Inclusion& inclusion, Offset whole) {
        kept_.push_back(inclusion);
        whole_.push_back(whole);
    }

    bool is_image_of(int k, Offset offset, const Inclusion& inclusion) const {
        if (inclusion.tag != kept_[k].tag) return false;
        const Vec2 translation = reduced_.translation(offset);
        for (int axis = 0; axis < 2; ++axis) {
            if (!has_walls_across(walls_, axis)) continue;
            if (std::abs(translation[axis]) > side_length(domain_, axis) / 2) return false;
        }
        return is_same_shape(translated(kept_[k].shape, translation), inclusion.shape);
    }

    const Lattice& domain_;
    Walls walls_;
    Lattice reduced_;
    TorusGrid grid_;
    std::vector<Inclusion> kept_;
    /// The whole periods that wrap() removed from the centre of each bounding circle.
    std::vector<Offset> whole_;
};

/// The translation that takes one point nearest to another one.
Offset nearest_offset(const Lattice& reduced, const Vec2& from, const Vec2& to) {
    const Vec2 u = reduced.to_lattice(to - from);
    return {static_cast<int>(std::lround(u.x())), static_cast<int>(std::lround(u.y()))};
}

}  // namespace

bool is_same_shape(const Shape& first, const Shape& second) {
    if (first.index() != second.index()) return false;
    return std::visit(
        [&](const auto& one) {
            const double tolerance = kSameShape * bounding_circle(first).radius;
            return agree(one, std::get<std::decay_t<decltype(one)>>(second), tolerance);
        },
        first);
}

std::vector<Inclusion> without_listed_images(const Lattice& domain, Walls walls,
                                             const std::vector<Inclusion>& listed) {
    KeptShapes kept(domain, walls, static_cast<int>(listed.size()));
    for (const Inclusion& inclusion : listed) {
        checkpoint();
        kept.add_unless_image(inclusion);
    }
    return kept.take();
}

bool lies_on_image(const Lattice& reduced, const Inclusion& first, const Inclusion& second) {
    const Circle from = bounding_circle(first.shape);
    const Vec2 to = bounding_circle(second.shape).centre;
    const Offset offset = nearest_offset(reduced, from.centre, to);
    const Vec2 image = from.centre + reduced.translation(offset);
    return agree(image, to, kSameShape * from.radius) && offset != Offset{} &&
           first.shape.index() == second.shape.index();
}

std::string complaint_of_overlap(const Lattice& reduced, const Inclusion& first,
                                 const Inclusion& second) {
    const std::string that = "that of line " + std::to_string(first.line);
    const Vec2 translation = reduced.translation(nearest_offset(
        reduced, bounding_circle(first.shape).centre, bounding_circle(second.shape).centre));
    if (is_same_shape(translated(first.shape, translation), second.shape)) {
        return first.tag == second.tag
                   ? "the shape is an image of " + that + "; remove one of them"
                   : "the shape is an image of " + that +
                         " with another tag; give both the same tag, or remove one of them";
    }
    if (lies_on_image(reduced, first, second)) {
        return "the shape lies on an image of " + that +
               " but differs from it in size or form; make them equal, or remove one of them";
    }
    return "the shape overlaps " + that + "; move one of them";
}

}  // namespace pcvt::plane
