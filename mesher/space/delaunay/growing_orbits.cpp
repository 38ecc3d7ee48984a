#include "mesher/space/delaunay/growing_orbits.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"

namespace pcvt::space {
namespace {

/// A facet's number is 4 times that of its cell and at most 3 more.
constexpr std::size_t kMostCells = (std::size_t{1} << 29) - 1;

Image at_displacement(const Displacement& d) { return {Vec3(d.x, d.y, d.z), {}}; }

bool is_zero(const Displacement& d) { return d.x == 0 && d.y == 0 && d.z == 0; }

/// A corner as a number that orders as it does; offsets are below 128 in each direction.
std::uint64_t packed(const Corner& corner) {
    const auto byte = [](int o) { return std::uint64_t{static_cast<std::uint8_t>(o + 128)}; };
    return static_cast<std::uint64_t>(corner.site) << 24 | byte(corner.offset.i) << 16 |
           byte(corner.offset.j) << 8 | byte(corner.offset.k);
}

/// An edge of the boundary of a set of facets.
struct DirectedSide {
    Corner from;
    Corner to;

    friend auto operator<=>(const DirectedSide&, const DirectedSide&) = default;
};

/// The directed edges of facets whose other sides belong to none of them.
std::vector<DirectedSide> horizon_of(const std::vector<std::array<Corner, 3>>& facets) {
    std::vector<DirectedSide> edges;
    for (const auto& [a, b, c] : facets) edges.insert(edges.end(), {{a, b}, {b, c}, {c, a}});
    std::sort(edges.begin(), edges.end());
    std::vector<DirectedSide> horizon;
    for (const DirectedSide& edge : edges) {
        if (!std::binary_search(edges.begin(), edges.end(), DirectedSide{edge.to, edge.from})) {
            horizon.push_back(edge);
        }
    }
    return horizon;
}

}  // namespace

GrowingOrbits::Step::Step(Offset o)
    : i(static_cast<std::int8_t>(o.i)),
      j(static_cast<std::int8_t>(o.j)),
      k(static_cast<std::int8_t>(o.k)) {
    if (offset() != o) throw InternalError("a tetrahedron spans more than 127 periods");
}

GrowingOrbits::GrowingOrbits(const Gram& gram, const Points& coordinates,
                             const TorusTetrahedra& start)
    : gram_(gram),
      coordinates_(coordinates),
      cells_(static_cast<std::size_t>(start.n_tetrahedra())),
      last_lifted_(cells_.size(), -1) {
    for (int f = 0; f < start.n_facets(); ++f) {
        Cell& cell = cells_[f / 4];
        cell.site[f % 4] = start.corner(f).site;
        cell.corner[f % 4] = Step(start.corner(f).offset);
        cell.opposite[f % 4] = start.opposite(f);
        cell.frame[f % 4] = Step(start.frame_across(f));
    }
}

bool GrowingOrbits::insert(SiteId site) {
    new_number_ = site;
    new_site_ = coordinates_.col(site);
    int cell = last_cell_;
    Offset shift;
    if (!find_first(cell, shift)) return false;
    find_cavity(cell, shift);
    for (const Offset image : near_images()) insert_into_star(image);
    sides_.clear();
    remove_cavity();
    add_star();
    link_sides();
    forget();
    return true;
}

Displacement GrowingOrbits::from_new_site(const Corner& corner) const {
    const double* const u = coordinates_.data() + 3 * std::ptrdiff_t(corner.site);
    return {u[0] - new_site_[0] + corner.offset.i, u[1] - new_site_[1] + corner.offset.j,
            u[2] - new_site_[2] + corner.offset.k};
}

std::array<Displacement, 4> GrowingOrbits::corners_of(int cell, Offset shift) const {
    const Cell& c = cells_[cell];
    return {from_new_site(corner(c, 0, shift)), from_new_site(corner(c, 1, shift)),
            from_new_site(corner(c, 2, shift)), from_new_site(corner(c, 3, shift))};
}

/// The corner opposite to a facet beyond which the new site lies, or -1.
int GrowingOrbits::exit_of(int cell, Offset shift) const {
    const auto d = corners_of(cell, shift);
    for (int k = 0; k < 4; ++k) {
        const auto& facet = TorusTetrahedra::kFacetCorners[k];
        if (orientation(at_displacement(d[facet[0]]), at_displacement(d[facet[1]]),
                        at_displacement(d[facet[2]]), at_displacement({0, 0, 0})) < 0) {
            return k;
        }
    }
    return -1;
}

/// Walks from a cell to the translate of a tetrahedron that contains the new site. The walk ends:
/// of tetrahedra in a Delaunay triangulation, those seen from a point behind others form no cycle.
/// @returns false if the new site is one of its corners.
bool GrowingOrbits::find_first(int& cell, Offset& shift) const {
    // Corner 3 is the site before, which is a neighbour on the curve.
    const Displacement before = from_new_site(corner(cells_[cell], 3, {}));
    shift = {-int(std::round(before.x)), -int(std::round(before.y)), -int(std::round(before.z))};
    long n_steps = 0;
    for (int exit = exit_of(cell, shift); exit >= 0; exit = exit_of(cell, shift)) {
        checkpoint_each(++n_steps);
        shift = shift + cells_[cell].frame[exit].offset();
        cell = cells_[cell].opposite[exit] / 4;
    }
    const auto corners = corners_of(cell, shift);
    return std::none_of(corners.begin(), corners.end(), is_zero);
}

bool GrowingOrbits::contains_new_site(int cell, Offset shift) const {
    const auto d = corners_of(cell, shift);
    return violates_delaunay(gram_, at_displacement(d[0]), at_displacement(d[1]),
                             at_displacement(d[2]), at_displacement(d[3]),
                             at_displacement({0, 0, 0}));
}

int GrowingOrbits::find_lifted(int cell, Offset shift) const {
    int found = last_lifted_[cell];
    while (found >= 0 && lifted_[found].shift != shift) found = lifted_[found].before;
    return found;
}

int GrowingOrbits::add_lifted(int cell, Offset shift, bool is_inside) {
    lifted_.push_back({cell, shift, is_inside, last_lifted_[cell]});
    last_lifted_[cell] = static_cast<int>(lifted_.size()) - 1;
    return last_lifted_[cell];
}

/// Finds the translates whose spheres contain the new site, and the facets around them.
void GrowingOrbits::find_cavity(int cell, Offset shift) {
    std::vector<int> inside{add_lifted(cell, shift, true)};
    for (std::size_t n = 0; n < inside.size(); ++n) {
        checkpoint_each(static_cast<long>(n));
        const Lifted here = lifted_[inside[n]];
        const Cell& c = cells_[here.cell];
        for (int k = 0; k < 4; ++k) {
            const int across = c.opposite[k] / 4;
            const Offset there = here.shift + c.frame[k].offset();
            int beyond = find_lifted(across, there);
            if (beyond < 0) {
                beyond = add_lifted(across, there, contains_new_site(across, there));
                if (lifted_[beyond].is_inside) inside.push_back(beyond);
            }
            if (lifted_[beyond].is_inside) continue;
            const auto& facet = TorusTetrahedra::kFacetCorners[k];
            star_.push_back({corner(c, facet[0], here.shift), corner(c, facet[1], here.shift),
                             corner(c, facet[2], here.shift)});
        }
    }
}

/// The images of the new site that may be its neighbours: those whose spheres also contain one of
/// the translates that were met.
std::vector<Offset> GrowingOrbits::near_images() const {
    std::vector<Offset> images;
    for (const Lifted& one : lifted_) {
        for (int k = last_lifted_[one.cell]; k >= 0; k = lifted_[k].before) {
            const Offset image = one.shift - lifted_[k].shift;
            if (lifted_[k].is_inside && image != Offset{}) images.push_back(image);
        }
    }
    std::sort(images.begin(), images.end());
    images.erase(std::unique(images.begin(), images.end()), images.end());
    return images;
}

/// Replaces the facets of the star whose spheres contain an image of the new site.
void GrowingOrbits::insert_into_star(Offset image) {
    const Image site = at_displacement({0, 0, 0});
    const Image other = at_displacement(from_new_site({new_number_, image}));
    std::vector<StarFacet> removed;
    std::erase_if(star_, [&](const StarFacet& facet) {
        const auto at = [&](int k) { return at_displacement(from_new_site(facet[k])); };
        if (!violates_delaunay(gram_, at(0), at(1), at(2), site, other)) return false;
        removed.push_back(facet);
        return true;
    });
    for (const auto& [from, to] : horizon_of(removed)) {
        star_.push_back({from, to, Corner{new_number_, image}});
    }
}

void GrowingOrbits::add_side(const Cell& c, int k, int cell, int cell_side, Offset frame) {
    const auto& corners = TorusTetrahedra::kFacetCorners[k];
    std::array facet{corner(c, corners[0], {}), corner(c, corners[1], {}),
                     corner(c, corners[2], {})};
    std::sort(facet.begin(), facet.end());
    const Offset base = facet[0].offset;
    for (Corner& one : facet) one.offset = one.offset - base;
    sides_.push_back(
        {{packed(facet[0]), packed(facet[1]), packed(facet[2])}, cell, cell_side, base - frame});
}

/// Removes the cells of the cavity. Collects the sides beyond which others remain.
void GrowingOrbits::remove_cavity() {
    std::vector<int> removed;
    for (const Lifted& lifted : lifted_) {
        if (lifted.is_inside) removed.push_back(lifted.cell);
    }
    std::sort(removed.begin(), removed.end());
    removed.erase(std::unique(removed.begin(), removed.end()), removed.end());
    for (const int cell : removed) {
        const Cell& c = cells_[cell];
        for (int k = 0; k < 4; ++k) {
            const int across = c.opposite[k] / 4;
            if (std::binary_search(removed.begin(), removed.end(), across)) continue;
            add_side(c, k, across, c.opposite[k] % 4, c.frame[k].offset());
        }
    }
    for (const int cell : removed) {
        cells_[cell].site[0] = -1;
        gaps_.push_back(cell);
    }
}

/// Adds the cells of the star, and collects their sides.
void GrowingOrbits::add_star() {
    for (const StarFacet& facet : star_) {
        // Keep one of the translates in which the new site is another corner.
        const bool is_first = std::all_of(facet.begin(), facet.end(), [&](const Corner& c) {
            return c.site != new_number_ || Offset{} < c.offset;
        });
        if (!is_first) continue;
        const int number = number_of_new_cell();
        Cell& c = cells_[number];
        for (int k = 0; k < 3; ++k) {
            c.site[k] = facet[k].site;
            c.corner[k] = Step(facet[k].offset);
        }
        c.site[3] = new_number_;
        c.corner[3] = Step();
        for (int k = 0; k < 4; ++k) add_side(c, k, number, k, {});
        last_cell_ = number;
    }
}

int GrowingOrbits::number_of_new_cell() {
    if (!gaps_.empty()) {
        const int number = gaps_.back();
        gaps_.pop_back();
        return number;
    }
    if (cells_.size() == kMostCells) {
        throw LimitExceeded("the sites have more than 2^29 Delaunay tetrahedra; take fewer sites");
    }
    cells_.emplace_back();
    last_lifted_.push_back(-1);
    return static_cast<int>(cells_.size()) - 1;
}

void GrowingOrbits::link_sides() {
    std::sort(sides_.begin(), sides_.end(),
              [](const Side& one, const Side& other) { return one.key < other.key; });
    for (std::size_t k = 0; k < sides_.size(); k += 2) {
        const bool is_pair = k + 1 < sides_.size() && sides_[k].key == sides_[k + 1].key &&
                             (k + 2 == sides_.size() || sides_[k].key != sides_[k + 2].key);
        if (!is_pair) throw InternalError("the star of an inserted site does not fill its cavity");
        const Side& one = sides_[k];
        const Side& other = sides_[k + 1];
        cells_[one.cell].opposite[one.facet] = 4 * other.cell + other.facet;
        cells_[one.cell].frame[one.facet] = Step(one.base - other.base);
        cells_[other.cell].opposite[other.facet] = 4 * one.cell + one.facet;
        cells_[other.cell].frame[other.facet] = Step(other.base - one.base);
    }
}

void GrowingOrbits::forget() {
    for (const Lifted& lifted : lifted_) last_lifted_[lifted.cell] = -1;
    lifted_.clear();
    star_.clear();
}

std::vector<Tetrahedron> GrowingOrbits::tetrahedra() const {
    std::vector<Tetrahedron> all;
    all.reserve(static_cast<std::size_t>(n_tetrahedra()));
    for (const Cell& c : cells_) {
        if (c.is_gap()) continue;
        all.push_back({corner(c, 0, {}), corner(c, 1, {}), corner(c, 2, {}), corner(c, 3, {})});
    }
    return all;
}

}  // namespace pcvt::space
