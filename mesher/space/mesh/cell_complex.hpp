#pragma once

#include <span>
#include <vector>

#include "mesher/space/delaunay/torus_tetrahedra.hpp"
#include "mesher/space/geometry/sites.hpp"

namespace pcvt::space {

/// An image of a vertex of the Voronoi diagram; the offset is in the reduced basis.
struct VertexImage {
    int vertex;
    Offset offset;

    friend constexpr auto operator<=>(const VertexImage&, const VertexImage&) = default;
};

/// The face between cell `cell` and the image of cell `neighbour` translated by `offset`.
struct CellFace {
    SiteId cell;
    SiteId neighbour;
    Offset offset;
};

/// The Voronoi diagram of the 3-torus: vertices and faces once for all their images.
///
/// Corners of cells within 1e-9 h of each other, h the mean spacing of the sites, are one vertex,
/// so that the cells of lattices (cospherical sites) have only the faces of their polyhedra.
///
/// Example usage:
///     const CellComplex complex = cell_complex(sites, tetrahedra);
///     for (int f = 0; f < complex.n_faces(); ++f) {
///         for (const VertexImage& corner : complex.corners_of(f)) use(complex.position(corner));
///     }
///
/// Laws, tested by number:
///   (1) Each face has at least three different corners, counter-clockwise seen from outside of its
///       cell, with the image of the cell whose site lies in the domain of the reduced basis.
///   (2) The faces of each cell close: each edge has two faces of the cell, in opposite directions.
///   (3) Each corner has the same distance from the sites of all cells that it belongs to.
struct CellComplex {
    Lattice reduced;
    int n_cells = 0;
    /// The sites of the cells in the domain of the reduced basis, length units.
    std::vector<Vec3> sites = {};
    /// The cell of each piece, ascending, where the cells of this complex are pieces inside of a
    /// box (mesher/space/box): `sites` then has the site of that cell in the frame of the piece.
    /// Empty for whole cells.
    std::vector<SiteId> piece_cell = {};
    /// Edges shorter than this part of h were removed (short_edges.hpp), and with them (3): faces
    /// are plane within this length. 0: none.
    double short_edges = 0;
    /// The positions of the vertices, length units.
    std::vector<Vec3> vertices = {};
    std::vector<CellFace> faces = {};
    /// Face f has the corners corners[begin[f]] ... corners[begin[f + 1] - 1].
    std::vector<int> begin = {0};
    std::vector<VertexImage> corners = {};

    int n_faces() const { return static_cast<int>(faces.size()); }
    SiteId site_of(int cell) const { return piece_cell.empty() ? cell : piece_cell[cell]; }
    std::span<const VertexImage> corners_of(int f) const {
        return {corners.data() + begin[f], corners.data() + begin[f + 1]};
    }
    Vec3 position(const VertexImage& image) const {
        return vertices[image.vertex] + reduced.translation(image.offset);
    }
};

/// Returns the dual of a periodic Delaunay triangulation, or with weights of a regular one: power
/// cells, for whose corners (3) holds with power distances.
/// @param weights  length^2, one a site; empty for Voronoi cells.
CellComplex cell_complex(const Sites& sites, const TorusTetrahedra& tetrahedra,
                         const Eigen::VectorXd& weights = {});

/// The volume of a cell, its centroid, and the integral of |p - centroid|^2 over it.
struct CellBody {
    double volume = 0;
    Vec3 centroid = Vec3::Zero();
    double moment = 0;
};

/// Adds up pyramids from one point over the faces of a cell, each as the fan of triangles from its
/// first corner.
///
/// Example usage:
///     PyramidSum sum(corners_of_face_0[0]);
///     sum.add(corners_of_face_0);
///     sum.add(corners_of_face_1);  // and so on
///     const double volume = sum.body().volume;
class PyramidSum {
   public:
    /// @param tip  on the cell or near to it.
    explicit PyramidSum(const Vec3& tip) : tip_(tip) {}

    /// @param corners  counter-clockwise seen from outside; clockwise with the sign -1.
    void add(std::span<const Vec3> corners, double sign = 1);
    CellBody body() const;

   private:
    Vec3 tip_;
    /// 6, 24 and 60 times the integrals of 1, p and |p|^2, relative to the tip.
    double volume_ = 0;
    Vec3 first_ = Vec3::Zero();
    double second_ = 0;
};

/// Returns the bodies of the cells, in the frame of their faces.
std::vector<CellBody> cell_bodies(const CellComplex& complex);

}  // namespace pcvt::space
