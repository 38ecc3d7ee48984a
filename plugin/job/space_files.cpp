#include "plugin/job/space_files.hpp"

#include <algorithm>

#include "io/formats/single_precision.hpp"
#include "mesher/portable/portable_functions.hpp"

namespace pcvt {
namespace {

/// Requires that 32-bit floats hold the lengths of the tile, of a job that knows its sites.
void require_precision(const Job& job, const std::string& path) {
    const auto n = double(job.n_wanted());
    if (n < 1) return;
    const space::Lattice& lattice = job.in_space().lattice;
    double longest = 0;
    for (const space::Vec3& period : lattice.periods()) longest = std::max(longest, period.norm());
    try {
        require_floats({.h = portable_cbrt(lattice.volume() / n),
                        .shortest_period = reduce(lattice).reduced.a().norm(),
                        .largest = longest});
    } catch (const InvalidInput& error) {
        throw InvalidInput("-o " + path + ": " + error.what());
    }
}

}  // namespace

JobFile space_file(const Job& job, const Format& format, const std::string& path) {
    const plane::MeshKind mesh = job.meshes.front();
    if (!format.space) {
        throw InvalidInput("-o " + path + ": " + std::string(format.extension) +
                           " does not support three dimensions; take " + space_extensions() +
                           ", or give two period vectors");
    }
    if (mesh == plane::MeshKind::kDelaunay && format.space->encode != nullptr &&
        format.space->encode_tetrahedra == nullptr) {
        throw InvalidInput("-o " + path + ": the format holds no tetrahedra; take " +
                           tetrahedra_extensions() + ", or write the cells in a run of their own");
    }
    if (job.tile.short_edges > 0 && !format.space->takes_short_edges(mesh)) {
        throw InvalidInput("-o " + path +
                           ": such files cannot say that short edges were removed; take " +
                           short_edges_extensions() + " with the cells");
    }
    if (format.is_single_precision) require_precision(job, path);
    return {.paths = format.space->paths(path),
            .format = &format,
            .folder = format.is_folder ? path : std::string()};
}

}  // namespace pcvt
