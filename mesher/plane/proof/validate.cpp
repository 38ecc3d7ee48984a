#include "mesher/plane/proof/validate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/disjoint_sets.hpp"
#include "mesher/base/law_violation.hpp"
#include "mesher/plane/geometry/face_polygon.hpp"
#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/proof/glued_faces.hpp"
#include "mesher/plane/proof/hole_polygons.hpp"
#include "mesher/plane/proof/validate_walls.hpp"
#include "mesher/plane/proof/vertex_orbits.hpp"

namespace pcvt::plane {
namespace {

using std::to_string;

const char* const kDiscLaw = "(3), disc";
const char* const kTorusLaw = "(4), torus";
const char* const kAreaLaw = "(5), areas";

void require_arrays(const Tile& tile) {
    if (tile.faces.begin.size() < 2) throw_violation(kFaceLaw, "the tile has no face");
    if (tile.faces.begin.front() != 0 ||
        tile.faces.begin.back() != static_cast<int>(tile.faces.corners.size())) {
        throw_violation(kFaceLaw, "the faces do not cover the list of corners");
    }
    for (int v = 0; v < tile.n_vertices(); ++v) {
        checkpoint_each(v);
        if (!tile.points[v].allFinite()) {
            throw_violation(kFaceLaw, "a coordinate of vertex " + to_string(v) + " is not finite");
        }
    }
    for (int f = 0; f < tile.n_faces(); ++f) {
        checkpoint_each(f);
        if (tile.face_size(f) < 3) {
            throw_violation(kFaceLaw, "face " + to_string(f) + " has " +
                                          to_string(tile.face_size(f)) +
                                          " corners; it needs three or more");
        }
    }
}

void require_known_vertices(const Tile& tile) {
    for (int f = 0; f < tile.n_faces(); ++f) {
        checkpoint_each(f);
        for (const int v : tile.faces[f]) {
            if (v >= 0 && v < tile.n_vertices()) continue;
            throw_violation(kFaceLaw, "face " + to_string(f) + " names vertex " + to_string(v) +
                                          "; there are " + to_string(tile.n_vertices()));
        }
    }
}

void require_true_copies(const Tile& tile) {
    const int n = tile.n_vertices() - static_cast<int>(tile.copies.size());
    for (int k = 0; k < static_cast<int>(tile.copies.size()); ++k) {
        const int v = tile.copies[k];
        if (n > 0 && v >= 0 && v < n && tile.points[v] == tile.points[n + k]) continue;
        throw_violation(kFaceLaw,
                        "vertex " + to_string(n + k) + " is not a copy of vertex " + to_string(v));
    }
}

/// Checks that each vertex, or another copy of it, belongs to a face.
void require_vertices_in_use(const Tile& tile, const VertexOrbits& orbits) {
    std::vector<bool> used(tile.points.size(), false);
    for (const int v : tile.faces.corners) used[orbits.first_copy[v]] = true;
    for (int v = 0; v < tile.n_vertices(); ++v) {
        if (used[orbits.first_copy[v]]) continue;
        throw_violation(kFaceLaw, "vertex " + to_string(v) + " belongs to no face");
    }
}

void require_distinct_vertices(const Tile& tile, const VertexOrbits& orbits) {
    for (int v = 0; v < tile.n_vertices(); ++v) {
        const int first = orbits.first_copy[v];
        if (first == v) continue;
        const double apart = (tile.points[v] - tile.points[first]).lpNorm<Eigen::Infinity>();
        throw_violation(kFaceLaw, "vertices " + to_string(first) + " and " + to_string(v) +
                                      " coincide: they lie " + in_words(apart) + " apart");
    }
}

/// Returns the sum of the areas, computed by W. Kahan's compensated summation.
double require_simple_faces(const Tile& tile, const GluedFaces& faces, Precision precision,
                            double tolerance) {
    double sum = 0;
    double lost = 0;
    Polygon polygon;
    for (int f = 0; f < faces.n_faces(); ++f) {
        checkpoint_each(f);
        face_polygon(tile.points, faces[f], polygon);
        const double area = polygon_area(polygon);
        const bool positive = precision == Precision::kDouble
                                  ? area > 0
                                  : area >= -tolerance * polygon_perimeter(polygon);
        if (!positive) {
            throw_violation(kFaceLaw, "face " + to_string(faces.file_face[f]) + " has the area " +
                                          in_words(area) + "; corners must run counter-clockwise");
        }
        if (crosses_itself(polygon, tolerance)) {
            throw_violation(kFaceLaw, "face " + to_string(faces.file_face[f]) + " crosses itself");
        }
        const double term = area - lost;
        const double next = sum + term;
        lost = (next - sum) - term;
        sum = next;
    }
    return sum;
}

/// @param over_seam  whether edges of the seam connect faces, too.
void require_connected(const GluedFaces& faces, bool over_seam) {
    DisjointSets pieces(faces.n_faces());
    for (int h = 0; h < faces.n_halfedges(); ++h) {
        checkpoint_each(h);
        if (over_seam || !faces.on_seam(h)) {
            pieces.unite(faces.face_of[h], faces.face_of[faces.opposite[h]]);
        }
    }
    for (int f = 0; f < faces.n_faces(); ++f) {
        checkpoint_each(f);
        if (pieces.find(f) == 0) continue;
        throw_violation(kDiscLaw, "face " + to_string(faces.file_face[f]) +
                                      " is not connected to face " + to_string(faces.file_face[0]) +
                                      (over_seam ? "" : " over edges inside of the tile"));
    }
}

/// The number of faces that are reached from that of h by turning round the vertex that h leaves,
/// over edges inside of the tile.
int faces_in_fan(const GluedFaces& faces, int h) {
    int n = 1;
    // Clockwise: h and the successor of its opposite leave the same vertex.
    for (int g = h; !faces.on_seam(g); ++n) {
        g = faces.next(faces.opposite[g]);
        if (g == h) return n;
    }
    for (int g = faces.previous(h); !faces.on_seam(g); ++n) {
        g = faces.previous(faces.opposite[g]);
    }
    return n;
}

void require_single_fans(const Tile& tile, const GluedFaces& faces) {
    std::vector<int> first(tile.points.size(), -1);
    std::vector<int> n_faces(tile.points.size(), 0);
    for (int h = 0; h < faces.n_halfedges(); ++h) {
        checkpoint_each(h);
        const int v = faces.corners[h];
        if (n_faces[v]++ == 0) first[v] = h;
    }
    for (int v = 0; v < tile.n_vertices(); ++v) {
        checkpoint_each(v);
        if (n_faces[v] == 0 || n_faces[v] == faces_in_fan(faces, first[v])) continue;
        throw_violation(kDiscLaw, "the faces at vertex " + to_string(v) +
                                      " form more than one fan: the tile is pinched there");
    }
}

/// Checks that the boundary is one loop. Each vertex has one fan by now, so exactly one boundary
/// edge leaves each boundary vertex.
void require_one_loop(const Tile& tile, const GluedFaces& faces) {
    DisjointSets loops(tile.n_vertices());
    int first = -1;
    for (int h = 0; h < faces.n_halfedges(); ++h) {
        checkpoint_each(h);
        if (!faces.on_seam(h)) continue;
        if (first < 0) first = h;
        loops.unite(faces.corners[h], faces.corners[faces.next(h)]);
    }
    if (first < 0) throw_violation(kDiscLaw, "the tile has no boundary");
    for (int h = first; h < faces.n_halfedges(); ++h) {
        checkpoint_each(h);
        if (!faces.on_seam(h)) continue;
        if (loops.find(faces.corners[h]) == loops.find(faces.corners[first])) continue;
        throw_violation(kDiscLaw, "the boundary has more than one loop: vertices " +
                                      to_string(faces.corners[first]) + " and " +
                                      to_string(faces.corners[h]) +
                                      " lie on two; the tile has a hole");
    }
}

void require_euler(const std::string& law, int n_vertices, int n_edges, int n_faces, int wanted) {
    const int euler = n_vertices - n_edges + n_faces;
    if (euler == wanted) return;
    throw_violation(law, "V - E + F = " + to_string(n_vertices) + " - " + to_string(n_edges) +
                             " + " + to_string(n_faces) + " = " + to_string(euler) + ", not " +
                             to_string(wanted));
}

/// Checks the total area. Moving each boundary vertex by the tolerance in each coordinate changes
/// the area by at most sqrt(2) times tolerance times perimeter; the second term bounds the rounding
/// error of the sum.
/// @param holes  the area of the polygons of the holes.
void require_area(const Tile& tile, const GluedFaces& faces, const TileProof& proof, double holes) {
    double perimeter = 0;
    for (int h = 0; h < faces.n_halfedges(); ++h) {
        checkpoint_each(h);
        if (!faces.on_seam(h)) continue;
        perimeter +=
            (tile.points[faces.corners[faces.next(h)]] - tile.points[faces.corners[h]]).norm();
    }
    const double wanted = tile.lattice.area();
    const double allowed = 2 * proof.tolerance * perimeter + 0x1p-48 * wanted;
    const double covered = proof.area + holes;
    if (std::abs(covered - wanted) <= allowed) return;
    throw_violation(kAreaLaw, std::string(holes > 0 ? "the faces and the holes" : "the faces") +
                                  " cover " + in_words(covered / wanted) +
                                  " of the fundamental domain's area; the difference is " +
                                  in_words(covered - wanted) + " where rounding explains " +
                                  in_words(allowed));
}

void collect_vertices(const VertexOrbits& orbits, const GluedFaces& faces, TileProof& proof) {
    std::vector<bool> in_faces(orbits.first_copy.size(), false);
    for (const int v : faces.corners) in_faces[v] = true;
    const int n = static_cast<int>(orbits.first_copy.size());
    for (int w = 0; w < n; ++w) {
        checkpoint_each(w);
        if (orbits.first_copy[w] != w) {
            ++proof.n_merged;
            continue;
        }
        const int v = orbits.representative[w];
        if (in_faces[w]) ++proof.n_vertices;
        if (v == w) {
            ++proof.n_orbits;
        } else {
            proof.vertex_pairs.push_back({v, w, orbits.offset[w]});
        }
    }
    proof.first_copy = orbits.first_copy;
}

void collect_edges(const GluedFaces& faces, TileProof& proof) {
    for (int h = 0; h < faces.n_halfedges(); ++h) {
        checkpoint_each(h);
        if (!faces.on_seam(h)) continue;
        ++proof.n_boundary_edges;
        // Store each pair once, from the side with the positive translation.
        if (faces.on_wall(h) || faces.across[h] < Offset{}) continue;
        const int g = faces.opposite[h];
        proof.edge_pairs.push_back({.v0 = faces.corners[h],
                                    .v1 = faces.corners[faces.next(h)],
                                    .w0 = faces.corners[faces.next(g)],
                                    .w1 = faces.corners[g],
                                    .offset = faces.across[h]});
    }
    std::sort(proof.edge_pairs.begin(), proof.edge_pairs.end());
    proof.wall_edges = faces.hole_edges;
}

/// Checks the arrays.
void require_sound(const Tile& tile) {
    require_arrays(tile);
    require_known_vertices(tile);
    require_true_copies(tile);
}

/// Finds the orbits and glues the faces (laws 1 and 2).
/// @param tile  require_sound(); without walls.
Gluing glued(const Tile& tile, Precision precision, double tolerance) {
    Gluing gluing;
    TileProof& proof = gluing.proof;
    proof.precision = precision;
    proof.tolerance = tolerance;
    const VertexOrbits orbits =
        find_vertex_orbits(tile.lattice, tile.points, proof.tolerance, tile.copies);
    if (precision == Precision::kDouble) require_distinct_vertices(tile, orbits);
    require_vertices_in_use(tile, orbits);
    proof.mismatch = orbits.mismatch;
    gluing.faces = glue_faces(tile, orbits, precision);
    proof.n_faces = gluing.faces.n_faces();
    collect_vertices(orbits, gluing.faces, proof);
    collect_edges(gluing.faces, proof);
    proof.area = require_simple_faces(tile, gluing.faces, precision, proof.tolerance);
    return gluing;
}

/// Law (3).
void require_disc(const Tile& tile, const Gluing& gluing) {
    const auto& [proof, faces] = gluing;
    if (!tile.holes.empty()) {
        require_connected(faces, true);
        return;
    }
    require_single_fans(tile, faces);
    require_connected(faces, false);
    require_one_loop(tile, faces);
    const int n_edges = (faces.n_halfedges() + proof.n_boundary_edges) / 2;
    require_euler(kDiscLaw, proof.n_vertices, n_edges, proof.n_faces, 1);
}

/// Laws (4), (5) and (7).
void require_torus(const Tile& tile, const Gluing& gluing) {
    const auto& [proof, faces] = gluing;
    const std::vector<Polygon> holes = hole_polygons(tile, faces, proof.tolerance);
    double area = 0;
    for (const Polygon& hole : holes) area += polygon_area(hole);
    const int n_edges = (faces.n_halfedges() + static_cast<int>(faces.hole_edges.size())) / 2;
    require_euler(kTorusLaw, proof.n_orbits, n_edges, proof.n_faces,
                  -static_cast<int>(holes.size()));
    require_area(tile, faces, proof, area);
}

}  // namespace

TileProof prove_cover(const Tile& tile, Precision precision) {
    require_sound(tile);
    Gluing gluing = glued(tile, precision, position_tolerance(tile, precision));
    require_torus(tile, gluing);
    return std::move(gluing.proof);
}

TileProof prove_tile(const Tile& tile, Precision precision, double least_tolerance) {
    require_sound(tile);
    const double tolerance = std::max(position_tolerance(tile, precision), least_tolerance);
    if (tile.walls == Walls::kNone) {
        Gluing gluing = glued(tile, precision, tolerance);
        require_disc(tile, gluing);
        require_torus(tile, gluing);
        return std::move(gluing.proof);
    }
    require_between_walls(tile, precision);
    const Tile torus = mirrored_tile(with_exact_walls(tile, tolerance));
    const Gluing whole =
        glued(torus, precision, std::max(position_tolerance(torus, precision), least_tolerance));
    Gluing part = part_of_tile(tile, whole);
    require_disc(tile, part);
    require_torus(torus, whole);
    return std::move(part.proof);
}

}  // namespace pcvt::plane
