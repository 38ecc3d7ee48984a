#include "plugin/job/job_staging.hpp"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <mutex>

#include "io/bytes/output_error.hpp"
#include "io/formats/file_proof.hpp"
#include "mesher/base/workers.hpp"
#include "plugin/job/version.hpp"

namespace pcvt {
namespace {

/// Encodes one file of a job in the form that its format writes.
class FileEncoder {
   public:
    FileEncoder(const Job& job, const JobFile& file, const Computation& result,
                std::span<const plane::BuiltTile> tiles)
        : job_(job), file_(file), result_(result), tiles_(tiles) {}

    std::vector<EncodedFile> encode() const { return std::visit(*this, file_.format->write); }

    std::vector<EncodedFile> operator()(TileWriter* write) const { return write(tile(), path()); }
    std::vector<EncodedFile> operator()(TileFormWriter* write) const {
        return write(tile(), tile_options(), path());
    }
    std::vector<EncodedFile> operator()(TorusWriter* write) const {
        const plane::PeriodicMesh cells = repeated(result_.cells.mesh(plane::MeshKind::kVoronoi),
                                                   job_.tile.columns, job_.tile.rows);
        try {
            return write({.cells = cells,
                          .origin = job_.tile.origin,
                          .site_densities = result_.site_densities,
                          .coriolis = job_.file_options.coriolis,
                          .history = history()},
                         path());
        } catch (const UnsuitableCells& error) {
            throw UnsuitableCells("-o " + path() + ": " + error.what());
        } catch (const InvalidInput& error) {
            throw InvalidInput("-o " + path() + ": " + error.what());
        }
    }
    std::vector<EncodedFile> operator()(SiteWriter* write) const { return write(sites(), path()); }

    std::vector<EncodedFile> operator()(CellWriter* write) const {
        return write(cell_rows(), path());
    }

    std::vector<EncodedFile> operator()(VoxelWriter* write) const {
        const plane::VoxelCounts counts =
            requested_voxels(format_request(job_, plane::MeshKind::kVoronoi));
        const plane::VoxelGrid grid =
            voxel_grid(job_.in_plane().lattice.repeated(job_.tile.columns, job_.tile.rows),
                       job_.tile.origin, counts);
        const plane::VoxelCells cells{.lattice = job_.in_plane().lattice,
                                      .sites = sites(),
                                      .weights = site_weights(result_.cells),
                                      .metric = result_.cells.elongation
                                                    ? result_.cells.elongation->metric
                                                    : plane::Metric()};
        return write(voxel_image(result_.cells.delaunay, cells.metric, grid, job_.run.n_threads),
                     cells, materials(), job_.file_options.elastic, path());
    }

    CellRows cell_rows() const {
        return {.sites = sites(),
                .cells = cells(),
                .weights = site_weights(result_.cells),
                .materials = materials(),
                .phases_are_tags = job_.has_inclusions(),
                .orbits = result_.cells.site_orbits};
    }
    /// The measures of the cells, which are freed: tiles are made before files.
    CellTable cells() const {
        CellTable table = table_outside_holes(result_.cells);
        result_.cells.drop_cells();
        return table;
    }
    /// The run as files state it: equal for equal results.
    std::string history() const {
        return std::string("pcvt ") + version() + (job_.command.empty() ? "" : ": ") +
               job_.command + "; seed " + std::to_string(job_.seed);
    }
    FileOptions tile_options() const {
        FileOptions options = job_.file_options;
        options.site_densities = result_.site_densities;
        options.site_orbits = result_.cells.site_orbits;
        if (!tile_materials().empty()) options.materials = &tile_materials();
        // The materials and groups of files are the tags.
        if (job_.has_inclusions() && !options.colouring) options.colouring = Colouring::kTag;
        return options;
    }
    const CellMaterials& materials() const { return result_.materials; }
    /// The materials that a file of a tile states; empty for Delaunay triangles where files state
    /// the materials of cells.
    const CellMaterials& tile_materials() const {
        static const CellMaterials none;
        const bool are_cells = faces_have_sites(tile().kind) || !file_.format->states_materials;
        return are_cells ? materials() : none;
    }
    plane::Points sites() const { return wrapped_sites(result_.cells, job_.tile.origin); }
    const plane::Tile& tile() const { return tiles_[static_cast<std::size_t>(file_.mesh)].tile; }

   private:
    const std::string& path() const { return file_.path(); }

    const Job& job_;
    const JobFile& file_;
    const Computation& result_;
    std::span<const plane::BuiltTile> tiles_;
};

/// The progress of the files of a job, which several threads write.
class FileProgress {
   public:
    FileProgress(const std::vector<JobFile>& files, JobMonitor& monitor)
        : files_(files), state_(files.size(), kWaiting), monitor_(monitor) {
        if (!files.empty()) monitor_.begin(Phase::kWriting, words(0));
    }

    void begin(std::size_t file) { set(file, kOpen); }
    void end(std::size_t file) { set(file, kDone); }
    /// Adds a share of the work on one file.
    void add(double share) {
        const std::lock_guard lock(mutex_);
        done_ += share / double(files_.size());
        monitor_.advance(done_);
    }

   private:
    enum State : char { kWaiting, kOpen, kDone };

    std::string words(std::size_t file) const {
        const std::string name = std::filesystem::path(files_[file].path()).filename().string();
        return "writing " + name + ", " + std::to_string(file + 1) + " of " +
               std::to_string(files_.size());
    }
    /// The words name the first open file.
    void set(std::size_t file, State state) {
        const std::lock_guard lock(mutex_);
        state_[file] = state;
        const auto open = std::find(state_.begin(), state_.end(), kOpen);
        const auto first = static_cast<std::size_t>(open - state_.begin());
        if (open == state_.end() || first == shown_) return;
        shown_ = first;
        monitor_.describe(words(first));
    }

    const std::vector<JobFile>& files_;
    std::vector<State> state_;
    JobMonitor& monitor_;
    std::mutex mutex_;
    std::size_t shown_ = 0;
    double done_ = 0;
};

/// About the shares of the steps in the time of a file.
constexpr double kEncoding = 0.35;
constexpr double kStaging = 0.1;
constexpr double kProving = 1 - kEncoding - kStaging;

void prove_encoded(const FileEncoder& encoder, const JobFile& file, const plane::Vec2& origin,
                   const std::vector<EncodedFile>& encoded) {
    if (file.format->reads_grid()) {
        prove_grid_files(*file.format, encoded);
    } else if (file.format->reads_sites()) {
        prove_site_files(*file.format, encoded, encoder.sites());
    } else if (file.format->reads_cells()) {
        prove_cell_files(*file.format, encoded, encoder.cell_rows());
    } else if (file.format->reads_voxels()) {
        prove_voxel_files(*file.format, encoded, encoder.materials());
    } else if (file.format->is_readable()) {
        prove_tile_files(*file.format, encoded, encoder.tile(), origin, encoder.tile_options());
    }
}

/// Encodes a file, proves its bytes and lets them reach the disk under a hidden name, where they
/// are compared. A file that is refused reaches no disk.
void stage_file(const FileEncoder& encoder, const JobFile& file, const plane::Vec2& origin,
                FileProgress& progress, OutputSet& outputs) {
    const std::vector<EncodedFile> encoded = encoder.encode();
    progress.add(kEncoding);
    prove_encoded(encoder, file, origin, encoded);
    progress.add(kProving);
    for (const EncodedFile& part : encoded) outputs.stage(part.path, part.bytes);
    require_on_disk(outputs, encoded);
    progress.add(kStaging);
}

}  // namespace

std::vector<std::string> stage_files(const Job& job, const std::vector<JobFile>& files,
                                     const Computation& result,
                                     std::span<const plane::BuiltTile> tiles, JobMonitor& monitor,
                                     OutputSet& outputs) {
    // Before all files, so that a file inside of a case folder is staged in that folder.
    for (const JobFile& file : files) {
        if (!file.folder.empty()) outputs.stage_folder(file.folder);
    }
    FileProgress progress(files, monitor);
    std::vector<std::exception_ptr> faults(files.size());
    std::vector<std::string> refused(files.size());
    Workers workers(std::min(job.run.n_threads, static_cast<int>(files.size())));
    workers.for_each(static_cast<int>(files.size()), [&](int k) {
        try {
            progress.begin(static_cast<std::size_t>(k));
            try {
                stage_file({job, files[k], result, tiles}, files[k], job.tile.origin, progress,
                           outputs);
            } catch (const CoarsePrecision& error) {
                refused[k] = error.what();
            }
            progress.end(static_cast<std::size_t>(k));
        } catch (...) {
            faults[k] = std::current_exception();
        }
    });
    for (const std::exception_ptr& fault : faults) {
        if (fault) std::rethrow_exception(fault);
    }
    return refused;
}

std::vector<std::string> wait_for_turn(OutputSet& outputs, JobMonitor& monitor) {
    return outputs.wait_for_turn([&monitor](const std::string& words) { monitor.describe(words); });
}

}  // namespace pcvt
