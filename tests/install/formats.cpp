// Writes a tile in each format of the installed pcvt::io and reads it back.
#include <cstdio>
#include <optional>

#include "io/tile_formats.hpp"
#include "mesher/cvt/cvt.hpp"
#include "mesher/mesh/outline.hpp"
#include "mesher/mesh/voronoi.hpp"

int main() {
    const pcvt::Lattice lattice = pcvt::Lattice::rectangle(1, 1);
    const auto result = pcvt::compute_cvt(lattice, pcvt::uniform_points(lattice, 20, 1), {});
    // All formats support triangles.
    const auto mesh = pcvt::periodic_mesh(result.delaunay, pcvt::MeshKind::kDelaunay);
    const auto tile = pcvt::make_tile(mesh, pcvt::whole_outline(mesh, {0, 0}));
    for (const pcvt::TileFormat& format : pcvt::tile_formats()) {
        const auto files = pcvt::encode_tile(format, tile, "tile" + format.extension);
        if (format.decode == nullptr) continue;
        const pcvt::TileFile back = format.decode(files, std::nullopt);
        std::printf("%s: %d faces\n", format.extension.c_str(), back.tile.n_faces());
    }
}
