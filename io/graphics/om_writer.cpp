#include "io/graphics/om_writer.hpp"

#include "io/forms/finite.hpp"
#include "io/graphics/om_encoder.hpp"
#include "mesher/plane/tile/openmesh_tile.hpp"
#include "mesher/space/tile/openmesh_surface.hpp"

namespace pcvt {

std::vector<EncodedFile> encode_om(const plane::Tile& tile, const std::string& path) {
    require_finite(tile);
    return only_file(path,
                     std::visit([&](const auto& any) { return encode_om_mesh(any.mesh, path); },
                                openmesh_tile(tile)));
}

std::vector<EncodedFile> encode_om_boundary(const space::TileSurface& surface,
                                            const std::string& path) {
    return only_file(path, encode_om_mesh(openmesh_surface(surface).mesh, path));
}

}  // namespace pcvt
