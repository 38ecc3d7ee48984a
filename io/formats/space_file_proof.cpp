#include "io/formats/space_file_proof.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "io/bytes/bad_file.hpp"
#include "io/bytes/output_error.hpp"
#include "io/formats/extension.hpp"
#include "io/forms/space_surface.hpp"
#include "io/gltf/space_gltf_proof.hpp"
#include "io/graphics/obj_reader.hpp"
#include "io/graphics/obj_writer.hpp"
#include "io/graphics/om_reader.hpp"
#include "io/graphics/om_writer.hpp"
#include "io/graphics/ply_reader.hpp"
#include "io/graphics/ply_writer.hpp"
#include "io/graphics/stl_proof.hpp"
#include "io/openfoam/foam_fields.hpp"
#include "io/openfoam/foam_lists.hpp"
#include "io/openfoam/foam_polyhedra.hpp"
#include "io/openfoam/foam_tetrahedra.hpp"
#include "io/openfoam/foam_writer.hpp"
#include "io/run_files/site_reader.hpp"
#include "io/solvers/vtu_volumes.hpp"
#include "io/solvers/vtu_writer.hpp"

namespace pcvt {
namespace {

/// Reads an OBJ or a PLY.
SurfaceList decode_surfaces(const EncodedFile& file) {
    const bool is_obj = lower_case_extension(file.path) == ".obj";
    return is_obj ? decode_obj_surfaces(file) : decode_ply_surfaces(file);
}

SurfaceList decode_boundary(const EncodedFile& file) {
    if (lower_case_extension(file.path) == ".om") {
        return {SurfaceForm::kBoundary, decode_om_boundary(file)};
    }
    SurfaceList list = decode_surfaces(file);
    require_faces(list, file.path);
    return list;
}

/// Encodes surfaces that were read from a file in the format of its path.
std::vector<EncodedFile> encode_again(SurfaceList list, const std::string& path) {
    const std::string extension = lower_case_extension(path);
    if (extension == ".om") return encode_om_boundary(list.surface, path);
    if (extension == ".obj") {
        return encode_obj_mesh(surface_mesh(std::move(list), SeamForm::kLines), path);
    }
    return encode_ply_mesh(surface_mesh(std::move(list), SeamForm::kColumns), path);
}

GltfSurface surface_of(const SpaceTile& tile, SurfaceForm form, Colouring colouring) {
    return gltf_surface(with_materials(surface_list(tile.mesh, tile.sites, form), tile, colouring));
}

/// Proves triangles of a tile. Those of a tile that is too fine for single precision may break laws
/// although they are those of its faces.
bool holds_same_triangles(const EncodedFile& glb, const SpaceTile& tile) {
    const GlbSurfaces found = decode_glb_surfaces(glb);
    require_same_surfaces(found, surface_of(tile, found.list.form, found.list.colouring));
    const space::TileSurface& surface = found.list.surface;
    if (surface.lattice.periods() != tile.mesh.lattice.periods() || surface.sites != tile.sites ||
        found.list.materials != tile.materials || found.list.weights != tile.weights) {
        return false;
    }
    try {
        prove_glb_surfaces(glb, found);
    } catch (const InvalidInput&) {
        if (fits_single_precision(surface_of(tile, SurfaceForm::kCells, Colouring::kFaces).mesh))
            throw;
        throw CoarsePrecision(glb.path +
                              ": the format's single precision is too coarse for this tile; take "
                              "another format");
    }
    return true;
}

bool is_vtu(const EncodedFile& file) { return lower_case_extension(file.path) == ".vtu"; }

/// Whether a file is a VTU that pcvt wrote, whose tags and words follow from its tile.
bool is_own_vtu(const EncodedFile& file) {
    return is_vtu(file) && file.bytes.find(kPolyhedraVtuMark) != std::string::npos;
}

/// A tile, and what the colours of its file show.
struct DecodedTile {
    SpaceTile tile;
    Colouring colouring = Colouring::kFaces;
};

DecodedTile decode(const std::vector<EncodedFile>& files, double tolerance) {
    if (is_foam_of_polyhedra(files)) return {decode_foam_polyhedra(files, tolerance)};
    if (is_vtu(files.front())) return {decode_vtu_polyhedra(files.front(), tolerance)};
    SurfaceList list = decode_surfaces(files.front());
    SpaceTile tile{.mesh = {{}, list.surface.lattice}};
    tile.sites = list.surface.sites;
    tile.weights = std::move(list.weights);
    tile.materials = std::move(list.materials);
    const Colouring colouring = list.colouring;
    tile.mesh = assembled_cells(std::move(list), files.front().path);
    return {std::move(tile), colouring};
}

/// The materials that the files of a tile state.
CellMaterials stated_materials(const std::vector<EncodedFile>& files, const SpaceTile& tile) {
    const Format* const format = find_format(files);
    return format != nullptr && format->space->states_materials ? tile.materials : CellMaterials();
}

bool holds_same_boundary(const std::vector<EncodedFile>& files, const SpaceTile& tile) {
    const BoundaryFileProof read = prove_boundary_files(files);
    const space::TileSurface& found = read.surface;
    const space::TileSurface wanted = tile_surface(tile.mesh, tile.sites);
    return found.points == wanted.points && found.faces == wanted.faces &&
           found.cell == wanted.cell && found.partner == wanted.partner &&
           found.offset == wanted.offset && found.sites == wanted.sites &&
           read.materials == stated_materials(files, tile);
}

bool holds_same_cells(const std::vector<EncodedFile>& files, const SpaceTile& tile) {
    const SpaceTile found = prove_space_files(files).tile;
    return found.materials == stated_materials(files, tile) && found.weights == tile.weights &&
           found.mesh.metric == tile.mesh.metric && found.mesh.points == tile.mesh.points &&
           found.mesh.piece_cell == tile.mesh.piece_cell && found.sites == tile.sites &&
           found.mesh.point_orbit == tile.mesh.point_orbit &&
           found.mesh.point_offset == tile.mesh.point_offset;
}

/// The part of the materials that a format of tetrahedra states.
CellMaterials held_materials(const SpaceFormat& format, const CellMaterials* materials) {
    if (materials == nullptr || !format.states_materials) return {};
    CellMaterials held = *materials;
    if (!format.takes.orientations) held.site_orientation.clear();
    return held;
}

/// Whether positions are equal, or, in a format that rounds them, within an ulp of the largest
/// coordinate.
bool same_positions(const std::vector<space::Vec3>& found, const std::vector<space::Vec3>& wanted,
                    bool are_rounded) {
    if (!are_rounded || found.size() != wanted.size()) return found == wanted;
    double largest = 0;
    double off = 0;
    for (std::size_t v = 0; v < wanted.size(); ++v) {
        largest = std::max(largest, wanted[v].lpNorm<Eigen::Infinity>());
        off = std::max(off, (found[v] - wanted[v]).lpNorm<Eigen::Infinity>());
    }
    return off <= std::numeric_limits<double>::epsilon() * largest;
}

/// Proves tetrahedra.
bool holds_same_tetrahedra(const std::vector<EncodedFile>& files, const SpaceFormat& format,
                           const space::TetrahedralMesh& mesh, const CellMaterials* materials) {
    const TetrahedralTile read = prove_tetrahedral_files(files).tile;
    const space::TetrahedralMesh& found = read.mesh;
    const bool sorts = format.sorts_corners;
    return same_positions(found.points, mesh.points, format.rounds_positions) &&
           found.point_site == mesh.point_site && found.point_offset == mesh.point_offset &&
           found.tetrahedra == (sorts ? with_sorted_corners(mesh) : mesh).tetrahedra &&
           found.cell == mesh.cell && found.order == (sorts ? 1 : mesh.order) &&
           read.materials == held_materials(format, materials);
}

/// Proves the closed surfaces of cells or of the boundary, in the form that the file states.
template <class Mesh>
bool holds_same_surfaces(const EncodedFile& file, const Mesh& mesh) {
    prove_stl(file);
    const std::optional<SurfaceForm> form = stl_form(decode_stl(file));
    return form && holds_surfaces(file, closed_surfaces(mesh, *form));
}

/// Proves files of a tile. @returns whether they hold it.
bool holds_same(const std::vector<EncodedFile>& files, const SpaceTile& tile) {
    switch (space_file_kind(files).value()) {
        case SpaceFileKind::kBoundary:
            return holds_same_boundary(files, tile);
        case SpaceFileKind::kTriangles:
            return holds_same_triangles(files.front(), tile);
        case SpaceFileKind::kClosedSurfaces:
            return holds_same_surfaces(files.front(), tile.mesh);
        default:
            return holds_same_cells(files, tile);
    }
}

}  // namespace

SpaceFileProof prove_space_files(const std::vector<EncodedFile>& files, double tolerance) {
    DecodedTile decoded = decode(files, tolerance);
    SpaceFileProof result{.tile = std::move(decoded.tile), .proof = {}, .sites = {}};
    const SpaceTile& tile = result.tile;
    result.proof = prove_polyhedra(tile.mesh, tolerance);
    if (tile.sites.cols() > 0) result.sites = prove_cell_sites(tile.mesh, tile.sites, tile.weights);
    if (is_foam_of_polyhedra(files)) {
        compare_files(files, encode_foam(foam_case(tile), foam_folder(files)), foam_fields);
    }
    const std::string extension = lower_case_extension(files.front().path);
    if (extension == ".obj" || extension == ".ply") {
        SurfaceList list = with_materials(surface_list(tile.mesh, tile.sites, SurfaceForm::kCells),
                                          tile, decoded.colouring);
        require_same_bytes(files, encode_again(std::move(list), files.front().path));
    }
    if (is_own_vtu(files.front())) {
        require_same_bytes(files, encode_vtu(vtu_grid(tile), files.front().path));
    }
    return result;
}

BoundaryFileProof prove_boundary_files(const std::vector<EncodedFile>& files) {
    SurfaceList list = decode_boundary(files.front());
    BoundaryFileProof result{
        .surface = list.surface, .materials = list.materials, .proof = prove_surface(list.surface)};
    require_same_bytes(files, encode_again(std::move(list), files.front().path));
    return result;
}

void prove_own_space_files(const std::vector<EncodedFile>& files, const SpaceTile& tile) {
    try {
        if (holds_same(files, tile)) return;
    } catch (const CoarsePrecision&) {
        throw;
    } catch (const InvalidInput& error) {
        throw InternalError(files.front().path + " breaks a law of tiles: " + error.what());
    }
    throw InternalError(files.front().path + ": another tile is read back than was written");
}

TetrahedralFileProof prove_tetrahedral_files(const std::vector<EncodedFile>& files,
                                             double tolerance) {
    const SpaceFormat& format = *find_format(files)->space;
    TetrahedralFileProof result{.tile = format.decode_tetrahedra(files, tolerance), .proof = {}};
    result.proof = prove_tetrahedra(result.tile.mesh, tolerance);
    format.compare_tetrahedra(files, result.tile, tolerance);
    return result;
}

void prove_own_tetrahedra(const std::vector<EncodedFile>& files, const space::TetrahedralMesh& mesh,
                          const CellMaterials* materials) {
    const SpaceFormat& format = *find_format(files)->space;
    const std::string& path = files.front().path;
    try {
        if (format.is_closed_surfaces ? holds_same_surfaces(files.front(), mesh)
                                      : holds_same_tetrahedra(files, format, mesh, materials)) {
            return;
        }
    } catch (const InvalidInput& error) {
        throw InternalError(path + " breaks a law of tiles: " + error.what());
    }
    throw InternalError(path + ": other tetrahedra are read back than were written");
}

void prove_space_site_file(const EncodedFile& file, const space::Points& sites) {
    if (reads_back(file.path, file.bytes, sites)) return;
    throw InternalError(file.path + ": other sites are read back than were written");
}

}  // namespace pcvt
