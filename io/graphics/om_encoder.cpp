// OpenMesh requires its readers and writers to be included before any mesh.
// clang-format off
#include <OpenMesh/Core/IO/MeshIO.hh>
// clang-format on

#include "io/graphics/om_encoder.hpp"

#include <mutex>
#include <sstream>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"

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

/// Collects bytes, and ends the writing of OpenMesh at a checkpoint.
class CheckpointBuffer final : public std::stringbuf {
   public:
    CheckpointBuffer() : std::stringbuf(std::ios::out | std::ios::binary) {}

   protected:
    std::streamsize xsputn(const char* bytes, std::streamsize n) override {
        checkpoint_each(++n_calls_);
        return std::stringbuf::xsputn(bytes, n);
    }

   private:
    long n_calls_ = 0;
};

/// OpenMesh keeps state for the whole process, and several threads write files.
std::mutex writing;

template <class Mesh>
std::string encode(const Mesh& mesh, const std::string& path) {
    const std::lock_guard lock(writing);
    const SilentOpenMesh silence;
    const OpenMesh::IO::Options options(OpenMesh::IO::Options::Binary);
    CheckpointBuffer bytes;
    std::ostream stream(&bytes);
    stream.exceptions(std::ios::badbit);
    const bool written = OpenMesh::IO::write_mesh(mesh, stream, ".om", options);
    // OpenMesh reports success even after its stream has failed.
    if (!written || !stream) throw InternalError("OpenMesh could not write " + path);
    return std::move(bytes).str();
}

}  // namespace

std::string encode_om_mesh(const plane::CellMesh& mesh, const std::string& path) {
    return encode(mesh, path);
}

std::string encode_om_mesh(const plane::TriangleMesh& mesh, const std::string& path) {
    return encode(mesh, path);
}

}  // namespace pcvt
