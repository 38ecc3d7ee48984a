#include "io/surfaces/surface_om_writer.hpp"

#include "io/graphics/om_encoder.hpp"
#include "mesher/space/tile/openmesh_surface.hpp"

namespace pcvt {

std::vector<EncodedFile> encode_surface_om(const space::TileSurface& surface,
                                           const std::string& path) {
    return only_file(path, encode_om_mesh(openmesh_surface(surface).mesh, path));
}

}  // namespace pcvt
