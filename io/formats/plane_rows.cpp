#include "io/formats/plane_rows.hpp"

#include <filesystem>

#include "io/formats/single_precision.hpp"
#include "io/forms/triangle_elements.hpp"
#include "io/gltf/gltf_reader.hpp"
#include "io/gltf/plane_gltf.hpp"
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
#include "io/pictures/dxf_writer.hpp"
#include "io/pictures/png_writer.hpp"
#include "io/pictures/svg_cut_writer.hpp"
#include "io/pictures/svg_writer.hpp"
#include "io/run_files/cell_reader.hpp"
#include "io/run_files/site_reader.hpp"
#include "io/run_files/site_writer.hpp"
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

namespace pcvt::plane_rows {
namespace {

/// The thickness of a layer over the mean distance of the sites. checkMesh finds faults at 1e-8
/// and 1e8.
constexpr double kLeastThickness = 1e-3;
constexpr double kLargestThickness = 1e3;

void require_thickness(const FormatRequest& request) {
    const double layers = request.files.thickness / request.spacing();
    if (layers == 0 || (layers >= kLeastThickness && layers <= kLargestThickness)) return;
    throw InvalidInput(
        "the thickness is not between 0.001 and 1000 times the mean distance of the sites, "
        "sqrt(area / n); take one nearer to it");
}

/// The order of wedges is that of their triangles.
void require_wedges(const FormatRequest& request) {
    const PlaneElementRow& row = plane_element_row(request.files.element);
    if (row.wedge_order == 0) return;
    require_thickness(request);
    if (row.wedge_order == request.tile.order) return;
    throw InvalidInput(row.wedge_order == 2
                           ? "the elements C3D15 have nodes in the middle of edges; take order 2, "
                             "or the elements C3D6"
                           : "the elements C3D6 have only corners; take the elements C3D15 for "
                             "order 2");
}

}  // namespace

/// Pieces of cells are slivers where the box cuts a cell near its corner.
void require_prisms(const FormatRequest& request) {
    require_thickness(request);
    if (request.tile.outline == plane::Outline::kWhole ||
        request.tile.kind != plane::MeshKind::kVoronoi)
        return;
    throw InvalidInput(
        "cells that the box cuts are too thin for finite volumes; take the whole outline, or the "
        "mesh grains");
}

/// The mean strains of the job need equations across all sides.
void require_solver_input(const FormatRequest& request) {
    require_wedges(request);
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
    if (request.tile.short_edges > 0) {
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

std::vector<EncodedFile> write_mpas(const Torus& torus, const FileOptions& options,
                                    const std::string& path) {
    MpasGrid grid = mpas_grid(torus.cells, torus.origin);
    if (!torus.site_densities.empty()) fill_mesh_density(torus.site_densities, grid);
    if (const auto& f = options.coriolis) fill_coriolis({(*f)[0], (*f)[1]}, grid);
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
    require_triangles(tile.kind, path);
    return encode_msh(entity_mesh(tile, options.materials, options.site_orbits), path);
}

std::vector<EncodedFile> write_vtu(const plane::Tile& tile, const FileOptions& options,
                                   const std::string& path) {
    return encode_vtu(vtu_grid(tile, options.materials, options.site_orbits), path);
}

std::vector<EncodedFile> write_foam(const plane::Tile& tile, const FileOptions& options,
                                    const std::string& path) {
    return encode_foam(foam_case(tile, extruded_mesh(tile, options.thickness), options.materials),
                       path);
}

}  // namespace pcvt::plane_rows
