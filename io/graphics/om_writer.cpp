// OpenMesh requires its readers and writers to be included before any mesh.
// clang-format off
#include <OpenMesh/Core/IO/MeshIO.hh>
// clang-format on

#include "io/graphics/om_writer.hpp"

#include <sstream>

#include "io/bytes/openmesh_netcdf_mutex.hpp"
#include "io/tiles/finite.hpp"
#include "mesher/base/error.hpp"
#include "mesher/tile/openmesh_tile.hpp"

namespace pcvt {
namespace {

/// Silences OpenMesh, which prints byte counts to std::clog and errors to std::cerr: a library
/// prints nothing.
class SilentOpenMesh {
   public:
    SilentOpenMesh() : log_(omlog().is_enabled()), errors_(omerr().is_enabled()) {
        omlog().disable();
        omerr().disable();
    }
    ~SilentOpenMesh() {
        if (log_) omlog().enable();
        if (errors_) omerr().enable();
    }
    SilentOpenMesh(const SilentOpenMesh&) = delete;
    SilentOpenMesh& operator=(const SilentOpenMesh&) = delete;

   private:
    bool log_;
    bool errors_;
};

}  // namespace

std::vector<EncodedFile> encode_om(const Tile& tile, const std::string& path) {
    require_finite(tile);
    const OpenMeshTile mesh = openmesh_tile(tile);
    const std::lock_guard lock(openmesh_netcdf_mutex());
    const SilentOpenMesh silence;
    const OpenMesh::IO::Options options(OpenMesh::IO::Options::Binary);
    std::ostringstream stream(std::ios::binary);
    const bool written = std::visit(
        [&](const auto& any) { return OpenMesh::IO::write_mesh(any.mesh, stream, ".om", options); },
        mesh);
    // OpenMesh reports success even after its stream has failed.
    if (!written || !stream) throw InternalError("OpenMesh could not write " + path);
    return only_file(path, std::move(stream).str());
}

}  // namespace pcvt
