#include "mesher/proof/validate_walls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "mesher/base/checkpoint.hpp"
#include "mesher/proof/law_violation.hpp"
#include "mesher/proof/vertex_orbits.hpp"

namespace pcvt {
namespace {

using std::to_string;

const char* const kWallLaw = "(6), walls";

/// Bounds the rounding errors of the representative, of the period and of their sum, in ulps.
constexpr double kUlps = 4;

/// The wall on which an edge of a proven tile between walls lies.
WallSide wall_of(const Tile& tile, int v, int w) {
    double nearest = std::numeric_limits<double>::infinity();
    WallSide side{};
    for (const WallSideRow& row : kWallSides) {
        if (!has_walls_across(tile.walls, row.axis)) continue;
        const double line = wall_line(row.side, tile.lattice);
        const double off = std::max(std::abs(tile.points[v][row.axis] - line),
                                    std::abs(tile.points[w][row.axis] - line));
        if (off < nearest) {
            nearest = off;
            side = row.side;
        }
    }
    return side;
}

/// Takes the faces of the tile, which come first, and their edges on walls.
void take_faces(const Tile& tile, const GluedFaces& all, Gluing& part) {
    GluedFaces& faces = part.faces;
    for (int f = 0; f < all.n_faces() && all.file_face[f] < tile.n_faces(); ++f) {
        faces.add(all[f]);
        faces.file_face.push_back(all.file_face[f]);
    }
    const int n_halfedges = static_cast<int>(faces.corners.size());
    faces.face_of.assign(all.face_of.begin(), all.face_of.begin() + n_halfedges);
    faces.opposite.assign(all.opposite.begin(), all.opposite.begin() + n_halfedges);
    faces.across.assign(all.across.begin(), all.across.begin() + n_halfedges);
    for (int h = 0; h < n_halfedges; ++h) {
        checkpoint_each(h);
        if (faces.opposite[h] < n_halfedges) continue;
        const int v = faces.corners[h];
        const int w = faces.corners[faces.next(h)];
        part.proof.wall_edges.push_back({wall_of(tile, v, w), v, w});
        faces.opposite[h] = h;
        faces.across[h] = {1, 1};
    }
    std::sort(part.proof.wall_edges.begin(), part.proof.wall_edges.end());
    part.proof.n_faces = faces.n_faces();
}

/// Takes the orbits of the tile's vertices. The representative of an orbit is its first vertex,
/// therefore one of the tile.
void take_vertices(const Tile& tile, const TileProof& torus, Gluing& part) {
    TileProof& proof = part.proof;
    const int n_points = tile.n_vertices() - static_cast<int>(tile.copies.size());
    std::vector<bool> in_faces(static_cast<std::size_t>(n_points), false);
    for (const int v : part.faces.corners) in_faces[v] = true;
    const VertexOrbits orbits = proven_orbits(torus);
    for (int v = 0; v < n_points; ++v) {
        checkpoint_each(v);
        const int first = torus.first_copy[v];
        proof.first_copy.push_back(first);
        if (first != v) {
            ++proof.n_merged;
            continue;
        }
        if (in_faces[v]) ++proof.n_vertices;
        if (orbits.representative[v] == v) {
            ++proof.n_orbits;
        } else {
            proof.vertex_pairs.push_back({orbits.representative[v], v, orbits.offset[v]});
        }
    }
    for (const int v : tile.copies) {
        proof.first_copy.push_back(proof.first_copy[v]);
        ++proof.n_merged;
    }
}

}  // namespace

double position_tolerance(const Tile& tile, Precision precision) {
    double largest = 0;
    for (const Vec2& p : tile.points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
    int exponent = 0;
    std::frexp(largest, &exponent);
    const int digits = precision == Precision::kDouble ? std::numeric_limits<double>::digits
                                                       : std::numeric_limits<float>::digits;
    return kUlps * std::ldexp(1.0, exponent - digits);
}

void require_between_walls(const Tile& tile, Precision precision) {
    if (!is_upright(tile.lattice)) {
        throw_violation(kWallLaw, "walls need the period vectors (width, 0) and (0, height)");
    }
    const double tolerance = position_tolerance(tile, precision);
    for (const WallSideRow& row : kWallSides) {
        if (!has_walls_across(tile.walls, row.axis)) continue;
        const double line = wall_line(row.side, tile.lattice);
        for (int v = 0; v < tile.n_vertices(); ++v) {
            checkpoint_each(v);
            const double beyond = (tile.points[v][row.axis] - line) * (row.at_end ? 1 : -1);
            if (beyond == 0 || beyond < -tolerance) continue;
            if (precision == Precision::kSingle && beyond <= tolerance) continue;
            throw_violation(kWallLaw, "vertex " + to_string(v) + " lies off " + row.word + " by " +
                                          in_words(beyond));
        }
    }
}

Tile with_exact_walls(Tile tile, double tolerance) {
    for (const WallSideRow& row : kWallSides) {
        if (!has_walls_across(tile.walls, row.axis)) continue;
        const double line = wall_line(row.side, tile.lattice);
        for (std::vector<Vec2>* points : {&tile.points, &tile.site_positions}) {
            for (Vec2& p : *points) {
                if (std::abs(p[row.axis] - line) <= tolerance) p[row.axis] = line;
            }
        }
    }
    return tile;
}

Gluing part_of_tile(const Tile& tile, const Gluing& torus) {
    Gluing part;
    TileProof& proof = part.proof;
    proof.precision = torus.proof.precision;
    proof.tolerance = torus.proof.tolerance;
    take_faces(tile, torus.faces, part);
    take_vertices(tile, torus.proof, part);
    const int n_points = tile.n_vertices() - static_cast<int>(tile.copies.size());
    for (const EdgePair& pair : torus.proof.edge_pairs) {
        if (std::max({pair.v0, pair.v1, pair.w0, pair.w1}) < n_points) {
            proof.edge_pairs.push_back(pair);
        }
    }
    proof.n_boundary_edges =
        static_cast<int>(2 * proof.edge_pairs.size() + proof.wall_edges.size());
    proof.area = torus.proof.area / (tile.walls == Walls::kXY ? 4 : 2);
    return part;
}

}  // namespace pcvt
