#include "plugin/space/space_files.hpp"

#include <algorithm>
#include <filesystem>

#include "io/bytes/output_error.hpp"
#include "io/file_proof.hpp"
#include "io/outputs/distinct_paths.hpp"
#include "io/outputs/recovery.hpp"
#include "io/outputs/writable_paths.hpp"
#include "io/run_files/site_writer.hpp"
#include "io/single_precision.hpp"
#include "io/space_file_proof.hpp"
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

SpaceJobFile plan_file(std::string path, const Job& job) {
    const SpaceFileOptions& options = job.space_files;
    if (path.ends_with(".foam/")) path.pop_back();
    const SpaceFormat* const format = find_space_format(path);
    if (format == nullptr) {
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
    if (options.mesh == SpaceMesh::kDelaunay && format->encode != nullptr &&
        format->encode_tetrahedra == nullptr) {
        throw InvalidInput("-o " + path + ": the format holds no tetrahedra; take " +
                           tetrahedra_extensions() + ", or write the cells in a run of their own");
    }
    if (job.tile.short_edges > 0 && !format->takes_short_edges(options)) {
        throw InvalidInput("-o " + path +
                           ": such files cannot say that short edges were removed; take " +
                           short_edges_extensions() + " with the cells");
    }
    if (format->is_single_precision) require_precision(job, path);
    return {path, format};
}

std::vector<EncodedFile> encode(const SpaceJobFile& file, const SpaceContent& content,
                                const SpaceFileOptions& options) {
    if (file.format->shows_tetrahedra(options)) {
        return file.format->encode_tetrahedra(content.tetrahedra.value(), file.path);
    }
    if (file.format->encode != nullptr) {
        return file.format->encode(content.tile, options, file.path);
    }
    return only_file(file.path, encode_sites(content.points));
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

void stage_file(const SpaceJobFile& file, const SpaceContent& content,
                const SpaceFileOptions& options, OutputSet& outputs) {
    const std::vector<EncodedFile> encoded = encode(file, content, options);
    prove(*file.format, encoded, content, options);
    for (const EncodedFile& part : encoded) outputs.stage(part.path, part.bytes);
    require_on_disk(outputs, encoded);
}

}  // namespace

std::vector<SpaceJobFile> plan_space_files(const Job& job) {
    std::vector<SpaceJobFile> files;
    DistinctPaths paths;
    for (const std::string& path : job.inputs) paths.add_input(path);
    for (const std::string& path : job.outputs) files.push_back(plan_file(path, job));
    for (const SpaceJobFile& file : files) {
        for (const std::string& path : file.format->paths(file.path)) paths.add_output(path);
    }
    if (!job.report.empty()) paths.add_output(job.report);
    return files;
}

std::vector<std::string> require_space_files_writable(const Job& job,
                                                      const std::vector<SpaceJobFile>& files) {
    std::vector<std::string> all;
    for (const SpaceJobFile& file : files) {
        for (const std::string& path : file.format->paths(file.path)) all.push_back(path);
    }
    if (!job.report.empty()) all.push_back(job.report);
    std::vector<std::string> recovered = recover_unfinished(all);
    for (const SpaceJobFile& file : files) {
        if (file.format->is_folder) {
            require_writable_folder(file.path, file.format->paths(file.path), job.force);
        } else {
            require_writable(file.path, job.force);
        }
    }
    if (!job.report.empty()) require_writable(job.report, job.force);
    return recovered;
}

std::vector<RefusedFile> stage_space_files(const std::vector<SpaceJobFile>& files,
                                           const SpaceContent& content,
                                           const SpaceFileOptions& options, JobMonitor& monitor,
                                           OutputSet& outputs) {
    std::vector<RefusedFile> refused;
    // Before all files, so that a file inside of a case folder is staged in that folder.
    for (const SpaceJobFile& file : files) {
        if (file.format->is_folder) outputs.stage_folder(file.path);
    }
    for (std::size_t k = 0; k < files.size(); ++k) {
        const std::string name = std::filesystem::path(files[k].path).filename().string();
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
            refused.push_back({files[k].path, error.what()});
        }
        monitor.advance(double(k + 1) / double(files.size()));
    }
    return refused;
}

}  // namespace pcvt
