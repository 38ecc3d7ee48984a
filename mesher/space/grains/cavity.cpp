#include "mesher/space/grains/cavity.hpp"

#include <algorithm>
#include <cmath>

namespace pcvt::space {
namespace {

/// A cavity of more tetrahedra loses all unseen ones in one pass: in a flat cell each sphere holds
/// most of them.
constexpr std::size_t kLarge = 200;
/// The volumes of Sight, times 6.
constexpr double kSeenWide = 1e-6;
constexpr double kSeenFar = 1e-12;

}  // namespace

bool Cavity::find(const Vec3& x, int holder, Sight sight) {
    x_ = x;
    least_volume6_ = sight == Sight::kWide ? kSeenWide : kSeenFar;
    std::vector<char>& marks = cell_.marks();
    grow(holder);
    const bool found = shrink(holder);
    for (const int t : inside_) marks[t] = 0;
    return found && keeps_vertices();
}

void Cavity::grow(int holder) {
    std::vector<char>& marks = cell_.marks();
    inside_.assign(1, holder);
    marks[holder] = 1;
    for (std::size_t i = 0; i < inside_.size(); ++i) {
        for (int k = 0; k < 4; ++k) {
            const int o = cell_.neighbour(inside_[i], k);
            if (o < 0 || marks[o] != 0) continue;
            const FourCorners& c = cell_.corners(o);
            if (!(in_sphere(cell_.point(c[0]), cell_.point(c[1]), cell_.point(c[2]),
                            cell_.point(c[3]), x_) > 0)) {
                continue;
            }
            marks[o] = 1;
            inside_.push_back(o);
        }
    }
}

bool Cavity::shrink(int holder) {
    for (;;) {
        bool blocked = false;
        const bool removed = remove_unseen(holder, blocked);
        if (blocked) return false;
        if (!removed) return true;
        keep_component(holder);
    }
}

bool Cavity::remove_unseen(int holder, bool& blocked) {
    std::vector<char>& marks = cell_.marks();
    boundary_.clear();
    const bool is_large = inside_.size() > kLarge;
    bool removed = false;
    for (std::size_t i = 0; i < inside_.size(); ++i) {
        const int t = inside_[i];
        if (marks[t] == 0 || sees_sides_of(t, blocked)) continue;
        removed = true;
        marks[t] = 0;
        blocked |= t == holder;
        if (blocked || !is_large) break;
        // Its neighbours now have a side on the boundary: look at them again.
        for (int k = 0; k < 4; ++k) {
            const int o = cell_.neighbour(t, k);
            if (o >= 0 && marks[o] != 0) inside_.push_back(o);
        }
    }
    return removed;
}

bool Cavity::sees_sides_of(int t, bool& blocked) {
    for (int k = 0; k < 4; ++k) {
        const int o = cell_.neighbour(t, k);
        if (o >= 0 && cell_.marks()[o] != 0) continue;
        const ThreeCorners triangle = cell_.triangle(t, k);
        const Vec3& a = cell_.point(triangle[0]);
        const Vec3& b = cell_.point(triangle[1]);
        const Vec3& c = cell_.point(triangle[2]);
        const double longest =
            std::max({squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)});
        if (-volume6(a, b, c, x_) < least_volume6_ * longest * std::sqrt(longest)) {
            blocked = o < 0;
            return false;
        }
        boundary_.push_back({triangle, o < 0});
    }
    return true;
}

void Cavity::keep_component(int holder) {
    std::vector<char>& marks = cell_.marks();
    kept_.assign(1, holder);
    marks[holder] = 2;
    for (std::size_t i = 0; i < kept_.size(); ++i) {
        for (int k = 0; k < 4; ++k) {
            const int o = cell_.neighbour(kept_[i], k);
            if (o < 0 || marks[o] != 1) continue;
            marks[o] = 2;
            kept_.push_back(o);
        }
    }
    for (const int t : inside_) marks[t] = 0;
    for (const int t : kept_) marks[t] = 1;
    inside_.swap(kept_);
}

bool Cavity::keeps_vertices() {
    seen_.resize(cell_.n_vertices(), 0);
    ++n_looks_;
    for (const Triangle& t : boundary_) {
        for (const int v : t.corners) seen_[v] = n_looks_;
    }
    return std::all_of(inside_.begin(), inside_.end(), [&](int t) {
        const FourCorners& c = cell_.corners(t);
        return seen_[c[0]] == n_looks_ && seen_[c[1]] == n_looks_ && seen_[c[2]] == n_looks_ &&
               seen_[c[3]] == n_looks_;
    });
}

double Cavity::size(double largest) const {
    double size = largest;
    for (const Triangle& t : boundary_) {
        for (const int v : t.corners) {
            size = std::min(size, cell_.size(v) + kSizeGrowth * distance(cell_.point(v), x_));
        }
    }
    return size;
}

bool Cavity::has_room(double from_vertices, double from_hull) const {
    const double squared = from_vertices * from_vertices;
    return std::all_of(boundary_.begin(), boundary_.end(), [&](const Triangle& t) {
        for (const int v : t.corners) {
            if (squared_distance(cell_.point(v), x_) < squared) return false;
        }
        if (!t.on_hull) return true;
        const Vec3& a = cell_.point(t.corners[0]);
        const Vec3 normal =
            cross_product(cell_.point(t.corners[1]) - a, cell_.point(t.corners[2]) - a);
        return dot_product(normal, a - x_) >= from_hull * length(normal);
    });
}

double Cavity::flatness() const {
    double least = kUnlimited;
    for (const Triangle& t : boundary_) {
        const auto& [a, b, c] = t.corners;
        least = std::min(
            least, CellTetrahedra::flatness_of(x_, cell_.point(a), cell_.point(b), cell_.point(c)));
    }
    return least;
}

void Cavity::fill(double size) {
    const int v = cell_.add_vertex(x_, size);
    fresh_.clear();
    for (const Triangle& t : boundary_) {
        fresh_.push_back({v, t.corners[0], t.corners[1], t.corners[2]});
    }
    cell_.replace(inside_, fresh_);
}

}  // namespace pcvt::space
