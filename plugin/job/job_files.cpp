#include "plugin/job/job_files.hpp"

#include <algorithm>
#include <filesystem>

#include "io/bytes/extension.hpp"
#include "io/bytes/nearest_word.hpp"
#include "io/forms/triangle_elements.hpp"
#include "io/outputs/distinct_paths.hpp"
#include "io/outputs/recovery.hpp"
#include "io/outputs/writable_paths.hpp"
#include "io/solvers/inp_sections.hpp"
#include "plugin/job/contradictions.hpp"
#include "plugin/job/features.hpp"
#include "plugin/job/job_checks.hpp"
#include "plugin/job/space_files.hpp"

namespace pcvt {
namespace {

namespace fs = std::filesystem;

/// The extension that `extension` is a misspelling of; empty if there is none.
std::string nearest_extension(const std::string& extension) {
    if (extension.empty()) return {};
    std::vector<std::string> words;
    for (const Format& format : formats()) words.emplace_back(format.extension.substr(1));
    const std::string meant = nearest_word(extension.substr(1), words);
    return meant.empty() ? meant : "." + meant;
}

/// @param known  the extensions that the job may have.
[[noreturn]] void refuse_extension(const std::string& path, const std::string& known) {
    const std::string extension = lower_case_extension(path);
    if (const std::string meant = nearest_extension(extension); !meant.empty()) {
        throw InvalidInput("-o " + path + ": unknown extension " + extension + "; did you mean " +
                           meant + "?");
    }
    throw InvalidInput("-o " + path + ": " +
                       (extension.empty() ? "no extension" : "unknown extension " + extension) +
                       "; take one of " + known);
}

/// The format of an output, whose path its programs can open.
const Format& format_of(const Job& job, const std::string& path) {
    const Format* const format = find_format(path);
    if (format == nullptr) {
        refuse_extension(path, job.is_in_space() ? space_extensions() : output_extensions());
    }
    if (format->check_path == nullptr) return *format;
    try {
        format->check_path(path);
    } catch (const InvalidInput& error) {
        throw InvalidInput("-o " + path + ": " + error.what());
    }
    return *format;
}

std::string kind_suffix(plane::MeshKind kind) {
    return std::string("-") + mesh_kind_row(kind).word;
}

/// @param kind  of the mesh that goes into the file; any one where the format needs no tile.
void check_format(const Job& job, const Format& format, plane::MeshKind kind,
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
        !format.holds_polygons || !has_mesh(job, &plane::MeshKindRow::faces_have_sites);
    if (format.states_materials && (job.has_inclusions() || !job.materials.empty()) &&
        !mesh_kind_row(kind).faces_have_sites && needs_cells) {
        throw InvalidInput("-o " + path +
                           ": Delaunay triangles are no cells, which phases and orientations "
                           "belong to; take the mesh grains");
    }
    if (format.needs_tile() && !format.holds_polygons) require_triangles(kind, "-o " + path);
}

void add_output(const Job& job, const std::string& path, std::vector<JobFile>& files) {
    const Format& format = format_of(job, path);
    if (job.is_in_space()) {
        files.push_back(space_file(job, format, path));
        return;
    }
    if (!format.needs_tile()) {
        check_format(job, format, plane::MeshKind::kVoronoi, path);
        files.push_back({format.paths(path), &format});
        return;
    }
    for (std::size_t m = 0; m < job.meshes.size(); ++m) {
        check_format(job, format, job.meshes[m], path);
        const std::string suffix = job.meshes.size() > 1 ? kind_suffix(job.meshes[m]) : "";
        const std::string name = with_suffix(path, suffix);
        files.push_back({format.paths(name), &format, static_cast<int>(m),
                         format.is_folder ? name : std::string()});
    }
}

/// The extensions of the formats that `keep` takes.
template <class Keep>
std::string extensions(const std::string& separator, const Keep& keep) {
    std::string all;
    for (const Format& format : formats()) {
        if (!keep(format)) continue;
        if (!all.empty()) all += separator;
        all += format.extension;
    }
    return all;
}

/// The widths of a tile for cutters, in millimetres.
constexpr double kLeastCutWidth = 1e-3;
constexpr double kLargestCutWidth = 1e6;

std::string extensions_that_take(const FeatureRow& feature) {
    std::string text;
    for (const Format& format : formats()) {
        if (!(format.*feature.taken)) continue;
        text += (text.empty() ? "" : " or ") + std::string(format.extension);
    }
    return text;
}

bool has_job(const JobFile& file, const FileOptions& options) {
    return file.format->takes_job && options.job != SolverJob::kNone;
}

/// Whether a file states the elastic constants of a user.
bool states_chosen_constants(const JobFile& file, const FileOptions& options) {
    return file.format->takes_constants && (!file.format->takes_job || has_job(file, options));
}

void check_constants(const Job& job, const std::vector<JobFile>& files,
                     const std::vector<std::string>& phases) {
    if (files.empty()) return;
    const FileOptions& options = job.file_options;
    bool is_stated = options.elastic.empty();
    for (const JobFile& file : files) {
        is_stated = is_stated || states_chosen_constants(file, options);
        if (!has_job(file, options)) continue;
        require_choice(options.elastic, phases);
        if (phases.empty() || mesh_kind_row(job.meshes[file.mesh]).faces_have_sites) continue;
        throw InvalidInput("-o " + file.paths.front() +
                           ": --job elastic would give Delaunay triangles one material, because "
                           "they have no phases; take the mesh grains");
    }
    if (!is_stated) {
        throw InvalidInput(
            "--material gives the elastic constants of --job elastic; add it, or leave --material "
            "out");
    }
    require_materials_of(options.elastic, phases);
}

}  // namespace

FormatRequest format_request(const Job& job, plane::MeshKind kind) {
    return {.lattice = job.in_plane().lattice.repeated(job.tile.columns, job.tile.rows),
            .kind = kind,
            .outline = job.tile.outline,
            .short_edges = job.tile.short_edges,
            .n_sites = double(job.n_wanted()),
            .n_periods = double(job.tile.columns) * job.tile.rows,
            .walls = job.walls,
            .has_holes = !job.holes.empty(),
            .has_weights = job.areas.has_value(),
            .origin = job.tile.origin,
            .files = job.file_options};
}

std::string output_extensions() {
    return extensions(" ", [](const Format&) { return true; });
}

std::string readable_extensions() {
    return extensions(" ", [](const Format& format) { return format.is_readable(); });
}

std::string second_order_extensions() {
    return extensions(", ", [](const Format& format) { return format.highest_order > 1; });
}

std::string without_slash(const std::string& path) {
    if (!path.ends_with('/')) return path;
    const std::string folder = path.substr(0, path.size() - 1);
    const Format* format = find_format(folder);
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
    const bool held = std::any_of(files.begin(), files.end(), [](const JobFile& file) {
        return file.format->highest_order > 1;
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
        if (feature.taken == nullptr || files.empty() || !feature.is_chosen(job)) continue;
        // Files for cutters have no colours and no background.
        const bool taken = std::any_of(files.begin(), files.end(), [&](const JobFile& file) {
            const bool is_cut = cut_width != 0 && file.format->takes_cut_width;
            return file.format->*feature.taken && (!is_cut || feature.feature == Feature::kCut);
        });
        if (taken) continue;
        throw InvalidInput(std::string("no output takes ") + feature.in_files + "; add one of " +
                           extensions_that_take(feature) + ", or leave the option out");
    }
    check_constants(job, files, phases);
    if (job.file_options.gltf_nodes == GltfNodes::kCells &&
        !has_mesh(job, &plane::MeshKindRow::faces_have_sites)) {
        throw InvalidInput(
            "Delaunay triangles have no cells that could be nodes; take the mesh voronoi or "
            "grains, or leave the glTF nodes out");
    }
}

std::vector<NamedConstants> stated_constants(const std::vector<JobFile>& files,
                                             const FileOptions& options,
                                             const CellMaterials& materials) {
    for (const JobFile& file : files) {
        const bool is_chosen =
            !options.elastic.materials.empty() && states_chosen_constants(file, options);
        if (!is_chosen && !has_job(file, options)) continue;
        return chosen_materials(options.elastic, materials, inp_standard_constants(materials));
    }
    return {};
}

std::optional<Colour> background_colour(const std::string& word) {
    if (word == "none") return std::nullopt;
    if (const auto colour = colour_of_hex(word)) return colour;
    throw InvalidInput("background " + word +
                       ": not a colour; take none or #rrggbb, such as #ffffff");
}

}  // namespace pcvt
