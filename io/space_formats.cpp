#include "io/space_formats.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "io/bytes/extension.hpp"
#include "io/forms/space_surface.hpp"
#include "io/gltf/glb_mesh_reader.hpp"
#include "io/gltf/glb_mesh_writer.hpp"
#include "io/graphics/obj_reader.hpp"
#include "io/graphics/obj_writer.hpp"
#include "io/graphics/om_reader.hpp"
#include "io/graphics/om_writer.hpp"
#include "io/graphics/ply_reader.hpp"
#include "io/graphics/ply_writer.hpp"
#include "io/openfoam/foam_polyhedra.hpp"
#include "io/openfoam/foam_text.hpp"
#include "io/openfoam/foam_writer.hpp"
#include "io/pictures/space_picture.hpp"
#include "io/solvers/msh_tetrahedra.hpp"
#include "io/solvers/msh_writer.hpp"
#include "io/solvers/vtu_volumes.hpp"
#include "io/solvers/vtu_writer.hpp"

namespace pcvt {
namespace {

std::vector<std::string> itself(const std::string& path) { return {path}; }

/// Encodes volumes, which have one form.
template <auto kEncode>
std::vector<EncodedFile> encode_volumes(const SpaceTile& tile, const SpaceFileOptions&,
                                        const std::string& path) {
    return kEncode(tile, path);
}

std::vector<EncodedFile> encode_polyhedra(const SpaceTile& tile, const std::string& folder) {
    return encode_foam(foam_case(tile), folder);
}

template <class Mesh>
std::vector<EncodedFile> encode_grid(const Mesh& mesh, const std::string& path) {
    return encode_vtu(vtu_grid(mesh), path);
}

std::vector<EncodedFile> encode_entities(const space::TetrahedralMesh& mesh,
                                         const std::string& path) {
    return encode_msh(entity_mesh(mesh), path);
}

template <auto kEncode, SeamForm kSeam>
std::vector<EncodedFile> encode_surfaces(const SpaceTile& tile, const SpaceFileOptions& options,
                                         const std::string& path) {
    SurfaceList list = surface_list(tile.mesh, tile.sites, options.surfaces);
    return kEncode(surface_mesh(std::move(list), kSeam), path);
}

std::vector<EncodedFile> encode_boundary(const SpaceTile& tile, const SpaceFileOptions&,
                                         const std::string& path) {
    return encode_om_boundary(tile_surface(tile.mesh, tile.sites), path);
}

using Kind = std::optional<SpaceFileKind>;

Kind case_kind(const std::vector<EncodedFile>& files) {
    return is_foam_of_polyhedra(files) ? Kind(SpaceFileKind::kPolyhedra) : std::nullopt;
}

template <SpaceFileKind kKind, auto kHolds>
Kind kind_where(const std::vector<EncodedFile>& files) {
    return kHolds(files.front()) ? Kind(kKind) : std::nullopt;
}

Kind vtu_kind(const std::vector<EncodedFile>& files) {
    if (holds_vtu_polyhedra(files.front())) return SpaceFileKind::kPolyhedra;
    return holds_vtu_tetrahedra(files.front()) ? Kind(SpaceFileKind::kTetrahedra) : std::nullopt;
}

template <auto kDecode>
Kind surfaces_kind(const std::vector<EncodedFile>& files) {
    if (!states_surfaces(files.front().bytes)) return std::nullopt;
    const bool are_cells = kDecode(files.front()).form == SurfaceForm::kCells;
    return are_cells ? SpaceFileKind::kPolyhedra : SpaceFileKind::kBoundary;
}

constexpr std::array kSpaceFormats{
    SpaceFormat{.extension = ".vtu",
                .is_folder = false,
                .surfaces = FormatSurfaces::kNone,
                .memory = 11300,
                .paths = itself,
                .encode = encode_volumes<encode_grid<SpaceTile>>,
                .encode_tetrahedra = encode_grid<space::TetrahedralMesh>,
                .kind = vtu_kind,
                .decode_tetrahedra = decode_vtu_tetrahedra,
                .compare_tetrahedra = compare_vtu_tetrahedra,
                .states_short_edges = true},
    SpaceFormat{.extension = ".foam",
                .is_folder = true,
                .surfaces = FormatSurfaces::kNone,
                .memory = 6900,
                .paths = foam_paths<FoamCells::kPolyhedra>,
                .encode = encode_volumes<encode_polyhedra>,
                .encode_tetrahedra = nullptr,
                .kind = case_kind,
                .states_short_edges = true,
                .check_path = require_foam_path},
    SpaceFormat{.extension = ".msh",
                .is_folder = false,
                .surfaces = FormatSurfaces::kNone,
                .memory = 7900,
                .paths = itself,
                .encode = nullptr,
                .encode_tetrahedra = encode_entities,
                .kind = kind_where<SpaceFileKind::kTetrahedra, holds_msh_tetrahedra>,
                .decode_tetrahedra = decode_msh_tetrahedra,
                .compare_tetrahedra = compare_msh_tetrahedra},
    SpaceFormat{.extension = ".obj",
                .is_folder = false,
                .surfaces = FormatSurfaces::kChosen,
                .memory = 7000,
                .paths = obj_mesh_paths,
                .encode = encode_surfaces<encode_obj_mesh, SeamForm::kLines>,
                .encode_tetrahedra = nullptr,
                .kind = surfaces_kind<decode_obj_surfaces>},
    SpaceFormat{.extension = ".ply",
                .is_folder = false,
                .surfaces = FormatSurfaces::kChosen,
                .memory = 8500,
                .paths = itself,
                .encode = encode_surfaces<encode_ply_mesh, SeamForm::kColumns>,
                .encode_tetrahedra = nullptr,
                .kind = surfaces_kind<decode_ply_surfaces>},
    SpaceFormat{.extension = ".glb",
                .is_folder = false,
                .surfaces = FormatSurfaces::kChosen,
                .memory = 15200,
                .paths = itself,
                .encode = encode_surfaces<encode_glb_mesh, SeamForm::kNone>,
                .encode_tetrahedra = nullptr,
                .kind = kind_where<SpaceFileKind::kTriangles, holds_glb_surfaces>,
                .is_single_precision = true},
    SpaceFormat{.extension = ".om",
                .is_folder = false,
                .surfaces = FormatSurfaces::kBoundary,
                .memory = 7000,
                .paths = itself,
                .encode = encode_boundary,
                .encode_tetrahedra = nullptr,
                .kind = kind_where<SpaceFileKind::kBoundary, holds_om_boundary>},
    SpaceFormat{.extension = ".svg",
                .is_folder = false,
                .surfaces = FormatSurfaces::kNone,
                .memory = 5700,
                .paths = itself,
                .encode = encode_volumes<encode_space_svg>,
                .encode_tetrahedra = nullptr,
                .kind = nullptr},
    SpaceFormat{.extension = ".png",
                .is_folder = false,
                .surfaces = FormatSurfaces::kNone,
                .memory = 5700,
                .paths = itself,
                .encode = encode_volumes<encode_space_png>,
                .encode_tetrahedra = nullptr,
                .kind = nullptr},
    SpaceFormat{.extension = ".txt",
                .is_folder = false,
                .surfaces = FormatSurfaces::kNone,
                .memory = 5700,
                .paths = itself,
                .encode = nullptr,
                .encode_tetrahedra = nullptr,
                .kind = nullptr}};

/// ".a, .b or .c", of the formats for which `chosen` holds.
template <class Chosen>
std::string listed_extensions(const Chosen& chosen) {
    std::vector<std::string_view> extensions;
    for (const SpaceFormat& format : kSpaceFormats) {
        if (chosen(format)) extensions.push_back(format.extension);
    }
    std::string text;
    for (const std::string_view extension : extensions) {
        const bool last = extension == extensions.back();
        text += (text.empty() ? "" : last ? " or " : ", ") + std::string(extension);
    }
    return text;
}

}  // namespace

const SpaceFormat* find_space_format(const std::string& path) {
    const std::string extension = lower_case_extension(path);
    const auto* const found = std::find_if(
        kSpaceFormats.begin(), kSpaceFormats.end(),
        [&extension](const SpaceFormat& format) { return format.extension == extension; });
    return found == kSpaceFormats.end() ? nullptr : found;
}

std::string space_extensions() {
    return listed_extensions([](const SpaceFormat&) { return true; });
}

std::string tetrahedra_extensions() {
    return listed_extensions(
        [](const SpaceFormat& format) { return format.encode_tetrahedra != nullptr; });
}

std::string short_edges_extensions() {
    return listed_extensions([](const SpaceFormat& format) { return format.states_short_edges; });
}

std::string surface_extensions() {
    return listed_extensions(
        [](const SpaceFormat& format) { return format.surfaces == FormatSurfaces::kChosen; });
}

std::optional<SpaceFileKind> space_file_kind(const std::vector<EncodedFile>& files) {
    // A case is a folder, whose files have other extensions.
    if (const Kind kind = case_kind(files)) return kind;
    const SpaceFormat* const format = find_space_format(files.front().path);
    if (format == nullptr || format->kind == nullptr) return std::nullopt;
    return format->kind(files);
}

}  // namespace pcvt
