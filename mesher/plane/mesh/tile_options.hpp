#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mesher/plane/geometry/walled_domain.hpp"
#include "mesher/plane/mesh/elongated_mesh.hpp"
#include "mesher/plane/mesh/outline.hpp"
#include "mesher/torus/repetition.hpp"

namespace pcvt::plane {

/// The sites whose cells are left out of a tile.
struct HoleSites {
    /// The names of the walls; several holes may share one.
    std::vector<std::string> names = {};
    /// For each site the number of its name, or -1 for the sites that stay.
    std::vector<int> of_site = {};

    bool empty() const { return names.empty(); }
    /// The sites that stay, by rising id. Site kept()[s] becomes site s of the tile.
    std::vector<SiteId> kept() const {
        std::vector<SiteId> sites;
        for (std::size_t s = 0; s < of_site.size(); ++s) {
            if (of_site[s] < 0) sites.push_back(static_cast<SiteId>(s));
        }
        return sites;
    }
};

/// How a tile is made from a tessellation; h = sqrt(area / number of sites).
struct TileOptions {
    MeshKind kind = MeshKind::kVoronoi;
    /// Delaunay triangles have no box outline.
    Outline outline = Outline::kWhole;
    /// Voronoi edges shorter than this are removed from cells and grains, units of h; 0: none, but
    /// for the shortest ones of grains (mesher/plane/grains/grains.hpp).
    double short_edges = 0;
    /// Edges of grains, length units; 0: h / 3.
    double grain_size = 0;
    /// The number of parts of each edge of the cells; excludes grain_size. 0: none.
    int grain_per_edge = 0;
    /// The order of the triangles of grains, as Tile::order.
    int order = 1;
    /// The tile covers these copies of the domain and is a tile of their lattice.
    Repetition repeat = {};
    /// Corner of the domain, length units.
    Vec2 origin = Vec2::Zero();
    /// Moves the box outline to where its shortest edge is longest, instead of to `origin`.
    bool finds_origin = false;
    /// Maps cells that were computed in the round space of a metric back to the plane.
    std::optional<Elongation> elongation = {};
    /// The tessellation consists of a domain between walls and its mirror images; the tile is that
    /// of the domain. Excludes elongation, finds_origin, copies across walls, and an origin off the
    /// walls.
    std::optional<WalledDomain> walled = {};
    /// A tag for each site, for cells beside interfaces. Edges with an end where cells of different
    /// tags meet are not removed. Empty: all cells are alike. Excludes weights and walls.
    std::span<const int> site_tags = {};
    /// The sites whose cells are left out. Excludes weights.
    HoleSites holes = {};
    /// Called now and then with the share that is done, about, from 0 to 1; an exception that it
    /// throws ends the building.
    std::function<void(double)> progress = {};
};

}  // namespace pcvt::plane
