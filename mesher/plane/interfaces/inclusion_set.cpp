#include "mesher/plane/interfaces/inclusion_set.hpp"

#include <string>

#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/geometry/sites.hpp"
#include "mesher/plane/geometry/walled_domain.hpp"
#include "mesher/plane/interfaces/listed_images.hpp"

namespace pcvt::plane {
namespace {

/// In units of the longer reduced period: a longer shape would have too many images to compare.
constexpr double kLongest = 8;

/// Corners of polygons are not sharper, on either side: chords would become ever shorter there. The
/// cosine of 3 degrees.
constexpr double kSharpestCosine = 0.99863;

[[noreturn]] void refuse(const Inclusion& inclusion, const std::string& what) {
    throw BadInclusion(inclusion.line, what);
}

void require_polygon(Inclusion& inclusion, Polygon& polygon) {
    for (const Vec2& corner : polygon) {
        if (!corner.allFinite()) refuse(inclusion, "a coordinate is not finite");
    }
    if (polygon.size() < 3) refuse(inclusion, "a polygon needs at least three corners");
    const double perimeter = polygon_perimeter(polygon);
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec2& next = polygon[(k + 1) % polygon.size()];
        if ((next - polygon[k]).norm() <= kSameVertex * perimeter) {
            refuse(inclusion, "corner " + std::to_string(k + 1) +
                                  " of the polygon repeats the next one; remove it");
        }
    }
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec2 before = polygon[(k + polygon.size() - 1) % polygon.size()] - polygon[k];
        const Vec2 after = polygon[(k + 1) % polygon.size()] - polygon[k];
        if (before.dot(after) <= kSharpestCosine * before.norm() * after.norm()) continue;
        refuse(inclusion, "corner " + std::to_string(k + 1) +
                              " of the polygon is sharper than 3 degrees; cut it off");
    }
    const double area = polygon_area(polygon);
    if (!(std::abs(area) > kSameVertex * perimeter * perimeter)) {
        refuse(inclusion, "the polygon has no area");
    }
    if (area < 0) std::reverse(polygon.begin(), polygon.end());
    if (PolygonSides(polygon).touch_themselves()) {
        refuse(inclusion, "the polygon crosses or touches itself");
    }
}

void require_shape(Inclusion& inclusion) {
    if (inclusion.tag < 1) refuse(inclusion, "the tag must be at least 1");
    if (auto* circle = std::get_if<Circle>(&inclusion.shape)) {
        if (!circle->centre.allFinite()) refuse(inclusion, "a coordinate is not finite");
        if (!(circle->radius > 0)) refuse(inclusion, "the radius must be positive");
    } else if (auto* ellipse = std::get_if<Ellipse>(&inclusion.shape)) {
        if (!ellipse->centre.allFinite()) refuse(inclusion, "a coordinate is not finite");
        if (!std::isfinite(ellipse->degrees)) refuse(inclusion, "the angle is not finite");
        if (!(ellipse->a > 0 && ellipse->b > 0)) {
            refuse(inclusion, "both semi-axes must be positive");
        }
    } else {
        require_polygon(inclusion, std::get<Polygon>(inclusion.shape));
    }
}

}  // namespace

InclusionSet::InclusionSet(const Lattice& domain, std::vector<Inclusion> inclusions, Walls walls)
    : domain_(domain),
      walls_(walls),
      lattice_(mirrored_lattice(domain, walls)),
      reduction_(reduce(lattice_)),
      inclusions_(std::move(inclusions)) {
    for (Inclusion& inclusion : inclusions_) {
        require_shape(inclusion);
        require_between_walls(inclusion);
    }
    add_mirror_images();
    for (const Inclusion& inclusion : inclusions_) {
        const auto* const polygon = std::get_if<Polygon>(&inclusion.shape);
        sides_.push_back(polygon != nullptr ? PolygonSides(*polygon) : PolygonSides());
    }
    const Lattice& reduced = reduction_.reduced;
    grid_.emplace(reduced, size());
    for (const Inclusion& inclusion : inclusions_) {
        const Circle bounds = bounding_circle(inclusion.shape);
        areas_.push_back(shape_area(inclusion.shape));
        const bool is_larger = !(areas_.back() < domain.area());
        if (is_larger || !(bounds.radius < kLongest / 2 * reduced.b().norm())) {
            refuse(inclusion, "the shape is larger than the domain; make it smaller");
        }
        const Vec2 u = reduced.to_lattice(bounds.centre);
        if (!(u.cwiseAbs().maxCoeff() < kFarthestPeriod)) {
            refuse(inclusion, "the shape lies more than 2^30 periods away; move it");
        }
        const Wrapped x = wrap(u.x());
        const Wrapped y = wrap(u.y());
        grid_->add(static_cast<int>(bounds_.size()), {x.fraction, y.fraction});
        whole_.push_back({x.whole, y.whole});
        bounds_.push_back(bounds);
        largest_radius_ = std::max(largest_radius_, bounds.radius);
    }
    find_parents();
}

void InclusionSet::require_between_walls(const Inclusion& inclusion) const {
    for (int axis = 0; axis < 2; ++axis) {
        if (!has_walls_across(walls_, axis)) continue;
        const auto [low, high] = extent(inclusion.shape, axis);
        const double near = kSameVertex * (high - low);
        const double side = side_length(domain_, axis);
        if (low > near && high < side - near) continue;
        const bool is_low = low <= near;
        const auto row = find_row(kWallSides, [axis, is_low](const WallSideRow& wall) {
            return wall.axis == axis && wall.at_end != is_low;
        });
        refuse(inclusion, std::string("the shape touches or crosses ") + row->word +
                              "; move it away from the wall or leave the wall out");
    }
}

/// Appends the images of all shapes behind the walls.
void InclusionSet::add_mirror_images() {
    const std::size_t n = inclusions_.size();
    for (int r = 1; r < n_images(walls_); ++r) {
        for (std::size_t k = 0; k < n; ++k) {
            const Inclusion& source = inclusions_[k];
            inclusions_.push_back({mirrored(source.shape, walls_, r), source.tag, source.line});
        }
    }
}

/// Calls visit(k, translation) for each image of each inclusion that may lie within `distance` of
/// p; the image is inclusion k translated.
template <class Visit>
void InclusionSet::visit_images(const Vec2& p, double distance, const Visit& visit) const {
    const Lattice& reduced = reduction_.reduced;
    const Vec2 u = reduced.to_lattice(p);
    const Wrapped x = wrap(u.x());
    const Wrapped y = wrap(u.y());
    const Offset here{x.whole, y.whole};
    grid_->visit({x.fraction, y.fraction}, distance + largest_radius_, [&](int k, Offset offset) {
        const Vec2 translation = reduced.translation(offset + here - whole_[k]);
        const double apart = (bounds_[k].centre + translation - p).norm();
        if (apart < bounds_[k].radius + distance) visit(k, translation);
    });
}

ShapeRelation InclusionSet::relation(int i, int j, const Vec2& translation) const {
    return sides_[i].size() > 0 && sides_[j].size() > 0
               ? sides_[i].relation(sides_[j], translation)
               : shape_relation(inclusions_[i].shape, inclusions_[j].shape, translation);
}

void InclusionSet::put_inside(int inner, int outer) {
    int& parent = parents_[inner];
    if (parent < 0 || areas_[outer] < areas_[parent]) parent = outer;
}

/// Finds which shapes lie inside of others, and refuses outlines that meet.
void InclusionSet::find_parents() {
    parents_.assign(inclusions_.size(), -1);
    for (int i = 0; i < n_given(); ++i) {
        checkpoint();
        int other = size();
        const auto compare = [&](int j, const Vec2& translation) {
            if (j < i || j >= other || (j == i && translation.isZero(0))) return;
            const ShapeRelation found = relation(i, j, translation);
            if (found == ShapeRelation::kApart) return;
            const bool is_nested =
                found != ShapeRelation::kMeet && j != i &&
                !lies_on_image(reduction_.reduced, inclusions_[i], inclusions_[j]);
            if (!is_nested) {
                other = j;
            } else if (found == ShapeRelation::kFirstInside) {
                put_inside(i, j);
            } else {
                put_inside(j, i);
            }
        };
        visit_images(bounds_[i].centre, bounds_[i].radius * (1 + kSameVertex), compare);
        if (other == i) {
            refuse(inclusions_[i], "the shape meets an image of itself; make it smaller");
        }
        if (other < size()) {
            refuse(inclusions_[other],
                   complaint_of_overlap(reduction_.reduced, inclusions_[i], inclusions_[other]));
        }
    }
    // An image behind a wall lies inside of the same image of the other shape.
    for (int k = n_given(); k < size(); ++k) {
        const int parent = parents_[k % n_given()];
        parents_[k] = parent < 0 ? -1 : parent + k / n_given() * n_given();
    }
}

double InclusionSet::signed_distance_to(int k, const Vec2& p) const {
    return sides_[k].size() > 0 ? sides_[k].signed_distance(p)
                                : signed_distance(inclusions_[k].shape, p);
}

int InclusionSet::containing(const Vec2& p) const {
    int found = -1;
    visit_images(p, 0, [&](int k, const Vec2& translation) {
        if (found >= 0 && areas_[found] <= areas_[k]) return;
        if (signed_distance_to(k, p - translation) < 0) found = k;
    });
    return found;
}

std::optional<Vec2> InclusionSet::in_frame_of(int k, const Vec2& p) const {
    std::optional<Vec2> found;
    double least = bounds_[k].radius / 2;
    visit_images(p, least, [&](int image, const Vec2& translation) {
        if (image != k) return;
        const double distance = std::abs(signed_distance_to(k, p - translation));
        if (distance > least) return;
        least = distance;
        found = p - translation;
    });
    return found;
}

double InclusionSet::distance_to_others(int own, const Vec2& p, double reach) const {
    double least = reach;
    visit_images(p, reach, [&](int k, const Vec2& translation) {
        if (k == own && translation.isZero(0)) return;
        const Vec2 there = p - translation;
        if ((there - bounds_[k].centre).norm() - bounds_[k].radius >= least) return;
        least = std::min(least, std::abs(signed_distance_to(k, there)));
    });
    return least;
}

}  // namespace pcvt::plane
