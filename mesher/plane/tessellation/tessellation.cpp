#include "mesher/plane/tessellation/tessellation.hpp"

#include <utility>

#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/cvt/wall_rounds.hpp"
#include "mesher/plane/geometry/domain.hpp"
#include "mesher/plane/mesh/cell_measures.hpp"
#include "mesher/plane/mesh/torus_mesh.hpp"
#include "mesher/plane/mesh/valence.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/mesh/walled_mesh.hpp"

namespace pcvt::plane {
namespace {

PeriodicMesh new_mesh(const Tessellation& tessellation, MeshKind kind) {
    const auto& walled = tessellation.walled;
    PeriodicMesh mesh =
        domain_mesh(tessellation.delaunay,
                    {.kind = kind, .elongation = tessellation.elongation, .walled = walled});
    if (walled && kind == MeshKind::kDelaunay) return part_between_walls(std::move(mesh), *walled);
    return mesh;
}

/// The positions of all sites, those inside holes among them.
Points plane_sites(const Tessellation& tessellation) {
    if (const auto& walled = tessellation.walled) {
        return points_between_walls(tessellation.delaunay, *walled);
    }
    const Sites& sites = tessellation.delaunay.sites();
    const Metric metric = tessellation.elongation ? tessellation.elongation->metric : Metric();
    Points points(2, sites.n_sites());
    for (SiteId s = 0; s < sites.n_sites(); ++s) {
        checkpoint_each(s);
        points.col(s) = metric.from_round(sites.position(s));
    }
    return points;
}

}  // namespace

PeriodicMesh Tessellation::mesh(MeshKind kind) const {
    if (kind == MeshKind::kVoronoi) {
        const std::lock_guard lock(cache->mutex);
        if (auto cells = std::exchange(cache->cells, std::nullopt)) return std::move(*cells);
    }
    return new_mesh(*this, kind);
}

const CellTable& Tessellation::table() const {
    const std::lock_guard lock(cache->mutex);
    if (!cache->table) {
        if (!cache->cells) cache->cells = new_mesh(*this, MeshKind::kVoronoi);
        cache->table = cell_table(*cache->cells);
    }
    return *cache->table;
}

void Tessellation::drop_cells() const {
    const std::lock_guard lock(cache->mutex);
    cache->cells.reset();
}

PeriodicMesh mesh_outside_holes(const Tessellation& tessellation, MeshKind kind) {
    return with_holes(tessellation.mesh(kind), tessellation.holes);
}

CellTable table_outside_holes(const Tessellation& tessellation) {
    const CellTable& all = tessellation.table();
    if (tessellation.holes.empty()) return all;
    const std::vector<SiteId> kept = tessellation.holes.kept();
    std::vector<SiteId> number(tessellation.holes.of_site.size(), -1);
    for (std::size_t k = 0; k < kept.size(); ++k) number[kept[k]] = static_cast<SiteId>(k);
    CellTable table;
    for (const SiteId s : kept) {
        table.measure.push_back(all.measure[s]);
        table.surface.push_back(all.surface[s]);
        table.sides.push_back(all.sides[s]);
        for (int k = all.neighbour_begin[s]; k < all.neighbour_begin[s + 1]; ++k) {
            const SiteId neighbour = number[all.neighbours[k]];
            if (neighbour >= 0) table.neighbours.push_back(neighbour);
        }
        table.neighbour_begin.push_back(static_cast<int>(table.neighbours.size()));
    }
    return table;
}

BuiltTile build_tile(const Tessellation& tessellation, TileOptions options) {
    options.elongation = tessellation.elongation;
    options.walled = tessellation.walled;
    options.site_tags = tessellation.site_tags;
    options.holes = tessellation.holes;
    if (options.kind == MeshKind::kDelaunay) return build_tile(tessellation.delaunay, options);
    return build_tile(tessellation.mesh(MeshKind::kVoronoi), tessellation.delaunay, options);
}

std::vector<int> cell_sides(const Tessellation& tessellation) {
    const bool is_plain = !tessellation.elongation && !tessellation.walled;
    return is_plain ? cell_sides(tessellation.delaunay) : tessellation.table().sides;
}

std::map<int, int> side_counts(const Tessellation& tessellation) {
    return histogram(cell_sides(tessellation));
}

Eigen::VectorXd site_weights(const Tessellation& tessellation) {
    const Eigen::VectorXd& weights = tessellation.delaunay.weights();
    if (weights.size() == 0) return weights;
    return weights.head(tessellation.n_sites());
}

Points wrapped_sites(const Tessellation& tessellation, const Vec2& origin) {
    const Walls walls = tessellation.walled ? tessellation.walled->walls : Walls::kNone;
    Points points =
        wrapped_points(plane_sites(tessellation), tessellation.lattice(), origin, walls);
    if (tessellation.holes.empty()) return points;
    const std::vector<SiteId> kept = tessellation.holes.kept();
    return points(Eigen::all, kept);
}

Points wrapped_points(Points points, const Lattice& lattice, const Vec2& origin, Walls walls) {
    const Domain domain(lattice, origin);
    for (Eigen::Index s = 0; s < points.cols(); ++s) {
        checkpoint_each(s);
        Offset into = domain.offset_into(points.col(s));
        if (has_walls_across(walls, 0)) into.i = 0;
        if (has_walls_across(walls, 1)) into.j = 0;
        points.col(s) += lattice.translation(into);
    }
    return points;
}

double energy_bound(const Tessellation& tessellation) {
    const Sites& sites = tessellation.delaunay.sites();
    if (!tessellation.walled) {
        return hexagonal_bound(tessellation.lattice().area(), sites.n_sites());
    }
    return hexagonal_bound(sites.lattice().area(), sites.n_sites()) /
           tessellation.walled->n_images();
}

std::optional<Minimum> minimum_of(const Tessellation& tessellation) {
    const Sites& sites = tessellation.delaunay.sites();
    const bool few = sites.n_sites() <= kMostSitesForStability;
    const bool uniform = !tessellation.density && !tessellation.areas && !tessellation.walled;
    if (tessellation.run.stop != Stop::kConverged || !uniform || !few) return {};
    return stability(sites);
}

}  // namespace pcvt::plane
