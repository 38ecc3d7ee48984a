#pragma once

#include <array>

#include "mesher/plane/mesh/periodic_mesh.hpp"

namespace pcvt::plane {

/// A triangulation of the torus that contains the edges of the cells and is Delaunay inside each
/// cell.
///
/// Example usage:
///   GrainTriangulation grains(cells);
///   const auto [p, q, r] = grains.triangle(0);
///   grains.insert(0, (p + q + r) / 3);
///   const PeriodicMesh triangles = grains.mesh(cells);
///
/// Halfedge 3 t + k leaves corner k of triangle t; the corners are in counter-clockwise order. A
/// triangle has the frame of its cell, so positions are compared within one cell only. A cell edge
/// is split on both of its sides at once, so no seam has to be matched.
class GrainTriangulation {
   public:
    /// The kind of an edge. A free edge may be flipped, a cell edge may be split, and a firm edge
    /// is never changed. A firm edge is part of a cell edge or is a chord inside a cell.
    enum class Edge : char { kFree, kCell, kFirm };

    /// Triangulates the cells on their own corners.
    /// @throws InternalError if a cell is not a simple polygon.
    explicit GrainTriangulation(const PeriodicMesh& cells);

    static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
    static int previous(int h) { return h % 3 == 0 ? h + 2 : h - 1; }
    const Lattice& lattice() const { return lattice_; }
    int n_triangles() const { return static_cast<int>(cell_.size()); }
    int n_vertices() const { return static_cast<int>(vertices_.size()); }
    int n_halfedges() const { return static_cast<int>(corners_.size()); }
    /// Returns the face of the cells in which a triangle lies.
    int cell(int t) const { return cell_[t] < 0 ? -1 - cell_[t] : cell_[t]; }
    /// Whether the triangle is a guard or a part of one (corner_guards.hpp).
    bool is_guard(int t) const { return cell_[t] < 0; }
    int vertex(int h) const { return corners_[h].vertex; }
    /// Returns the position of the corner that h leaves, in the frame of its cell.
    const Vec2& point(int h) const { return corners_[h].point; }
    int opposite(int h) const { return opposite_[h]; }
    Edge edge(int h) const { return edge_[h]; }
    std::array<Vec2, 3> triangle(int t) const {
        return {point(3 * t), point(3 * t + 1), point(3 * t + 2)};
    }
    /// Returns the halfedge along the edge that corner c of the cells leaves. Valid before the
    /// first change only.
    int halfedge_of_corner(int c) const { return halfedge_of_corner_[c]; }

    /// Makes the triangle of h a guard with its tip at the start of h: its two sides become firm,
    /// and its chord becomes an edge of the given kind.
    void make_guard(int h, Edge chord);
    /// Inserts a vertex at the fraction `part` of h, on both sides of the edge, and restores the
    /// Delaunay property. Afterwards h leads to the new vertex.
    int split_edge(int h, double part);
    /// Inserts a vertex at p, strictly inside triangle t, and restores the Delaunay property.
    int insert(int t, const Vec2& p);
    /// Moves a vertex inside a cell to p, in the frame of the cell, and restores the Delaunay
    /// property.
    /// @param star  all halfedges that leave the vertex.
    void move(const std::vector<int>& star, const Vec2& p);
    /// Returns the triangles that the last change modified; a triangle may occur more than once.
    const std::vector<int>& touched() const { return touched_; }

    /// Returns the triangles as a mesh of the torus (`kGrains`), each with the site and the number
    /// of sides of its cell.
    PeriodicMesh mesh(const PeriodicMesh& cells) const;

   private:
    struct Corner {
        int vertex;
        Offset offset;
        Vec2 point;
    };

    int add_triangle(const Corner& a, const Corner& b, const Corner& c, int cell);
    void set_triangle(int t, const Corner& a, const Corner& b, const Corner& c);
    void link(int h, int o, Edge edge);
    void triangulate(const PeriodicMesh& cells, int f);
    void restore_delaunay(std::vector<int> suspects);
    bool must_flip(int h) const;
    void flip(int h);

    Lattice lattice_;
    std::vector<Vec2> vertices_;
    std::vector<Corner> corners_;
    std::vector<int> opposite_;
    std::vector<Edge> edge_;
    /// For each triangle, its face f of the cells, or -1 - f if it belongs to a guard.
    std::vector<int> cell_;
    std::vector<int> halfedge_of_corner_;
    std::vector<int> touched_;
};

}  // namespace pcvt::plane
