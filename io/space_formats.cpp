#include "io/space_formats.hpp"

#include <algorithm>
#include <array>

#include "io/bytes/bad_file.hpp"
#include "io/bytes/extension.hpp"
#include "io/pictures/space_picture.hpp"
#include "io/run_files/site_reader.hpp"
#include "io/space/space_foam_reader.hpp"
#include "io/space/space_foam_writer.hpp"
#include "io/space/space_msh_reader.hpp"
#include "io/space/space_msh_writer.hpp"
#include "io/space/space_vtu_reader.hpp"
#include "io/space/space_vtu_writer.hpp"
#include "io/surfaces/surface_glb_fields.hpp"
#include "io/surfaces/surface_glb_reader.hpp"
#include "io/surfaces/surface_glb_writer.hpp"
#include "io/surfaces/surface_obj_reader.hpp"
#include "io/surfaces/surface_obj_writer.hpp"
#include "io/surfaces/surface_om_reader.hpp"
#include "io/surfaces/surface_om_writer.hpp"
#include "io/surfaces/surface_ply_reader.hpp"
#include "io/surfaces/surface_ply_writer.hpp"

namespace pcvt {
namespace {

std::vector<std::string> itself(const std::string& path) { return {path}; }

/// Encodes volumes, which have one form.
template <auto kEncode>
std::vector<EncodedFile> encode_volumes(const SpaceTile& tile, const SpaceFileOptions&,
                                        const std::string& path) {
    return kEncode(tile, path);
}

template <auto kEncode>
std::vector<EncodedFile> encode_surfaces(const SpaceTile& tile, const SpaceFileOptions& options,
                                         const std::string& path) {
    return kEncode(surface_list(tile, options.surfaces), path);
}

std::vector<EncodedFile> encode_om_boundary(const SpaceTile& tile, const SpaceFileOptions&,
                                            const std::string& path) {
    return encode_surface_om(tile_surface(tile.mesh, tile.sites), path);
}

using Kind = std::optional<SpaceFileKind>;

Kind case_kind(const std::vector<EncodedFile>& files) {
    return is_space_case(files) ? Kind(SpaceFileKind::kPolyhedra) : std::nullopt;
}

template <SpaceFileKind kKind, auto kHolds>
Kind kind_where(const std::vector<EncodedFile>& files) {
    return kHolds(files.front()) ? Kind(kKind) : std::nullopt;
}

SpaceFileKind kind_of(const SurfaceList& list) {
    return list.form == SurfaceForm::kCells ? SpaceFileKind::kPolyhedra : SpaceFileKind::kBoundary;
}

Kind obj_kind(const std::vector<EncodedFile>& files) {
    if (!is_surface_obj(files.front())) return std::nullopt;
    return kind_of(decode_surface_obj(files.front()));
}

Kind ply_kind(const std::vector<EncodedFile>& files) {
    if (!is_surface_ply(files.front())) return std::nullopt;
    return kind_of(decode_surface_ply(files.front()));
}

constexpr std::array kFormats{
    SpaceFormat{.extension = ".vtu",
                .is_folder = false,
                .surfaces = FormatSurfaces::kNone,
                .memory = 8900,
                .paths = itself,
                .encode = encode_volumes<encode_space_vtu>,
                .encode_tetrahedra = nullptr,
                .kind = kind_where<SpaceFileKind::kPolyhedra, holds_polyhedra>},
    SpaceFormat{.extension = ".foam",
                .is_folder = true,
                .surfaces = FormatSurfaces::kNone,
                .memory = 6900,
                .paths = space_foam_paths,
                .encode = encode_volumes<encode_space_foam>,
                .encode_tetrahedra = nullptr,
                .kind = case_kind},
    SpaceFormat{.extension = ".msh",
                .is_folder = false,
                .surfaces = FormatSurfaces::kNone,
                .memory = 8600,
                .paths = itself,
                .encode = nullptr,
                .encode_tetrahedra = encode_space_msh,
                .kind = kind_where<SpaceFileKind::kTetrahedra, holds_tetrahedra>},
    SpaceFormat{.extension = ".obj",
                .is_folder = false,
                .surfaces = FormatSurfaces::kChosen,
                .memory = 7000,
                .paths = surface_obj_paths,
                .encode = encode_surfaces<encode_surface_obj>,
                .encode_tetrahedra = nullptr,
                .kind = obj_kind},
    SpaceFormat{.extension = ".ply",
                .is_folder = false,
                .surfaces = FormatSurfaces::kChosen,
                .memory = 8500,
                .paths = itself,
                .encode = encode_surfaces<encode_surface_ply>,
                .encode_tetrahedra = nullptr,
                .kind = ply_kind},
    SpaceFormat{.extension = ".glb",
                .is_folder = false,
                .surfaces = FormatSurfaces::kChosen,
                .memory = 15200,
                .paths = itself,
                .encode = encode_surfaces<encode_surface_glb>,
                .encode_tetrahedra = nullptr,
                .kind = kind_where<SpaceFileKind::kTriangles, is_surface_glb>},
    SpaceFormat{.extension = ".om",
                .is_folder = false,
                .surfaces = FormatSurfaces::kBoundary,
                .memory = 7000,
                .paths = itself,
                .encode = encode_om_boundary,
                .encode_tetrahedra = nullptr,
                .kind = kind_where<SpaceFileKind::kBoundary, is_surface_om>},
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
    for (const SpaceFormat& format : kFormats) {
        if (chosen(format)) extensions.push_back(format.extension);
    }
    std::string text;
    for (const std::string_view extension : extensions) {
        const bool last = extension == extensions.back();
        text += (text.empty() ? "" : last ? " or " : ", ") + std::string(extension);
    }
    return text;
}

/// Requires that files are, byte for byte, those that pcvt writes for what was read from them.
/// Companions may be missing.
void require_same_bytes(const std::vector<EncodedFile>& files,
                        const std::vector<EncodedFile>& wanted) {
    for (const EncodedFile& own : wanted) {
        for (const EncodedFile& file : files) {
            if (file.path != own.path || file.bytes == own.bytes) continue;
            const auto [here, there] = std::mismatch(file.bytes.begin(), file.bytes.end(),
                                                     own.bytes.begin(), own.bytes.end());
            const auto line = 1 + std::count(file.bytes.begin(), here, '\n');
            throw BadFile(file.path + ":" + std::to_string(line) +
                          ": another line follows from the cells; write the file again with pcvt");
        }
    }
}

/// Reads an OBJ or a PLY.
SurfaceContent decode_surfaces(const EncodedFile& file) {
    const bool is_obj = lower_case_extension(file.path) == ".obj";
    return surface_content(is_obj ? decode_surface_obj(file) : decode_surface_ply(file), file.path);
}

TileSurface decode_boundary(const EncodedFile& file) {
    if (lower_case_extension(file.path) == ".om") return decode_surface_om(file);
    return std::get<TileSurface>(decode_surfaces(file));
}

/// Encodes what was read from a file in the format of its path.
std::vector<EncodedFile> encode_again(const SurfaceList& list, const std::string& path) {
    const std::string extension = lower_case_extension(path);
    return extension == ".obj" ? encode_surface_obj(list, path) : encode_surface_ply(list, path);
}

std::vector<EncodedFile> encode_again(const TileSurface& surface, const std::string& path) {
    const bool is_om = lower_case_extension(path) == ".om";
    return is_om ? encode_surface_om(surface, path) : encode_again(surface_list(surface), path);
}

/// Proves triangles of a tile.
bool holds_same_triangles(const EncodedFile& glb, const SpaceTile& tile) {
    const SurfaceGlb found = decode_surface_glb(glb);
    prove_surface_glb(found);
    compare_surface_glb(glb, found);
    require_same_surfaces(found, surface_list(tile, found.form));
    return found.lattice.periods() == tile.mesh.lattice.periods() && found.sites == tile.sites;
}

/// Whether a file is a VTU that pcvt wrote, whose tags and words follow from its tile.
bool is_own_vtu(const EncodedFile& file) {
    return lower_case_extension(file.path) == ".vtu" &&
           file.bytes.find(kSpaceVtuMark) != std::string::npos;
}

SpaceTile decode(const std::vector<EncodedFile>& files) {
    if (is_space_case(files)) return decode_space_foam(files);
    if (lower_case_extension(files.front().path) == ".vtu") return decode_space_vtu(files.front());
    return std::get<SpaceTile>(decode_surfaces(files.front()));
}

bool holds_same_boundary(const std::vector<EncodedFile>& files, const SpaceTile& tile) {
    const TileSurface found = prove_boundary_files(files).surface;
    const TileSurface wanted = tile_surface(tile.mesh, tile.sites);
    return found.points == wanted.points && found.faces == wanted.faces &&
           found.cell == wanted.cell && found.partner == wanted.partner &&
           found.offset == wanted.offset && found.sites == wanted.sites;
}

bool holds_same_cells(const std::vector<EncodedFile>& files, const SpaceTile& tile) {
    const SpaceTile found = prove_space_files(files).tile;
    return found.mesh.points == tile.mesh.points && found.sites == tile.sites &&
           found.mesh.point_orbit == tile.mesh.point_orbit &&
           found.mesh.point_offset == tile.mesh.point_offset;
}

/// Proves files of a tile. @returns whether they hold it.
bool holds_same(const std::vector<EncodedFile>& files, const SpaceTile& tile) {
    switch (space_file_kind(files).value()) {
        case SpaceFileKind::kBoundary:
            return holds_same_boundary(files, tile);
        case SpaceFileKind::kTriangles:
            return holds_same_triangles(files.front(), tile);
        default:
            return holds_same_cells(files, tile);
    }
}

}  // namespace

const SpaceFormat* find_space_format(const std::string& path) {
    const std::string extension = lower_case_extension(path);
    const auto* const found = std::find_if(
        kFormats.begin(), kFormats.end(),
        [&extension](const SpaceFormat& format) { return format.extension == extension; });
    return found == kFormats.end() ? nullptr : found;
}

std::string space_extensions() {
    return listed_extensions([](const SpaceFormat&) { return true; });
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

SpaceFileProof prove_space_files(const std::vector<EncodedFile>& files) {
    SpaceFileProof result{.tile = decode(files), .proof = {}, .sites = {}};
    const SpaceTile& tile = result.tile;
    result.proof = prove_polyhedra(tile.mesh);
    if (tile.sites.cols() > 0) result.sites = prove_cell_sites(tile.mesh, tile.sites);
    if (is_space_case(files)) compare_space_case(files, tile);
    const std::string extension = lower_case_extension(files.front().path);
    if (extension == ".obj" || extension == ".ply") {
        const SurfaceList list = surface_list(tile, SurfaceForm::kCells);
        require_same_bytes(files, encode_again(list, files.front().path));
    }
    if (is_own_vtu(files.front())) {
        require_same_bytes(files, encode_space_vtu(tile, files.front().path));
    }
    return result;
}

BoundaryFileProof prove_boundary_files(const std::vector<EncodedFile>& files) {
    BoundaryFileProof result{.surface = decode_boundary(files.front()), .proof = {}};
    result.proof = prove_surface(result.surface);
    require_same_bytes(files, encode_again(result.surface, files.front().path));
    return result;
}

void prove_own_space_files(const std::vector<EncodedFile>& files, const SpaceTile& tile) {
    try {
        if (holds_same(files, tile)) return;
    } catch (const InvalidInput& error) {
        throw InternalError(files.front().path + " breaks a law of tiles: " + error.what());
    }
    throw InternalError(files.front().path + ": another tile is read back than was written");
}

TetrahedralFileProof prove_tetrahedral_file(const EncodedFile& msh) {
    TetrahedralFileProof result{.mesh = decode_space_msh(msh), .proof = {}};
    result.proof = prove_tetrahedra(result.mesh);
    compare_space_msh(msh, result.mesh);
    return result;
}

void prove_own_tetrahedra(const EncodedFile& msh, const TetrahedralMesh& mesh) {
    try {
        const TetrahedralMesh found = prove_tetrahedral_file(msh).mesh;
        if (found.points == mesh.points && found.point_site == mesh.point_site &&
            found.point_offset == mesh.point_offset && found.tetrahedra == mesh.tetrahedra) {
            return;
        }
    } catch (const InvalidInput& error) {
        throw InternalError(msh.path + " breaks a law of tiles: " + error.what());
    }
    throw InternalError(msh.path + ": other tetrahedra are read back than were written");
}

void prove_space_site_file(const EncodedFile& file, const Points3& sites) {
    if (reads_back(file.path, file.bytes, sites)) return;
    throw InternalError(file.path + ": other sites are read back than were written");
}

}  // namespace pcvt
