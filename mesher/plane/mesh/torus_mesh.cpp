#include "mesher/plane/mesh/torus_mesh.hpp"

#include <algorithm>
#include <utility>

#include "mesher/plane/geometry/domain.hpp"
#include "mesher/plane/mesh/area_fit.hpp"
#include "mesher/plane/mesh/box_origin.hpp"
#include "mesher/plane/mesh/box_outline.hpp"
#include "mesher/plane/mesh/interface_proof.hpp"
#include "mesher/plane/mesh/short_edges.hpp"
#include "mesher/plane/mesh/valence.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/mesh/walled_mesh.hpp"

namespace pcvt::plane {
namespace {

/// Makes the meshes of one set of options; each function takes a domain_mesh().
class TorusMesher {
   public:
    TorusMesher(const PeriodicDelaunay& delaunay, const TileOptions& options)
        : options_(options),
          h_(delaunay.sites().spacing()),
          weights_(delaunay.weights()),
          has_grains_(options.kind == MeshKind::kGrains) {}

    TorusMesh triangles(PeriodicMesh domain) const {
        const bool has_images = options_.walled && weights_.size() > 0;
        const Eigen::Index n = has_images ? options_.walled->n_sites : weights_.size();
        return {copies(std::move(domain)), options_.origin, weights_.head(n)};
    }

    TorusMesh cells(PeriodicMesh domain) const {
        PeriodicMesh mesh = without_shortest(copies(std::move(domain)));
        const Vec2 corner = domain_corner(mesh);
        return cut({std::move(mesh), corner}, corner);
    }

    /// Power cells, which keep their areas without their short edges, and at the sides of a box.
    TorusMesh power_cells(const PeriodicMesh& domain) const {
        PeriodicMesh joined = without_shortest(domain);
        const Vec2 corner = domain_corner(copies(joined));
        const Metric metric = options_.elongation ? options_.elongation->metric : Metric();
        FittedCells fitted = options_.outline == Outline::kWhole
                                 ? fit_areas(domain, std::move(joined), metric, weights_)
                                 : fit_areas_in_box(domain, joined, metric, weights_,
                                                    {options_.repeat.columns, options_.repeat.rows,
                                                     corner, snap_distance()});
        TorusMesh torus{copies(std::move(fitted.cells)), corner, std::move(fitted.weights),
                        fitted.largest_relative_error};
        return fitted.cut ? in_pieces(std::move(torus), std::move(*fitted.cut))
                          : cut(std::move(torus), corner);
    }

    /// The cells between walls with their images, halved where their sites lie on walls.
    TorusMesh cells_between_walls(PeriodicMesh domain) const {
        const WalledDomain& walled = *options_.walled;
        PeriodicMesh joined = domain;
        if (has_grains_) joined.whole_sides = cell_sides(joined);
        if (const double shortest = shortest_edge(); shortest > 0) {
            joined = without_short_edges(joined, shortest, walled, still_vertices(joined));
        }
        joined = mirrored_mesh(std::move(joined), walled);
        TorusMesh torus{.mesh = std::move(joined), .corner = options_.origin};
        if (weights_.size() > 0) {
            domain = mirrored_mesh(std::move(domain), walled);
            FittedCells fitted = fit_between_walls(domain, std::move(torus.mesh));
            torus.area_error = fitted.largest_relative_error;
            torus.mesh = std::move(fitted.cells);
            torus.weights = std::move(fitted.weights);
        }
        torus.mesh = copies(std::move(torus.mesh));
        if (!cuts_between_walls()) return torus;
        return cut(std::move(torus), corner_between_walls());
    }

   private:
    PeriodicMesh copies(PeriodicMesh domain) const {
        return repeated(std::move(domain), options_.repeat.columns, options_.repeat.rows);
    }

    /// The length below which edges are removed, length units; 0: none.
    double shortest_edge() const {
        return h_ * (has_grains_ ? std::max(kShortGrainEdge, options_.short_edges)
                                 : options_.short_edges);
    }

    /// How far the outline moves vertices, length units.
    double snap_distance() const { return has_grains_ ? kGrainSnap * h_ : 0; }

    /// The vertices on interfaces, which stay where they are; empty without tags.
    std::vector<bool> still_vertices(const PeriodicMesh& mesh) const {
        if (options_.site_tags.empty()) return {};
        std::vector<int> tags;
        for (const SiteId s : mesh.site) tags.push_back(options_.site_tags[s]);
        return interface_vertices(mesh, tags);
    }

    PeriodicMesh without_shortest(PeriodicMesh mesh) const {
        const double shortest = shortest_edge();
        if (!(shortest > 0)) return mesh;
        // Cells of grains keep the number of sides that they had before.
        if (has_grains_) mesh.whole_sides = cell_sides(mesh);
        return without_short_edges(mesh, shortest, still_vertices(mesh));
    }

    /// @param mesh  without short edges.
    Vec2 domain_corner(const PeriodicMesh& mesh) const {
        const bool finds = options_.outline == Outline::kBox && options_.finds_origin;
        return finds ? find_box_origin(mesh) : options_.origin;
    }

    BoxCut box_cut(const PeriodicMesh& mesh, const Vec2& corner) const {
        return cut_along_box(mesh, corner, snap_distance(), {.still = still_vertices(mesh)});
    }

    TorusMesh in_pieces(TorusMesh torus, BoxCut box) const {
        torus.box_shortest_edge = box.shortest_edge / h_;
        torus.mesh = std::move(box.pieces);
        return torus;
    }

    TorusMesh cut(TorusMesh torus, const Vec2& corner) const {
        if (options_.outline == Outline::kWhole) return torus;
        BoxCut box = box_cut(torus.mesh, corner);
        return in_pieces(std::move(torus), std::move(box));
    }

    /// The box outline cuts the torus along the periodic direction only: across walls it runs
    /// through the middle of the mirror images.
    bool cuts_between_walls() const {
        return options_.outline == Outline::kBox && options_.walled->walls != Walls::kXY;
    }
    Vec2 corner_between_walls() const {
        const WalledDomain domain =
            options_.walled->repeated(options_.repeat.columns, options_.repeat.rows);
        Vec2 corner = options_.origin;
        const int axis = domain.walls == Walls::kX ? 0 : 1;
        corner[axis] = -side_length(domain.lattice, axis) / 2;
        return corner;
    }

    /// Gives power cells between walls back the areas that they had before their corners were
    /// moved.
    /// @param cells, joined  with their mirror images.
    FittedCells fit_between_walls(const PeriodicMesh& cells, PeriodicMesh joined) const {
        const int n = options_.walled->n_sites;
        const int n_copies = options_.repeat.columns * options_.repeat.rows;
        const WalledDomain domain =
            options_.walled->repeated(options_.repeat.columns, options_.repeat.rows);
        const AreaMeasure measure = [&](const PeriodicMesh& mesh) -> Eigen::VectorXd {
            if (!cuts_between_walls()) return areas_by_site(mesh, n);
            const PeriodicMesh pieces = box_cut(copies(mesh), corner_between_walls()).pieces;
            const auto places = places_between_walls(pieces, domain);
            const PeriodicMesh between = mesh_between_walls(pieces, places, domain);
            return areas_by_site(between, n) * domain.n_images() / n_copies;
        };
        return fit_areas(cells, std::move(joined), Metric(), weights_.head(n), measure);
    }

    const TileOptions& options_;
    double h_;
    const Eigen::VectorXd& weights_;
    bool has_grains_;
};

/// Sets the corners of the domain.
TorusMesh with_corners(TorusMesh torus, const TileOptions& options) {
    if (options.walled) {
        const WalledDomain domain =
            options.walled->repeated(options.repeat.columns, options.repeat.rows);
        torus.corner = options.origin;
        torus.opposite_corner = options.origin + domain.lattice.a() + domain.lattice.b();
    } else if (torus.is_cut()) {
        torus.opposite_corner = torus.corner + torus.mesh.lattice.a() + torus.mesh.lattice.b();
    } else {
        const Domain domain(torus.mesh.lattice, options.origin);
        torus.corner = domain.corner();
        torus.opposite_corner = domain.opposite_corner();
    }
    return torus;
}

}  // namespace

PeriodicMesh domain_mesh(const PeriodicDelaunay& delaunay, const TileOptions& options) {
    const bool are_triangles = options.kind == MeshKind::kDelaunay;
    PeriodicMesh domain = are_triangles ? triangle_mesh(delaunay) : cell_mesh(delaunay);
    if (options.walled && !are_triangles) {
        return part_between_walls(std::move(domain), *options.walled);
    }
    const auto& elongation = options.elongation;
    if (!elongation) return domain;
    return from_round(std::move(domain), elongation->metric, elongation->lattice);
}

TorusMesh torus_mesh(PeriodicMesh domain, const PeriodicDelaunay& delaunay,
                     const TileOptions& options) {
    const TorusMesher mesher(delaunay, options);
    if (options.kind == MeshKind::kDelaunay) {
        return with_corners(mesher.triangles(std::move(domain)), options);
    }
    if (options.walled) {
        return with_corners(mesher.cells_between_walls(std::move(domain)), options);
    }
    return with_corners(delaunay.weights().size() > 0 ? mesher.power_cells(domain)
                                                      : mesher.cells(std::move(domain)),
                        options);
}

}  // namespace pcvt::plane
