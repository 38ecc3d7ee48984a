#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "mesher/cells/cell_table.hpp"
#include "mesher/cvt/centroid_figures.hpp"
#include "mesher/plane/cvt/area_newton.hpp"
#include "mesher/plane/cvt/cvt.hpp"
#include "mesher/plane/energy/stability.hpp"
#include "mesher/plane/geometry/walled_domain.hpp"
#include "mesher/plane/interfaces/inclusion.hpp"
#include "mesher/plane/mesh/elongated_mesh.hpp"
#include "mesher/plane/tile/build_tile.hpp"
#include "mesher/plane/tile/tile_holes.hpp"

namespace pcvt::plane {

/// Numbers of cells round inclusions.
struct InterfaceFigures {
    std::vector<Inclusion> shapes = {};
    /// Shapes left out because they were listed as images of the others.
    int n_images = 0;
    /// Shapes inside of others.
    int n_nested = 0;
    int n_chords = 0;
    /// Sites in pairs beside the chords, which do not move.
    int n_fixed = 0;
    /// Sites that ended at a circle round the end of a chord, where they would have moved on.
    int n_held = 0;
};

/// The cells of a tessellation and their table, once they are made.
struct CellCache {
    std::mutex mutex;
    std::optional<PeriodicMesh> cells;
    std::optional<CellTable> table;
};

/// A tessellation and the run that computed it: Voronoi cells, or power cells of prescribed areas,
/// in the plane or in a metric, on the torus or between walls. tessellate() computes it. Meshes and
/// positions that follow from it lie in the plane of the user.
///
/// Example usage:
///     const Tessellation cells = tessellate(lattice, {.walls = Walls::kY}, points, options);
///     const double area = cells.table().measure[0];
///     const BuiltTile tile = build_tile(cells, {.kind = MeshKind::kGrains});
struct Tessellation {
    /// In the round space of `elongation`, if there is one. With weights in a run with areas.
    PeriodicDelaunay delaunay;
    /// The metric of elongated cells.
    std::optional<Elongation> elongation = {};
    /// The part between walls, if there are some: `delaunay` then has the mirror images too.
    std::optional<WalledDomain> walled = {};
    /// Energy and residuals are those of the round space; with walls, of the domain.
    RunStatistics run;
    DelaunayCounts counts;
    /// Figures of a run with a density.
    std::optional<DensityFigures> density = {};
    /// Figures of a run with prescribed areas.
    std::optional<SizeFigures> areas = {};
    /// Figures of a run with prescribed centroids.
    std::optional<CentroidFigures> centroids = {};

    /// With a symmetry: the orbit of each site. Orbits are counted from 0 in the order of their
    /// first sites.
    std::vector<int> site_orbits = {};
    /// Round inclusions: the tag of each site, 0 for the matrix, and for each tag its word and the
    /// area of its shapes, length^2.
    std::vector<int> site_tags = {};
    std::vector<std::string> tag_names = {};
    std::vector<double> tag_areas = {};
    std::optional<InterfaceFigures> interfaces = {};
    /// The sites whose cells are left out.
    HoleSites holes = {};
    /// See mesh() and table().
    std::unique_ptr<CellCache> cache = std::make_unique<CellCache>();

    /// The periods of the user.
    const Lattice& lattice() const {
        if (walled) return walled->lattice;
        return elongation ? elongation->lattice : delaunay.sites().lattice();
    }
    int n_sites() const { return walled ? walled->n_sites : delaunay.sites().n_sites(); }
    /// The number of orbits of sites; 0 without a symmetry.
    int n_orbits() const {
        return site_orbits.empty() ? 0
                                   : *std::max_element(site_orbits.begin(), site_orbits.end()) + 1;
    }

    /// The cells or triangles of all sites, with walls the part between them. The first call after
    /// table() takes the cells from which the table was made. Any number of threads may call this.
    PeriodicMesh mesh(MeshKind kind) const;
    /// Measures of the cells of all sites, made by the first call. Any number of threads may call
    /// this.
    const CellTable& table() const;
    /// Frees the cells from which the table was made, if mesh() has not taken them.
    void drop_cells() const;
};

/// mesh() without the faces in holes, whose sites are numbered as in wrapped_sites().
PeriodicMesh mesh_outside_holes(const Tessellation& tessellation, MeshKind kind);

/// table() without the cells in holes, which do not count as neighbours either.
CellTable table_outside_holes(const Tessellation& tessellation);

/// Builds a tile, as build_tile() does from a triangulation, with the elongation, the walls, the
/// tags and the holes of the tessellation in place of those of the options.
BuiltTile build_tile(const Tessellation& tessellation, TileOptions options);

/// The number of sides of each site's cell, of those longer than kShortEdge h in the plane.
std::vector<int> cell_sides(const Tessellation& tessellation);
/// The numbers of cells by their number of sides.
std::map<int, int> side_counts(const Tessellation& tessellation);

/// The weights of the sites, length^2; empty without areas.
Eigen::VectorXd site_weights(const Tessellation& tessellation);

/// The sites outside of holes, 2 x n, wrapped into the Domain at `origin`, as in `.txt` files.
Points wrapped_sites(const Tessellation& tessellation, const Vec2& origin);

/// Moves points into the Domain at `origin`, but not across walls.
Points wrapped_points(Points points, const Lattice& lattice, const Vec2& origin, Walls walls);

/// The energy of as many regular hexagons (hexagonal_bound()) in the area of the domain. Cells
/// of sites on walls count only with their parts between the walls.
double energy_bound(const Tessellation& tessellation);

/// Whether the sites are at a minimum of the energy, according to its Hessian; `nullopt` if the run
/// did not converge, has a density or areas, or has more than kMostSitesForStability sites. Cost:
/// of order n^1.5.
std::optional<Minimum> minimum_of(const Tessellation& tessellation);

}  // namespace pcvt::plane
