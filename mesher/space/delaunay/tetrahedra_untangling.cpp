#include "mesher/space/delaunay/tetrahedra_untangling.hpp"

#include <algorithm>

#include "mesher/base/checkpoint.hpp"

namespace pcvt::space {
namespace {

constexpr int kRounds = 20;
/// A site tries its whole remaining move, then half of it, and so on. A short move succeeds
/// unless a tetrahedron around the site is almost flat.
constexpr int kHalvings = 10;

}  // namespace

std::vector<int> star_of_corner(const TorusTetrahedra& tetrahedra, int corner) {
    std::vector<int> star{corner};
    // The loop visits corners that it appends.
    for (std::size_t n = 0; n < star.size(); ++n) {
        const int here = star[n];
        const Corner image = tetrahedra.corner(here);
        const int first = here - here % 4;
        for (int f = first; f < first + 4; ++f) {
            if (f == here) continue;
            const Offset frame = tetrahedra.frame_across(f);
            const int across = tetrahedra.opposite(f);
            for (int c = across - across % 4; c < across - across % 4 + 4; ++c) {
                const Corner other = tetrahedra.corner(c);
                if (other.site != image.site || other.offset + frame != image.offset) continue;
                if (std::find(star.begin(), star.end(), c) == star.end()) star.push_back(c);
            }
        }
    }
    return star;
}

TetrahedraUntangling::TetrahedraUntangling(TorusTetrahedra& tetrahedra, const Points& valid,
                                           Points& coordinates, const Gram& gram)
    : tetrahedra_(tetrahedra),
      valid_(valid),
      coordinates_(coordinates),
      flips_(tetrahedra, coordinates, gram,
             [this](const std::vector<int>& changed) { note_changed(changed); }) {}

void TetrahedraUntangling::note_changed(const std::vector<int>& changed) {
    for (const int t : changed) {
        for (int c = 4 * t; c < 4 * t + 4; ++c) {
            const auto held = corner_at_.find(tetrahedra_.corner(c).site);
            if (held != corner_at_.end()) held->second = c;
        }
    }
}

bool TetrahedraUntangling::hold(int tetrahedron) {
    const std::size_t n_held = held_.size();
    for (int c = 4 * tetrahedron; c < 4 * tetrahedron + 4; ++c) {
        const SiteId site = tetrahedra_.corner(c).site;
        if (!corner_at_.insert({site, c}).second) continue;
        held_.push_back({site, coordinates_.col(site)});
        coordinates_.col(site) = valid_.col(site);
    }
    return held_.size() > n_held;
}

bool TetrahedraUntangling::hold_inverted_stars(std::size_t most_held) {
    // The loop visits sites that it appends to held_.
    for (std::size_t k = 0; k < held_.size() && held_.size() <= most_held; ++k) {
        checkpoint();
        for (const int c : star_of_corner(tetrahedra_, corner_at_.at(held_[k].site))) {
            if (!is_positive(tetrahedra_, coordinates_, c / 4) && !hold(c / 4)) return false;
        }
    }
    return held_.size() <= most_held;
}

void TetrahedraUntangling::append_facets(const std::vector<int>& star, std::vector<int>& facets) {
    for (const int c : star) {
        for (int f = c - c % 4; f < c - c % 4 + 4; ++f) facets.push_back(f);
    }
}

bool TetrahedraUntangling::all_positive(const std::vector<int>& star) const {
    return std::all_of(star.begin(), star.end(),
                       [this](int c) { return is_positive(tetrahedra_, coordinates_, c / 4); });
}

bool TetrahedraUntangling::advance(const Held& held) {
    const Vec3 from = coordinates_.col(held.site);
    const Vec3 remaining = held.target - from;
    const std::vector<int> star = star_of_corner(tetrahedra_, corner_at_.at(held.site));
    double part = 1;
    for (int halving = 0; halving < kHalvings; ++halving, part /= 2) {
        // Both ends are multiples of 2^-50, and intermediate positions must be as well.
        coordinates_.col(held.site) = from + snapped_displacement(part * remaining);
        if (!all_positive(star)) continue;
        std::vector<int> facets;
        append_facets(star, facets);
        flips_.flip(facets);
        return part == 1;
    }
    coordinates_.col(held.site) = from;
    return false;
}

void TetrahedraUntangling::give_up() {
    for (const Held& held : held_) coordinates_.col(held.site) = held.target;
}

bool TetrahedraUntangling::run(const std::vector<int>& inverted, std::vector<int> facets,
                               std::size_t most_held) {
    // Move the sites of inverted tetrahedra back to their valid positions.
    for (const int t : inverted) hold(t);
    if (!hold_inverted_stars(most_held)) {
        give_up();
        return false;
    }
    // Restore the Delaunay property there.
    for (const Held& held : held_) {
        append_facets(star_of_corner(tetrahedra_, corner_at_.at(held.site)), facets);
    }
    flips_.flip(facets);
    // Advance the sites one by one.
    for (int round = 0; round < kRounds && !held_.empty(); ++round) {
        std::erase_if(held_, [this](const Held& held) { return advance(held); });
    }
    const bool arrived = held_.empty();
    give_up();
    return arrived && flips_.n_stuck() == 0;
}

}  // namespace pcvt::space
