#include "mesher/space/grains/vertex_insertion.hpp"

#include <algorithm>
#include <array>

namespace pcvt::space {
namespace {

/// The smallest sine of a star must rise by this much.
constexpr double kContractionGain = 1e-6;
/// A cavity grows until its worst tetrahedron has this many times the sine before, and more.
constexpr double kGrowth = 1.15;
constexpr double kGrowthMore = 0.02;
constexpr int kMostInside = 40;
constexpr int kMostMoves = 3;
/// Depths below the hull, over the square root of twice the area of a triangle.
constexpr std::array kInward{0.35, 0.6, 0.9};
/// Two triangles of the hull whose normals cancel have no inward direction.
constexpr double kLeastNormal = 0.1;

}  // namespace

bool VertexInsertion::mend(int t) {
    const FourCorners corners = cell_.corners(t);
    for (const int v : corners) {
        if (!cell_.is_inner(v) || cell_.has_failed(CellTetrahedra::kContraction, v)) continue;
        if (contract(v)) return true;
        cell_.note_failure(CellTetrahedra::kContraction, v);
    }
    if (insert_near(t)) return true;
    cell_.note_failure(CellTetrahedra::kInsertion, t);
    return false;
}

/// Stops at the first sine that is not above `least`.
double VertexInsertion::quality_after(int v, int into, double least) const {
    double worst = kUnlimited;
    for (const int t : star_) {
        if (cell_.has_corner(t, into)) continue;
        FourCorners corners = cell_.corners(t);
        std::replace(corners.begin(), corners.end(), v, into);
        worst = std::min(worst, cell_.quality_of(corners));
        if (worst <= least) break;
    }
    return worst;
}

bool VertexInsertion::contract(int v) {
    cell_.find_star(v, star_);
    double before = kUnlimited;
    vertices_.clear();
    for (const int t : star_) {
        before = std::min(before, cell_.quality(t));
        for (const int w : cell_.corners(t)) {
            if (w != v) vertices_.push_back(w);
        }
    }
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
    int into = -1;
    double best = before + kContractionGain;
    for (const int w : vertices_) {
        const double worst = quality_after(v, w, best);
        if (!(worst > best) || worst == kUnlimited) continue;
        best = worst;
        into = w;
    }
    if (into < 0) return false;
    fresh_.clear();
    for (const int t : star_) {
        if (cell_.has_corner(t, into)) continue;
        fresh_.push_back(cell_.corners(t));
        std::replace(fresh_.back().begin(), fresh_.back().end(), v, into);
    }
    cell_.replace(star_, fresh_);
    cell_.forget_vertex(v);
    return true;
}

bool VertexInsertion::insert_near(int t) {
    const Vec3 middle = cell_.barycentre(t);
    if (insert_at(t, middle, {t}) || insert_into_longest_edge(t)) return true;
    Vec3 inward = Vec3::Zero();
    double lengths = 0;
    int n = 0;
    for (int k = 0; k < 4; ++k) {
        if (cell_.neighbour(t, k) >= 0) continue;
        const ThreeCorners triangle = cell_.triangle(t, k);
        const Vec3& a = cell_.point(triangle[0]);
        const Vec3 normal =
            cross_product(cell_.point(triangle[1]) - a, cell_.point(triangle[2]) - a);
        const double twice_area = length(normal);
        if (!(twice_area > 0)) continue;
        inward -= normal / twice_area;
        lengths += std::sqrt(twice_area);
        ++n;
    }
    if (n == 0 || length(inward) <= kLeastNormal) return false;
    const Vec3 step = lengths / n * unit_vector(inward);
    return std::any_of(kInward.begin(), kInward.end(),
                       [&](double depth) { return insert_at(t, middle + depth * step, {t}); });
}

bool VertexInsertion::insert_into_longest_edge(int t) {
    const FourCorners& corners = cell_.corners(t);
    int a = -1;
    int b = -1;
    double longest = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = i + 1; j < 4; ++j) {
            const double edge = squared_distance(cell_.point(corners[i]), cell_.point(corners[j]));
            if (edge <= longest) continue;
            longest = edge;
            a = corners[i];
            b = corners[j];
        }
    }
    cell_.find_star(a, star_);
    std::vector<int> holders;
    for (const int s : star_) {
        if (!cell_.has_corner(s, b)) continue;
        holders.push_back(s);
        for (int k = 0; k < 4; ++k) {
            const int v = cell_.corners(s)[k];
            if (cell_.neighbour(s, k) < 0 && v != a && v != b) return false;
        }
    }
    return insert_at(t, (cell_.point(a) + cell_.point(b)) / 2, holders);
}

/// Adds the triangles of a tetrahedron that bound `inside_` to the front.
void VertexInsertion::add_to_front(const Vec3& x, int t) {
    for (int k = 0; k < 4; ++k) {
        const int o = cell_.neighbour(t, k);
        if (o >= 0 && cell_.marks()[o] != 0) continue;
        const ThreeCorners c = cell_.triangle(t, k);
        const double sine =
            smallest_sine(x, cell_.point(c[0]), cell_.point(c[1]), cell_.point(c[2]));
        // The new vertex is not near to a feature.
        front_.push_back({cell_.rated({c[0], c[0], c[1], c[2]}, sine), o});
    }
}

/// Adds tetrahedra to `inside_` at its worst triangle until x sees each triangle under a sine above
/// `least`.
bool VertexInsertion::grow(const Vec3& x, double least) {
    std::vector<char>& marks = cell_.marks();
    front_.clear();
    for (const int t : inside_) marks[t] = 1;
    for (const int t : inside_) add_to_front(x, t);
    bool grown = false;
    while (!grown) {
        const auto worst =
            std::min_element(front_.begin(), front_.end(),
                             [](const Side& s, const Side& r) { return s.quality < r.quality; });
        grown = worst->quality > least;
        const int beyond = worst->beyond;
        if (grown || beyond < 0 || static_cast<int>(inside_.size()) > kMostInside) break;
        marks[beyond] = 1;
        inside_.push_back(beyond);
        std::erase_if(front_, [&](const Side& s) { return s.beyond == beyond; });
        add_to_front(x, beyond);
        if (front_.empty()) break;
    }
    for (const int t : inside_) marks[t] = 0;
    return grown;
}

/// Lists the tetrahedra that join v with the boundary of `inside_`.
/// @returns false if a vertex would vanish, or the boundary is not a sphere.
bool VertexInsertion::find_boundary(int v) {
    std::vector<char>& marks = cell_.marks();
    fresh_.clear();
    vertices_.clear();
    for (const int t : inside_) marks[t] = 1;
    for (const int t : inside_) {
        for (int k = 0; k < 4; ++k) {
            const int o = cell_.neighbour(t, k);
            if (o >= 0 && marks[o] != 0) continue;
            const ThreeCorners c = cell_.triangle(t, k);
            fresh_.push_back({v, c[0], c[1], c[2]});
            vertices_.insert(vertices_.end(), c.begin(), c.end());
        }
    }
    for (const int t : inside_) marks[t] = 0;
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
    if (2 * vertices_.size() != fresh_.size() + 4) return false;
    return std::all_of(inside_.begin(), inside_.end(), [&](int t) {
        const FourCorners& c = cell_.corners(t);
        return std::all_of(c.begin(), c.end(), [&](int w) {
            return std::binary_search(vertices_.begin(), vertices_.end(), w);
        });
    });
}

/// Moves a new vertex, and gives it a size.
void VertexInsertion::finish(int v) {
    for (int k = 0; k < kMostMoves && moves_.climb(v, kUnlimited); ++k) {
    }
    double size = kUnlimited;
    for (const int w : vertices_) {
        size =
            std::min(size, cell_.size(w) + kSizeGrowth * distance(cell_.point(w), cell_.point(v)));
    }
    cell_.set_size(v, size);
}

/// The sines of the new tetrahedra are above that of t, which is among those that they replace.
bool VertexInsertion::insert_at(int t, const Vec3& x, const std::vector<int>& holders) {
    inside_ = holders;
    const double least = std::max(kGrowth * cell_.quality(t), 0.0) + kGrowthMore;
    if (!grow(x, least) || !find_boundary(cell_.n_vertices())) return false;
    const int v = cell_.add_vertex(x, 0);
    cell_.replace(inside_, fresh_);
    finish(v);
    return true;
}

}  // namespace pcvt::space
