#include "mesher/space/box/box_origin.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "mesher/base/checkpoint.hpp"
#include "mesher/portable/portable_angles.hpp"
#include "mesher/space/box/plane_levels.hpp"
#include "mesher/space/mesh/vector_area.hpp"

namespace pcvt::space {
namespace {

constexpr int kFewCells = 200;
constexpr int kFewPositions = 200;
constexpr int kManyPositions = 1000;
/// Sums, and distances from vertices over the largest one, that differ by less are equal up to
/// rounding.
constexpr double kEqual = 1e-6;

double dot(const Vec3& a, const Vec3& b) { return a.x() * b.x() + a.y() * b.y() + a.z() * b.z(); }

/// The angle between two vectors, degrees.
double degrees(const Vec3& a, const Vec3& b) {
    const Vec3 normal = a.cross(b);
    return portable_atan2(std::sqrt(dot(normal, normal)), dot(a, b)) * 180 / std::numbers::pi;
}

double penalty(double angle) {
    return angle < kNarrowAngle ? (kNarrowAngle - angle) * (kNarrowAngle - angle) : 0;
}

/// The penalty of the angle between two vectors.
double penalty_between(const Vec3& a, const Vec3& b) {
    // The square of the cosine of 25.1 degrees: most angles are wider, and need no arc tangent.
    constexpr double kWide = 0.82;
    const double cosine = dot(a, b);
    if (cosine <= 0 || cosine * cosine < kWide * (dot(a, a) * dot(b, b))) return 0;
    return penalty(degrees(a, b));
}

/// The penalty of an angle between two lines and of its supplement.
double penalty_of_lines(const Vec3& a, const Vec3& b) {
    return dot(a, b) < 0 ? penalty_between(a, -b) : penalty_between(a, b);
}

/// A part of the section of a cell: the line in which a plane cuts one of its faces, with the
/// section of the cell on the left seen from above.
struct SectionEdge {
    SiteId cell;
    /// Tells apart the sections of several images.
    int plane;
    Vec3 from;
    Vec3 to;
};

/// A face as seen by the planes of one axis.
class FaceSections {
   public:
    FaceSections(const Sites& sites, const CellComplex& complex, int axis)
        : complex_(complex), lattice_(sites.lattice()), reduction_(sites.reduction()), axis_(axis) {
        up_ = upwards(lattice_, axis);
        for (const Vec3& vertex : complex.vertices) {
            heights_.push_back(lattice_.to_lattice(vertex)[axis]);
            wrapped_.push_back(heights_.back() - std::floor(heights_.back()));
        }
        std::sort(wrapped_.begin(), wrapped_.end());
        for (const VertexImage& corner : complex.corners) {
            corners_.push_back(
                {heights_[corner.vertex] + along(corner.offset), complex.position(corner)});
        }
        for (int f = 0; f < complex.n_faces(); ++f) {
            tilts_.push_back(2 * penalty_of_lines(normal(f), up_));
        }
    }

    /// The distance of a plane from the nearest vertex, in periods.
    double distance_from_vertices(double position) const {
        const auto next = std::lower_bound(wrapped_.begin(), wrapped_.end(), position);
        const double above = next == wrapped_.end() ? wrapped_.front() + 1 : *next;
        const double below = next == wrapped_.begin() ? wrapped_.back() - 1 : *std::prev(next);
        return std::min(above - position, position - below);
    }

    int along(const Offset& offset) const {
        return reduction_.to_original(offset).components()[axis_];
    }
    /// The range of heights of a face.
    std::pair<double, double> range(int f) const {
        double low = corners_of(f)[0].height;
        double high = low;
        for (const FaceCorner& corner : corners_of(f)) {
            low = std::min(low, corner.height);
            high = std::max(high, corner.height);
        }
        return {low, high};
    }

    /// Adds the angles at the line in which a plane cuts a face: a corner above or below at each
    /// end, and a dihedral angle in both cells. Adds that line to the sections of these cells.
    /// Planes that touch a face do not count.
    void cut(int f, double position, int whole, double& sum,
             std::vector<SectionEdge>& edges) const {
        const std::span<const FaceCorner> corners = corners_of(f);
        const double plane = position + whole;
        std::array<Vec3, 2> ends;
        std::array<Vec3, 2> along_edges;
        int n_found = 0;
        bool rises_first = false;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const FaceCorner& to = corners[k + 1 < corners.size() ? k + 1 : 0];
            const double here = corners[k].height - plane;
            const double next = to.height - plane;
            if ((here < 0) == (next < 0)) continue;
            if (n_found == 2) return;
            const Vec3& from = corners[k].position;
            const Vec3 step = to.position - from;
            if (n_found == 0) rises_first = here < 0;
            ends[n_found] = from + here / (here - next) * step;
            along_edges[n_found++] = step;
        }
        if (n_found < 2) return;
        if (!rises_first) std::swap(ends[0], ends[1]);
        if (!rises_first) std::swap(along_edges[0], along_edges[1]);
        const Vec3 line = ends[1] - ends[0];
        for (const Vec3& edge : along_edges) sum += penalty_of_lines(line, edge);
        sum += tilts_[f];
        // From where the face rises to where it comes down runs the face below the plane, so that
        // the section has this line in reverse.
        const CellFace& face = complex_.faces[f];
        const Vec3 back = complex_.reduced.translation(face.offset);
        edges.push_back({face.cell, whole, ends[1], ends[0]});
        edges.push_back(
            {face.neighbour, whole - along(face.offset), ends[0] - back, ends[1] - back});
    }

   private:
    struct FaceCorner {
        /// In periods.
        double height;
        Vec3 position;
    };

    std::span<const FaceCorner> corners_of(int f) const {
        return {corners_.data() + complex_.begin[f], corners_.data() + complex_.begin[f + 1]};
    }

    Vec3 normal(int f) const {
        return twice_vector_area(corners_of(f),
                                 [](const FaceCorner& corner) { return corner.position; });
    }

    const CellComplex& complex_;
    const Lattice& lattice_;
    const Reduction& reduction_;
    int axis_;
    /// Towards larger heights, normal to the planes.
    Vec3 up_;
    /// Of vertices, in periods.
    std::vector<double> heights_;
    /// The same from 0 to 1, rising.
    std::vector<double> wrapped_;
    /// Of all faces, in the order of CellComplex::corners.
    std::vector<FaceCorner> corners_;
    /// For each face the penalty of its two dihedral angles with a plane.
    std::vector<double> tilts_;
};

/// The penalty of the corners of sections, whose two sides are the pieces above and below.
double section_penalty(std::vector<SectionEdge>& edges) {
    std::stable_sort(edges.begin(), edges.end(), [](const SectionEdge& e, const SectionEdge& g) {
        return std::tie(e.cell, e.plane) < std::tie(g.cell, g.plane);
    });
    double sum = 0;
    for (std::size_t begin = 0; begin < edges.size();) {
        std::size_t end = begin;
        while (end < edges.size() && edges[end].cell == edges[begin].cell &&
               edges[end].plane == edges[begin].plane) {
            ++end;
        }
        for (std::size_t k = begin; k < end; ++k) {
            // The edge that begins where this one ends.
            const auto next = std::min_element(edges.begin() + std::ptrdiff_t(begin),
                                               edges.begin() + std::ptrdiff_t(end),
                                               [&](const SectionEdge& e, const SectionEdge& g) {
                                                   return (e.from - edges[k].to).squaredNorm() <
                                                          (g.from - edges[k].to).squaredNorm();
                                               });
            sum += penalty_between(edges[k].from - edges[k].to, next->to - next->from);
        }
        begin = end;
    }
    return sum;
}

/// The lowest and the highest points of all cells across the planes of an axis, in periods
/// modulo 1.
class CellEnds {
   public:
    CellEnds(const Sites& sites, const FaceSections& sections, const CellComplex& complex, int axis)
        : periods_(kThinPiece * sites.spacing() / sites.lattice().heights()[axis]) {
        constexpr double kInfinity = std::numeric_limits<double>::infinity();
        std::vector<double> low(static_cast<std::size_t>(complex.n_cells), kInfinity);
        std::vector<double> high(low.size(), -kInfinity);
        for (int f = 0; f < complex.n_faces(); ++f) {
            const CellFace& face = complex.faces[f];
            const auto [least, largest] = sections.range(f);
            const int along = sections.along(face.offset);
            low[face.cell] = std::min(low[face.cell], least);
            high[face.cell] = std::max(high[face.cell], largest);
            low[face.neighbour] = std::min(low[face.neighbour], least - along);
            high[face.neighbour] = std::max(high[face.neighbour], largest - along);
        }
        // Heights count upwards from the lowest points, and downwards from the highest ones.
        for (const double u : low) low_.push_back(u - std::floor(u));
        for (const double u : high) high_.push_back(-u - std::floor(-u));
    }

    double thin_pieces(double plane) const {
        return sum_above(low_, plane) + sum_above(high_, -plane);
    }

   private:
    double sum_above(const std::vector<double>& ends, double plane) const {
        double sum = 0;
        for (const double end : ends) {
            const double above = plane - end - std::floor(plane - end);
            // A plane through the end cuts nothing off.
            if (above < kTouching || above >= periods_) continue;
            sum += penalty(kNarrowAngle * above / periods_);
        }
        return sum;
    }

    static constexpr double kTouching = 1e-9;
    /// The thickness of thin pieces.
    double periods_;
    std::vector<double> low_;
    std::vector<double> high_;
};

int whole_below(double height) { return static_cast<int>(std::ceil(height)); }

/// The faces that each position cuts, and the number of periods from there.
using CutFaces = std::vector<std::pair<int, int>>;

double sum_of_angles(const FaceSections& sections, double position, const CutFaces& faces) {
    double sum = 0;
    std::vector<SectionEdge> edges;
    for (const auto& [f, whole] : faces) sections.cut(f, position, whole, sum, edges);
    return sum + section_penalty(edges);
}

/// The best of m positions along an axis.
double best_position(const Sites& sites, const CellComplex& complex, int axis, int m) {
    const FaceSections sections(sites, complex, axis);
    const CellEnds ends(sites, sections, complex, axis);
    const auto position = [m](long k) { return (double(k) + 0.5) / m; };
    std::vector<CutFaces> cut(static_cast<std::size_t>(m));
    for (int f = 0; f < complex.n_faces(); ++f) {
        checkpoint_each(f);
        const auto [low, high] = sections.range(f);
        const auto last = static_cast<long>(std::ceil(high * m));
        for (auto k = static_cast<long>(std::floor(low * m)) - 1; k <= last; ++k) {
            const long whole = k >= 0 ? k / m : -((m - 1 - k) / m);
            cut[k - whole * m].emplace_back(f, static_cast<int>(whole));
        }
    }
    std::vector<double> sums;
    for (int k = 0; k < m; ++k) {
        checkpoint();
        sums.push_back(sum_of_angles(sections, position(k), cut[k]) +
                       ends.thin_pieces(position(k)));
    }
    const double least = *std::min_element(sums.begin(), sums.end());
    double best = 0;
    double farthest = -1;
    for (int k = 0; k < m; ++k) {
        if (sums[k] > least + kEqual * (1 + least)) continue;
        const double distance = sections.distance_from_vertices(position(k));
        if (!(distance > farthest + kEqual / m)) continue;
        farthest = distance;
        best = position(k);
    }
    return best;
}

}  // namespace

double narrow_angles(const Sites& sites, const CellComplex& complex, int axis, double plane) {
    const FaceSections sections(sites, complex, axis);
    CutFaces faces;
    for (int f = 0; f < complex.n_faces(); ++f) {
        const auto [low, high] = sections.range(f);
        for (int k = whole_below(low - plane); plane + k <= high; ++k) faces.emplace_back(f, k);
    }
    return sum_of_angles(sections, plane, faces);
}

double thin_pieces(const Sites& sites, const CellComplex& complex, int axis, double plane) {
    return CellEnds(sites, FaceSections(sites, complex, axis), complex, axis).thin_pieces(plane);
}

Vec3 best_box_origin(const Sites& sites, const CellComplex& complex) {
    const int m = complex.n_cells > kFewCells ? kManyPositions : kFewPositions;
    Vec3 u;
    for (int axis = 0; axis < 3; ++axis) u[axis] = best_position(sites, complex, axis, m);
    return sites.lattice().to_position(u);
}

}  // namespace pcvt::space
