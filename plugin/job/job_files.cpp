#include "plugin/job/job_files.hpp"

#include <filesystem>

#include "io/bytes/nearest_word.hpp"
#include "io/elements/triangle_elements.hpp"
#include "io/outputs/distinct_paths.hpp"
#include "plugin/job/job_checks.hpp"

namespace pcvt {
namespace {

namespace fs = std::filesystem;

/// The extension that `extension` is a misspelling of; empty if there is none.
std::string nearest_extension(const std::string& extension) {
    if (extension.empty()) return {};
    std::vector<std::string> words;
    for (const TileFormat& format : tile_formats()) words.emplace_back(format.extension.substr(1));
    const std::string meant = nearest_word(extension.substr(1), words);
    return meant.empty() ? meant : "." + meant;
}

[[noreturn]] void refuse_extension(const std::string& path) {
    const std::string extension = lower_case_extension(path);
    if (const std::string meant = nearest_extension(extension); !meant.empty()) {
        throw InvalidInput("-o " + path + ": unknown extension " + extension + "; did you mean " +
                           meant + "?");
    }
    throw InvalidInput("-o " + path + ": " +
                       (extension.empty() ? "no extension" : "unknown extension " + extension) +
                       "; take one of " + output_extensions());
}

std::string kind_suffix(MeshKind kind) { return std::string("-") + mesh_kind_row(kind).word; }

/// @param kind  of the mesh that goes into the file; any one where the format needs no tile.
void check_format(const Job& job, const TileFormat& format, MeshKind kind,
                  const std::string& path) {
    if (format.needs_torus() && (job.areas || job.aspect)) {
        throw InvalidInput("-o " + path +
                           ": the grid needs Voronoi cells; leave areas and aspect out, or take "
                           "another format, such as .vtu");
    }
    if (format.check != nullptr) {
        try {
            format.check(format_request(job, kind));
        } catch (const InvalidInput& error) {
            throw InvalidInput("-o " + path + ": " + error.what());
        }
    }
    // Beside a mesh of cells, the file of the triangles may lack what belongs to cells.
    const bool needs_cells =
        !format.holds_polygons || !has_mesh(job, &MeshKindRow::faces_have_sites);
    if (format.states_materials && (job.has_inclusions() || !job.materials.empty()) &&
        !mesh_kind_row(kind).faces_have_sites && needs_cells) {
        throw InvalidInput("-o " + path +
                           ": Delaunay triangles are no cells, which phases and orientations "
                           "belong to; take the mesh grains");
    }
    if (format.needs_tile() && !format.holds_polygons) require_triangles(kind, "-o " + path);
}

void add_output(const Job& job, const std::string& path, std::vector<JobFile>& files) {
    const TileFormat* format = find_tile_format(path);
    if (format == nullptr) refuse_extension(path);
    if (!format->needs_tile()) {
        check_format(job, *format, MeshKind::kVoronoi, path);
        files.push_back({format->paths(path), format});
        return;
    }
    for (std::size_t m = 0; m < job.meshes.size(); ++m) {
        check_format(job, *format, job.meshes[m], path);
        const std::string suffix = job.meshes.size() > 1 ? kind_suffix(job.meshes[m]) : "";
        const std::string name = with_suffix(path, suffix);
        files.push_back({format->paths(name), format, static_cast<int>(m),
                         format->is_folder ? name : std::string()});
    }
}

/// The extensions of the formats that `keep` takes.
template <class Keep>
std::string extensions(const std::string& separator, const Keep& keep) {
    std::string all;
    for (const TileFormat& format : tile_formats()) {
        if (!keep(format)) continue;
        if (!all.empty()) all += separator;
        all += format.extension;
    }
    return all;
}

}  // namespace

FormatRequest format_request(const Job& job, MeshKind kind) {
    return {.lattice = job.lattice.repeated(job.columns, job.rows),
            .kind = kind,
            .outline = job.outline,
            .short_edges = job.short_edges,
            .n_sites = job.points.cols() > 0 ? double(job.points.cols()) : job.n_sites,
            .n_periods = double(job.columns) * job.rows,
            .walls = job.walls,
            .has_holes = !job.holes.empty(),
            .files = job.file_options};
}

std::string output_extensions() {
    return extensions(" ", [](const TileFormat&) { return true; });
}

std::string readable_extensions() {
    return extensions(" ", [](const TileFormat& format) { return format.is_readable(); });
}

std::string second_order_extensions() {
    return extensions(", ", [](const TileFormat& format) { return format.highest_order > 1; });
}

std::string without_slash(const std::string& path) {
    if (!path.ends_with('/')) return path;
    const std::string folder = path.substr(0, path.size() - 1);
    const TileFormat* format = find_tile_format(folder);
    return format != nullptr && format->is_folder ? folder : path;
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
