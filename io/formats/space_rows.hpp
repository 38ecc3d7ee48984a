#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "io/formats/space_format.hpp"
#include "io/forms/space_surface.hpp"
#include "io/forms/tetrahedra_entities.hpp"
#include "io/gltf/space_gltf.hpp"
#include "io/graphics/obj_reader.hpp"
#include "io/graphics/obj_writer.hpp"
#include "io/graphics/om_reader.hpp"
#include "io/graphics/om_writer.hpp"
#include "io/graphics/ply_reader.hpp"
#include "io/graphics/ply_writer.hpp"
#include "io/graphics/stl_file.hpp"
#include "io/openfoam/foam_polyhedra.hpp"
#include "io/openfoam/foam_tetrahedra.hpp"
#include "io/openfoam/foam_text.hpp"
#include "io/openfoam/foam_writer.hpp"
#include "io/pictures/space_picture.hpp"
#include "io/solvers/inp_tetrahedra.hpp"
#include "io/solvers/msh_tetrahedra.hpp"
#include "io/solvers/msh_writer.hpp"
#include "io/solvers/vtu_tetrahedra.hpp"
#include "io/solvers/vtu_volumes.hpp"
#include "io/solvers/vtu_writer.hpp"

namespace pcvt::space_rows {

// Functions that rows of the table of formats name for space.

/// Encodes volumes, which have one form.
template <auto kEncode>
std::vector<EncodedFile> encode_volumes(const SpaceTile& tile, const FileOptions&,
                                        const std::string& path) {
    return kEncode(tile, path);
}

inline std::vector<EncodedFile> encode_polyhedra(const SpaceTile& tile, const std::string& folder) {
    return encode_foam(foam_case(tile), folder);
}

inline std::vector<EncodedFile> encode_grid(const SpaceTile& tile, const std::string& path) {
    return encode_vtu(vtu_grid(tile), path);
}

inline std::vector<EncodedFile> encode_tetrahedra_grid(const space::TetrahedralMesh& mesh,
                                                       const FileOptions& options,
                                                       const std::string& path) {
    return encode_vtu(vtu_grid(mesh, options.materials), path);
}

inline std::vector<EncodedFile> encode_entities(const space::TetrahedralMesh& mesh,
                                                const FileOptions& options,
                                                const std::string& path) {
    return encode_msh(entity_mesh(mesh, options.materials), path);
}

/// Encodes a picture.
template <auto kEncode>
std::vector<EncodedFile> encode_picture(const SpaceTile& tile, const FileOptions& options,
                                        const std::string& path) {
    return kEncode(tile, options.colouring.value_or(default_colouring(tile.materials)), path);
}

/// The surfaces of a tile that the options choose.
inline SurfaceList chosen_surfaces(const SpaceTile& tile, const FileOptions& options) {
    SurfaceList list = surface_list(tile.mesh, tile.sites, options.surfaces);
    const bool are_cells = options.surfaces == SurfaceForm::kCells;
    return with_materials(std::move(list), tile,
                          are_cells ? options.colouring.value_or(default_colouring(tile.materials))
                                    : Colouring::kFaces);
}

template <auto kEncode, SeamForm kSeam>
std::vector<EncodedFile> encode_surfaces(const SpaceTile& tile, const FileOptions& options,
                                         const std::string& path) {
    return kEncode(surface_mesh(chosen_surfaces(tile, options), kSeam), path);
}

inline std::vector<EncodedFile> encode_triangles(const SpaceTile& tile, const FileOptions& options,
                                                 const std::string& path) {
    return encode_glb_surfaces(chosen_surfaces(tile, options), path);
}

inline std::vector<EncodedFile> encode_boundary(const SpaceTile& tile, const FileOptions&,
                                                const std::string& path) {
    return encode_om_boundary(tile_surface(tile.mesh, tile.sites), path);
}

/// Encodes the closed surfaces of cells, or of cells that tetrahedra fill.
template <class Tile>
std::vector<EncodedFile> encode_closed(const Tile& tile, const FileOptions& options,
                                       const std::string& path) {
    if constexpr (std::is_same_v<Tile, SpaceTile>) {
        return encode_stl(closed_surfaces(tile.mesh, options.surfaces), path);
    } else {
        return encode_stl(closed_surfaces(tile, options.surfaces), path);
    }
}

using Kind = std::optional<SpaceFileKind>;

inline Kind closed_kind(const std::vector<EncodedFile>&) { return SpaceFileKind::kClosedSurfaces; }

inline Kind case_kind(const std::vector<EncodedFile>& files) {
    if (is_foam_of_tetrahedra(files)) return SpaceFileKind::kTetrahedra;
    return is_foam_of_polyhedra(files) ? Kind(SpaceFileKind::kPolyhedra) : std::nullopt;
}

inline std::vector<EncodedFile> encode_case(const space::TetrahedralMesh& mesh,
                                            const FileOptions& options, const std::string& folder) {
    return encode_foam_tetrahedra(mesh, options.materials, folder);
}

/// Reads, and compares, tetrahedra in one file.
template <auto kDecode>
TetrahedralTile decode_one(const std::vector<EncodedFile>& files, double) {
    return kDecode(files.front());
}
template <auto kCompare>
void compare_one(const std::vector<EncodedFile>& files, const TetrahedralTile& tile, double) {
    kCompare(files.front(), tile);
}

template <SpaceFileKind kKind, auto kHolds>
Kind kind_where(const std::vector<EncodedFile>& files) {
    return kHolds(files.front()) ? Kind(kKind) : std::nullopt;
}

inline Kind vtu_kind(const std::vector<EncodedFile>& files) {
    if (holds_vtu_polyhedra(files.front())) return SpaceFileKind::kPolyhedra;
    return holds_vtu_tetrahedra(files.front()) ? Kind(SpaceFileKind::kTetrahedra) : std::nullopt;
}

template <auto kDecode>
Kind surfaces_kind(const std::vector<EncodedFile>& files) {
    if (!states_surfaces(files.front().bytes)) return std::nullopt;
    const bool are_cells = kDecode(files.front()).form == SurfaceForm::kCells;
    return are_cells ? SpaceFileKind::kPolyhedra : SpaceFileKind::kBoundary;
}

inline constexpr SpaceFormat kGmsh{
    .memory = 7900,
    .takes = {.phases = true},
    .encode_tetrahedra = encode_entities,
    .kind = kind_where<SpaceFileKind::kTetrahedra, holds_msh_tetrahedra>,
    .decode_tetrahedra = decode_one<decode_msh_tetrahedra>,
    .compare_tetrahedra = compare_one<compare_msh_tetrahedra>,
    .states_materials = true};

inline constexpr SpaceFormat kAbaqus{
    .memory = 9000,
    .takes = {.job = true, .constants = true, .phases = true, .orientations = true},
    .encode_tetrahedra = encode_tetrahedra_inp,
    .kind = kind_where<SpaceFileKind::kTetrahedra, holds_inp_tetrahedra>,
    .decode_tetrahedra = decode_one<decode_inp_tetrahedra>,
    .compare_tetrahedra = compare_one<compare_inp_tetrahedra>,
    .states_materials = true,
    .rounds_positions = true};

inline constexpr SpaceFormat kFoam{.memory = 6900,
                                   .takes = {.phases = true, .orientations = true},
                                   .paths = foam_paths<FoamCells::kPolyhedra>,
                                   .encode = encode_volumes<encode_polyhedra>,
                                   .encode_tetrahedra = encode_case,
                                   .kind = case_kind,
                                   .decode_tetrahedra = decode_foam_tetrahedra,
                                   .compare_tetrahedra = compare_foam_tetrahedra,
                                   .holds_only_grains = true,
                                   .sorts_corners = true,
                                   .states_materials = true,
                                   .states_weights = true,
                                   .states_short_edges = true};

inline constexpr SpaceFormat kStl{.surfaces = FormatSurfaces::kChosen,
                                  .memory = 11000,
                                  .encode = encode_closed<SpaceTile>,
                                  .encode_tetrahedra = encode_closed<space::TetrahedralMesh>,
                                  .kind = closed_kind,
                                  .holds_only_grains = true,
                                  .is_closed_surfaces = true};

}  // namespace pcvt::space_rows
