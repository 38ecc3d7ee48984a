#include "plugin/job/job_staging.hpp"

#include <algorithm>
#include <exception>
#include <thread>

#include "io/mpas/mpas_writer.hpp"
#include "io/pictures/svg_writer.hpp"
#include "io/run_files/site_writer.hpp"
#include "mesher/base/workers.hpp"
#include "mesher/finite_volume/mpas_grid.hpp"
#include "mesher/mesh/voronoi.hpp"
#include "plugin/job/job_proof.hpp"

namespace pcvt {
namespace {

/// Pictures of a graded mesh show the sizes of its cells.
std::vector<EncodedFile> encode(const Job& job, const JobFile& file, const ProvedTile& tile) {
    if (job.density && file.format->extension == ".svg") {
        return encode_graded_svg(tile.flat, file.paths.front());
    }
    return file.format->encode(tile.mesh, tile.flat,
                               file.folder.empty() ? file.paths.front() : file.folder);
}

/// Encodes a tile, lets it reach the disk under a hidden name and proves what stands there.
void stage_tile(const Job& job, const JobFile& file, const ProvedTile& tile, OutputSet& outputs) {
    if (!file.folder.empty()) outputs.stage_folder(file.folder);
    const std::vector<EncodedFile> encoded = encode(job, file, tile);
    for (const EncodedFile& part : encoded) outputs.stage(part.path, part.bytes);
    require_on_disk(outputs, encoded);
    if (file.format->decode != nullptr) prove_files(*file.format, encoded, tile.flat, job.origin);
}

void stage_sites(const std::string& path, const CvtResult& result, OutputSet& outputs) {
    const auto encoded = only_file(path, encode_sites(wrapped_sites(result)));
    outputs.stage(path, encoded.front().bytes);
    require_on_disk(outputs, encoded);
}

/// The C-grid of the whole torus, encoded, on the disk and proved there like a tile.
void stage_mpas_grid(const std::string& path, const Job& job, const Computation& result,
                     OutputSet& outputs) {
    const PeriodicMesh cells =
        repeated(periodic_mesh(result.cvt.delaunay, MeshKind::kVoronoi), job.columns, job.rows);
    std::vector<EncodedFile> encoded;
    try {
        MpasGrid grid = mpas_grid(cells, job.origin);
        if (job.density) fill_mesh_density(result.site_densities, grid);
        encoded = only_file(path, encode_mpas(grid));
    } catch (const InvalidInput& error) {
        throw InvalidInput("-o " + path + ": " + error.what());
    }
    outputs.stage(path, encoded.front().bytes);
    require_on_disk(outputs, encoded);
    prove_mpas_grid_file(encoded.front());
}

void stage_file(const Job& job, const JobFile& file, const Computation& result,
                std::span<const ProvedTile> tiles, OutputSet& outputs) {
    if (file.content == JobContent::kSites) {
        stage_sites(file.paths.front(), result.cvt, outputs);
    } else if (file.content == JobContent::kMpasGrid) {
        stage_mpas_grid(file.paths.front(), job, result, outputs);
    } else {
        stage_tile(job, file, tiles[static_cast<std::size_t>(file.mesh)], outputs);
    }
}

}  // namespace

void stage_files(const Job& job, const std::vector<JobFile>& files, const Computation& result,
                 std::span<const ProvedTile> tiles, const std::function<void()>& between_files,
                 OutputSet& outputs) {
    const std::thread::id caller = std::this_thread::get_id();
    std::vector<std::exception_ptr> faults(files.size());
    Workers workers(std::min(job.n_threads, static_cast<int>(files.size())));
    workers.for_each(static_cast<int>(files.size()), [&](int k) {
        try {
            stage_file(job, files[k], result, tiles, outputs);
        } catch (...) {
            faults[k] = std::current_exception();
        }
        if (std::this_thread::get_id() == caller) between_files();
    });
    for (const std::exception_ptr& fault : faults) {
        if (fault) std::rethrow_exception(fault);
    }
}

}  // namespace pcvt
