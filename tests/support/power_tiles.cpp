#include "tests/support/power_tiles.hpp"

#include "mesher/cells/target_areas.hpp"

namespace pcvt::testing {

std::vector<CellShape> cell_shapes() {
    return {{"power", "lognormal:0.42"},
            {"elongated", "", plane::Metric(3, 30)},
            {"elongated power", "gamma:0.3", plane::Metric(0.4, -77.25)}};
}

plane::AreaCvtResult power_cells(const plane::Lattice& lattice, int n, int seed,
                                 const CellShape& shape, int centroidal_steps) {
    const plane::Lattice round = shape.metric.to_round(lattice);
    const plane::Points points = shape.metric.to_round(uniform_points(lattice, n, seed));
    const AreaLaw law = parse_area_law(*shape.law == '\0' ? "equal" : shape.law);
    return compute_area_cvt(round, points,
                            {.areas = scaled_areas(draw_areas(law, n, seed), n, lattice.area()),
                             .run = {.max_iterations = centroidal_steps}});
}

plane::Tile power_tile(const plane::Lattice& lattice, int n, int seed, const CellShape& shape,
                       plane::TileOptions options, int centroidal_steps) {
    if (!shape.metric.is_round()) options.elongation = plane::Elongation{shape.metric, lattice};
    if (*shape.law == '\0') {
        const plane::Points points = shape.metric.to_round(uniform_points(lattice, n, seed));
        const plane::Sites sites(shape.metric.to_round(lattice), points);
        return build_tile(plane::PeriodicDelaunay(sites), options).tile;
    }
    const plane::AreaCvtResult cells = power_cells(lattice, n, seed, shape, centroidal_steps);
    return build_tile(cells.delaunay, options).tile;
}

std::vector<plane::TileOptions> tile_kinds() {
    std::vector<plane::TileOptions> kinds;
    const auto add = [&kinds](plane::MeshKind kind, plane::Outline outline,
                              int columns) -> plane::TileOptions& {
        plane::TileOptions& options = kinds.emplace_back();
        options.kind = kind;
        options.outline = outline;
        options.repeat.columns = columns;
        return options;
    };
    for (const int columns : {1, 2}) {
        for (const plane::Outline outline : {plane::Outline::kWhole, plane::Outline::kBox}) {
            add(plane::MeshKind::kVoronoi, outline, columns);
            add(plane::MeshKind::kGrains, outline, columns);
            plane::TileOptions& second_order = add(plane::MeshKind::kGrains, outline, columns);
            second_order.grain_per_edge = 1;
            second_order.order = 2;
            second_order.repeat.rows = 2;
        }
        add(plane::MeshKind::kDelaunay, plane::Outline::kWhole, columns);
    }
    add(plane::MeshKind::kVoronoi, plane::Outline::kWhole, 1).short_edges = 0.2;
    return kinds;
}

}  // namespace pcvt::testing
