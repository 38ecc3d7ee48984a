#include "io/tile_formats.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "io/bytes/extension.hpp"
#include "io/cutting/dxf_writer.hpp"
#include "io/cutting/svg_cut_writer.hpp"
#include "io/gltf/gltf_reader.hpp"
#include "io/gltf/gltf_writer.hpp"
#include "io/graphics/obj_reader.hpp"
#include "io/graphics/obj_writer.hpp"
#include "io/graphics/om_reader.hpp"
#include "io/graphics/om_writer.hpp"
#include "io/graphics/ply_reader.hpp"
#include "io/graphics/ply_writer.hpp"
#include "io/mpas/mpas_graph.hpp"
#include "io/mpas/mpas_reader.hpp"
#include "io/mpas/mpas_writer.hpp"
#include "io/openfoam/foam_fields.hpp"
#include "io/openfoam/foam_layer.hpp"
#include "io/openfoam/foam_text.hpp"
#include "io/openfoam/foam_writer.hpp"
#include "io/page/html_writer.hpp"
#include "io/pictures/png_writer.hpp"
#include "io/pictures/svg_writer.hpp"
#include "io/run_files/cell_reader.hpp"
#include "io/run_files/site_reader.hpp"
#include "io/run_files/site_writer.hpp"
#include "io/single_precision.hpp"
#include "io/solvers/inp_fields.hpp"
#include "io/solvers/inp_reader.hpp"
#include "io/solvers/inp_writer.hpp"
#include "io/solvers/msh_fields.hpp"
#include "io/solvers/msh_reader.hpp"
#include "io/solvers/msh_writer.hpp"
#include "io/solvers/vtu_arrays.hpp"
#include "io/solvers/vtu_reader.hpp"
#include "io/solvers/vtu_writer.hpp"
#include "io/voxels/vti_writer.hpp"
#include "mesher/base/error.hpp"

namespace pcvt {
namespace {

/// The thickness of a layer over the mean distance of the sites. checkMesh finds faults at 1e-8
/// and 1e8.
constexpr double kLeastThickness = 1e-3;
constexpr double kLargestThickness = 1e3;

/// Pieces of cells are slivers where the box cuts a cell near its corner.
void require_prisms(const FormatRequest& request) {
    const double layers = request.files.thickness / request.spacing();
    if (layers != 0 && !(layers >= kLeastThickness && layers <= kLargestThickness)) {
        throw InvalidInput(
            "the thickness is not between 0.001 and 1000 times the mean distance of the sites, "
            "sqrt(area / n); take one nearer to it");
    }
    if (request.outline == plane::Outline::kWhole || request.kind != plane::MeshKind::kVoronoi)
        return;
    throw InvalidInput(
        "cells that the box cuts are too thin for finite volumes; take the whole outline, or the "
        "mesh grains");
}

/// The mean strains of the job need equations across all sides.
void require_job_without_walls(const FormatRequest& request) {
    if (request.files.job == SolverJob::kNone || request.walls == Walls::kNone) return;
    throw InvalidInput(
        "the job prescribes mean strains, which need a tile that is periodic along both "
        "directions; "
        "leave the job or the walls out");
}

/// MPAS takes a rectangular torus, and the Voronoi diagram as it is.
void require_mpas_torus(const FormatRequest& request) {
    if (request.walls != Walls::kNone) {
        throw InvalidInput(
            "MPAS meshes are periodic along both directions; leave the walls out, or take .vtu");
    }
    if (request.has_holes) {
        throw InvalidInput(
            "MPAS meshes of pcvt cover the whole torus; leave the holes out, or take .vtu");
    }
    if (request.short_edges > 0) {
        throw InvalidInput("MPAS needs every Voronoi edge; remove no short edges");
    }
    rectangular_periods(request.lattice);
}

/// The mesh, and the graph of its cells beside it.
std::vector<std::string> mpas_paths(const std::string& path) {
    return {path, std::filesystem::path(path).replace_extension(".graph.info").string()};
}

void require_image_size(const FormatRequest& request) {
    const int pixels = request.files.pixels;
    image_height(request.lattice, pixels == 0 ? kDefaultPixels : pixels);
}

void require_voxel_grid(const FormatRequest& request) {
    if (request.has_holes) {
        throw InvalidInput(
            "voxels fill the whole rectangle; leave the holes out, whose tags are then phases, or "
            "take .vtu");
    }
    if (request.walls != Walls::kNone) {
        throw InvalidInput(
            "DAMASK's voxels are periodic along both directions; leave the walls out, or take "
            ".vtu");
    }
    requested_voxels(request);
}

std::vector<EncodedFile> write_mpas(const Torus& torus, const std::string& path) {
    MpasGrid grid = mpas_grid(torus.cells, torus.origin);
    if (!torus.site_densities.empty()) fill_mesh_density(torus.site_densities, grid);
    if (torus.coriolis) fill_coriolis({(*torus.coriolis)[0], (*torus.coriolis)[1]}, grid);
    const std::vector<std::string> paths = mpas_paths(path);
    std::vector<EncodedFile> files = only_file(paths[0], encode_mpas(grid, torus.history));
    files.push_back({paths[1], encode_mpas_graph(grid)});
    return files;
}

MpasGrid read_mpas(const std::vector<EncodedFile>& files) {
    return decode_mpas(files.front().path, files.front().bytes);
}

std::vector<EncodedFile> write_sites(const plane::Points& sites, const std::string& path) {
    return only_file(path, encode_sites(sites));
}

bool reads_back_sites(const std::vector<EncodedFile>& files, const plane::Points& sites) {
    return reads_back(files.front().path, files.front().bytes, sites);
}

std::vector<EncodedFile> write_cells(const CellRows& rows, const std::string& path) {
    return only_file(path, encode_cells(rows));
}

bool reads_back_cells(const std::vector<EncodedFile>& files, const CellRows& rows) {
    return reads_back(files.front().path, files.front().bytes, rows);
}

std::vector<EncodedFile> write_svg(const plane::Tile& tile, const FileOptions& options,
                                   const std::string& path) {
    if (options.cut_width > 0) return encode_svg_cut(tile, options.cut_width, path);
    return encode_svg(tile, options, path);
}

std::vector<EncodedFile> write_msh(const plane::Tile& tile, const FileOptions& options,
                                   const std::string& path) {
    return encode_msh(tile, path, options.materials, options.site_orbits);
}

std::vector<EncodedFile> write_vtu(const plane::Tile& tile, const FileOptions& options,
                                   const std::string& path) {
    return encode_vtu(tile, path, options.site_orbits,
                      options.materials == nullptr ? CellMaterials{} : *options.materials);
}

std::vector<EncodedFile> write_foam(const plane::Tile& tile, const FileOptions& options,
                                    const std::string& path) {
    return encode_foam(foam_case(tile, extruded_mesh(tile, options.thickness), options.materials),
                       path);
}

constexpr std::array<TileFormat, 17> kTileFormats{{
    {.extension = ".obj",
     .description = "Wavefront OBJ, with .mtl and .seam.json beside it",
     .write = encode_obj,
     .read = decode_obj,
     .paths = obj_paths,
     .takes_colouring = true,
     .takes_phases = true,
     .states_orbits = true},
    {.extension = ".ply",
     .description = "PLY, ASCII with double coordinates, or float with --float32",
     .write = encode_ply,
     .read = decode_ply,
     .check = require_ply_precision,
     .takes_single_precision = true,
     .takes_colouring = true,
     .takes_phases = true},
    {.extension = ".glb",
     .description = "glTF 2.0, one binary file",
     .write = encode_glb,
     .read = decode_gltf,
     .check = require_gltf_precision,
     .is_single_precision = true,
     .moves_distant_tiles = true,
     .takes_gltf_nodes = true,
     .takes_colouring = true,
     .takes_phases = true},
    {.extension = ".gltf",
     .description = "glTF 2.0, one text file",
     .write = encode_gltf,
     .read = decode_gltf,
     .check = require_gltf_precision,
     .is_single_precision = true,
     .moves_distant_tiles = true,
     .takes_gltf_nodes = true,
     .takes_colouring = true,
     .takes_phases = true},
    {.extension = ".om",
     .description = "OpenMesh, with the identification as properties",
     .write = encode_om,
     .read = decode_om},
    {.extension = ".msh",
     .description = "Gmsh MSH 4.1 with $Periodic, triangles only",
     .write = write_msh,
     .read = decode_msh,
     .fields = msh_fields,
     .holds_polygons = false,
     .highest_order = 2,
     .takes_phases = true,
     .states_materials = true,
     .states_orbits = true},
    {.extension = ".inp",
     .description = "Abaqus and CalculiX with *EQUATION, triangles only",
     .write = encode_inp,
     .read = decode_inp,
     .fields = inp_fields,
     .holds_polygons = false,
     .highest_order = 2,
     .check = require_job_without_walls,
     .takes_element = true,
     .takes_job = true,
     .takes_constants = true,
     .takes_phases = true,
     .takes_orientations = true,
     .states_materials = true,
     .states_orbits = true},
    {.extension = ".vtu",
     .description = "VTK unstructured grid, ASCII, with double coordinates",
     .write = write_vtu,
     .read = decode_vtu,
     .fields = vtu_fields,
     .highest_order = 2,
     .takes_phases = true,
     .states_materials = true,
     .states_orbits = true},
    {.extension = ".svg",
     .description = "a picture, or with --cut lines for cutters",
     .write = write_svg,
     .takes_cut_width = true,
     .takes_colouring = true,
     .takes_background = true,
     .takes_phases = true},
    {.extension = ".png",
     .description = "an image of one period that repeats without a seam",
     .write = encode_tile_png,
     .check = require_image_size,
     .takes_pixels = true,
     .takes_colouring = true,
     .takes_phases = true},
    {.extension = ".dxf",
     .description = "DXF R12 with each edge once, for cutters",
     .write = encode_dxf,
     .takes_cut_width = true},
    {.extension = ".html",
     .description = "a page that shows the tile in any browser",
     .write = encode_html,
     .takes_colouring = true,
     .takes_phases = true},
    {.extension = ".foam",
     .description = "OpenFOAM, a case folder that icoFoam runs",
     .write = write_foam,
     .read = decode_foam_layer,
     .fields = foam_fields,
     .holds_sites = false,
     .paths = foam_paths<FoamCells::kLayer>,
     .is_folder = true,
     .check = require_prisms,
     .check_path = require_foam_path,
     .takes_thickness = true,
     .takes_phases = true,
     .states_materials = true},
    {.extension = ".nc",
     .description =
         "MPAS mesh of the whole torus, which is rectangular, with .graph.info beside it",
     .write = write_mpas,
     .read = read_mpas,
     .paths = mpas_paths,
     .check = require_mpas_torus,
     .takes_coriolis = true},
    {.extension = ".vti",
     .description =
         "cells as voxels of a rectangle for DAMASK, VTK image data, with .material.yaml beside it",
     .write = encode_vti,
     .read = decode_vti,
     .paths = vti_paths,
     .check = require_voxel_grid,
     .takes_voxels = true,
     .takes_constants = true,
     .takes_phases = true,
     .takes_orientations = true},
    {.extension = ".csv",
     .description = "a table of the cells, one row a site",
     .write = write_cells,
     .read = reads_back_cells,
     .takes_phases = true,
     .takes_orientations = true},
    {.extension = ".txt",
     .description = "the sites, in the order of the input",
     .write = write_sites,
     .read = reads_back_sites},
}};

}  // namespace

double FormatRequest::spacing() const { return std::sqrt(lattice.area() / (n_sites * n_periods)); }

plane::VoxelCounts requested_voxels(const FormatRequest& request) {
    plane::VoxelCounts counts = request.files.voxels;
    if (counts.x == 0) {
        counts = default_voxels(request.lattice, request.n_sites * request.n_periods);
        counts.z = request.files.voxels.z;
    }
    voxel_grid(request.lattice, {0, 0}, counts);
    return counts;
}

std::vector<std::string> single_path(const std::string& path) { return {path}; }

std::span<const TileFormat> tile_formats() { return kTileFormats; }

std::vector<EncodedFile> encode_tile(const TileFormat& format, const plane::Tile& tile,
                                     const std::string& path, const FileOptions& options) {
    if (const auto* write = std::get_if<TileWriter*>(&format.write)) return (*write)(tile, path);
    return std::get<TileFormWriter*>(format.write)(tile, options, path);
}

TileFile decode_tile(const TileFormat& format, const std::vector<EncodedFile>& files,
                     const std::optional<plane::Lattice>& lattice) {
    return std::get<TileReader*>(format.read)(files, lattice);
}

const TileFormat* find_tile_format(const std::string& path) {
    const std::string extension = lower_case_extension(path);
    const auto found =
        std::find_if(kTileFormats.begin(), kTileFormats.end(),
                     [&](const TileFormat& format) { return format.extension == extension; });
    return found == kTileFormats.end() ? nullptr : &*found;
}

}  // namespace pcvt
