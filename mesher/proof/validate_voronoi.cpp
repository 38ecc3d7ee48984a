#include "mesher/proof/validate_voronoi.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "mesher/lattice/polygon.hpp"
#include "mesher/proof/glued_faces.hpp"
#include "mesher/proof/law_violation.hpp"
#include "mesher/proof/vertex_orbits.hpp"

namespace pcvt {
namespace {

using std::to_string;

const char* const kVoronoiLaw = "of Voronoi";
const char* const kDelaunayLaw = "of Delaunay";

/// Whether triangle f continues the fan of triangle f - 1.
bool continues_fan(const Tile& tile, const std::vector<int>& first_copy, int f) {
    if (f == 0 || tile.face_site.size() != static_cast<std::size_t>(tile.n_faces())) return false;
    if (tile.face_site[f] != tile.face_site[f - 1]) return false;
    if (tile.face_size(f) != 3 || tile.face_size(f - 1) != 3) return false;
    const auto corner = [&](int face, int k) {
        return first_copy[tile.faces[face][static_cast<std::size_t>(k)]];
    };
    return corner(f, 0) == corner(f - 1, 0) && corner(f, 1) == corner(f - 1, 2);
}

/// Returns the tile with each fan of triangles joined to the polygon that it divides; `file_face`
/// receives the first face of each polygon.
Tile join_fans(const Tile& tile, const TileProof& proof, std::vector<int>& file_face) {
    Tile cells{.lattice = tile.lattice, .kind = MeshKind::kVoronoi, .points = tile.points};
    for (int f = 0; f < tile.n_faces(); ++f) {
        const bool joins = continues_fan(tile, proof.first_copy, f);
        if (!joins) {
            if (f > 0) cells.faces.close();
            file_face.push_back(f);
        }
        for (int c = tile.faces.begin[f] + (joins ? 2 : 0); c < tile.faces.begin[f + 1]; ++c) {
            cells.faces.corners.push_back(tile.faces.corners[c]);
        }
    }
    cells.faces.close();
    return cells;
}

/// The faces of a proven tile on its vertices, with their indices in the file for the messages.
class ProvenFaces {
   public:
    ProvenFaces(const Tile& tile, const TileProof& proof)
        : tile_(join_fans(tile, proof, joined_)),
          faces_(glue_faces(tile_, proven_orbits(proof), Precision::kSingle)) {}

    const GluedFaces& glued() const { return faces_; }
    const Vec2& from(int h) const { return tile_.points[faces_.corners[h]]; }
    const Vec2& to(int h) const { return from(faces_.next(h)); }
    /// Returns the translation that moves the face across h next to the face of h.
    Vec2 back_across(int h) const { return tile_.lattice.translation(-faces_.across[h]); }

    Polygon polygon(int f) const {
        Polygon corners;
        for (const int v : faces_[f]) corners.push_back(tile_.points[v]);
        return corners;
    }
    std::string name(int f) const { return "face " + to_string(joined_[faces_.file_face[f]]); }
    std::string edge_name(int h) const {
        return "edge " + edge_in_words(faces_.corners[h], faces_.corners[faces_.next(h)]) +
               " between " + name(faces_.face_of[h]) + " and " +
               name(faces_.face_of[faces_.opposite[h]]);
    }

   private:
    std::vector<int> joined_;
    Tile tile_;
    GluedFaces faces_;
};

std::string against(double amount, double tolerance) {
    return in_words(amount) + " h (tolerance " + in_words(tolerance) + " h)";
}

/// Returns the centroids of the cells.
std::vector<Vec2> require_convex_cells(const ProvenFaces& faces, double h, double tolerance,
                                       const CentroidFunction& centroid) {
    std::vector<Vec2> centroids;
    for (int f = 0; f < faces.glued().n_faces(); ++f) {
        const Polygon polygon = faces.polygon(f);
        const double depth = reflex_depth(polygon) / h;
        if (!(depth <= tolerance)) {
            throw_violation(kVoronoiLaw, faces.name(f) +
                                             " is not convex: a corner lies inside by " +
                                             against(depth, tolerance));
        }
        if (!(polygon_area(polygon) > 0)) {
            throw_violation(kVoronoiLaw, faces.name(f) + " has no area, so no centroid");
        }
        centroids.push_back(centroid(polygon));
    }
    return centroids;
}

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
