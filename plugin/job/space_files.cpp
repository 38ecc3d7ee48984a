#include "plugin/job/space_files.hpp"

#include <algorithm>
#include <filesystem>

#include "io/bytes/output_error.hpp"
#include "io/formats/file_proof.hpp"
#include "io/formats/single_precision.hpp"
#include "io/formats/space_file_proof.hpp"
#include "io/run_files/site_writer.hpp"
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

std::vector<EncodedFile> encode(const JobFile& file, const SpaceContent& content,
                                const SpaceFileOptions& options) {
    if (file.format->space->shows_tetrahedra(options)) {
        return file.format->space->encode_tetrahedra(content.tetrahedra.value(), file.path());
    }
    if (file.format->space->encode != nullptr) {
        return file.format->space->encode(content.tile, options, file.path());
    }
    return only_file(file.path(), encode_sites(content.points));
}

void prove(const SpaceFormat& format, const std::vector<EncodedFile>& encoded,
           const SpaceContent& content, const SpaceFileOptions& options) {
    if (format.is_picture()) return;
    if (format.shows_tetrahedra(options)) {
        prove_own_tetrahedra(encoded.front(), content.tetrahedra.value());
    } else if (format.encode != nullptr) {
        prove_own_space_files(encoded, content.tile);
    } else {
        prove_space_site_file(encoded.front(), content.points);
    }
}

void stage_file(const JobFile& file, const SpaceContent& content, const SpaceFileOptions& options,
                OutputSet& outputs) {
    const std::vector<EncodedFile> encoded = encode(file, content, options);
    prove(*file.format->space, encoded, content, options);
    for (const EncodedFile& part : encoded) outputs.stage(part.path, part.bytes);
    require_on_disk(outputs, encoded);
}

}  // namespace

JobFile space_file(const Job& job, const std::string& path) {
    const SpaceFileOptions& options = job.space_files;
    const Format* const format = find_format(path);
    if (format == nullptr || !format->space) {
        throw InvalidInput("-o " + path + ": the format holds no volumes; take " +
                           space_extensions() + ", or give two period vectors");
    }
    if (format->check_path != nullptr) {
        try {
            format->check_path(path);
        } catch (const InvalidInput& error) {
            throw InvalidInput("-o " + path + ": " + error.what());
        }
    }
    if (options.mesh == SpaceMesh::kDelaunay && format->space->encode != nullptr &&
        format->space->encode_tetrahedra == nullptr) {
        throw InvalidInput("-o " + path + ": the format holds no tetrahedra; take " +
                           tetrahedra_extensions() + ", or write the cells in a run of their own");
    }
    if (job.tile.short_edges > 0 && !format->space->takes_short_edges(options)) {
        throw InvalidInput("-o " + path +
                           ": such files cannot say that short edges were removed; take " +
                           short_edges_extensions() + " with the cells");
    }
    if (format->is_single_precision) require_precision(job, path);
    return {.paths = format->space->paths(path),
            .format = format,
            .folder = format->is_folder ? path : std::string()};
}

std::vector<RefusedFile> stage_space_files(const std::vector<JobFile>& files,
                                           const SpaceContent& content,
                                           const SpaceFileOptions& options, JobMonitor& monitor,
                                           OutputSet& outputs) {
    std::vector<RefusedFile> refused;
    // Before all files, so that a file inside of a case folder is staged in that folder.
    for (const JobFile& file : files) {
        if (file.format->is_folder) outputs.stage_folder(file.path());
    }
    for (std::size_t k = 0; k < files.size(); ++k) {
        const std::string name = std::filesystem::path(files[k].path()).filename().string();
        const std::string words = "writing " + name + ", " + std::to_string(k + 1) + " of " +
                                  std::to_string(files.size());
        if (k == 0) {
            monitor.begin(Phase::kWriting, words);
        } else {
            monitor.describe(words);
        }
        try {
            stage_file(files[k], content, options, outputs);
        } catch (const CoarsePrecision& error) {
            refused.push_back({files[k].path(), error.what()});
        }
        monitor.advance(double(k + 1) / double(files.size()));
    }
    return refused;
}

}  // namespace pcvt
