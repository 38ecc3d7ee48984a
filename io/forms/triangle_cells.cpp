#include "io/forms/triangle_cells.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include "io/forms/triangle_elements.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

/// A position is a sum of a few rounded vectors; two images of a site differ by a period vector.
constexpr double kUlps = 64;

std::vector<plane::Vec2> positions_of_sites(const plane::Tile& tile,
                                            const std::vector<SiteId>& sites) {
    if (!tile.grain_site_points.empty()) return tile.grain_site_points;
    std::vector<plane::Vec2> positions(sites.size(), plane::Vec2::Zero());
    if (tile.vertex_site.empty()) return positions;
    for (int f = 0; f < tile.n_faces(); ++f) positions[f] = tile.points[owner_corner(tile, f)];
    return positions;
}

double largest_coordinate(const plane::Tile& tile, const std::vector<plane::Vec2>& more) {
    double largest = 0;
    for (const std::vector<plane::Vec2>* points : {&tile.points, &more}) {
        for (const plane::Vec2& p : *points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
    }
    return largest;
}

/// The first cells that are known to meet at a node.
struct Contacts {
    static constexpr int kMost = 3;
    int n = 0;
    std::array<SiteId, kMost> site{};
    std::array<plane::Vec2, kMost> place{};
};

}  // namespace

TriangleCells::TriangleCells(const plane::Tile& tile)
    : sites_(element_cells(tile)), site_points_(positions_of_sites(tile, sites_)) {
    rounding_ =
        kUlps * std::numeric_limits<double>::epsilon() * largest_coordinate(tile, site_points_);
}

CellContacts cell_contacts(const plane::Tile& tile, const SolverNodes& nodes,
                           const TriangleCells& cells) {
    // The representative of each node, and the translation from there to the node.
    std::vector<int> representative(nodes.points.size());
    std::iota(representative.begin(), representative.end(), 0);
    std::vector<plane::Vec2> translation(nodes.points.size(), plane::Vec2::Zero());
    for (const plane::VertexPair& pair : nodes.pairs) {
        representative[pair.w] = pair.v;
        translation[pair.w] = tile.lattice.translation(pair.offset);
    }
    // The cells at each representative, as its frame has them.
    std::vector<Contacts> contacts(nodes.points.size());
    for (int f = 0; f < tile.n_faces(); ++f) {
        checkpoint_each(f);
        for (const int v : element_nodes(tile, nodes, f)) {
            Contacts& at = contacts[representative[v]];
            const plane::Vec2 place = cells.site_point(f) - translation[v];
            int k = 0;
            while (k < at.n &&
                   !(at.site[k] == cells.site(f) && cells.same_place(at.place[k], place)))
                ++k;
            if (k < at.n || at.n == Contacts::kMost) continue;
            at.site[k] = cells.site(f);
            at.place[k] = place;
            ++at.n;
        }
    }
    CellContacts found;
    for (int v = 0; v < nodes.n_nodes(); ++v) {
        const int n = contacts[representative[v]].n;
        if (n >= 2) found.of_two_cells.push_back(v);
        if (n >= 3) found.of_three_cells.push_back(v);
    }
    return found;
}

}  // namespace pcvt
