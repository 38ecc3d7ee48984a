#pragma once

#include <array>

#include "mesher/mesh/periodic_mesh.hpp"

namespace pcvt {

/// A triangulation of the torus that keeps the edges of cells and is Delaunay inside of each cell.
///
/// Halfedge 3 t + k leaves corner k of triangle t; the corners run counter-clockwise. A triangle
/// stands in the frame of its cell, so positions are compared within a cell only, and a cell edge
/// is split on both of its sides at once: on the torus there is no seam to be matched.
class GrainTriangulation {
   public:
    /// What an edge is: free edges may be flipped, cell edges may be split, firm ones stay. A firm
    /// edge is a cell edge or a chord inside of a cell.
    enum class Edge : char { kFree, kCell, kFirm };

    /// The cells, triangulated on their own corners.
    /// @throws InternalError if a cell is no simple polygon.
    explicit GrainTriangulation(const PeriodicMesh& cells);

    static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
    static int previous(int h) { return h % 3 == 0 ? h + 2 : h - 1; }
    const Lattice& lattice() const { return lattice_; }
    int n_triangles() const { return static_cast<int>(cell_.size()); }
    int n_vertices() const { return static_cast<int>(vertices_.size()); }
    int n_halfedges() const { return static_cast<int>(corners_.size()); }
    /// The face of the cells in which a triangle lies.
    int cell(int t) const { return cell_[t] < 0 ? -1 - cell_[t] : cell_[t]; }
    /// Whether the triangle is a guard or a part of one (corner_guards.hpp).
    bool is_guard(int t) const { return cell_[t] < 0; }
    int vertex(int h) const { return corners_[h].vertex; }
    /// Of the corner that h leaves, in the frame of its cell.
    const Vec2& point(int h) const { return corners_[h].point; }
    int opposite(int h) const { return opposite_[h]; }
    Edge edge(int h) const { return edge_[h]; }
    std::array<Vec2, 3> triangle(int t) const {
        return {point(3 * t), point(3 * t + 1), point(3 * t + 2)};
    }
    /// The halfedge along the edge that corner c of the cells leaves, before the first change.
    int halfedge_of_corner(int c) const { return halfedge_of_corner_[c]; }

    /// Makes the triangle of h a guard with its tip where h starts: its sides become firm, and its
    /// chord the kind of edge that is given.
    void make_guard(int h, Edge chord);
    /// Puts a vertex at the part `part` of the way along h, on both sides of the edge, and restores
    /// Delaunay. h then leads to it.
    int split_edge(int h, double part);
    /// Puts a vertex at p, strictly inside of triangle t, and restores Delaunay.
    int insert(int t, const Vec2& p);
    /// Moves a vertex inside of a cell, in the cell's frame, with the triangles round it, and
    /// restores Delaunay.
    /// @param star  the halfedges that leave the vertex.
    void move(const std::vector<int>& star, const Vec2& p);
    /// Triangles that the last change has touched, each once or more.
    const std::vector<int>& touched() const { return touched_; }

    /// The triangles as a mesh of the torus (`kGrains`), with the sites of their cells.
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
    /// The face f of the cells, or -1 - f in a guard.
    std::vector<int> cell_;
    std::vector<int> halfedge_of_corner_;
    std::vector<int> touched_;
};

}  // namespace pcvt
