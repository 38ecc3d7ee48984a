#pragma once

#include <utility>
#include <vector>

#include "mesher/space/grains/cell_tetrahedra.hpp"
#include "mesher/space/grains/tetrahedron_flips.hpp"

namespace pcvt::space {

/// Raises the smallest sines at the faces of the cells, in all cells at a face or an edge at once:
/// flips edges of face triangles, moves nodes of faces in their plane and nodes of edges along
/// their edge. The surface and the hulls change with the cells.
///
/// Example usage:
///     SharedMoves shared(complex, surface, hulls, cells);
///     shared.flip_edges();
///     shared.move_nodes();
///
/// Laws, tested by number:
///   (1) The laws of GrainSurface and of CellTetrahedra hold as before.
///   (2) The triangles of each hull remain those of its faces.
class SharedMoves {
   public:
    SharedMoves(const CellComplex& complex, GrainSurface& surface, std::vector<CellHull>& hulls,
                std::vector<CellTetrahedra>& cells);

    void flip_edges();
    void move_nodes();

   private:
    /// An image of a node: a cell, and the vertex there.
    struct Use {
        int cell;
        int vertex;
    };
    /// An edge between two triangles of a face, in the frame of the face.
    struct FaceEdge {
        NodeImage low;
        NodeImage high;
        int triangle;
        NodeImage apex;
    };

    std::vector<FaceEdge> face_edges(int f) const;
    void flip_face(int f);
    bool flip(int f, const FaceEdge& left, const FaceEdge& right);
    bool leaves_area(const NodeImage& a, const NodeImage& b, const NodeImage& c,
                     const NodeImage& d) const;
    bool plan(int cell, const Offset& shift, const std::array<NodeImage, 4>& corners,
              FlipPlan& plan);
    void carry_out(int cell, const Offset& shift, const std::array<NodeImage, 4>& corners,
                   const FlipPlan& plan);
    bool move(int node);
    void collect_stars(int node);
    double worst_with(int node, const Vec3& at, double least);
    void place(int node, const Vec3& at);
    std::vector<Vec3> directions(int node) const;

    const CellComplex& complex_;
    GrainSurface& surface_;
    std::vector<CellHull>& hulls_;
    std::vector<CellTetrahedra>& cells_;
    std::vector<std::vector<Use>> uses_;
    /// The tetrahedra round all images of a node: quality, cell, number.
    struct Around {
        double quality;
        int cell;
        int tetrahedron;
    };
    std::vector<Around> around_;
    std::vector<int> star_;
    FlipPlan first_;
    FlipPlan second_;
};

}  // namespace pcvt::space
