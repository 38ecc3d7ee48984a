#pragma once

#include <array>
#include <vector>

#include "mesher/base/workers.hpp"
#include "mesher/space/grains/cell_edges.hpp"

namespace pcvt::space {

/// A node of the faces, once for all its images.
struct SurfaceNode {
    Vec3 position;
    /// 0: a vertex of the cells, 1: inside of an edge, 2: inside of a face.
    int dimension;
    /// The number of that vertex, edge or face.
    int carrier;
};

/// An image of a node; the offset is in the reduced basis. VertexImage::vertex is the node.
using NodeImage = VertexImage;
using SurfaceTriangle = std::array<NodeImage, 3>;

/// The faces of the cells as triangles, each face once for both of its cells and all images.
///
/// Laws, tested by number:
///   (1) The triangles of a face are counter-clockwise seen from outside of its cell, cover it, and
///       lie in the frame of the face. Nodes of a plane face lie in its plane.
///   (2) Faces with a common edge share the nodes on it, which lie on that edge.
///   (3) The bytes do not depend on the number of threads.
struct GrainSurface {
    /// The vertices of the cells come first, in their order; then nodes of edges, then of faces.
    std::vector<SurfaceNode> nodes = {};
    /// For each face of the cells.
    std::vector<std::vector<SurfaceTriangle>> triangles = {};
    CellEdges edges = {};
    /// For each edge its inner nodes, in the frame of the edge: one for each cut.
    std::vector<std::vector<int>> edge_nodes = {};

    Vec3 position(const CellComplex& complex, const NodeImage& image) const {
        return nodes[image.vertex].position + complex.reduced.translation(image.offset);
    }
};

/// The plane of a face: a point of it, two unit vectors in it, and its outward normal.
struct FacePlane {
    Vec3 origin;
    Vec3 x;
    Vec3 y;
    Vec3 normal;
};

/// The plane normal to the vector area of a face.
FacePlane face_plane(const CellComplex& complex, int face);

/// Triangulates the faces of the cells.
///
/// Example usage:
///     const GrainSurface surface = grain_surface(complex, std::vector(n, size), workers);
///     for (const SurfaceTriangle& triangle : surface.triangles[face]) use(triangle);
///
/// @param cell_size  as cell_edges() takes it.
GrainSurface grain_surface(const CellComplex& complex, const std::vector<double>& cell_size,
                           Workers& workers);

}  // namespace pcvt::space
