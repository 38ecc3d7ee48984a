#include "mesher/plane/proof/validate_voronoi.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/law_violation.hpp"
#include "mesher/plane/proof/proven_faces.hpp"
#include "mesher/plane/proof/round_tile.hpp"
#include "mesher/plane/proof/site_images.hpp"
#include "mesher/plane/proof/validate_walls.hpp"
#include "mesher/plane/tile/site_positions.hpp"

namespace pcvt::plane {
namespace {

using std::to_string;

const char* const kDelaunayLaw = "of Delaunay";
/// Centroids nearer than this are one point, in units of h.
constexpr double kSamePoint = 1e-9;

/// Returns the larger distance of the ends of a side from the bisector of the centroids on its left
/// and right.
double bisector_distance(const ProvenFaces& faces, int side, const Vec2& left, const Vec2& right) {
    const Vec2 direction = (right - left).normalized();
    const Vec2 middle = (left + right) / 2;
    return std::max(std::abs(direction.dot(faces.from(side) - middle)),
                    std::abs(direction.dot(faces.to(side) - middle)));
}

/// The walls of a tile and of its mirror images, on which the sites of halves and quarters of cells
/// lie.
struct WallLines {
    Walls walls = Walls::kNone;
    Lattice domain;

    /// The line of a wall on which a coordinate lies, or of one to which it is nearest.
    double nearest(double coordinate, int axis) const {
        const double side = side_length(domain, axis);
        return std::round(coordinate / side) * side;
    }
    bool holds(const Vec2& p, int axis) const {
        return has_walls_across(walls, axis) && p[axis] == nearest(p[axis], axis);
    }
};

/// The centroids of whole cells, of which some faces are halves or quarters.
struct WholeCells {
    std::vector<Vec2> centroids;
    /// Whether each face is only a part of its cell.
    std::vector<bool> is_part;
    /// The number of whole cells, the sum of the parts that the faces are.
    double n_cells = 0;
};

/// A cell whose site lies on a wall consists of a face and its mirror image, so that its centroid
/// is that of the face, moved onto the wall.
WholeCells whole_cells(const Tile& torus, const ProvenFaces& faces, const WallLines& lines,
                       std::vector<Vec2> centroids) {
    const std::vector<Vec2> positions = site_positions(torus);
    WholeCells cells{std::move(centroids), {}, 0};
    for (int f = 0; f < faces.glued().n_faces(); ++f) {
        double share = 1;
        for (int axis = 0; axis < 2 && !positions.empty(); ++axis) {
            const Vec2& site = positions[torus.face_site[faces.file_face(f)]];
            if (!lines.holds(site, axis)) continue;
            cells.centroids[f][axis] = lines.nearest(cells.centroids[f][axis], axis);
            share /= 2;
        }
        cells.is_part.push_back(share < 1);
        cells.n_cells += share;
    }
    return cells;
}

/// Checks bisectors only: a convex cell contains its centroid, so the centroids lie on the correct
/// sides of their edge. A cell of halves is convex, too: its site lies on the wall, and those of
/// its neighbours on the same side of the wall as their halves.
double require_voronoi_cells(const Tile& tile, const ProvenFaces& faces, double tolerance,
                             const CentroidFunction& centroid, const WallLines& lines) {
    const GluedFaces& glued = faces.glued();
    const double least_h = std::sqrt(tile.lattice.area() / glued.n_faces());
    const WholeCells cells =
        whole_cells(tile, faces, lines, require_convex_cells(faces, least_h, tolerance, centroid));
    const double h = std::sqrt(tile.lattice.area() / cells.n_cells);
    double largest = 0;
    for (int side = 0; side < glued.n_halfedges(); ++side) {
        checkpoint_each(side);
        if (glued.on_wall(side)) continue;
        const int f = glued.face_of[side];
        const Vec2& left = cells.centroids[f];
        const Vec2 right =
            cells.centroids[glued.face_of[glued.opposite[side]]] + faces.back_across(side);
        // A wall inside of a cell.
        if (cells.is_part[f] && (right - left).norm() <= kSamePoint * h) continue;
        const double distance = bisector_distance(faces, side, left, right) / h;
        if (!(distance <= tolerance)) {
            throw_violation(kVoronoiLaw, "a corner of the " + faces.edge_name(side) +
                                             " lies off the bisector of their centroids by " +
                                             against(distance, tolerance));
        }
        largest = std::max(largest, distance);
    }
    return largest;
}

/// Compares the sites with the centroids of their cells; the cells are power cells by
/// prove_sites(). Two cells that lie at one site, parts of a cell that an outline has cut, are
/// refused.
double require_centroidal_sites(const Tile& tile, const ProvenFaces& faces, double tolerance,
                                const CentroidFunction& centroid) {
    const int n_cells = faces.glued().n_faces();
    const double h = std::sqrt(tile.lattice.area() / n_cells);
    const std::vector<Vec2> centroids = require_convex_cells(faces, h, tolerance, centroid);
    const SiteImages images(tile, site_positions(tile));
    if (n_cells != images.n_sites() * images.copies()) {
        throw_violation(kVoronoiLaw, "there are " + to_string(n_cells) + " faces for " +
                                         to_string(images.n_sites()) +
                                         " sites: the cells are not whole");
    }
    double largest = 0;
    for (int f = 0; f < n_cells; ++f) {
        const SiteId site = tile.face_site[faces.file_face(f)];
        const Vec2 at = images.position(site, images.nearest(site, centroids[f]));
        const double distance = (centroids[f] - at).norm() / h;
        if (!(distance <= tolerance)) {
            throw_violation(kVoronoiLaw,
                            "site " + to_string(site) + " lies off the centroid of its cell, " +
                                faces.name(f) + ", by " + against(distance, tolerance));
        }
        largest = std::max(largest, distance);
    }
    return largest;
}

/// A corner of triangles with the weight of its site.
struct WeightedPoint {
    Vec2 p;
    double weight;
};

/// Returns the depth of the point inside the power circle of a counter-clockwise triangle, negative
/// outside: the power distance of the corners from the centre less that of the point, over the sum
/// of the distances of a and the point from the centre. Without weights, the depth in the
/// circumcircle.
double depth_in_circle(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c,
                       const WeightedPoint& point) {
    const Vec2 p = b.p - a.p;
    const Vec2 q = c.p - a.p;
    const Vec2 s = point.p - a.p;
    const double twice_area = cross(p, q);
    const Vec2 weighted =
        (p.squaredNorm() + a.weight - b.weight) * q - (q.squaredNorm() + a.weight - c.weight) * p;
    const Vec2 centre = Vec2(weighted.y(), -weighted.x()) / (2 * twice_area);
    // Radius minus distance, without cancellation between two nearly equal roots.
    return (s.dot(2 * centre - s) + point.weight - a.weight) /
           (centre.norm() + (s - centre).norm());
}

/// The corners of triangles with their weights.
class WeightedCorners {
   public:
    WeightedCorners(const Tile& tile, const ProvenFaces& faces) : tile_(tile), faces_(faces) {}

    /// The corner at which a side begins.
    WeightedPoint at(int side) const {
        if (tile_.site_weights.empty()) return {faces_.from(side), 0};
        return {faces_.from(side), tile_.site_weights[tile_.vertex_site[faces_.vertex(side)]]};
    }

   private:
    const Tile& tile_;
    const ProvenFaces& faces_;
};

double require_delaunay_edges(const Tile& tile, const ProvenFaces& faces, double tolerance,
                              double h) {
    const GluedFaces& glued = faces.glued();
    const WeightedCorners corners(tile, faces);
    const std::string circle = tile.site_weights.empty() ? "circumcircle" : "power circle";
    double largest = 0;
    for (int side = 0; side < glued.n_halfedges(); ++side) {
        checkpoint_each(side);
        if (glued.on_wall(side)) continue;
        const int beside = glued.opposite[side];
        WeightedPoint corner = corners.at(glued.next(glued.next(beside)));
        corner.p += faces.back_across(side);
        const int next = glued.next(side);
        const double depth = depth_in_circle(corners.at(side), corners.at(next),
                                             corners.at(glued.next(next)), corner) /
                             h;
        if (!(depth <= tolerance)) {
            throw_violation(kDelaunayLaw, "at the " + faces.edge_name(side) +
                                              " the corner of the second lies inside the " +
                                              circle + " of the first by " +
                                              against(depth, tolerance));
        }
        largest = std::max(largest, depth);
    }
    return largest;
}

/// The centroid of a polygon of the round space: that of the polygon mapped back to the plane.
CentroidFunction in_round_space(const CentroidFunction& centroid, const Metric& metric) {
    return [&centroid, &metric](Polygon polygon) {
        for (Vec2& p : polygon) p = metric.from_round(p);
        return metric.to_round(centroid(polygon));
    };
}

/// The centroid of a cell beyond a wall: the mirror image of that of its image in the domain.
CentroidFunction of_mirror_images(const CentroidFunction& centroid, Walls walls) {
    return [&centroid, walls](Polygon polygon) {
        const Vec2 sum = std::accumulate(polygon.begin(), polygon.end(), Vec2(0, 0));
        Vec2 signs(1, 1);
        for (int axis = 0; axis < 2; ++axis) {
            if (has_walls_across(walls, axis) && sum[axis] < 0) signs[axis] = -1;
        }
        for (Vec2& p : polygon) p = p.cwiseProduct(signs);
        if (signs.prod() < 0) std::reverse(polygon.begin(), polygon.end());
        return Vec2(centroid(polygon).cwiseProduct(signs));
    };
}

void require_triangles(const ProvenFaces& faces) {
    const GluedFaces& glued = faces.glued();
    for (int f = 0; f < glued.n_faces(); ++f) {
        checkpoint_each(f);
        const int size = glued.size(f);
        if (size == 3) continue;
        throw_violation(kDelaunayLaw,
                        faces.name(f) + " has " + to_string(size) + " corners, not 3");
    }
}

/// @param tile  round, without walls.
double prove_torus(const Tile& tile, const TileProof& proof, double tolerance,
                   const CentroidFunction& centroid, const WallLines& lines) {
    const ProvenFaces faces(tile, proof);
    if (tile.kind == MeshKind::kVoronoi && !tile.site_weights.empty()) {
        return require_centroidal_sites(tile, faces, tolerance, centroid);
    }
    if (tile.kind == MeshKind::kVoronoi) {
        return require_voronoi_cells(tile, faces, tolerance, centroid, lines);
    }
    require_triangles(faces);
    const double h = std::sqrt(tile.lattice.area() / proof.n_orbits);
    return require_delaunay_edges(tile, faces, tolerance, h);
}

}  // namespace

double prove_voronoi(const Tile& tile, const TileProof& proof, double tolerance,
                     const CentroidFunction& centroid) {
    if (tile.kind == MeshKind::kGrains) {
        throw InvalidInput(
            "grains are neither Voronoi cells nor Delaunay triangles; ask for the "
            "Voronoi property of a tile of cells");
    }
    if (tile.walls != Walls::kNone) {
        const Tile torus = mirrored_tile(with_exact_walls(tile, proof.tolerance));
        return prove_torus(torus, prove_cover(torus, proof.precision), tolerance,
                           of_mirror_images(centroid, tile.walls), {tile.walls, tile.lattice});
    }
    if (!tile.metric.is_round()) {
        return prove_torus(round_tile(tile), proof, tolerance,
                           in_round_space(centroid, tile.metric), {Walls::kNone, tile.lattice});
    }
    return prove_torus(tile, proof, tolerance, centroid, {Walls::kNone, tile.lattice});
}

double prove_voronoi(const Tile& tile, const TileProof& proof, double tolerance) {
    return prove_voronoi(tile, proof, tolerance, polygon_centroid);
}

}  // namespace pcvt::plane
