#include "plugin/job/job_tiles.hpp"

#include <algorithm>

#include "mesher/plane/proof/generated_tile.hpp"
#include "plugin/job/job_checks.hpp"

namespace pcvt {

namespace {

plane::BuiltTile built_tile(const Job& job, const Tessellation& cells, plane::MeshKind kind,
                            const std::function<void(double)>& progress) {
    plane::TileOptions options = job.tile;
    options.kind = kind;
    options.elongation = cells.elongation;
    options.walled = cells.walled;
    options.site_tags = cells.site_tags;
    options.holes = cells.holes;
    options.progress = progress;
    return build_tile(cells.delaunay, options);
}

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

bool needs_tiles(const Job& job, const std::vector<JobFile>& files) {
    return job.tile.outline == plane::Outline::kBox ||
           has_mesh(job, &plane::MeshKindRow::grain_size) ||
           std::any_of(files.begin(), files.end(),
                       [](const JobFile& file) { return file.format->needs_tile(); });
}

std::vector<plane::BuiltTile> proved_tiles(const Job& job, const Tessellation& cells,
                                           JobMonitor& monitor) {
    std::vector<plane::BuiltTile> tiles;
    tiles.reserve(job.meshes.size());
    for_each_mesh(job, monitor, Phase::kBuilding, "building", [&](std::size_t k) {
        const auto progress = [&](double share) {
            monitor.advance((double(k) + share) / double(job.meshes.size()));
        };
        tiles.push_back(built_tile(job, cells, job.meshes[k], progress));
    });
    for_each_mesh(job, monitor, Phase::kProving, "proving",
                  [&](std::size_t k) { verify_generated_tile(tiles[k].tile); });
    return tiles;
}

}  // namespace pcvt
