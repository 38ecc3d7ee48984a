// Writes a tile, or a grid of the whole torus, in each format of the installed pcvt::io and reads
// it back.
#include "io/formats/formats.hpp"

#include <cstdio>
#include <optional>
#include <string>

#include "mesher/plane/cvt/cvt.hpp"
#include "mesher/plane/mesh/outline.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/search/lattice_pattern.hpp"
#include "mesher/plane/tile/tile_builder.hpp"

namespace plane = pcvt::plane;

namespace {

/// Formats of whole tori need acute triangles, as the best lattice has them.
void repeat_grid(const pcvt::Format& format, const plane::Lattice& lattice) {
    const auto points = plane::pattern_points(plane::best_lattice(lattice, 30));
    const auto result = plane::compute_cvt(lattice, points, {});
    const auto cells = plane::periodic_mesh(result.delaunay, plane::MeshKind::kVoronoi);
    const pcvt::Torus torus{cells, {0, 0}, {}};
    const auto files = std::get<pcvt::TorusWriter*>(format.write)(torus, {}, "grid");
    const pcvt::MpasGrid back = std::get<pcvt::GridReader*>(format.read)(files);
    std::printf("%s: %d cells\n", std::string(format.extension).c_str(), back.n_cells);
}

}  // namespace

int main() {
    const plane::Lattice lattice = plane::Lattice::rectangle(1, 1);
    const auto result = plane::compute_cvt(lattice, plane::uniform_points(lattice, 20, 1), {});
    // All formats support triangles.
    const auto mesh = plane::periodic_mesh(result.delaunay, plane::MeshKind::kDelaunay);
    const auto tile = plane::make_tile(mesh, plane::whole_outline(mesh, {0, 0}));
    for (const pcvt::Format& format : pcvt::formats()) {
        if (format.reads_grid()) repeat_grid(format, lattice);
        if (!format.needs_tile()) continue;
        const std::string extension(format.extension);
        const auto files = pcvt::encode_tile(format, tile, "tile" + extension);
        if (!format.is_readable()) continue;
        const pcvt::TileFile back = pcvt::decode_tile(format, files, std::nullopt);
        std::printf("%s: %d faces\n", extension.c_str(), back.tile.n_faces());
    }
}
