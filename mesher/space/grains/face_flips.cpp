#include "mesher/space/grains/face_flips.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "mesher/space/grains/cell_filling.hpp"
#include "mesher/space/grains/tetrahedron_flips.hpp"

namespace pcvt::space {
namespace {

constexpr double kFlipGain = 1e-6;
/// Both new triangles have at least this part of the area of an old one.
constexpr double kLeastArea = 1e-3;

/// An edge between two triangles of a face, in the frame of the face.
struct TriangleEdge {
    NodeImage low;
    NodeImage high;
    int triangle;
    NodeImage apex;
};

/// The edges of the triangles of a face, so that both triangles of an inner edge follow each other.
std::vector<TriangleEdge> triangle_edges(const std::vector<SurfaceTriangle>& triangles) {
    std::vector<TriangleEdge> edges;
    for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
        for (int k = 0; k < 3; ++k) {
            const auto [low, high] =
                std::minmax(triangles[t][(k + 1) % 3], triangles[t][(k + 2) % 3]);
            edges.push_back({low, high, t, triangles[t][k]});
        }
    }
    std::sort(edges.begin(), edges.end(), [](const TriangleEdge& e, const TriangleEdge& g) {
        return std::tie(e.low, e.high, e.triangle) < std::tie(g.low, g.high, g.triangle);
    });
    return edges;
}

/// The flips of edges in one face.
class FaceFlips {
   public:
    FaceFlips(const CellComplex& complex, GrainSurface& surface, const std::vector<CellHull>& hulls,
              std::vector<CellTetrahedra>& cells, int f)
        : complex_(complex),
          surface_(surface),
          triangles_(surface.triangles[f]),
          sides_{Side(hulls[complex.faces[f].cell], cells[complex.faces[f].cell], {}),
                 Side(hulls[complex.faces[f].neighbour], cells[complex.faces[f].neighbour],
                      complex.faces[f].offset)} {}

    void run() {
        const std::vector<TriangleEdge> edges = triangle_edges(triangles_);
        std::vector<char> touched(triangles_.size(), 0);
        for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
            const TriangleEdge& left = edges[k];
            const TriangleEdge& right = edges[k + 1];
            if (left.low != right.low || left.high != right.high) continue;
            if (touched[left.triangle] != 0 || touched[right.triangle] != 0) continue;
            if (!flip(left, right)) continue;
            touched[left.triangle] = touched[right.triangle] = 1;
        }
    }

   private:
    /// A cell of the face: its frame is that of the face without `shift`.
    struct Side {
        Side(const CellHull& its_hull, CellTetrahedra& its_cell, const Offset& its_shift)
            : hull(its_hull), cell(its_cell), shift(its_shift), flips(its_cell) {}

        bool find_ring(const std::array<NodeImage, 4>& corners) {
            for (std::size_t k = 0; k < 4; ++k) {
                vertices[k] = hull.find({corners[k].vertex, corners[k].offset - shift});
            }
            return flips.find_ring_on_hull(vertices[0], vertices[1], vertices[2], vertices[3],
                                           plan);
        }
        void carry_out() {
            const auto [a, b, c, d] = vertices;
            cell.replace(plan.old, plan.fresh,
                         {.gone = {{a, b, c}, {a, b, d}}, .come = {{c, d, a}, {c, d, b}}});
        }

        const CellHull& hull;
        CellTetrahedra& cell;
        Offset shift;
        TetrahedronFlips flips;
        std::array<int, 4> vertices = {};
        FlipPlan plan = {};
    };

    /// Whether the triangles (c, d, b) and (d, c, a) lie in the quadrilateral of (a, b, c) and
    /// (b, a, d).
    bool leaves_area(const std::array<NodeImage, 4>& corners) const {
        const auto at = [&](int k) { return surface_.position(complex_, corners[k]); };
        const auto area = [&](int p, int q, int r) {
            return cross_product(at(q) - at(p), at(r) - at(p));
        };
        const Vec3 old = area(0, 1, 2);
        const double least = kLeastArea * squared_length(old);
        return dot_product(area(2, 3, 1), old) > least && dot_product(area(3, 2, 0), old) > least;
    }

    /// Replaces the edge between two triangles by that between their apexes, if the smallest sine
    /// of the tetrahedra at it in both cells rises.
    bool flip(const TriangleEdge& left, const TriangleEdge& right) {
        // The triangle on the left is (a, b, c).
        NodeImage a = left.low;
        NodeImage b = left.high;
        const SurfaceTriangle& t = triangles_[left.triangle];
        for (int k = 0; k < 3; ++k) {
            if (t[k] == b && t[(k + 1) % 3] == a) std::swap(a, b);
        }
        const std::array<NodeImage, 4> corners{a, b, left.apex, right.apex};
        auto& [first, second] = sides_;
        if (!first.find_ring(corners) || !second.find_ring(corners)) return false;
        const double before = std::min(first.plan.before, second.plan.before);
        const double least = before + kFlipGain;
        if (before > kTargetSine || !leaves_area(corners)) return false;
        if (!first.flips.fill_ring_on_hull(least, first.plan) ||
            !second.flips.fill_ring_on_hull(least, second.plan)) {
            return false;
        }
        if (&first.cell == &second.cell) {
            // A cell that is its own neighbour: the two plans must not share a tetrahedron.
            const std::vector<int>& others = second.plan.old;
            for (const int s : first.plan.old) {
                if (std::find(others.begin(), others.end(), s) != others.end()) return false;
            }
        }
        // Plans name vertices, so the first one leaves the numbers of the second as they are,
        // except where both are of one cell: those that are alive keep their numbers.
        first.carry_out();
        second.carry_out();
        triangles_[left.triangle] = {a, right.apex, left.apex};
        triangles_[right.triangle] = {b, left.apex, right.apex};
        return true;
    }

    const CellComplex& complex_;
    GrainSurface& surface_;
    std::vector<SurfaceTriangle>& triangles_;
    std::array<Side, 2> sides_;
};

}  // namespace

void flip_face_edges(const CellComplex& complex, GrainSurface& surface,
                     const std::vector<CellHull>& hulls, std::vector<CellTetrahedra>& cells,
                     int face) {
    FaceFlips(complex, surface, hulls, cells, face).run();
}

}  // namespace pcvt::space
