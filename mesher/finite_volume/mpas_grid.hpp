#pragma once

#include "mesher/mesh/periodic_mesh.hpp"

namespace pcvt {

/// The staggered mesh of an ocean or atmosphere model (MPAS): cells, their edges and the vertices
/// of the dual triangles on a rectangular torus, with the weights of the TRiSK scheme.
///
/// Tables are stored row by row: max_edges entries a cell, 2 max_edges an edge (edges_on_edge and
/// weights_on_edge), 2 an edge, 3 a vertex. Indices count from 0; -1 and the weight 0 fill rows up.
/// Points lie in [origin, origin + period); neighbours are meant at their nearest images.
///
/// Symbols: e an edge, n its normal from cell 1 to cell 2 of cells_on_edge, t = k x n the direction
/// from vertex 1 to vertex 2 of vertices_on_edge; d_e = dc_edge between the cells, l_e = dv_edge
/// between the vertices. Laws, proved by prove_mpas_grid under their numbers:
///   (1) n_edges = 3 n_cells, n_vertices = 2 n_cells, and the tables agree with each other:
///       edges_on_cell runs counter-clockwise, cells_on_cell lies across it, vertices_on_cell(j)
///       between edges j and j + 1; cells_on_vertex(j) between edges_on_vertex(j) and (j + 1);
///       edges_on_edge runs counter-clockwise round cell 1, then round cell 2, from e on.
///   (2) Lengths, angles and edge points follow from the points; n and t are orthogonal.
///   (3) Kites are positive and sum to the areas of their cell and triangle, and all to the area of
///       the domain.
///   (4) For any normal velocities u_e, with v_e = sum of weights times u (along t), the outflow of
///       v from each triangle is the divergence of u in the cells, weighted with the kites:
///       sum_e +-d_e v_e = sum_i kite_i / A_i sum_e +-l_e u_e
///       (J. Thuburn et al., J. Comput. Phys. 228, 2009, section 3).
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
    /// The density at the sites over its largest value there; 1 where it is uniform.
    std::vector<double> mesh_density;
};

/// The periods along x and y of a rectangular lattice, whatever basis it is given by.
/// @throws InvalidInput for any other one.
Vec2 rectangular_periods(const Lattice& lattice);

/// @param cells   Voronoi cells with their sites; the cell of face f has index f.
/// @param origin  corner of the domain in which the points are told.
/// @throws InvalidInput where the lattice is not rectangular, a Delaunay triangle is not acute (its
///         circumcentre would leave it, and its kites turn over; the worst is named), or neighbours
///         lie half a period apart, so that the nearest image is not the right one.
MpasGrid mpas_grid(const PeriodicMesh& cells, const Vec2& origin);

/// Tells the grid the density of each site, of which its cells are one copy or more: cell
/// k n_sites + i is one of site i.
void fill_mesh_density(const std::vector<double>& site_densities, MpasGrid& grid);

}  // namespace pcvt
