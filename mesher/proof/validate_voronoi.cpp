#include "mesher/proof/validate_voronoi.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "mesher/base/checkpoint.hpp"
#include "mesher/proof/law_violation.hpp"
#include "mesher/proof/proven_faces.hpp"

namespace pcvt {
namespace {

using std::to_string;

const char* const kDelaunayLaw = "of Delaunay";

/// Returns the larger distance of the ends of a side from the bisector of the centroids on its left
/// and right.
double bisector_distance(const ProvenFaces& faces, int side, const Vec2& left, const Vec2& right) {
    const Vec2 direction = (right - left).normalized();
    const Vec2 middle = (left + right) / 2;
    return std::max(std::abs(direction.dot(faces.from(side) - middle)),
                    std::abs(direction.dot(faces.to(side) - middle)));
}

/// Checks bisectors only: a convex cell contains its centroid, so the centroids lie on the correct
/// sides of their edge.
double require_voronoi_cells(const ProvenFaces& faces, double tolerance, double h,
                             const CentroidFunction& centroid) {
    const std::vector<Vec2> centroids = require_convex_cells(faces, h, tolerance, centroid);
    const GluedFaces& glued = faces.glued();
    double largest = 0;
    for (int side = 0; side < glued.n_halfedges(); ++side) {
        checkpoint_each(side);
        const Vec2& left = centroids[glued.face_of[side]];
        const Vec2 right = centroids[glued.face_of[glued.opposite[side]]] + faces.back_across(side);
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

/// Returns the depth of the point inside the circumcircle of a counter-clockwise triangle; negative
/// outside.
double depth_in_circle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& point) {
    const Vec2 p = b - a;
    const Vec2 q = c - a;
    const Vec2 s = point - a;
    const double twice_area = cross(p, q);
    const Vec2 weighted = p.squaredNorm() * q - q.squaredNorm() * p;
    const Vec2 centre = Vec2(weighted.y(), -weighted.x()) / (2 * twice_area);
    // Radius minus distance, without cancellation between two nearly equal roots.
    return s.dot(2 * centre - s) / (centre.norm() + (s - centre).norm());
}

double require_delaunay_edges(const ProvenFaces& faces, double tolerance, double h) {
    const GluedFaces& glued = faces.glued();
    double largest = 0;
    for (int side = 0; side < glued.n_halfedges(); ++side) {
        checkpoint_each(side);
        const int beside = glued.opposite[side];
        const Vec2 corner = faces.to(glued.next(beside)) + faces.back_across(side);
        const int apex = glued.next(glued.next(side));
        const double depth =
            depth_in_circle(faces.from(side), faces.to(side), faces.from(apex), corner) / h;
        if (!(depth <= tolerance)) {
            throw_violation(kDelaunayLaw,
                            "at the " + faces.edge_name(side) +
                                " the corner of the second lies inside the circumcircle of "
                                "the first by " +
                                against(depth, tolerance));
        }
        largest = std::max(largest, depth);
    }
    return largest;
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

}  // namespace

double prove_voronoi(const Tile& tile, const TileProof& proof, double tolerance,
                     const CentroidFunction& centroid) {
    if (tile.kind == MeshKind::kGrains) {
        throw InvalidInput(
            "grains are neither Voronoi cells nor Delaunay triangles; ask for the "
            "Voronoi property of a tile of cells");
    }
    const ProvenFaces faces(tile, proof);
    if (tile.kind == MeshKind::kVoronoi) {
        const double h = std::sqrt(tile.lattice.area() / faces.glued().n_faces());
        return require_voronoi_cells(faces, tolerance, h, centroid);
    }
    require_triangles(faces);
    const double h = std::sqrt(tile.lattice.area() / proof.n_orbits);
    return require_delaunay_edges(faces, tolerance, h);
}

double prove_voronoi(const Tile& tile, const TileProof& proof, double tolerance) {
    return prove_voronoi(tile, proof, tolerance, polygon_centroid);
}

}  // namespace pcvt
