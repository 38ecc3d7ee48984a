#include "io/formats/formats.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/formats/extension.hpp"
#include "io/formats/plane_rows.hpp"
#include "io/formats/single_precision.hpp"
#include "io/formats/space_rows.hpp"
#include "io/forms/triangle_elements.hpp"
#include "io/gltf/gltf_reader.hpp"
#include "io/gltf/plane_gltf.hpp"
#include "io/graphics/obj_reader.hpp"
#include "io/graphics/obj_writer.hpp"
#include "io/graphics/om_reader.hpp"
#include "io/graphics/om_writer.hpp"
#include "io/graphics/ply_reader.hpp"
#include "io/graphics/ply_writer.hpp"
#include "io/openfoam/foam_fields.hpp"
#include "io/openfoam/foam_layer.hpp"
#include "io/openfoam/foam_text.hpp"
#include "io/openfoam/foam_writer.hpp"
#include "io/page/html_writer.hpp"
#include "io/pictures/dxf_writer.hpp"
#include "io/pictures/png_writer.hpp"
#include "io/solvers/inp_fields.hpp"
#include "io/solvers/inp_reader.hpp"
#include "io/solvers/inp_writer.hpp"
#include "io/solvers/msh_fields.hpp"
#include "io/solvers/msh_reader.hpp"
#include "io/solvers/vtu_arrays.hpp"
#include "io/solvers/vtu_reader.hpp"
#include "io/voxels/vti_writer.hpp"
#include "mesher/base/error.hpp"

namespace pcvt {
namespace {

constexpr std::array<Format, 18> kFormats{{
    {.extension = ".obj",
     .description = "Wavefront OBJ, with .mtl and .seam.json beside it",
     .write = encode_obj,
     .read = decode_obj,
     .paths = obj_paths,
     .takes = {.colouring = true, .phases = true, .orientations = true},
     .states_orbits = true,
     .memory = {900, 280, 250},
     .space = SpaceFormat{.surfaces = FormatSurfaces::kChosen,
                          .memory = 7000,
                          .takes = {.colouring = true, .phases = true, .orientations = true},
                          .paths = obj_mesh_paths,
                          .encode = space_rows::encode_surfaces<encode_obj_mesh, SeamForm::kLines>,
                          .kind = space_rows::surfaces_kind<decode_obj_surfaces>,
                          .states_materials = true,
                          .states_weights = true}},
    {.extension = ".ply",
     .description = "PLY, ASCII with double coordinates, or float with --float32",
     .write = encode_ply,
     .read = decode_ply,
     .check = require_ply_precision,
     .takes = {.single_precision = true, .colouring = true, .phases = true, .orientations = true},
     .memory = {900, 300, 250},
     .space =
         SpaceFormat{.surfaces = FormatSurfaces::kChosen,
                     .memory = 8500,
                     .takes = {.colouring = true, .phases = true, .orientations = true},
                     .encode = space_rows::encode_surfaces<encode_ply_mesh, SeamForm::kColumns>,
                     .kind = space_rows::surfaces_kind<decode_ply_surfaces>,
                     .states_materials = true,
                     .states_weights = true}},
    {.extension = ".glb",
     .description = "glTF 2.0, one binary file",
     .write = encode_glb,
     .read = decode_gltf,
     .check = require_gltf_precision,
     .is_single_precision = true,
     .moves_distant_tiles = true,
     .takes = {.gltf_nodes = true, .colouring = true, .phases = true, .orientations = true},
     .memory = {985, 280, 240},
     .space =
         SpaceFormat{.surfaces = FormatSurfaces::kChosen,
                     .memory = 15200,
                     .takes = {.colouring = true, .phases = true, .orientations = true},
                     .encode = space_rows::encode_triangles,
                     .kind = space_rows::kind_where<SpaceFileKind::kTriangles, holds_glb_surfaces>,
                     .states_materials = true,
                     .states_weights = true}},
    {.extension = ".gltf",
     .description = "glTF 2.0, one text file",
     .write = encode_gltf,
     .read = decode_gltf,
     .check = require_gltf_precision,
     .is_single_precision = true,
     .moves_distant_tiles = true,
     .takes = {.gltf_nodes = true, .colouring = true, .phases = true, .orientations = true},
     .memory = {1200, 490, 380}},
    {.extension = ".om",
     .description = "OpenMesh, with the identification as properties",
     .write = encode_om,
     .read = decode_om,
     .memory = {1230, 560, 460},
     .space =
         SpaceFormat{.surfaces = FormatSurfaces::kBoundary,
                     .memory = 7000,
                     .encode = space_rows::encode_boundary,
                     .kind = space_rows::kind_where<SpaceFileKind::kBoundary, holds_om_boundary>}},
    {.extension = ".stl",
     .description = "binary STL, closed surfaces of cells or of the tile in space",
     .note = "STL states no unit and no cells; lengths are those of --period, rounded to 32 bits",
     .is_single_precision = true,
     .memory = {},
     .space = space_rows::kStl},
    {.extension = ".msh",
     .description = "Gmsh MSH 4.1 with $Periodic, triangles or tetrahedra",
     .write = plane_rows::write_msh,
     .read = decode_msh,
     .fields = msh_fields,
     .holds_polygons = false,
     .highest_order = 2,
     .takes = {.phases = true},
     .states_materials = true,
     .states_orbits = true,
     .memory = {0, 2030, 540},
     .space = space_rows::kGmsh},
    {.extension = ".inp",
     .description = "Abaqus and CalculiX with *EQUATION, triangles, wedges or tetrahedra",
     .write = encode_inp,
     .read = decode_inp,
     .fields = inp_fields,
     .holds_polygons = false,
     .highest_order = 2,
     .check = plane_rows::require_solver_input,
     .takes = {.element = true,
               .job = true,
               .constants = true,
               .thickness = true,
               .phases = true,
               .orientations = true},
     .states_materials = true,
     .states_orbits = true,
     .memory = {0, 1180, 800},
     .space = space_rows::kAbaqus},
    {.extension = ".vtu",
     .description = "VTK unstructured grid, ASCII, with double coordinates",
     .write = plane_rows::write_vtu,
     .read = decode_vtu,
     .fields = vtu_fields,
     .highest_order = 2,
     .takes = {.phases = true},
     .states_materials = true,
     .states_orbits = true,
     .memory = {1180, 470, 440},
     .space = SpaceFormat{.memory = 11300,
                          .takes = {.phases = true, .orientations = true},
                          .encode = space_rows::encode_volumes<space_rows::encode_grid>,
                          .encode_tetrahedra = space_rows::encode_tetrahedra_grid,
                          .kind = space_rows::vtu_kind,
                          .decode_tetrahedra = space_rows::decode_one<decode_vtu_tetrahedra>,
                          .compare_tetrahedra = space_rows::compare_one<compare_vtu_tetrahedra>,
                          .states_materials = true,
                          .states_weights = true,
                          .states_metric = true,
                          .states_short_edges = true}},
    {.extension = ".svg",
     .description = "a picture, or with --cut lines for cutters",
     .write = plane_rows::write_svg,
     .takes = {.cut_width = true,
               .colouring = true,
               .background = true,
               .phases = true,
               .orientations = true},
     .memory = {710, 285, 395},
     .space = SpaceFormat{.memory = 5700,
                          .takes = {.colouring = true, .phases = true, .orientations = true},
                          .encode = space_rows::encode_picture<encode_space_svg>}},
    {.extension = ".png",
     .description = "an image of one period that repeats without a seam",
     .write = encode_tile_png,
     .check = plane_rows::require_image_size,
     .takes = {.pixels = true, .colouring = true, .phases = true, .orientations = true},
     .memory = {930, 510, 520},
     .space = SpaceFormat{.memory = 5700,
                          .takes = {.colouring = true, .phases = true, .orientations = true},
                          .encode = space_rows::encode_picture<encode_space_png>}},
    {.extension = ".dxf",
     .description = "DXF R12 with each edge once, for cutters",
     .write = encode_dxf,
     .takes = {.cut_width = true},
     .memory = {1180, 580, 465}},
    {.extension = ".html",
     .description = "a page that shows the tile in any browser",
     .write = encode_html,
     .takes = {.colouring = true, .phases = true, .orientations = true},
     .memory = {1190, 320, 305}},
    {.extension = ".foam",
     .description = "OpenFOAM, a case folder that icoFoam runs",
     .write = plane_rows::write_foam,
     .read = decode_foam_layer,
     .fields = foam_fields,
     .holds_sites = false,
     .paths = foam_paths<FoamCells::kLayer>,
     .is_folder = true,
     .check = plane_rows::require_prisms,
     .check_path = require_foam_path,
     .takes = {.thickness = true, .phases = true},
     .states_materials = true,
     .memory = {1900, 1080, 815},
     .space = space_rows::kFoam},
    {.extension = ".nc",
     .description =
         "MPAS mesh of the whole torus, which is rectangular, with .graph.info beside it",
     .write = plane_rows::write_mpas,
     .read = plane_rows::read_mpas,
     .paths = plane_rows::mpas_paths,
     .check = plane_rows::require_mpas_torus,
     .takes = {.coriolis = true},
     .memory = {5400, 0, 0}},
    {.extension = ".vti",
     .description = "cells as voxels of a rectangle or a box for DAMASK, VTK image data, with "
                    ".material.yaml beside it",
     .write = encode_vti,
     .read = decode_vti,
     .paths = vti_paths,
     .check = plane_rows::require_voxel_grid,
     .takes = {.voxels = true, .constants = true, .phases = true, .orientations = true},
     .memory = {440, 0, 0},
     .space =
         SpaceFormat{
             .memory = 5700,
             .takes = {.voxels = true, .constants = true, .phases = true, .orientations = true},
             .paths = vti_paths,
             .encode_voxels = encode_space_vti}},
    {.extension = ".csv",
     .description = "a table of the cells, one row a site",
     .write = plane_rows::write_cells,
     .read = plane_rows::reads_back_cells,
     .takes = {.phases = true, .orientations = true},
     .memory = {815, 0, 0},
     .space = SpaceFormat{.memory = 5700, .takes = {.phases = true, .orientations = true}}},
    {.extension = ".txt",
     .description = "the sites, in the order of the input",
     .write = plane_rows::write_sites,
     .read = plane_rows::reads_back_sites,
     .memory = {0, 0, 0},
     .space = SpaceFormat{.memory = 5700}},
}};

/// ".a, .b or .c", of the formats of space for which `chosen` holds.
template <class Chosen>
std::string listed_extensions(const Chosen& chosen) {
    std::vector<std::string_view> extensions;
    for (const Format& format : kFormats) {
        if (format.space && chosen(*format.space)) extensions.push_back(format.extension);
    }
    std::string text;
    for (const std::string_view extension : extensions) {
        const bool last = extension == extensions.back();
        text += (text.empty() ? "" : last ? " or " : ", ") + std::string(extension);
    }
    return text;
}

}  // namespace

double FormatRequest::spacing() const { return std::sqrt(lattice.area() / n_all_sites()); }

plane::VoxelCounts requested_voxels(const FormatRequest& request) {
    plane::VoxelCounts counts = request.files.voxels;
    if (counts.x == 0) {
        counts = default_voxels(request.lattice, request.n_all_sites());
        counts.z = request.files.voxels.z;
    }
    voxel_grid(request.lattice, {0, 0}, counts);
    return counts;
}

VoxelCounts requested_voxels(const space::Lattice& lattice, double n_sites, VoxelCounts counts) {
    // Layers without voxels along x and y are no default.
    if (counts == VoxelCounts{}) counts = default_voxels(lattice, n_sites);
    voxel_grid(lattice, {0, 0, 0}, counts);
    return counts;
}

std::vector<std::string> single_path(const std::string& path) { return {path}; }

std::span<const Format> formats() { return kFormats; }

std::vector<EncodedFile> encode_tile(const Format& format, const plane::Tile& tile,
                                     const std::string& path, const FileOptions& options) {
    if (const auto* write = std::get_if<TileWriter*>(&format.write)) return (*write)(tile, path);
    return std::get<TileFormWriter*>(format.write)(tile, options, path);
}

TileFile decode_tile(const Format& format, const std::vector<EncodedFile>& files,
                     const std::optional<plane::Lattice>& lattice) {
    return std::get<TileReader*>(format.read)(files, lattice);
}

const Format* find_format(const std::string& path) {
    const std::string extension = lower_case_extension(path);
    const auto found = std::find_if(kFormats.begin(), kFormats.end(), [&](const Format& format) {
        return format.extension == extension;
    });
    return found == kFormats.end() ? nullptr : &*found;
}

const Format* find_format(const std::vector<EncodedFile>& files) {
    const auto found = std::find_if(kFormats.begin(), kFormats.end(), [&](const Format& format) {
        return format.is_folder && format.space && format.space->kind(files);
    });
    return found == kFormats.end() ? find_format(files.front().path) : &*found;
}

std::string space_extensions() {
    return listed_extensions([](const SpaceFormat&) { return true; });
}

std::string tetrahedra_extensions(plane::MeshKind mesh) {
    return listed_extensions([mesh](const SpaceFormat& format) {
        return format.shows_tetrahedra(mesh) && !format.is_closed_surfaces;
    });
}

std::string short_edges_extensions() {
    return listed_extensions([](const SpaceFormat& format) { return format.states_short_edges; });
}

std::string weight_extensions() {
    return listed_extensions(
        [](const SpaceFormat& format) { return format.takes_weights(plane::MeshKind::kVoronoi); });
}

std::string metric_extensions() {
    return listed_extensions(
        [](const SpaceFormat& format) { return format.takes_metric(plane::MeshKind::kVoronoi); });
}

std::string surface_extensions() {
    return listed_extensions(
        [](const SpaceFormat& format) { return format.surfaces == FormatSurfaces::kChosen; });
}

std::optional<SpaceFileKind> space_file_kind(const std::vector<EncodedFile>& files) {
    const Format* const format = find_format(files);
    const bool is_read = format != nullptr && format->space && format->space->kind != nullptr;
    return is_read ? format->space->kind(files) : std::nullopt;
}

}  // namespace pcvt
