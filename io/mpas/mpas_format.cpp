#include "io/mpas/mpas_format.hpp"

namespace pcvt {
namespace {

using Size = MpasSize;

MpasVariable indices(const char* name, Size rows, Size columns, std::vector<int> MpasGrid::*table) {
    return {.name = name, .rows = rows, .columns = columns, .indices = table};
}
MpasVariable counts(const char* name, Size rows, std::vector<int> MpasGrid::*table) {
    return {.name = name, .rows = rows, .columns = Size::kOne, .counts = table};
}
MpasVariable numbers(const char* name, Size rows, Size columns,
                     std::vector<double> MpasGrid::*table) {
    return {.name = name, .rows = rows, .columns = columns, .numbers = table};
}
MpasVariable numbers(const char* name, Size rows, std::vector<double> MpasGrid::*table) {
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

int mpas_size(const MpasGrid& grid, MpasSize size) {
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
        numbers("xCell", Size::kCells, &MpasGrid::x_cell),
        numbers("yCell", Size::kCells, &MpasGrid::y_cell),
        numbers("xEdge", Size::kEdges, &MpasGrid::x_edge),
        numbers("yEdge", Size::kEdges, &MpasGrid::y_edge),
        numbers("xVertex", Size::kVertices, &MpasGrid::x_vertex),
        numbers("yVertex", Size::kVertices, &MpasGrid::y_vertex),
        counts("nEdgesOnCell", Size::kCells, &MpasGrid::n_edges_on_cell),
        counts("nEdgesOnEdge", Size::kEdges, &MpasGrid::n_edges_on_edge),
        indices("cellsOnCell", Size::kCells, Size::kMaxEdges, &MpasGrid::cells_on_cell),
        indices("edgesOnCell", Size::kCells, Size::kMaxEdges, &MpasGrid::edges_on_cell),
        indices("verticesOnCell", Size::kCells, Size::kMaxEdges, &MpasGrid::vertices_on_cell),
        indices("cellsOnEdge", Size::kEdges, Size::kTwo, &MpasGrid::cells_on_edge),
        indices("verticesOnEdge", Size::kEdges, Size::kTwo, &MpasGrid::vertices_on_edge),
        indices("edgesOnEdge", Size::kEdges, Size::kMaxEdges2, &MpasGrid::edges_on_edge),
        numbers("weightsOnEdge", Size::kEdges, Size::kMaxEdges2, &MpasGrid::weights_on_edge),
        indices("cellsOnVertex", Size::kVertices, Size::kVertexDegree, &MpasGrid::cells_on_vertex),
        indices("edgesOnVertex", Size::kVertices, Size::kVertexDegree, &MpasGrid::edges_on_vertex),
        numbers("kiteAreasOnVertex", Size::kVertices, Size::kVertexDegree,
                &MpasGrid::kite_areas_on_vertex),
        numbers("areaCell", Size::kCells, &MpasGrid::area_cell),
        numbers("areaTriangle", Size::kVertices, &MpasGrid::area_triangle),
        numbers("dcEdge", Size::kEdges, &MpasGrid::dc_edge),
        numbers("dvEdge", Size::kEdges, &MpasGrid::dv_edge),
        numbers("angleEdge", Size::kEdges, &MpasGrid::angle_edge),
        numbers("meshDensity", Size::kCells, &MpasGrid::mesh_density)};
    return variables;
}

}  // namespace pcvt
