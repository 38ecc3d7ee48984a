#include "plugin/job/job_files.hpp"

#include <algorithm>

#include "io/outputs/distinct_paths.hpp"
#include "io/outputs/recovery.hpp"
#include "io/outputs/writable_paths.hpp"
#include "plugin/job/contradictions.hpp"
#include "plugin/job/features.hpp"
#include "plugin/job/job_checks.hpp"

namespace pcvt {
namespace {

/// The content that a job has for its files.
OutputRequest output_request(const Job& job) {
    if (job.is_in_space()) {
        return SpaceRequest{job.in_space().lattice,
                            job.tile.short_edges,
                            job.n_wanted(),
                            job.has_weights(),
                            job.aspect.has_value(),
                            job.file_options.voxels,
                            job.tile.outline == plane::Outline::kBox};
    }
    return RunRequest{.content = format_request(job),
                      .has_metric = job.aspect.has_value(),
                      .has_materials = job.has_inclusions() || !job.materials.empty()};
}

/// The widths of a tile for cutters, in millimetres.
constexpr double kLeastCutWidth = 1e-3;
constexpr double kLargestCutWidth = 1e6;

std::string extensions_that_take(const FeatureRow& feature, bool in_space) {
    std::string text;
    for (const Format& format : formats()) {
        if (!feature.taken(format, in_space)) continue;
        text += (text.empty() ? "" : " or ") + std::string(format.extension);
    }
    return text;
}

/// Whether a file of a job can hold nodes in the middle of edges.
bool holds_middle_nodes(const JobFile& file, const Job& job) {
    return file.format->highest_order > 1 &&
           (!job.is_in_space() || file.format->space->shows_tetrahedra(job.meshes.front()));
}

/// Whether the elements in a file of a job lie in cells.
bool elements_have_cells(const Job& job, const JobFile& file) {
    if (job.is_in_space()) return job.meshes.front() == plane::MeshKind::kGrains;
    return mesh_kind_row(job.meshes[file.mesh]).faces_have_sites;
}

void check_constants(const Job& job, const std::vector<JobFile>& files,
                     const std::vector<std::string>& phases) {
    if (files.empty()) return;
    const FileOptions& options = job.file_options;
    bool is_stated = options.elastic.empty();
    for (const JobFile& file : files) {
        is_stated = is_stated || file.format->states_constants(options);
        if (!file.format->holds_job(options)) continue;
        require_choice(options.elastic, phases);
        if (phases.empty() || elements_have_cells(job, file)) continue;
        throw InvalidInput("-o " + file.paths.front() + ": --job elastic would give Delaunay " +
                           (job.is_in_space() ? "tetrahedra" : "triangles") +
                           " one material, because they have no phases; take the mesh grains");
    }
    if (!is_stated) {
        throw InvalidInput(
            "--material gives the elastic constants of --job elastic; add it, or leave --material "
            "out");
    }
    require_materials_of(options.elastic, phases);
}

}  // namespace

plane::TileOptions tile_options(const Job& job) {
    plane::TileOptions options = job.tile;
    options.origin = job.in_plane().origin;
    return options;
}

FormatRequest format_request(const Job& job) {
    return {
        .lattice = job.in_plane().lattice.repeated(job.tile.repeat.columns, job.tile.repeat.rows),
        .tile = tile_options(job),
        .n_sites = double(job.n_wanted()),
        .walls = job.walls,
        .has_holes = !job.holes.empty(),
        .has_weights = job.has_weights(),
        .files = job.file_options};
}

std::vector<JobFile> plan_files(const Job& job) {
    const OutputRequest request = output_request(job);
    std::vector<JobFile> files;
    for (const std::string& output : job.outputs) {
        const std::string path = without_slash(output);
        try {
            add_output(path, request, job.meshes, files);
        } catch (const InvalidInput& error) {
            throw InvalidInput(std::string("-o ") + error.what());
        }
    }
    DistinctPaths book;
    for (const std::string& path : job.inputs) book.add_input(path);
    for (const JobFile& file : files) {
        for (const std::string& path : file.paths) book.add_output(path);
    }
    if (!job.report.empty()) book.add_output(job.report);
    return files;
}

std::vector<std::string> require_all_writable(const Job& job, const std::vector<JobFile>& files) {
    std::vector<std::string> paths;
    for (const JobFile& file : files) {
        paths.insert(paths.end(), file.paths.begin(), file.paths.end());
    }
    if (!job.report.empty()) paths.push_back(job.report);
    std::vector<std::string> recovered = recover_unfinished(paths);
    for (const JobFile& file : files) {
        if (!file.folder.empty()) {
            require_writable_folder(file.folder, file.paths, job.force);
            continue;
        }
        for (const std::string& path : file.paths) require_writable(path, job.force);
    }
    if (!job.report.empty()) require_writable(job.report, job.force);
    return recovered;
}

void check_order(const Job& job, const std::vector<JobFile>& files) {
    if (job.tile.order == 1 || files.empty()) return;
    const bool held = std::any_of(files.begin(), files.end(), [&job](const JobFile& file) {
        return holds_middle_nodes(file, job);
    });
    if (held) return;
    throw InvalidInput("no output holds the mid-side nodes of order 2; add one of " +
                       second_order_extensions() + ", or take order 1");
}

void check_file_options(const Job& job, const std::vector<JobFile>& files,
                        const std::vector<std::string>& phases) {
    require_compatible(job);
    const double cut_width = job.file_options.cut_width;
    if (cut_width != 0 && !(cut_width >= kLeastCutWidth && cut_width <= kLargestCutWidth)) {
        throw InvalidInput("the width to cut is not between 0.001 and 1e6 mm");
    }
    for (const FeatureRow& feature : features()) {
        if (feature.in_files == nullptr || files.empty() || !feature.is_chosen(job)) continue;
        const auto is_taken = [&](const JobFile& file) {
            return feature.taken(*file.format, job.is_in_space());
        };
        const auto is_held = [&](const JobFile& file) {
            // Files for cutters have no colours and no background.
            const bool is_cut = cut_width != 0 && file.format->takes.cut_width;
            return is_taken(file) && (!is_cut || feature.feature == Feature::kCut) &&
                   (feature.held == nullptr || feature.held(*file.format, job.file_options));
        };
        if (std::any_of(files.begin(), files.end(), is_held)) continue;
        const bool may_hold =
            feature.held != nullptr && std::any_of(files.begin(), files.end(), is_taken);
        throw InvalidInput(
            std::string("no output takes ") + feature.in_files + "; " +
            (may_hold ? feature.held_by
                      : "add one of " + extensions_that_take(feature, job.is_in_space())) +
            ", or leave the option out");
    }
    check_constants(job, files, phases);
    if (job.file_options.gltf_nodes == GltfNodes::kCells &&
        !has_mesh(job, &plane::MeshKindRow::faces_have_sites)) {
        throw InvalidInput(
            "Delaunay triangles have no cells that could be nodes; take the mesh voronoi or "
            "grains, or leave the glTF nodes out");
    }
}

std::optional<Colour> background_colour(const std::string& word) {
    if (word == "none") return std::nullopt;
    if (const auto colour = colour_of_hex(word)) return colour;
    throw InvalidInput("background " + word +
                       ": not a colour; take none or #rrggbb, such as #ffffff");
}

}  // namespace pcvt
