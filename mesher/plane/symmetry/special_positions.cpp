#include "mesher/plane/symmetry/special_positions.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <tuple>

#include "mesher/base/error.hpp"

namespace pcvt::plane {
namespace {

using Pair = std::array<int, 2>;

constexpr int kHighestOrder = 6;

int wrapped(int k) { return ((k % kTwelfths) + kTwelfths) % kTwelfths; }

Pair image(const LatticeIsometry& g, const Pair& p) {
    return {wrapped(g.m[0] * p[0] + g.m[1] * p[1] + kTwelfths / 2 * g.halves[0]),
            wrapped(g.m[2] * p[0] + g.m[3] * p[1] + kTwelfths / 2 * g.halves[1])};
}

std::set<Pair> orbit(const PlaneGroup& group, const Pair& p) {
    std::set<Pair> images;
    for (const LatticeIsometry& g : group.operations()) images.insert(image(g, p));
    return images;
}

/// A line modulo the periods: its direction, and n.p in twelfths with n the direction rotated by
/// +90 degrees.
struct LatticeLine {
    Pair along;
    int at;

    friend bool operator<(const LatticeLine& l, const LatticeLine& m) {
        return std::tie(l.along, l.at) < std::tie(m.along, m.at);
    }
};

/// The same direction with a positive first entry that is not 0.
Pair upward(const Pair& along) {
    const bool down = along[0] < 0 || (along[0] == 0 && along[1] < 0);
    return down ? Pair{-along[0], -along[1]} : along;
}

LatticeLine line_through(const Pair& p, const Pair& along) {
    return {along, wrapped(-along[1] * p[0] + along[0] * p[1])};
}

std::vector<RotationCentre> rotation_centres(const PlaneGroup& group) {
    std::vector<RotationCentre> centres;
    std::set<Pair> seen;
    for (int k = 0; k < kTwelfths * kTwelfths; ++k) {
        const Pair p{k / kTwelfths, k % kTwelfths};
        const auto rotations = std::count_if(
            group.operations().begin(), group.operations().end(),
            [&p](const LatticeIsometry& g) { return g.determinant() > 0 && image(g, p) == p; });
        if (rotations == 1 || seen.contains(p)) continue;
        const std::set<Pair> images = orbit(group, p);
        seen.insert(images.begin(), images.end());
        centres.push_back({p, static_cast<int>(rotations), static_cast<int>(images.size())});
    }
    std::stable_sort(centres.begin(), centres.end(), [](const auto& c, const auto& d) {
        return std::tuple(-c.order, c.n_sites) < std::tuple(-d.order, d.n_sites);
    });
    return centres;
}

std::vector<MirrorLine> mirror_lines(const PlaneGroup& group) {
    std::vector<MirrorLine> mirrors;
    std::set<LatticeLine> seen;
    for (const LatticeIsometry& g : group.operations()) {
        if (g.determinant() > 0) continue;
        const Pair along = mirror_direction(g);
        for (int k = 0; k < kTwelfths * kTwelfths; ++k) {
            const Pair p{k / kTwelfths, k % kTwelfths};
            const bool quarters = p[0] % 3 == 0 && p[1] % 3 == 0;
            if (!quarters || image(g, p) != p || seen.contains(line_through(p, along))) continue;
            mirrors.push_back({p, along, group.order() / 2});
            for (const LatticeIsometry& h : group.operations()) {
                const Pair turned = upward(
                    {h.m[0] * along[0] + h.m[1] * along[1], h.m[2] * along[0] + h.m[3] * along[1]});
                seen.insert(line_through(image(h, p), turned));
            }
        }
    }
    return mirrors;
}

/// The subsets of centres in the order in which a plan tries them: those with the fewest centres of
/// the lowest order first, of these with the fewest of the next order, and so on.
std::vector<std::vector<bool>> subsets(const std::vector<RotationCentre>& centres) {
    std::vector<std::vector<bool>> all;
    for (unsigned bits = 0; bits < 1U << centres.size(); ++bits) {
        std::vector<bool> chosen(centres.size());
        for (std::size_t k = 0; k < centres.size(); ++k) chosen[k] = (bits >> k & 1U) != 0;
        all.push_back(std::move(chosen));
    }
    const auto counts = [&centres](const std::vector<bool>& chosen) {
        std::array<int, kHighestOrder + 1> count{};
        for (std::size_t k = 0; k < centres.size(); ++k) count[centres[k].order] += int(chosen[k]);
        return count;
    };
    std::stable_sort(all.begin(), all.end(),
                     [&](const auto& c, const auto& d) { return counts(c) < counts(d); });
    return all;
}

std::optional<OrbitPlan> find_plan(const PlaneGroup& group, const SpecialPositions& special,
                                   int n) {
    const int order = group.order();
    for (const bool with_mirror : {false, true}) {
        if (with_mirror && special.mirrors.empty()) continue;
        for (std::vector<bool>& chosen : subsets(special.centres)) {
            OrbitPlan plan{0, std::vector<int>(special.mirrors.size()), std::move(chosen)};
            if (with_mirror) plan.on_mirrors[0] = 1;
            const int rest = n - n_sites(group, special, plan);
            if (rest < 0 || rest % order != 0) continue;
            plan.n_general = rest / order;
            return plan;
        }
    }
    return std::nullopt;
}

}  // namespace

SpecialPositions special_positions(const PlaneGroup& group) {
    return {rotation_centres(group), mirror_lines(group)};
}

int n_sites(const PlaneGroup& group, const SpecialPositions& special, const OrbitPlan& plan) {
    int n = plan.n_general * group.order();
    for (std::size_t k = 0; k < special.mirrors.size(); ++k) {
        n += plan.on_mirrors[k] * special.mirrors[k].n_sites;
    }
    for (std::size_t k = 0; k < special.centres.size(); ++k) {
        if (plan.at_centres[k]) n += special.centres[k].n_sites;
    }
    return n;
}

OrbitPlan distribute(const PlaneGroup& group, const SpecialPositions& special, int n) {
    if (n < 1) throw InvalidInput("the number of sites must be at least 1");
    if (auto plan = find_plan(group, special, n)) return *plan;
    int below = n - 1;
    while (below > 0 && !find_plan(group, special, below)) --below;
    int above = n + 1;
    while (!find_plan(group, special, above)) ++above;
    throw InvalidInput("no orbits of the symmetry " + std::string(group.row().word) + " sum to " +
                       std::to_string(n) + " sites; take " +
                       (below > 0 ? std::to_string(below) + " or " : "") + std::to_string(above));
}

}  // namespace pcvt::plane
