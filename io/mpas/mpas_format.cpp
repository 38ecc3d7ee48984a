#include "io/mpas/mpas_format.hpp"

namespace pcvt {
namespace {

using Size = MpasSize;

MpasVariable indices(const char* name, Size rows, Size columns, std::vector<int> CGrid::*table) {
    return {name, rows, columns, table, nullptr, nullptr};
}
MpasVariable counts(const char* name, Size rows, std::vector<int> CGrid::*table) {
    return {name, rows, Size::kOne, nullptr, table, nullptr};
}
MpasVariable numbers(const char* name, Size rows, Size columns, std::vector<double> CGrid::*table) {
    return {name, rows, columns, nullptr, nullptr, table};
}
MpasVariable numbers(const char* name, Size rows, std::vector<double> CGrid::*table) {
    return numbers(name, rows, Size::kOne, table);
}

}  // namespace

const std::vector<MpasDimension>& mpas_dimensions() {
    static const std::vector<MpasDimension> dimensions{{"nCells", Size::kCells},
                                                       {"nEdges", Size::kEdges},
                                                       {"nVertices", Size::kVertices},
                                                       {"maxEdges", Size::kMaxEdges},
                                                       {"maxEdges2", Size::kMaxEdges2},
                                                       {"TWO", Size::kTwo},
                                                       {"vertexDegree", Size::kVertexDegree}};
    return dimensions;
}

int mpas_size(const CGrid& grid, MpasSize size) {
    switch (size) {
        case Size::kCells:
            return grid.n_cells;
        case Size::kEdges:
            return grid.n_edges;
        case Size::kVertices:
            return grid.n_vertices;
        case Size::kMaxEdges:
            return grid.max_edges;
        case Size::kMaxEdges2:
            return 2 * grid.max_edges;
        case Size::kTwo:
            return 2;
        case Size::kVertexDegree:
            return 3;
        case Size::kOne:
            break;
    }
    return 1;
}

const std::vector<MpasVariable>& mpas_variables() {
    static const std::vector<MpasVariable> variables{
        numbers("xCell", Size::kCells, &CGrid::x_cell),
        numbers("yCell", Size::kCells, &CGrid::y_cell),
        numbers("xEdge", Size::kEdges, &CGrid::x_edge),
        numbers("yEdge", Size::kEdges, &CGrid::y_edge),
        numbers("xVertex", Size::kVertices, &CGrid::x_vertex),
        numbers("yVertex", Size::kVertices, &CGrid::y_vertex),
        counts("nEdgesOnCell", Size::kCells, &CGrid::n_edges_on_cell),
        counts("nEdgesOnEdge", Size::kEdges, &CGrid::n_edges_on_edge),
        indices("cellsOnCell", Size::kCells, Size::kMaxEdges, &CGrid::cells_on_cell),
        indices("edgesOnCell", Size::kCells, Size::kMaxEdges, &CGrid::edges_on_cell),
        indices("verticesOnCell", Size::kCells, Size::kMaxEdges, &CGrid::vertices_on_cell),
        indices("cellsOnEdge", Size::kEdges, Size::kTwo, &CGrid::cells_on_edge),
        indices("verticesOnEdge", Size::kEdges, Size::kTwo, &CGrid::vertices_on_edge),
        indices("edgesOnEdge", Size::kEdges, Size::kMaxEdges2, &CGrid::edges_on_edge),
        numbers("weightsOnEdge", Size::kEdges, Size::kMaxEdges2, &CGrid::weights_on_edge),
        indices("cellsOnVertex", Size::kVertices, Size::kVertexDegree, &CGrid::cells_on_vertex),
        indices("edgesOnVertex", Size::kVertices, Size::kVertexDegree, &CGrid::edges_on_vertex),
        numbers("kiteAreasOnVertex", Size::kVertices, Size::kVertexDegree,
                &CGrid::kite_areas_on_vertex),
        numbers("areaCell", Size::kCells, &CGrid::area_cell),
        numbers("areaTriangle", Size::kVertices, &CGrid::area_triangle),
        numbers("dcEdge", Size::kEdges, &CGrid::dc_edge),
        numbers("dvEdge", Size::kEdges, &CGrid::dv_edge),
        numbers("angleEdge", Size::kEdges, &CGrid::angle_edge),
        numbers("meshDensity", Size::kCells, &CGrid::mesh_density)};
    return variables;
}

}  // namespace pcvt
