#include "plugin/job/job_staging.hpp"

#include <algorithm>
#include <exception>
#include <thread>

#include "io/file_proof.hpp"
#include "mesher/base/workers.hpp"
#include "mesher/mesh/voronoi.hpp"

namespace pcvt {
namespace {

/// Encodes one file of a job in the form that its format writes.
class FileEncoder {
   public:
    FileEncoder(const Job& job, const JobFile& file, const Computation& result,
                std::span<const BuiltTile> tiles)
        : job_(job), file_(file), result_(result), tiles_(tiles) {}

    std::vector<EncodedFile> encode() const { return std::visit(*this, file_.format->write); }

    std::vector<EncodedFile> operator()(TileWriter* write) const {
        const bool graded = job_.density && file_.format->write_graded != nullptr;
        if (!graded) return write(tile(), path());
        return file_.format->write_graded(tile(), result_.site_densities, path());
    }
    std::vector<EncodedFile> operator()(TorusWriter* write) const {
        const PeriodicMesh cells = repeated(periodic_mesh(result_.cvt.delaunay, MeshKind::kVoronoi),
                                            job_.columns, job_.rows);
        try {
            return write({cells, job_.origin, result_.site_densities}, path());
        } catch (const InvalidInput& error) {
            throw InvalidInput("-o " + path() + ": " + error.what());
        }
    }
    std::vector<EncodedFile> operator()(SiteWriter* write) const {
        return write(wrapped_sites(result_.cvt, job_.origin), path());
    }

    const Tile& tile() const { return tiles_[static_cast<std::size_t>(file_.mesh)].tile; }

   private:
    const std::string& path() const {
        return file_.folder.empty() ? file_.paths.front() : file_.folder;
    }

    const Job& job_;
    const JobFile& file_;
    const Computation& result_;
    std::span<const BuiltTile> tiles_;
};

/// Encodes a file, lets it reach the disk under a hidden name and proves the bytes there.
void stage_file(const Job& job, const JobFile& file, const Computation& result,
                std::span<const BuiltTile> tiles, OutputSet& outputs) {
    const FileEncoder encoder(job, file, result, tiles);
    const std::vector<EncodedFile> encoded = encoder.encode();
    for (const EncodedFile& part : encoded) outputs.stage(part.path, part.bytes);
    require_on_disk(outputs, encoded);
    if (file.format->reads_grid()) {
        prove_grid_files(*file.format, encoded);
    } else if (file.format->is_readable()) {
        prove_tile_files(*file.format, encoded, encoder.tile(), job.origin);
    }
}

}  // namespace

void stage_files(const Job& job, const std::vector<JobFile>& files, const Computation& result,
                 std::span<const BuiltTile> tiles, const std::function<void()>& between_files,
                 OutputSet& outputs) {
    // Before all files, so that a file inside of a case folder is staged in that folder.
    for (const JobFile& file : files) {
        if (!file.folder.empty()) outputs.stage_folder(file.folder);
    }
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
