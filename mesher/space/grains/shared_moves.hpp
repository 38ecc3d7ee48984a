#pragma once

#include <vector>

#include "mesher/base/workers.hpp"
#include "mesher/space/grains/cell_tetrahedra.hpp"

namespace pcvt::space {

/// A vertex of a cell that is an image of a node.
struct NodeUse {
    int cell;
    int vertex;
};

/// Raises the smallest sines at the faces of the cells, in all cells at a face or an edge at once:
/// flips edges of face triangles, moves nodes of faces in their plane and nodes of edges along
/// their edge. The surface and the hulls change with the cells.
///
/// Example usage:
///     SharedMoves shared(complex, surface, hulls, cells, workers);
///     shared.flip_edges();
///     shared.move_nodes();
///
/// Laws, tested by number:
///   (1) The laws of GrainSurface and of CellTetrahedra hold as before.
///   (2) The triangles of each hull remain those of its faces.
///   (3) The bytes do not depend on the number of threads: faces or edges that are changed at the
///       same time have no cell in common.
class SharedMoves {
   public:
    SharedMoves(const CellComplex& complex, GrainSurface& surface, std::vector<CellHull>& hulls,
                std::vector<CellTetrahedra>& cells, Workers& workers);

    void flip_edges();
    void move_nodes();

   private:
    using Groups = std::vector<std::vector<int>>;
    template <class Task>
    void for_each_of(const Groups& groups, const Task& task);

    const CellComplex& complex_;
    GrainSurface& surface_;
    std::vector<CellHull>& hulls_;
    std::vector<CellTetrahedra>& cells_;
    Workers& workers_;
    std::vector<std::vector<NodeUse>> uses_;
    /// The nodes in each face.
    std::vector<std::vector<int>> face_nodes_;
    /// Groups of faces, and of edges, without a common cell in a group.
    Groups faces_;
    Groups edges_;
};

}  // namespace pcvt::space
