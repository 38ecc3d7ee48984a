// The library on one page: optimises 30 sites on an oblique torus, builds the tile of their cells
// and walks along its seam. Prints each identified pair of boundary edges once.
#include <cstdio>

#include "mesher/plane/cvt/cvt.hpp"
#include "mesher/plane/mesh/outline.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/tile/openmesh_tile.hpp"
#include "mesher/plane/tile/tile_builder.hpp"

namespace plane = pcvt::plane;

int main() {
    const plane::Lattice lattice({1, 0}, {0.37, 0.81});
    const plane::Points points = plane::uniform_points(lattice, 30, /*seed=*/7);

    const plane::CvtResult result = plane::compute_cvt(lattice, points, {});
    std::printf("energy %.9g, %.6f of the hexagonal bound, after %d evaluations\n",
                result.run.energy, result.run.energy / result.energy_bound, result.run.evaluations);

    const plane::PeriodicMesh cells =
        plane::periodic_mesh(result.delaunay, plane::MeshKind::kVoronoi);
    const plane::Tile arrays = plane::make_tile(cells, plane::whole_outline(cells, {0, 0}));
    const plane::OpenMeshTile any_tile = plane::openmesh_tile(arrays);
    const auto& tile = std::get<plane::CellTile>(any_tile);

    for (const auto halfedge : tile.mesh.halfedges()) {
        const int partner = tile.mesh.property(tile.identification.partner, halfedge);
        const auto offset = tile.mesh.property(tile.identification.partner_offset, halfedge);
        if (partner > halfedge.idx()) {
            std::printf("halfedge %d + (%d a, %d b) = halfedge %d\n", halfedge.idx(), offset[0],
                        offset[1], partner);
        }
    }
}
