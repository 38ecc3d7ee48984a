#include "plugin/job/job_files.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "io/tiles/triangle_elements.hpp"
#include "mesher/finite_volume/mpas_grid.hpp"
#include "plugin/job/distinct_paths.hpp"

namespace pcvt {
namespace {

namespace fs = std::filesystem;

std::string lower_case_extension(const std::string& path) {
    std::string extension = fs::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

[[noreturn]] void refuse_extension(const std::string& path) {
    const std::string extension = lower_case_extension(path);
    throw InvalidInput("-o " + path + ": " +
                       (extension.empty() ? "no extension" : "unknown extension " + extension) +
                       "; take one of " + output_extensions());
}

const char* kind_suffix(MeshKind kind) {
    switch (kind) {
        case MeshKind::kVoronoi:
            return "-voronoi";
        case MeshKind::kDelaunay:
            return "-delaunay";
        case MeshKind::kGrains:
            return "-grains";
    }
    return "";
}

/// Pieces of cells are slivers where the box cuts a cell near its corner.
void require_whole_cells(const Job& job, MeshKind kind, const std::string& path) {
    if (job.outline == Outline::kWhole || kind != MeshKind::kVoronoi) return;
    throw InvalidInput("-o " + path +
                       ": cells that the box cuts are too thin for finite volumes; take the whole "
                       "outline, or the mesh grains");
}

/// MPAS takes a rectangular torus, and the Voronoi diagram as it is.
void require_mpas_grid(const Job& job, const std::string& path) {
    if (job.short_edges > 0) {
        throw InvalidInput("-o " + path +
                           ": MPAS needs every Voronoi edge; leave --short-edges out");
    }
    try {
        rectangular_periods(job.lattice.repeated(job.columns, job.rows));
    } catch (const InvalidInput& error) {
        throw InvalidInput("-o " + path + ": " + error.what());
    }
}

void add_output(const Job& job, const std::string& path, std::vector<JobFile>& files) {
    const std::string extension = lower_case_extension(path);
    if (extension == ".txt" || extension == ".nc") {
        if (extension == ".nc") require_mpas_grid(job, path);
        files.push_back({{path}, extension == ".nc" ? JobContent::kMpasGrid : JobContent::kSites});
        return;
    }
    const TileFormat* format = find_tile_format(path);
    if (format == nullptr) refuse_extension(path);
    for (std::size_t m = 0; m < job.meshes.size(); ++m) {
        if (format->whole_cells_only) require_whole_cells(job, job.meshes[m], path);
        if (format->triangles_only) require_triangles(job.meshes[m], "-o " + path);
        const std::string suffix = job.meshes.size() > 1 ? kind_suffix(job.meshes[m]) : "";
        const std::string name = with_suffix(path, suffix);
        files.push_back({format->paths(name), JobContent::kTile, format, static_cast<int>(m),
                         format->is_folder ? name : std::string()});
    }
}

}  // namespace

std::string output_extensions() {
    std::string all;
    for (const TileFormat& format : tile_formats()) all += format.extension + " ";
    return all + ".nc .txt";
}

std::string readable_extensions() {
    std::string all;
    for (const TileFormat& format : tile_formats()) {
        if (format.decode == nullptr) continue;
        all += format.extension + " ";
    }
    return all + ".nc";
}

std::string without_slash(const std::string& path) {
    return path.ends_with(".foam/") ? path.substr(0, path.size() - 1) : path;
}

std::string with_suffix(const std::string& path, const std::string& suffix) {
    const std::size_t extension = fs::path(path).extension().string().size();
    return path.substr(0, path.size() - extension) + suffix + path.substr(path.size() - extension);
}

std::vector<JobFile> plan_files(const Job& job) {
    std::vector<JobFile> files;
    for (const std::string& path : job.outputs) add_output(job, without_slash(path), files);
    DistinctPaths book;
    for (const std::string& path : job.inputs) book.add_input(path);
    for (const JobFile& file : files) {
        for (const std::string& path : file.paths) book.add_output(path);
    }
    if (!job.report.empty()) book.add_output(job.report);
    return files;
}

}  // namespace pcvt
