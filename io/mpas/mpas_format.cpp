#include "io/mpas/mpas_format.hpp"

namespace pcvt {
namespace {

using Size = MpasSize;

/// The dimensions of a variable: of one column without `columns`.
struct Shape {
    Size rows;
    Size columns = Size::kOne;
};

/// A variable without its table.
MpasVariable variable(const char* name, Shape shape, const char* units, const char* long_name) {
    return {.name = name,
            .rows = shape.rows,
            .columns = shape.columns,
            .units = units,
            .long_name = long_name};
}
MpasVariable indices(const char* name, Shape shape, const char* long_name,
                     std::vector<int> MpasGrid::*table) {
    MpasVariable result = variable(name, shape, "unitless", long_name);
    result.indices = table;
    return result;
}
MpasVariable counts(const char* name, Shape shape, const char* long_name,
                    std::vector<int> MpasGrid::*table) {
    MpasVariable result = variable(name, shape, "unitless", long_name);
    result.counts = table;
    return result;
}
MpasVariable numbers(const char* name, Shape shape, const char* units, const char* long_name,
                     std::vector<double> MpasGrid::*table) {
    MpasVariable result = variable(name, shape, units, long_name);
    result.numbers = table;
    return result;
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

const std::vector<MpasPlain>& mpas_plain_variables() {
    static const std::vector<MpasPlain> variables = [] {
        std::vector<MpasPlain> all;
        const auto append = [&](const std::string& word, const std::string& plural, Size rows) {
            all.push_back({"lat" + word, rows, false, "rad", "latitude of " + plural});
            all.push_back({"lon" + word, rows, false, "rad", "longitude of " + plural});
            all.push_back({"z" + word, rows, false, "m", "coordinate z of " + plural});
            all.push_back({"indexTo" + word + "ID", rows, true, "unitless", "ids of " + plural});
        };
        append("Cell", "cells", Size::kCells);
        append("Edge", "edges", Size::kEdges);
        append("Vertex", "vertices", Size::kVertices);
        return all;
    }();
    return variables;
}

const std::vector<MpasVariable>& mpas_variables() {
    constexpr Shape cells{Size::kCells};
    constexpr Shape edges{Size::kEdges};
    constexpr Shape vertices{Size::kVertices};
    constexpr Shape on_cell{Size::kCells, Size::kMaxEdges};
    constexpr Shape on_edge{Size::kEdges, Size::kTwo};
    constexpr Shape around_edge{Size::kEdges, Size::kMaxEdges2};
    constexpr Shape on_vertex{Size::kVertices, Size::kVertexDegree};
    using Grid = MpasGrid;
    static const std::vector<MpasVariable> variables{
        numbers("xCell", cells, "m", "coordinate x of cells", &Grid::x_cell),
        numbers("yCell", cells, "m", "coordinate y of cells", &Grid::y_cell),
        numbers("xEdge", edges, "m", "coordinate x of edges", &Grid::x_edge),
        numbers("yEdge", edges, "m", "coordinate y of edges", &Grid::y_edge),
        numbers("xVertex", vertices, "m", "coordinate x of vertices", &Grid::x_vertex),
        numbers("yVertex", vertices, "m", "coordinate y of vertices", &Grid::y_vertex),
        counts("nEdgesOnCell", cells, "number of edges of each cell", &Grid::n_edges_on_cell),
        counts("nEdgesOnEdge", edges, "number of edges that reconstruct the tangential velocity",
               &Grid::n_edges_on_edge),
        indices("cellsOnCell", on_cell, "cells that neighbour each cell", &Grid::cells_on_cell),
        indices("edgesOnCell", on_cell, "edges of each cell", &Grid::edges_on_cell),
        indices("verticesOnCell", on_cell, "vertices of each cell", &Grid::vertices_on_cell),
        indices("cellsOnEdge", on_edge, "cells on both sides of each edge", &Grid::cells_on_edge),
        indices("verticesOnEdge", on_edge, "vertices at the ends of each edge",
                &Grid::vertices_on_edge),
        indices("edgesOnEdge", around_edge, "edges that reconstruct the tangential velocity",
                &Grid::edges_on_edge),
        numbers("weightsOnEdge", around_edge, "unitless",
                "weights of the edges that reconstruct the tangential velocity",
                &Grid::weights_on_edge),
        indices("cellsOnVertex", on_vertex, "cells at each vertex", &Grid::cells_on_vertex),
        indices("edgesOnVertex", on_vertex, "edges at each vertex", &Grid::edges_on_vertex),
        numbers("kiteAreasOnVertex", on_vertex, "m^2",
                "areas of the parts of each dual cell in its cells", &Grid::kite_areas_on_vertex),
        numbers("areaCell", cells, "m^2", "area of each cell", &Grid::area_cell),
        numbers("areaTriangle", vertices, "m^2", "area of each dual cell", &Grid::area_triangle),
        numbers("dcEdge", edges, "m", "distance between the cells of each edge", &Grid::dc_edge),
        numbers("dvEdge", edges, "m", "length of each edge", &Grid::dv_edge),
        numbers("angleEdge", edges, "rad", "angle from x to the normal of each edge",
                &Grid::angle_edge),
        numbers("meshDensity", cells, "unitless", "density of the mesh over its largest value",
                &Grid::mesh_density),
        numbers("fCell", cells, "s^{-1}", "Coriolis parameter at cells", &Grid::f_cell),
        numbers("fEdge", edges, "s^{-1}", "Coriolis parameter at edges", &Grid::f_edge),
        numbers("fVertex", vertices, "s^{-1}", "Coriolis parameter at vertices", &Grid::f_vertex)};
    return variables;
}

bool is_coriolis(const MpasVariable& variable) {
    return variable.numbers == &MpasGrid::f_cell || variable.numbers == &MpasGrid::f_edge ||
           variable.numbers == &MpasGrid::f_vertex;
}

}  // namespace pcvt
