#include "io/formats/output_files.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>

#include "io/bytes/nearest_word.hpp"
#include "io/formats/extension.hpp"
#include "io/formats/single_precision.hpp"
#include "io/forms/triangle_elements.hpp"
#include "io/solvers/inp_sections.hpp"
#include "mesher/base/error.hpp"

namespace pcvt {
namespace {

/// The meshes of a format that holds no tile.
constexpr std::array kCells{plane::MeshKind::kVoronoi};

/// The extensions of the formats that `keep` takes.
template <class Keep>
std::string kept_extensions(const std::string& separator, const Keep& keep) {
    std::string all;
    for (const Format& format : formats()) {
        if (!keep(format)) continue;
        if (!all.empty()) all += separator;
        all += format.extension;
    }
    return all;
}

/// The extension that `extension` is a misspelling of; empty if there is none.
std::string nearest_extension(const std::string& extension) {
    if (extension.empty()) return {};
    std::vector<std::string> words;
    for (const Format& format : formats()) words.emplace_back(format.extension.substr(1));
    const std::string meant = nearest_word(extension.substr(1), words);
    return meant.empty() ? meant : "." + meant;
}

/// @param known  the extensions that the output may have.
[[noreturn]] void refuse_extension(const std::string& path, const std::string& known) {
    const std::string extension = lower_case_extension(path);
    if (const std::string meant = nearest_extension(extension); !meant.empty()) {
        throw InvalidInput(path + ": unknown extension " + extension + "; did you mean " + meant +
                           "?");
    }
    throw InvalidInput(path + ": " +
                       (extension.empty() ? "no extension" : "unknown extension " + extension) +
                       "; take one of " + known);
}

/// Calls a check of a format, whose refusals begin with the path.
template <class Check>
void naming_path(const std::string& path, const Check& check) {
    try {
        check();
    } catch (const InvalidInput& error) {
        throw InvalidInput(path + ": " + error.what());
    }
}

/// The format of an output, whose path its programs can open.
/// @param known  the extensions that the output may have.
const Format& format_of_output(const std::string& path, std::string (*known)()) {
    const Format* const format = find_format(path);
    if (format == nullptr) refuse_extension(path, known());
    if (format->check_path != nullptr) naming_path(path, [&] { format->check_path(path); });
    return *format;
}

bool has_cells(plane::MeshKind kind) { return mesh_kind_row(kind).faces_have_sites; }

using Meshes = std::span<const plane::MeshKind>;

/// Requires that a format holds the mesh `content.tile.kind`; any one where it needs no tile.
/// @param meshes  of the run.
void require_held(const Format& format, const FormatRequest& content, const RunRequest& run,
                  Meshes meshes, const std::string& path) {
    if (format.needs_torus() && (content.has_weights || run.has_metric)) {
        throw InvalidInput(path +
                           ": the grid needs Voronoi cells; leave areas, weights and aspect out, "
                           "or take another format, such as .vtu");
    }
    if (format.check != nullptr) naming_path(path, [&] { format.check(content); });
    // Beside a mesh of cells, the file of the triangles may lack what belongs to cells.
    const bool needs_cells =
        !format.holds_polygons || std::none_of(meshes.begin(), meshes.end(), has_cells);
    if (format.states_materials && run.has_materials && !has_cells(content.tile.kind) &&
        needs_cells) {
        throw InvalidInput(path +
                           ": Delaunay triangles are not cells, which phases and orientations "
                           "belong to; take the mesh grains");
    }
    if (format.needs_tile() && !format.holds_polygons) require_triangles(content.tile.kind, path);
}

void add_files(const std::string& path, const RunRequest& run, Meshes meshes,
               std::vector<OutputFile>& files) {
    const Format& format = format_of_output(path, output_extensions);
    if (format.is_only_in_space()) {
        throw InvalidInput(path + ": " + std::string(format.extension) +
                           " holds tiles in space only; give three period vectors, or take another "
                           "format, such as .obj");
    }
    const Meshes written = format.needs_tile() ? meshes : Meshes(kCells);
    FormatRequest content = run.content;
    for (std::size_t m = 0; m < written.size(); ++m) {
        content.tile.kind = written[m];
        const std::string suffix = std::string("-") + mesh_kind_row(content.tile.kind).word;
        const std::string name = written.size() > 1 ? with_suffix(path, suffix) : path;
        require_held(format, content, run, meshes, path);
        files.push_back({format.paths(name), &format,
                         format.needs_tile() ? static_cast<int>(m) : -1,
                         format.is_folder ? name : std::string()});
    }
}

/// Requires that 32-bit floats hold the lengths of the tile, of a run that knows its sites.
void require_precision(const SpaceRequest& run) {
    if (run.n_sites < 1) return;
    double longest = 0;
    for (const space::Vec3& period : run.lattice.periods()) {
        longest = std::max(longest, period.norm());
    }
    require_floats({.h = run.lattice.spacing(run.n_sites),
                    .shortest_period = reduce(run.lattice).reduced.a().norm(),
                    .largest = longest});
}

void add_files(const std::string& path, const SpaceRequest& run, Meshes meshes,
               std::vector<OutputFile>& files) {
    const plane::MeshKind mesh = meshes.front();
    const Format& format = format_of_output(path, space_extensions);
    if (!format.space) {
        throw InvalidInput(path + ": " + std::string(format.extension) +
                           " does not support three dimensions; take " + space_extensions() +
                           ", or give two period vectors");
    }
    if (mesh != plane::MeshKind::kVoronoi && format.space->encode != nullptr &&
        !format.space->shows_tetrahedra(mesh)) {
        throw InvalidInput(path + ": the format holds no " +
                           (format.space->holds_only_grains ? "Delaunay " : "") +
                           "tetrahedra; take " + tetrahedra_extensions(mesh) +
                           ", or write the cells in a run of their own");
    }
    if (run.is_box && format.space->shows_tetrahedra(mesh) && mesh != plane::MeshKind::kGrains) {
        throw InvalidInput(path +
                           ": --outline box cannot cut Delaunay tetrahedra; add --mesh grains, or "
                           "leave the outline out");
    }
    if (run.short_edges > 0 && !format.space->takes_short_edges(mesh)) {
        throw InvalidInput(path + ": such files cannot say that short edges were removed; take " +
                           short_edges_extensions() + " with the cells");
    }
    if (run.has_weights && !format.space->takes_weights(mesh)) {
        throw InvalidInput(path + ": such files cannot state the weights of power cells; take " +
                           weight_extensions());
    }
    if (run.has_metric && !format.space->takes_metric(mesh)) {
        throw InvalidInput(path + ": such files cannot state the aspect of elongated cells; take " +
                           metric_extensions());
    }
    if (format.space->takes.voxels) {
        naming_path(path,
                    [&] { requested_voxels(run.lattice, std::max(run.n_sites, 1), run.voxels); });
    }
    if (format.is_single_precision) naming_path(path, [&] { require_precision(run); });
    files.push_back({.paths = format.space->paths(path),
                     .format = &format,
                     .folder = format.is_folder ? path : std::string()});
}

}  // namespace

void add_output(const std::string& path, const OutputRequest& request, Meshes meshes,
                std::vector<OutputFile>& files) {
    std::visit([&](const auto& run) { add_files(path, run, meshes, files); }, request);
}

std::string format_note(const std::string& path) {
    const Format* const format = find_format(path);
    return format == nullptr ? "" : std::string(format->note);
}

std::string without_slash(const std::string& path) {
    if (!path.ends_with('/')) return path;
    const std::string folder = path.substr(0, path.size() - 1);
    const Format* format = find_format(folder);
    return format != nullptr && format->is_folder ? folder : path;
}

std::string with_suffix(const std::string& path, const std::string& suffix) {
    const std::size_t extension = std::filesystem::path(path).extension().string().size();
    return path.substr(0, path.size() - extension) + suffix + path.substr(path.size() - extension);
}

std::string output_extensions() {
    return kept_extensions(" ", [](const Format&) { return true; });
}

std::string readable_extensions() {
    return kept_extensions(" ", [](const Format& format) { return format.is_readable(); });
}

std::string second_order_extensions() {
    return kept_extensions(", ", [](const Format& format) { return format.highest_order > 1; });
}

std::vector<NamedConstants> stated_constants(const std::vector<OutputFile>& files,
                                             const FileOptions& options,
                                             const CellMaterials& materials) {
    const bool are_chosen = options.elastic.are_given();
    for (const OutputFile& file : files) {
        const bool states_chosen = are_chosen && file.format->states_constants(options);
        if (!states_chosen && !file.format->holds_job(options)) continue;
        return chosen_materials(options.elastic, materials, inp_standard_constants(materials));
    }
    return {};
}

}  // namespace pcvt
