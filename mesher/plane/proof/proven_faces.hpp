#pragma once

#include <functional>
#include <string>

#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/proof/glued_faces.hpp"

namespace pcvt::plane {

inline const char* const kVoronoiLaw = "of Voronoi";

using CentroidFunction = std::function<Vec2(const Polygon&)>;

/// The faces of a proven tile on its vertices, with their indices in the file for the messages. A
/// fan of triangles is joined to the polygon that it divides.
///
/// Example usage:
///   const ProvenFaces faces(tile, proof);
///   const Vec2 side = faces.to(h) - faces.from(h);
///   const Vec2 beyond = centroids[faces.face_across(h)] + faces.back_across(h);
class ProvenFaces {
   public:
    ProvenFaces(const Tile& tile, const TileProof& proof);

    const GluedFaces& glued() const { return faces_; }
    const Vec2& from(int h) const { return tile_.points[faces_.corners[h]]; }
    const Vec2& to(int h) const { return from(faces_.next(h)); }
    /// The vertex at which h begins.
    int vertex(int h) const { return faces_.corners[h]; }
    int face_across(int h) const { return faces_.face_of[faces_.opposite[h]]; }
    /// Returns the translation that moves the face across h next to the face of h.
    Vec2 back_across(int h) const { return tile_.lattice.translation(-faces_.across[h]); }

    Polygon polygon(int f) const;
    /// The first face of face f in the file.
    int file_face(int f) const { return joined_[faces_.file_face[f]]; }
    std::string name(int f) const { return "face " + std::to_string(file_face(f)); }
    std::string edge_name(int h) const;

   private:
    std::vector<int> joined_;
    Tile tile_;
    GluedFaces faces_;
};

/// Formats an amount for a message: "1.2e-05 h (tolerance 1e-06 h)".
std::string against(double amount, double tolerance);

/// Proves that the cells are convex.
/// @param h  the unit of the tolerance, length units.
/// @returns  the centroids of the cells.
std::vector<Vec2> require_convex_cells(const ProvenFaces& faces, double h, double tolerance,
                                       const CentroidFunction& centroid);

}  // namespace pcvt::plane
