#include "mesher/space/mesh/boundary_surface.hpp"

#include <algorithm>
#include <tuple>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/disjoint_sets.hpp"

namespace pcvt::space {
namespace {

/// A side of a boundary face, by its edge; `corner` is the index of its first corner in the list of
/// corners, `next` that of its second.
struct Side {
    int low;
    int high;
    int corner;
    int next;
};

std::vector<Side> boundary_sides(const PolyhedralMesh& mesh) {
    std::vector<Side> sides;
    for (int f = mesh.n_inner_faces(); f < mesh.n_faces(); ++f) {
        const int begin = mesh.faces.begin[f];
        const int n = mesh.faces.size(f);
        for (int k = 0; k < n; ++k) {
            const int corner = begin + k;
            const int next = begin + (k + 1) % n;
            const auto [low, high] =
                std::minmax(mesh.faces.corners[corner], mesh.faces.corners[next]);
            sides.push_back({low, high, corner, next});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& s, const Side& t) {
        return std::tie(s.low, s.high, s.corner) < std::tie(t.low, t.high, t.corner);
    });
    return sides;
}

}  // namespace

bool boundary_is_manifold(const PolyhedralMesh& mesh) {
    const std::vector<Side> sides = boundary_sides(mesh);
    // Corners of faces at one point belong to one fan if they share an edge there.
    DisjointSets fans(static_cast<int>(mesh.faces.corners.size()));
    for (std::size_t k = 0; k < sides.size(); k += 2) {
        checkpoint_each(static_cast<long>(k));
        const auto same = [&](std::size_t m) {
            return m < sides.size() && sides[m].low == sides[k].low &&
                   sides[m].high == sides[k].high;
        };
        if (!same(k + 1) || same(k + 2)) return false;
        // The two sides run in opposite directions.
        fans.unite(sides[k].corner, sides[k + 1].next);
        fans.unite(sides[k].next, sides[k + 1].corner);
    }
    std::vector<int> fan_of(mesh.points.size(), -1);
    for (int c = mesh.faces.begin[mesh.n_inner_faces()]; c < mesh.faces.begin.back(); ++c) {
        int& fan = fan_of[mesh.faces.corners[c]];
        if (fan < 0) fan = fans.find(c);
        if (fan != fans.find(c)) return false;
    }
    return true;
}

}  // namespace pcvt::space
