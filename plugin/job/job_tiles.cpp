#include "plugin/job/job_tiles.hpp"

#include <algorithm>

#include "mesher/base/error.hpp"
#include "mesher/plane/proof/generated_tile.hpp"
#include "plugin/job/job_checks.hpp"

namespace pcvt {

namespace {

/// "building the tile" if the job has one mesh, "building grains, 2 of 3" if it has several.
std::string words(const std::string& verb, const Job& job, std::size_t k) {
    const std::size_t n = job.meshes.size();
    if (n == 1) return verb + " the tile";
    return verb + " " + mesh_kind_row(job.meshes[k]).word + ", " + std::to_string(k + 1) + " of " +
           std::to_string(n);
}

/// Runs step(k) for each mesh of the job as one phase.
template <class Step>
void for_each_mesh(const Job& job, JobMonitor& monitor, Phase phase, const std::string& verb,
                   const Step& step) {
    const std::size_t n = job.meshes.size();
    monitor.begin(phase, words(verb, job, 0));
    for (std::size_t k = 0; k < n; ++k) {
        if (k > 0) monitor.describe(words(verb, job, k));
        step(k);
        monitor.advance(double(k + 1) / double(n));
    }
}

}  // namespace

std::string unheld_grains(const std::string& fault) {
    return "doubles do not hold the power cells that were found for these sizes and centroids (" +
           fault + "); correct the centroids and the sizes, or take fewer iterations";
}

bool needs_tiles(const Job& job, const std::vector<JobFile>& files) {
    return job.tile.outline == plane::Outline::kBox ||
           has_mesh(job, &plane::MeshKindRow::grain_size) ||
           std::any_of(files.begin(), files.end(),
                       [](const JobFile& file) { return file.format->needs_tile(); });
}

std::vector<plane::BuiltTile> proved_tiles(const Job& job, const plane::Tessellation& cells,
                                           JobMonitor& monitor) {
    // Figures of the run need the table, and a tile takes the cells.
    if (cells.areas || cells.elongation || cells.walled) cells.table();
    plane::TileOptions options = tile_options(job);
    std::vector<plane::BuiltTile> tiles;
    tiles.reserve(job.meshes.size());
    for_each_mesh(job, monitor, Phase::kBuilding, "building", [&](std::size_t k) {
        options.kind = job.meshes[k];
        options.progress = [&](double share) {
            monitor.advance((double(k) + share) / double(job.meshes.size()));
        };
        tiles.push_back(build_tile(cells, options));
    });
    cells.drop_cells();
    for_each_mesh(job, monitor, Phase::kProving, "proving", [&](std::size_t k) {
        try {
            verify_generated_tile(tiles[k].tile);
        } catch (const InternalError& error) {
            if (job.centroids) throw InvalidInput(unheld_grains(error.what()));
            throw;
        }
    });
    return tiles;
}

}  // namespace pcvt
