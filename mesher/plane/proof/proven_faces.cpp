#include "mesher/plane/proof/proven_faces.hpp"

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/law_violation.hpp"
#include "mesher/plane/geometry/face_polygon.hpp"
#include "mesher/plane/proof/vertex_orbits.hpp"

namespace pcvt::plane {
namespace {

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
        checkpoint_each(f);
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
    cells.holes = tile.holes;
    cells.wall_edges = tile.wall_edges;
    return cells;
}

}  // namespace

ProvenFaces::ProvenFaces(const Tile& tile, const TileProof& proof)
    : tile_(join_fans(tile, proof, joined_)),
      faces_(glue_faces(tile_, proven_orbits(proof), Precision::kSingle)) {}

Polygon ProvenFaces::polygon(int f) const { return face_polygon(tile_.points, faces_[f]); }

std::string ProvenFaces::edge_name(int h) const {
    return "edge " + edge_in_words(faces_.corners[h], faces_.corners[faces_.next(h)]) +
           " between " + name(faces_.face_of[h]) + " and " + name(face_across(h));
}

std::string against(double amount, double tolerance) {
    return in_words(amount) + " h (tolerance " + in_words(tolerance) + " h)";
}

std::vector<Vec2> require_convex_cells(const ProvenFaces& faces, double h, double tolerance,
                                       const CentroidFunction& centroid) {
    std::vector<Vec2> centroids;
    for (int f = 0; f < faces.glued().n_faces(); ++f) {
        checkpoint_each(f);
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

}  // namespace pcvt::plane
