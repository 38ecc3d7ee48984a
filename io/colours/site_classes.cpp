#include "io/colours/site_classes.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "mesher/base/cancellable_sort.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/tile/tile_edges.hpp"

namespace pcvt {
namespace {

/// Pairs of neighbouring sites in both directions, sorted, each pair once.
using Neighbours = std::vector<std::pair<SiteId, SiteId>>;

void finish(Neighbours& pairs) {
    const std::size_t n = pairs.size();
    for (std::size_t k = 0; k < n; ++k) pairs.emplace_back(pairs[k].second, pairs[k].first);
    cancellable_sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    std::erase_if(pairs, [](const auto& pair) { return pair.first == pair.second; });
}

/// The groups of sites, which the graph joins to one node each.
class SiteGroups {
   public:
    explicit SiteGroups(std::span<const int> site_group) : site_group_(site_group) {}

    int operator[](SiteId site) const {
        return site_group_.empty()
                   ? site
                   : site_group_[static_cast<std::size_t>(site) % site_group_.size()];
    }

   private:
    std::span<const int> site_group_;
};

/// Returns the groups of sites whose faces share an edge, inside the tile or across its seam; for
/// Delaunay triangles, those of the sites at the ends of an edge.
Neighbours neighbours(const plane::Tile& tile, const SiteGroups& group) {
    const bool owned = faces_have_sites(tile.kind);
    Neighbours pairs;
    for (const plane::TileEdge& edge : tile_edges(tile)) {
        if (owned && edge.right < 0) continue;
        if (owned) {
            pairs.emplace_back(group[tile.face_site[edge.left]], group[tile.face_site[edge.right]]);
        } else {
            pairs.emplace_back(group[tile.vertex_site[edge.v]], group[tile.vertex_site[edge.w]]);
        }
    }
    finish(pairs);
    return pairs;
}

/// The graph of the sites, with the range of the neighbours of each site.
class SiteGraph {
   public:
    SiteGraph(Neighbours pairs, SiteId n_sites)
        : pairs_(std::move(pairs)), begin_(static_cast<std::size_t>(n_sites) + 1, 0) {
        for (const auto& [site, other] : pairs_) ++begin_[site + 1];
        for (SiteId s = 0; s < n_sites; ++s) begin_[s + 1] += begin_[s];
    }
    SiteId n_sites() const { return static_cast<SiteId>(begin_.size()) - 1; }
    int degree(SiteId site) const { return begin_[site + 1] - begin_[site]; }
    template <class Visit>
    void for_each_neighbour(SiteId site, const Visit& visit) const {
        for (int k = begin_[site]; k < begin_[site + 1]; ++k) visit(pairs_[k].second);
    }

   private:
    Neighbours pairs_;
    std::vector<int> begin_;
};

/// Returns the sites so that each one has at most six neighbours among the sites before it: the
/// site with the fewest remaining neighbours is removed again and again, and becomes the last one.
std::vector<SiteId> smallest_last_order(const SiteGraph& graph) {
    std::vector<int> degree(static_cast<std::size_t>(graph.n_sites()));
    std::vector<std::vector<SiteId>> by_degree;
    const auto enter = [&](SiteId site) {
        if (std::size_t(degree[site]) >= by_degree.size()) by_degree.resize(degree[site] + 1);
        by_degree[degree[site]].push_back(site);
    };
    for (SiteId s = graph.n_sites() - 1; s >= 0; --s) {
        checkpoint_each(s);
        degree[s] = graph.degree(s);
        enter(s);
    }
    std::vector<SiteId> order;
    for (std::size_t d = 0; d < by_degree.size();) {
        if (by_degree[d].empty()) {
            ++d;
            continue;
        }
        const SiteId site = by_degree[d].back();
        by_degree[d].pop_back();
        // The entry is old if the site has lost neighbours since, or was removed.
        if (degree[site] != static_cast<int>(d)) continue;
        degree[site] = -1;
        order.push_back(site);
        graph.for_each_neighbour(site, [&](SiteId other) {
            if (degree[other] <= 0) return;
            --degree[other];
            enter(other);
        });
        d = d > 0 ? d - 1 : 0;
    }
    std::reverse(order.begin(), order.end());
    return order;
}

/// Returns the class of each site: of the classes that no neighbour has, the one with the fewest
/// sites; of all classes, where the neighbours have them all.
std::vector<int> classes(const SiteGraph& graph) {
    constexpr int kNone = -1;
    std::vector<int> class_of(static_cast<std::size_t>(graph.n_sites()), kNone);
    std::array<int, kSiteClasses> n_sites{};
    for (const SiteId site : smallest_last_order(graph)) {
        checkpoint();
        std::array<bool, kSiteClasses> taken{};
        graph.for_each_neighbour(site, [&](SiteId other) {
            if (class_of[other] != kNone) taken[class_of[other]] = true;
        });
        // Diagonals of cocircular sites, which break a symmetry, may add neighbours to an orbit.
        if (std::all_of(taken.begin(), taken.end(), [](bool is) { return is; })) taken.fill(false);
        int best = kNone;
        for (int k = 0; k < kSiteClasses; ++k) {
            if (!taken[k] && (best == kNone || n_sites[k] < n_sites[best])) best = k;
        }
        class_of[site] = best;
        ++n_sites[best];
    }
    return class_of;
}

}  // namespace

std::vector<int> site_classes(const plane::Tile& tile, std::span<const int> site_group) {
    const std::vector<SiteId>& sites =
        faces_have_sites(tile.kind) ? tile.face_site : tile.vertex_site;
    if (sites.empty()) return {};
    const SiteGroups group(site_group);
    SiteId n_groups = 0;
    for (const SiteId site : sites) n_groups = std::max(n_groups, group[site] + 1);
    const std::vector<int> class_of_group = classes(SiteGraph(neighbours(tile, group), n_groups));
    std::vector<int> result;
    result.reserve(sites.size());
    for (const SiteId site : sites) result.push_back(class_of_group[group[site]]);
    return result;
}

std::vector<int> classes_of_neighbours(std::vector<std::pair<SiteId, SiteId>> pairs, SiteId n) {
    finish(pairs);
    return classes(SiteGraph(std::move(pairs), n));
}

}  // namespace pcvt
