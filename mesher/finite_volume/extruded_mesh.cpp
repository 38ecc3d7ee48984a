#include "mesher/finite_volume/extruded_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "mesher/base/bucket_sort.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"

namespace pcvt {
namespace {

/// The halfedge from v to w of a face.
struct Side {
    int v;
    int w;
    int face;
};

/// Compares sides by their edge, so that the two sides of an inner edge are adjacent after sorting.
bool edge_less(const Side& s, const Side& t) {
    return std::tuple(std::minmax(s.v, s.w), s.face) < std::tuple(std::minmax(t.v, t.w), t.face);
}

std::vector<Side> sides_by_edge(const plane::Tile& tile) {
    std::vector<Side> sides;
    sides.reserve(tile.faces.corners.size());
    for (int f = 0; f < tile.n_faces(); ++f) {
        checkpoint_each(f);
        int from = tile.faces[f].back();
        for (const int v : tile.faces[f]) {
            sides.push_back({from, v, f});
            from = v;
        }
    }
    bucket_sort(
        sides, tile.n_vertices(), [](const Side& side) { return std::min(side.v, side.w); },
        edge_less);
    return sides;
}

/// An inner edge, seen from the face with the smaller index.
struct InnerEdge {
    int owner;
    int neighbour;
    int v;
    int w;
    friend auto operator<=>(const InnerEdge&, const InnerEdge&) = default;
};

bool same_edge(const Side& s, const Side& t) { return s.v == t.w && s.w == t.v; }

std::vector<InnerEdge> inner_edges(const std::vector<Side>& sides, int n_faces) {
    std::vector<InnerEdge> edges;
    for (std::size_t k = 0; k + 1 < sides.size(); ++k) {
        const Side& side = sides[k];
        if (!same_edge(side, sides[k + 1])) continue;
        edges.push_back({side.face, sides[k + 1].face, side.v, side.w});
    }
    bucket_sort(edges, n_faces, [](const InnerEdge& edge) { return edge.owner; });
    return edges;
}

/// Returns the face whose halfedge runs from v to w.
int face_beside(const std::vector<Side>& sides, int v, int w) {
    auto found = std::lower_bound(sides.begin(), sides.end(), Side{v, w, -1}, edge_less);
    while (found != sides.end() && std::minmax(found->v, found->w) == std::minmax(v, w)) {
        if (found->v == v) return found->face;
        ++found;
    }
    throw InternalError("an edge of the seam belongs to no face");
}

/// Appends faces to an extruded mesh that has its points already.
class ExtrudedFaces {
   public:
    explicit ExtrudedFaces(FiniteVolumeMesh& extruded)
        : mesh_(extruded), above_(extruded.n_points() / 2) {}

    /// Adds the upright face over v -> w; its normal points to the right of v -> w.
    void add_upright(int v, int w, int owner) { add({v, w, w + above_, v + above_}, owner); }
    /// Adds the same face with its points listed from w, so that it matches the face over w' -> v'
    /// of the partner.
    void add_answering_upright(int v, int w, int owner) {
        add({w, w + above_, v + above_, v}, owner);
    }

    void add_lids(const plane::Tile& tile, bool front) {
        for (int f = 0; f < tile.n_faces(); ++f) {
            checkpoint_each(f);
            std::vector<int> points(tile.faces[f].begin(), tile.faces[f].end());
            if (front) {
                for (int& p : points) p += above_;
            } else {
                std::reverse(points.begin() + 1, points.end());
            }
            add(points, f);
        }
    }

   private:
    void add(const std::vector<int>& points, int owner) {
        mesh_.faces.add(points);
        mesh_.owner.push_back(owner);
    }

    FiniteVolumeMesh& mesh_;
    int above_;
};

void add_points(const plane::Tile& tile, double thickness, FiniteVolumeMesh& extruded) {
    if (thickness == 0) thickness = std::sqrt(tile.lattice.area() / tile.n_faces());
    for (const double z : {0.0, thickness}) {
        for (const plane::Vec2& p : tile.points) extruded.points.emplace_back(p.x(), p.y(), z);
    }
}

/// Adds the two patches of the pairs from `begin` to `end`, which share one offset.
void add_seam(const std::vector<plane::EdgePair>& pairs, std::size_t begin, std::size_t end,
              const plane::Lattice& lattice, const std::vector<Side>& sides,
              FiniteVolumeMesh& extruded) {
    const plane::Offset offset = pairs[begin].offset;
    const plane::Vec2 translation = lattice.translation(offset);
    add_seam_patches({offset.i, offset.j}, {translation.x(), translation.y(), 0},
                     {-translation.x(), -translation.y(), 0}, static_cast<int>(end - begin),
                     extruded);
    ExtrudedFaces faces(extruded);
    for (std::size_t k = begin; k < end; ++k) {
        faces.add_upright(pairs[k].v0, pairs[k].v1, face_beside(sides, pairs[k].v0, pairs[k].v1));
    }
    for (std::size_t k = begin; k < end; ++k) {
        faces.add_answering_upright(pairs[k].w1, pairs[k].w0,
                                    face_beside(sides, pairs[k].w1, pairs[k].w0));
    }
}

void add_seams(const plane::Tile& tile, const std::vector<Side>& sides,
               FiniteVolumeMesh& extruded) {
    std::vector<plane::EdgePair> pairs;
    for (const plane::EdgePair& pair : tile.edge_pairs) {
        pairs.push_back(pair.offset < plane::Offset{} ? pair.reversed() : pair);
    }
    std::sort(pairs.begin(), pairs.end(), [](const plane::EdgePair& s, const plane::EdgePair& t) {
        return std::tie(s.offset, s) < std::tie(t.offset, t);
    });
    for (std::size_t begin = 0; begin < pairs.size();) {
        std::size_t end = begin;
        while (end < pairs.size() && pairs[end].offset == pairs[begin].offset) ++end;
        add_seam(pairs, begin, end, tile.lattice, sides, extruded);
        begin = end;
    }
}

/// Adds one patch for each wall, whose edges follow each other in the tile.
void add_walls(const plane::Tile& tile, const std::vector<Side>& sides,
               FiniteVolumeMesh& extruded) {
    ExtrudedFaces faces(extruded);
    const plane::WallEdge* before = nullptr;
    for (const plane::WallEdge& edge : tile.wall_edges) {
        if (before == nullptr || before->wall != edge.wall) {
            extruded.patches.push_back({.name = wall_name(tile, edge.wall),
                                        .kind = PatchKind::kWall,
                                        .first_face = extruded.n_faces(),
                                        .n_faces = 0});
        }
        faces.add_upright(edge.v0, edge.v1, face_beside(sides, edge.v0, edge.v1));
        ++extruded.patches.back().n_faces;
        before = &edge;
    }
}

}  // namespace

FiniteVolumeMesh extruded_mesh(const plane::Tile& tile, double thickness) {
    FiniteVolumeMesh extruded{.n_cells = tile.n_faces()};
    add_points(tile, thickness, extruded);
    const std::vector<Side> sides = sides_by_edge(tile);
    ExtrudedFaces faces(extruded);
    for (const InnerEdge& edge : inner_edges(sides, tile.n_faces())) {
        faces.add_upright(edge.v, edge.w, edge.owner);
        extruded.neighbour.push_back(edge.neighbour);
    }
    add_seams(tile, sides, extruded);
    add_walls(tile, sides, extruded);
    for (const bool front : {false, true}) {
        extruded.patches.push_back({.name = std::string(front ? kFrontPatch : kBackPatch),
                                    .kind = PatchKind::kEmpty,
                                    .first_face = extruded.n_faces(),
                                    .n_faces = tile.n_faces()});
        faces.add_lids(tile, front);
    }
    return extruded;
}

}  // namespace pcvt
