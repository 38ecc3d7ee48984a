#include "mesher/space/delaunay/growing_tetrahedra.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/base/checkpoint.hpp"

namespace pcvt::space {
namespace {

/// A walk of more steps has lost its way, and a search of all cells takes over.
constexpr int kMostSteps = 1000;
/// Cavities with more neighbours, of a site amid a sphere of others, are linked by sorting.
constexpr std::size_t kMostInTable = 256;

/// The components of the shortest of a displacement's images; exact for multiples of 2^-50 in
/// (-1, 1).
inline double shortest(double x) {
    constexpr double kRoundsToIntegers = 0x1.8p52;
    return x - ((x + kRoundsToIntegers) - kRoundsToIntegers);
}

inline Displacement shortest_between(const double* from, const double* to) {
    return {shortest(to[0] - from[0]), shortest(to[1] - from[1]), shortest(to[2] - from[2])};
}

inline double triple(const Displacement& d, const Displacement& e, const Displacement& f) {
    return d.x * (e.y * f.z - e.z * f.y) + d.y * (e.z * f.x - e.x * f.z) +
           d.z * (e.x * f.y - e.y * f.x);
}

Image as_image(const Displacement& d) { return {Vec3(d.x, d.y, d.z), {}}; }

/// Whether corners, each at its shortest displacement, are those of one image of a tetrahedron.
bool belong_together(const std::array<Displacement, 4>& corners) {
    const auto near = [](double x, double y) { return std::abs(x - y) < 0.5; };
    const Displacement& first = corners[0];
    return std::all_of(corners.begin(), corners.end(), [&](const Displacement& d) {
        return near(d.x, first.x) && near(d.y, first.y) && near(d.z, first.z);
    });
}

}  // namespace

GrowingTetrahedra::GrowingTetrahedra(const Gram& gram, const Points& coordinates,
                                     const TorusTetrahedra& start)
    : gram_(gram),
      coordinates_(coordinates),
      most_determinant_error_(determinant_rounding({1, 1, 1})),
      most_in_sphere_error_(in_sphere_rounding(gram, {1, 1, 1})),
      cells_(static_cast<std::size_t>(start.n_tetrahedra())),
      side_(cells_.size(), Side::kUnknown),
      place_(static_cast<std::size_t>(coordinates.cols()), 0) {
    for (int f = 0; f < start.n_facets(); ++f) {
        cells_[f / 4].site[f % 4] = start.corner(f).site;
        cells_[f / 4].opposite[f % 4] = start.opposite(f);
    }
}

bool GrowingTetrahedra::insert(SiteId site) {
    new_number_ = site;
    new_site_ = coordinates_.col(site);
    const int first = find_first();
    if (first < 0) return false;
    find_cavity(first);
    fill_cavity();
    return true;
}

Displacement GrowingTetrahedra::from_new_site(SiteId site) const {
    return shortest_between(new_site_.data(), coordinates_.data() + 3 * std::ptrdiff_t(site));
}

GrowingTetrahedra::Corners GrowingTetrahedra::corners_from_new_site(const Cell& cell) const {
    return {from_new_site(cell.site[0]), from_new_site(cell.site[1]), from_new_site(cell.site[2]),
            from_new_site(cell.site[3])};
}

bool GrowingTetrahedra::contains_new_site(const Corners& corners,
                                          const std::array<double, 4>& heights) const {
    const double value = in_sphere_determinant(corners, heights);
    if (std::abs(value) > most_in_sphere_error_) return value > 0;
    return violates_delaunay(gram_, as_image(corners[0]), as_image(corners[1]),
                             as_image(corners[2]), as_image(corners[3]), as_image({0, 0, 0}));
}

bool GrowingTetrahedra::contains_new_site(const Corners& corners) const {
    return contains_new_site(
        corners, {height(corners[0]), height(corners[1]), height(corners[2]), height(corners[3])});
}

/// The corner opposite to a facet beyond which the new site lies, or -1.
int GrowingTetrahedra::exit_of(int t) const {
    const auto d = corners_from_new_site(cells_[t]);
    const std::array<double, 4> side{triple(d[1], d[2], d[3]), -triple(d[0], d[2], d[3]),
                                     triple(d[0], d[1], d[3]), -triple(d[0], d[1], d[2])};
    const auto least = int(std::min_element(side.begin(), side.end()) - side.begin());
    if (side[least] < -most_determinant_error_) return least;
    for (int k = 0; k < 4; ++k) {
        if (side[k] > most_determinant_error_) continue;
        const auto& corners = TorusTetrahedra::kFacetCorners[k];
        if (orientation(as_image(d[corners[0]]), as_image(d[corners[1]]), as_image(d[corners[2]]),
                        as_image({0, 0, 0})) < 0) {
            return k;
        }
    }
    return -1;
}

/// Whether the sphere of a cell, anywhere in the torus, contains the new site within.
bool GrowingTetrahedra::can_be_first(int t) const {
    const auto corners = corners_from_new_site(cells_[t]);
    const auto coincides = [](const Displacement& d) { return d.x == 0 && d.y == 0 && d.z == 0; };
    return belong_together(corners) && std::none_of(corners.begin(), corners.end(), coincides) &&
           contains_new_site(corners);
}

/// A tetrahedron whose sphere contains the new site, or -1.
int GrowingTetrahedra::find_first() const {
    const int found = find_by_walk();
    return found >= 0 && can_be_first(found) ? found : find_by_search();
}

int GrowingTetrahedra::find_by_walk() const {
    int t = last_cell_;
    for (int step = 0; step < kMostSteps; ++step) {
        const int exit = exit_of(t);
        if (exit < 0) return t;
        t = cells_[t].opposite[exit] / 4;
    }
    return -1;
}

int GrowingTetrahedra::find_by_search() const {
    for (int t = 0; t < static_cast<int>(cells_.size()); ++t) {
        checkpoint_each(t);
        if (!cells_[t].is_gap() && can_be_first(t)) return t;
    }
    return -1;
}

/// The place of a site among the neighbours, which it joins if it is new.
[[gnu::always_inline]] inline int GrowingTetrahedra::place_of(SiteId site) {
    const int place = place_[site];
    if (std::size_t(place) < neighbours_.size() && neighbours_[place].site == site) return place;
    return add_neighbour(site);
}

[[gnu::noinline]] int GrowingTetrahedra::add_neighbour(SiteId site) {
    constexpr double kFar = 0.25;
    const Displacement d = from_new_site(site);
    const double largest = std::max(std::max(std::abs(d.x), std::abs(d.y)), std::abs(d.z));
    place_[site] = static_cast<int>(neighbours_.size());
    neighbours_.push_back({site, largest >= kFar, d, height(d)});
    return place_[site];
}

/// @param facet  of the cell in question; the cell across it contains the new site.
bool GrowingTetrahedra::is_in_conflict(int facet) {
    const Cell& cell = cells_[facet / 4];
    Corners corners;
    std::array<double, 4> heights;
    bool far = false;
    for (int k = 0; k < 4; ++k) {
        const Neighbour& corner = neighbours_[place_of(cell.site[k])];
        corners[k] = corner.displacement;
        heights[k] = corner.height;
        far |= corner.is_far;
    }
    return far ? is_in_conflict_across_seam(facet) : contains_new_site(corners, heights);
}

/// The same where nearest images need not belong together.
bool GrowingTetrahedra::is_in_conflict_across_seam(int facet) const {
    const Cell& cell = cells_[facet / 4];
    Corners corners = corners_from_new_site(cell);
    // The corners of the facet are less than half a period away, but the fourth one need not be.
    const int fourth = facet % 4;
    const int shared = fourth ^ 1;
    const double* const u = coordinates_.data();
    const Displacement edge = shortest_between(u + 3 * std::ptrdiff_t(cell.site[shared]),
                                               u + 3 * std::ptrdiff_t(cell.site[fourth]));
    const Displacement& d = corners[shared];
    corners[fourth] = {d.x + edge.x, d.y + edge.y, d.z + edge.z};
    return contains_new_site(corners);
}

/// Finds the connected set of tetrahedra that the new site replaces, and its walls.
void GrowingTetrahedra::find_cavity(int first) {
    cavity_.assign(1, first);
    side_[first] = Side::kInside;
    outside_.clear();
    walls_.clear();
    neighbours_.clear();
    for (std::size_t k = 0; k < cavity_.size(); ++k) {
        const int t = cavity_[k];
        const std::array<int, 4> opposite = cells_[t].opposite;
        for (int corner = 0; corner < 4; ++corner) {
            const int behind = opposite[corner];
            Side side = side_[behind / 4];
            if (side == Side::kUnknown) {
                side = is_in_conflict(behind) ? Side::kInside : Side::kOutside;
                side_[behind / 4] = side;
                (side == Side::kInside ? cavity_ : outside_).push_back(behind / 4);
            }
            if (side == Side::kOutside) add_wall(4 * t + corner);
        }
    }
    for (const int t : cavity_) side_[t] = Side::kUnknown;
    for (const int t : outside_) side_[t] = Side::kUnknown;
}

void GrowingTetrahedra::add_wall(int facet) {
    const Cell& cell = cells_[facet / 4];
    const auto& corners = TorusTetrahedra::kFacetCorners[facet % 4];
    const auto place = [&](int k) { return place_of(cell.site[corners[k]]); };
    walls_.push_back({{place(0), place(1), place(2)}, cell.opposite[facet % 4], -1});
}

/// Joins the walls to the new site: corner 3 of the new tetrahedra.
void GrowingTetrahedra::fill_cavity() {
    for (Wall& wall : walls_) {
        wall.cell = number_of_new_cell();
        Cell& cell = cells_[wall.cell];
        for (int k = 0; k < 3; ++k) cell.site[k] = neighbours_[wall.corner[k]].site;
        cell.site[3] = new_number_;
        cell.opposite[3] = wall.behind;
        cells_[wall.behind / 4].opposite[wall.behind % 4] = 4 * wall.cell + 3;
    }
    for (const int t : cavity_) {
        cells_[t].site[0] = -1;
        gaps_.push_back(t);
    }
    if (neighbours_.size() <= kMostInTable) {
        link_by_table();
    } else {
        link_by_sorting();
    }
    last_cell_ = walls_.back().cell;
}

/// The number of an old tetrahedron, then that of a gap, then a new one.
int GrowingTetrahedra::number_of_new_cell() {
    std::vector<int>& free = cavity_.empty() ? gaps_ : cavity_;
    if (free.empty()) {
        cells_.emplace_back();
        side_.push_back(Side::kUnknown);
        return static_cast<int>(cells_.size()) - 1;
    }
    const int number = free.back();
    free.pop_back();
    return number;
}

void GrowingTetrahedra::link_by_table() {
    const auto n = static_cast<int>(neighbours_.size());
    beside_.resize(std::max(beside_.size(), neighbours_.size() * neighbours_.size()));
    for (const Wall& wall : walls_) {
        const auto& [a, b, c] = wall.corner;
        beside_[b * n + c] = 4 * wall.cell;
        beside_[c * n + a] = 4 * wall.cell + 1;
        beside_[a * n + b] = 4 * wall.cell + 2;
    }
    for (const Wall& wall : walls_) {
        const auto& [a, b, c] = wall.corner;
        Cell& cell = cells_[wall.cell];
        cell.opposite[0] = beside_[c * n + b];
        cell.opposite[1] = beside_[a * n + c];
        cell.opposite[2] = beside_[b * n + a];
    }
}

void GrowingTetrahedra::link_by_sorting() {
    struct Edge {
        int low;
        int high;
        int facet;
    };
    std::vector<Edge> edges;
    for (const Wall& wall : walls_) {
        for (int k = 0; k < 3; ++k) {
            const auto [low, high] =
                std::minmax(wall.corner[(k + 1) % 3], wall.corner[(k + 2) % 3]);
            edges.push_back({low, high, 4 * wall.cell + k});
        }
    }
    std::sort(edges.begin(), edges.end(), [](const Edge& one, const Edge& other) {
        return std::pair(one.low, one.high) < std::pair(other.low, other.high);
    });
    for (std::size_t k = 0; k + 1 < edges.size(); k += 2) {
        const int f = edges[k].facet;
        const int o = edges[k + 1].facet;
        cells_[f / 4].opposite[f % 4] = o;
        cells_[o / 4].opposite[o % 4] = f;
    }
}

}  // namespace pcvt::space
