#include "mesher/plane/tessellation/tessellate.hpp"

#include <algorithm>
#include <utility>

#include "mesher/base/error.hpp"
#include "mesher/plane/cvt/centroid_cells.hpp"
#include "mesher/plane/cvt/interface_cvt.hpp"
#include "mesher/plane/cvt/walled_area_cvt.hpp"
#include "mesher/plane/cvt/walled_cvt.hpp"
#include "mesher/plane/cvt/weighted_cells.hpp"
#include "mesher/plane/interfaces/listed_images.hpp"
#include "mesher/plane/mesh/interface_proof.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/mesh/walled_mesh.hpp"

namespace pcvt::plane {
namespace {

Tessellation tessellation_of(CvtResult cvt, std::optional<WalledDomain> walled = {}) {
    return {.delaunay = std::move(cvt.delaunay),
            .walled = walled,
            .run = cvt.run,
            .counts = cvt.counts,
            .density = cvt.density};
}

Tessellation tessellation_of(AreaCvtResult cvt, std::optional<WalledDomain> walled = {}) {
    return {.delaunay = std::move(cvt.delaunay),
            .walled = walled,
            .run = cvt.run,
            .counts = cvt.counts,
            .areas = cvt.areas};
}

/// Numbers orbits in the order of their first sites.
std::vector<int> counted_by_sites(std::vector<int> site_orbits) {
    std::vector<int> number(site_orbits.size(), -1);
    int n_orbits = 0;
    for (int& orbit : site_orbits) {
        if (number[orbit] < 0) number[orbit] = n_orbits++;
        orbit = number[orbit];
    }
    return site_orbits;
}

/// Sets the words and the areas of the tags of the matrix and of the inclusions.
void set_tags(const std::vector<std::string>& names, const InclusionSet& set, Tessellation& cells) {
    cells.tag_names = names;
    cells.tag_areas.assign(cells.tag_names.size(), 0);
    cells.tag_areas[0] = cells.lattice().area();
    for (int k = 0; k < set.n_given(); ++k) {
        const double area = shape_area(set[k].shape);
        const int parent = set.parent(k);
        cells.tag_areas[set[k].tag] += area;
        cells.tag_areas[parent < 0 ? 0 : set[parent].tag] -= area;
    }
}

/// Refuses shapes in holes: the cells there would belong to no connected part of the tile.
void require_empty_holes(const TaggedInclusions& inclusions, const InclusionSet& set) {
    for (int k = 0; k < set.n_given(); ++k) {
        if (set.parent(k) < 0) continue;
        const Inclusion& around = set[set.parent(k)];
        const std::string& tag = inclusions.tag_names[around.tag];
        const auto& holes = inclusions.holes;
        if (std::find(holes.begin(), holes.end(), tag) == holes.end()) continue;
        throw BadInclusion(set[k].line, "the shape lies in the hole " + tag + " of line " +
                                            std::to_string(around.line) +
                                            "; leave the shape or the hole out");
    }
}

int n_nested(const InclusionSet& set) {
    int n = 0;
    for (int k = 0; k < set.n_given(); ++k) n += set.parent(k) < 0 ? 0 : 1;
    return n;
}

/// The sites of cells with the tags of holes.
HoleSites hole_sites(const std::vector<std::string>& names, const Tessellation& cells) {
    HoleSites holes{.names = names};
    if (holes.empty()) return holes;
    for (const int tag : cells.site_tags) {
        const auto hole = std::find(names.begin(), names.end(), cells.tag_names[tag]);
        holes.of_site.push_back(hole == names.end() ? -1 : int(hole - names.begin()));
    }
    return holes;
}

}  // namespace

Tessellation tessellate(const Lattice& lattice, const WallChoice& walls, Points points,
                        const CvtOptions& options) {
    if (walls.walls == Walls::kNone) {
        return tessellation_of(compute_cvt(lattice, std::move(points), options));
    }
    WalledCvt walled =
        compute_walled_cvt(lattice, walls.walls, walls.cells, std::move(points), options);
    return tessellation_of(std::move(walled.torus), walled.domain);
}

Tessellation tessellate(const SymmetricSites& start, const CvtOptions& options) {
    Tessellation cells = tessellation_of(compute_cvt(start, options));
    cells.site_orbits = counted_by_sites(start.orbit);
    return cells;
}

Tessellation tessellate(const Lattice& lattice, const WallChoice& walls, Points points,
                        const AreaCvtOptions& options) {
    if (walls.walls == Walls::kNone) {
        return tessellation_of(compute_area_cvt(lattice, points, options));
    }
    WalledAreaCvt walled =
        compute_walled_area_cvt(lattice, walls.walls, walls.cells, std::move(points), options);
    return tessellation_of(std::move(walled.torus), walled.domain);
}

Tessellation tessellate(const Lattice& lattice, const Points& centroids,
                        const AreaCvtOptions& options) {
    CentroidCells found = fit_areas_and_centroids(lattice, centroids, options);
    Tessellation cells = tessellation_of(std::move(found.grains));
    cells.centroids = found.centroids;
    return cells;
}

Tessellation tessellate(const Lattice& lattice, Walls walls, const Points& points,
                        const Eigen::VectorXd& weights, const RunOptions& run) {
    if (walls == Walls::kNone)
        return tessellation_of(weighted_cells(lattice, points, weights, run));
    WalledCvt walled = walled_weighted_cells(lattice, walls, points, weights, run);
    return tessellation_of(std::move(walled.torus), walled.domain);
}

Tessellation tessellate(const Lattice& lattice, const WallChoice& walls,
                        const TaggedInclusions& inclusions, int n, std::uint64_t seed,
                        const CvtOptions& options) {
    // Compute, and prove the outlines.
    const std::vector<Inclusion> shapes =
        without_listed_images(lattice, walls.walls, inclusions.shapes);
    InclusionSet set(lattice, shapes, walls.walls);
    require_empty_holes(inclusions, set);
    if (inclusions.box_corner) set.set_box(*inclusions.box_corner);
    InterfaceCvt result = compute_interface_cvt(set, n, seed, options, walls.cells);
    PeriodicMesh mesh = cell_mesh(result.cvt.delaunay);
    if (const auto wrong = interface_violation(mesh, result.interfaces, result.inclusion)) {
        throw InternalError(*wrong);
    }
    // Tag the cells.
    Tessellation cells = tessellation_of(std::move(result.cvt), result.walled);
    if (result.walled) mesh = part_between_walls(std::move(mesh), *result.walled);
    cells.cache->cells = std::move(mesh);
    cells.site_tags = std::move(result.tag);
    set_tags(inclusions.tag_names, set, cells);
    cells.holes = hole_sites(inclusions.holes, cells);
    cells.interfaces =
        InterfaceFigures{.shapes = shapes,
                         .n_images = static_cast<int>(inclusions.shapes.size() - shapes.size()),
                         .n_nested = n_nested(set),
                         .n_chords = static_cast<int>(result.interfaces.chords.size()),
                         .n_fixed = result.interfaces.n_seeds(),
                         .n_held = static_cast<int>(result.held.size())};
    return cells;
}

}  // namespace pcvt::plane
