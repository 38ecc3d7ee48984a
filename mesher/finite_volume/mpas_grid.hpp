#pragma once

#include <optional>
#include <span>

#include "mesher/base/error.hpp"
#include "mesher/plane/mesh/periodic_mesh.hpp"

namespace pcvt {

/// The Coriolis parameter f + beta y of a plane that turns, and of a beta plane.
struct Coriolis {
    /// 1 / s.
    double f = 0;
    /// 1 / (s length).
    double beta = 0;

    double at(double y) const { return f + beta * y; }
    friend bool operator==(const Coriolis&, const Coriolis&) = default;
};

/// The staggered mesh of an ocean or atmosphere model (MPAS): cells, their edges and the vertices
/// of the dual triangles on a rectangular torus, with the weights of the TRiSK scheme.
///
/// Tables are stored row by row. A row has max_edges entries for a cell and 3 for a vertex. For an
/// edge it has 2 max_edges entries in edges_on_edge and weights_on_edge, and 2 in the other tables.
/// Indices count from 0; unused entries are -1, or 0 for weights. Points lie in [origin, origin +
/// period); every neighbour is the nearest image.
///
/// Symbols: e is an edge, n its normal from cell 1 to cell 2 of cells_on_edge, and t = k x n the
/// direction from vertex 1 to vertex 2 of vertices_on_edge. d_e = dc_edge is the distance of the
/// cells, l_e = dv_edge the distance of the vertices. Laws, proved by prove_mpas_grid under their
/// numbers:
///   (1) n_edges = 3 n_cells, n_vertices = 2 n_cells, and the tables agree with each other:
///       edges_on_cell runs counter-clockwise, cells_on_cell lies across it, vertices_on_cell(j)
///       between edges j and j + 1; cells_on_vertex(j) between edges_on_vertex(j) and (j + 1);
///       edges_on_edge runs counter-clockwise around cell 1, then around cell 2, starting after e.
///   (2) Lengths, angles and edge points follow from the points; n and t are orthogonal.
///   (3) The kites are positive. The kites of a cell or of a triangle sum to its area, and all
///       kites to the area of the domain.
///   (4) For any normal velocities u_e, let v_e be the sum of weights times u (along t). The
///       outflow of v from each triangle is the divergence of u in the cells, weighted with the
///       kites:
///       sum_e +-d_e v_e = sum_i kite_i / A_i sum_e +-l_e u_e
///       (J. Thuburn et al., J. Comput. Phys. 228, 2009, section 3).
///   (5) mesh_density lies above 0, its largest value is 1, and its mean over the area is the
///       stated one.
///   (6) The Coriolis parameter is f + beta y at cells, edges and vertices, y as the tables have
///   it.
struct MpasGrid {
    double x_period;
    double y_period;
    int n_cells;
    int n_edges;
    int n_vertices;
    int max_edges;

    std::vector<double> x_cell, y_cell, x_edge, y_edge, x_vertex, y_vertex;
    std::vector<int> n_edges_on_cell, n_edges_on_edge;
    std::vector<int> cells_on_cell, edges_on_cell, vertices_on_cell;
    std::vector<int> cells_on_edge, vertices_on_edge, edges_on_edge;
    std::vector<int> cells_on_vertex, edges_on_vertex;
    std::vector<double> weights_on_edge, kite_areas_on_vertex;
    std::vector<double> area_cell, area_triangle, dc_edge, dv_edge, angle_edge;
    /// The density at the sites relative to its largest value there; 1 if it is uniform.
    std::vector<double> mesh_density;
    /// The mean of mesh_density over the area, as a file states it; nullopt: not stated.
    std::optional<double> stated_mean_density;
    /// As stated; nullopt: no Coriolis parameter.
    std::optional<Coriolis> coriolis;
    /// 1 / s; empty without one.
    std::vector<double> f_cell, f_edge, f_vertex;
};

/// Returns the mean of mesh_density over the area.
double mean_density(const MpasGrid& grid);

/// Returns the periods along x and y of a rectangular lattice, given in any basis.
/// @throws InvalidInput for any other lattice.
plane::Vec2 rectangular_periods(const plane::Lattice& lattice);

/// The cells of these sites do not suit an output; the cells of other sites may.
class UnsuitableCells : public InvalidInput {
   public:
    using InvalidInput::InvalidInput;
};

/// Builds the staggered mesh of Voronoi cells.
///
/// Example usage:
///   const MpasGrid grid = mpas_grid(cell_mesh(delaunay), {0, 0});
///   const MpasGridProof proof = prove_mpas_grid(grid);
///
/// @param cells   Voronoi cells with their sites; the cell of face f has index f.
/// @param origin  corner of the domain that contains the points.
/// @throws UnsuitableCells if a Delaunay triangle is not acute: its circumcentre would lie outside
///         it, and a kite would be negative. The message names the worst triangle.
/// @throws InvalidInput if the lattice is not rectangular, or if the distance of neighbours is half
///         a period, so that the nearest image is ambiguous.
MpasGrid mpas_grid(const plane::PeriodicMesh& cells, const plane::Vec2& origin);

/// Sets the Coriolis parameter of cells, edges and vertices from their positions.
void fill_coriolis(const Coriolis& coriolis, MpasGrid& grid);

/// Sets mesh_density from the density of each site. The grid may contain several copies of the
/// sites: cell k n_sites + i belongs to site i.
void fill_mesh_density(std::span<const double> site_densities, MpasGrid& grid);

}  // namespace pcvt
