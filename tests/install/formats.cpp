// Writes a tile in each format of the installed pcvt::io and reads it back.
#include <cstdio>
#include <optional>
#include <string>

#include "io/tile_formats.hpp"
#include "mesher/cvt/cvt.hpp"
#include "mesher/mesh/outline.hpp"
#include "mesher/mesh/voronoi.hpp"
#include "mesher/tile/tile_builder.hpp"

int main() {
    const pcvt::Lattice lattice = pcvt::Lattice::rectangle(1, 1);
    const auto result = pcvt::compute_cvt(lattice, pcvt::uniform_points(lattice, 20, 1), {});
    // All formats support triangles.
    const auto mesh = pcvt::periodic_mesh(result.delaunay, pcvt::MeshKind::kDelaunay);
    const auto tile = pcvt::make_tile(mesh, pcvt::whole_outline(mesh, {0, 0}));
    for (const pcvt::TileFormat& format : pcvt::tile_formats()) {
        if (!format.needs_tile()) continue;
        const std::string extension(format.extension);
        const auto files = pcvt::encode_tile(format, tile, "tile" + extension);
        if (!format.is_readable()) continue;
        const pcvt::TileFile back = pcvt::decode_tile(format, files, std::nullopt);
        std::printf("%s: %d faces\n", extension.c_str(), back.tile.n_faces());
    }
}
