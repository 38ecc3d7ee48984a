#include "io/space/space_formats.hpp"

#include <algorithm>
#include <array>

#include "io/bytes/bad_file.hpp"
#include "io/bytes/extension.hpp"
#include "io/run_files/site_reader.hpp"
#include "io/space/space_foam_reader.hpp"
#include "io/space/space_foam_writer.hpp"
#include "io/space/space_msh_reader.hpp"
#include "io/space/space_msh_writer.hpp"
#include "io/space/space_vtu_reader.hpp"
#include "io/space/space_vtu_writer.hpp"

namespace pcvt {
namespace {

std::vector<std::string> itself(const std::string& path) { return {path}; }

constexpr std::array kFormats{SpaceFormat{".vtu", false, itself, encode_space_vtu},
                              SpaceFormat{".foam", true, space_foam_paths, encode_space_foam},
                              SpaceFormat{".msh", false, itself, nullptr, encode_space_msh},
                              SpaceFormat{".txt", false, itself, nullptr}};

SpaceTile decode(const std::vector<EncodedFile>& files) {
    return is_space_case(files) ? decode_space_foam(files) : decode_space_vtu(files.front());
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
    std::string text;
    for (const SpaceFormat& format : kFormats) {
        const bool last = &format == &kFormats.back();
        text += (text.empty() ? "" : last ? " or " : ", ") + std::string(format.extension);
    }
    return text;
}

bool hold_space_tile(const std::vector<EncodedFile>& files) {
    return is_space_case(files) ||
           (files.size() == 1 && lower_case_extension(files.front().path) == ".vtu" &&
            holds_polyhedra(files.front()));
}

SpaceFileProof prove_space_files(const std::vector<EncodedFile>& files) {
    SpaceFileProof result{.tile = decode(files), .proof = {}, .sites = {}};
    const SpaceTile& tile = result.tile;
    result.proof = prove_polyhedra(tile.mesh);
    if (tile.sites.cols() > 0) result.sites = prove_cell_sites(tile.mesh, tile.sites);
    if (is_space_case(files)) compare_space_case(files, tile);
    return result;
}

void prove_own_space_files(const std::vector<EncodedFile>& files, const SpaceTile& tile) {
    try {
        const SpaceTile found = prove_space_files(files).tile;
        if (found.mesh.points == tile.mesh.points && found.sites == tile.sites &&
            found.mesh.point_orbit == tile.mesh.point_orbit &&
            found.mesh.point_offset == tile.mesh.point_offset) {
            return;
        }
    } catch (const InvalidInput& error) {
        throw InternalError(files.front().path + " breaks a law of tiles: " + error.what());
    }
    throw InternalError(files.front().path + ": another tile is read back than was written");
}

bool hold_tetrahedra(const std::vector<EncodedFile>& files) {
    return files.size() == 1 && lower_case_extension(files.front().path) == ".msh" &&
           holds_tetrahedra(files.front());
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
