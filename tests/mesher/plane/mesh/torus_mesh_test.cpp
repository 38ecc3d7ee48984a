#include "mesher/plane/mesh/torus_mesh.hpp"

#include <gmock/gmock.h>

#include "tests/support/power_tiles.hpp"

namespace pcvt::plane {
namespace {

/// The parallelogram of the tests, with cells of each shape in it.
const Lattice kOblique({1, 0}, {0.37, 0.81});

struct Case {
    PeriodicDelaunay delaunay;
    TileOptions options;
};

std::vector<Case> cases() {
    std::vector<Case> all;
    all.push_back({PeriodicDelaunay(Sites(kOblique, uniform_points(kOblique, 40, 1))), {}});
    for (const testing::CellShape& shape : testing::cell_shapes()) {
        if (*shape.law == '\0') continue;
        Case c{testing::power_cells(kOblique, 40, 1, shape).delaunay, {}};
        if (!shape.metric.is_round()) c.options.elongation = Elongation{shape.metric, kOblique};
        all.push_back(std::move(c));
    }
    return all;
}

double total_area(const PeriodicMesh& mesh) {
    double area = 0;
    Polygon polygon;
    for (int f = 0; f < mesh.n_faces(); ++f) {
        face_polygon(mesh, f, polygon);
        area += polygon_area(polygon);
    }
    return area;
}

TEST(TorusMesh, EveryMeshFillsItsCopies) {
    for (auto& [delaunay, options] : cases()) {
        for (const MeshKindRow& row : kMeshKinds) {
            for (const Outline outline : {Outline::kWhole, Outline::kBox}) {
                if (outline == Outline::kBox && !row.box_outline) continue;
                options.kind = row.kind;
                options.outline = outline;
                options.repeat.columns = 2;
                const TorusMesh torus =
                    torus_mesh(domain_mesh(delaunay, options), delaunay, options);
                EXPECT_EQ(torus.is_cut(), outline == Outline::kBox);
                EXPECT_NEAR(total_area(torus.mesh), 2 * kOblique.area(), 1e-9);
                EXPECT_EQ(torus.weights.size(), delaunay.weights().size());
            }
        }
    }
}

TEST(TorusMesh, OnlyGrainsAndRemovedEdgesChangeTheCells) {
    for (auto& [delaunay, options] : cases()) {
        const PeriodicMesh domain = domain_mesh(delaunay, options);
        EXPECT_EQ(torus_mesh(domain, delaunay, options).mesh.vertices, domain.vertices);
        options.short_edges = 0.2;
        EXPECT_LT(torus_mesh(domain, delaunay, options).mesh.n_vertices(), domain.n_vertices());
    }
}

}  // namespace
}  // namespace pcvt::plane
