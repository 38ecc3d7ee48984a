#include "mesher/plane/delaunay/untangling.hpp"

#include <algorithm>

namespace pcvt::plane {
namespace {

constexpr int kRounds = 20;
/// A site tries its whole remaining move, then half of it, and so on.
constexpr int kHalvings = 5;

}  // namespace

void Untangling::after_flip(int h) {
    for (const int side : {h, triangulation_.opposite(h)}) {
        for (const int g :
             {side, TorusTriangulation::next(side), TorusTriangulation::previous(side)}) {
            const auto held = leaving_.find(triangulation_.corner(g).site);
            if (held != leaving_.end()) held->second = g;
        }
    }
}

bool Untangling::hold(int triangle) {
    const std::size_t n_held = held_.size();
    for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        const SiteId site = triangulation_.corner(h).site;
        if (!leaving_.insert({site, h}).second) continue;
        held_.push_back({site, coordinates_.col(site)});
        coordinates_.col(site) -= moves_.of(site);
    }
    return held_.size() > n_held;
}

bool Untangling::hold_inverted_stars(std::size_t most_held) {
    // The loop visits sites that it appends to held_.
    for (std::size_t k = 0; k < held_.size() && held_.size() <= most_held; ++k) {
        const int first = leaving_.at(held_[k].site);
        int h = first;
        do {
            if (!flips_.is_counter_clockwise(h / 3) && !hold(h / 3)) return false;
            h = triangulation_.next_round_site(h);
        } while (h != first);
    }
    return held_.size() <= most_held;
}

bool Untangling::star_is_counter_clockwise(int first) const {
    int h = first;
    do {
        if (!flips_.is_counter_clockwise(h / 3)) return false;
        h = triangulation_.next_round_site(h);
    } while (h != first);
    return true;
}

std::vector<int> Untangling::edges_round(SiteId site) const {
    std::vector<int> edges;
    const int first = leaving_.at(site);
    int h = first;
    do {
        edges.push_back(h);
        edges.push_back(TorusTriangulation::next(h));
        h = triangulation_.next_round_site(h);
    } while (h != first);
    return edges;
}

bool Untangling::advance(const Held& held) {
    const Vec2 from = coordinates_.col(held.site);
    const Vec2 remaining = held.target - from;
    double part = 1;
    for (int halving = 0; halving < kHalvings; ++halving, part /= 2) {
        // Both ends are multiples of 2^-51, and intermediate positions must be as well.
        coordinates_.col(held.site) = from + snapped_displacement(part * remaining);
        if (!star_is_counter_clockwise(leaving_.at(held.site))) continue;
        std::vector<int> suspects = edges_round(held.site);
        n_flips_ += flips_.flip(suspects, this);
        return part == 1;
    }
    coordinates_.col(held.site) = from;
    return false;
}

void Untangling::give_up() {
    for (const Held& held : held_) coordinates_.col(held.site) = held.target;
}

bool Untangling::run(const std::vector<int>& inverted, std::vector<int> suspects,
                     std::size_t most_held) {
    // Move the sites of inverted triangles back to their old positions.
    for (const int triangle : inverted) hold(triangle);
    if (!hold_inverted_stars(most_held)) {
        give_up();
        return false;
    }

    // Restore the Delaunay property at the old positions.
    for (const Held& held : held_) {
        const std::vector<int> edges = edges_round(held.site);
        suspects.insert(suspects.end(), edges.begin(), edges.end());
    }
    n_flips_ += flips_.flip(suspects, this);
    // Advance the sites one by one.
    for (int round = 0; round < kRounds && !held_.empty(); ++round) {
        std::erase_if(held_, [this](const Held& held) { return advance(held); });
    }
    give_up();
    return held_.empty();
}

}  // namespace pcvt::plane
