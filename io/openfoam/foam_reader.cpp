#include "io/openfoam/foam_reader.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "io/openfoam/foam_lists.hpp"
#include "io/openfoam/foam_scanner.hpp"
#include "io/tiles/file_tile_builder.hpp"
#include "io/tiles/material_words.hpp"
#include "mesher/finite_volume/extruded_base.hpp"

namespace pcvt {
namespace {

/// Returns (I, J) of the name seam_I_J; `nullopt` for any other name.
std::optional<plane::Offset> named_offset(const std::string& name) {
    const std::string head = "seam_";
    const std::size_t cut = name.find('_', head.size());
    if (!name.starts_with(head) || cut == std::string::npos) return std::nullopt;
    try {
        return plane::Offset{parse_integer(name.substr(head.size(), cut - head.size())),
                             parse_integer(name.substr(cut + 1))};
    } catch (const InvalidInput&) {
        return std::nullopt;
    }
}

std::optional<WallSide> named_side(const std::string& name) {
    for (const WallSideRow& row : kWallSides) {
        if (name == row.word) return row.side;
    }
    return std::nullopt;
}

plane::Vec2 read_separation(FoamScanner& scanner) {
    scanner.expect("(");
    const double x = scanner.number();
    const double y = scanner.number();
    if (scanner.number() != 0) scanner.throw_bad_file("a separation leaves the plane; make z 0");
    scanner.expect(")");
    return {x, y};
}

/// Reads a patch and the name of its partner, which is empty if the patch has none.
/// @param n_holes  of the patches before.
std::pair<ExtrudedPatch, std::string> read_patch(FoamScanner& scanner, int n_holes) {
    ExtrudedPatch patch{.name = std::string(scanner.next()),
                        .first_face = -1,
                        .n_faces = -1,
                        .partner = -1,
                        .offset = {},
                        .separation = plane::Vec2(0, 0)};
    std::string type;
    std::string partner;
    // Read the entries that matter, skip the others.
    scanner.expect("{");
    for (std::string_view key = scanner.next(); key != "}"; key = scanner.next()) {
        if (key.empty()) scanner.throw_bad_file("a patch does not end; give the whole file");
        if (key == "type") type = scanner.next();
        if (key == "neighbourPatch") partner = scanner.next();
        if (key == "nFaces") patch.n_faces = scanner.integer();
        if (key == "startFace") patch.first_face = scanner.integer();
        if (key == "separationVector") patch.separation = read_separation(scanner);
        scanner.skip_entry();
    }
    // A patch is a wall, empty, or cyclic with an offset in its name.
    const std::optional<WallSide> side = named_side(patch.name);
    if (type == "wall")
        patch.wall = side ? plane::WallId::side(*side) : plane::WallId::hole(n_holes);
    if (partner.empty() && (type == "wall" || (type == "empty" && !side))) return {patch, partner};
    const std::optional<plane::Offset> offset = named_offset(patch.name);
    const auto fits = [](int k) { return k >= -kLargestOffset && k <= kLargestOffset; };
    if (type != "cyclic" || partner.empty() || !offset || !fits(offset->i) || !fits(offset->j)) {
        scanner.throw_bad_file(
            "patch " + in_quotes(patch.name) +
            " is neither an empty one, a wall nor one side of a seam; name the cyclic ones "
            "seam_I_J, and give each of these a neighbourPatch");
    }
    patch.offset = *offset;
    return {patch, partner};
}

void read_boundary(const EncodedFile& file, ExtrudedMesh& extruded) {
    // Read the patches.
    FoamScanner scanner(file.path, file.bytes);
    std::vector<std::string> partners;
    int n_holes = 0;
    for (int left = scanner.begin_list(); left > 0; --left) {
        auto [patch, partner] = read_patch(scanner, n_holes);
        if (patch.wall && patch.wall->is_hole()) ++n_holes;
        extruded.patches.push_back(std::move(patch));
        partners.push_back(std::move(partner));
    }
    scanner.expect(")");
    // Find the partners by their names.
    std::map<std::string, int> index;
    for (const ExtrudedPatch& patch : extruded.patches) {
        index.emplace(patch.name, static_cast<int>(index.size()));
    }
    if (index.size() != extruded.patches.size())
        scanner.throw_bad_file("two patches have one name; rename one");
    for (std::size_t p = 0; p < partners.size(); ++p) {
        if (partners[p].empty()) continue;
        const auto found = index.find(partners[p]);
        if (found == index.end()) {
            scanner.throw_bad_file("there is no patch " + in_quotes(partners[p]) +
                                   "; name an existing one");
        }
        extruded.patches[p].partner = found->second;
    }
}

/// Reads the comments `// pcvt ...`.
FileTileBuilder read_comments(const EncodedFile& file) {
    FileTileBuilder comments{.name = file.path, .index_base = 0, .notes = {.short_edges = 0}};
    LineScanner scanner(file.path, file.bytes);
    while (scanner.next()) {
        const auto& words = scanner.words();
        if (words.size() < 3 || words[0] != "//" || words[1] != "pcvt") continue;
        const std::vector<std::string_view> values(words.begin() + 3, words.end());
        if (comments.take_comment(scanner, words[2], values)) continue;
        if (take_material(scanner, words[2], values, comments.materials)) continue;
        scanner.throw_bad_file("pcvt does not know " + in_quotes(words[2]) + "; remove the line");
    }
    return comments;
}

/// Gives the tile its sites and their notes. The patches state its walls and holes, with which the
/// notes must agree.
void give_notes(const EncodedFile& boundary, FileTileBuilder comments, plane::Tile& tile) {
    const Walls walls = tile.walls;
    std::vector<plane::WallEdge> wall_edges = std::move(tile.wall_edges);
    std::vector<std::string> holes = std::move(tile.holes);
    give_sites(std::move(comments), tile);
    const bool states_notes = !tile.site_positions.empty() || tile.walls != Walls::kNone;
    if (states_notes && tile.walls != walls) {
        throw BadFile(boundary.path + ": the comment on walls means " + walls_row(tile.walls).word +
                      ", but the patches " + walls_row(walls).word + "; correct the comment");
    }
    const auto on_holes = [](std::vector<plane::WallEdge> edges) {
        std::erase_if(edges, [](const plane::WallEdge& edge) { return !edge.wall.is_hole(); });
        return edges;
    };
    const bool states_holes = states_notes || !tile.holes.empty();
    if (states_holes &&
        (tile.holes != holes || on_holes(tile.wall_edges) != on_holes(wall_edges))) {
        throw BadFile(boundary.path +
                      ": the comments on holes mean other edges than the patches of type wall; "
                      "correct the comments");
    }
    tile.walls = walls;
    tile.wall_edges = std::move(wall_edges);
    tile.holes = std::move(holes);
}

}  // namespace

TileFile decode_foam(const std::vector<EncodedFile>& files,
                     const std::optional<plane::Lattice>& lattice) {
    const EncodedFile& boundary = foam_mesh_file(files, "boundary");
    for (const EncodedFile& file : files) {
        refuse_binary(file.path, file.bytes, "write the case with writeFormat ascii");
    }
    FileTileBuilder comments = read_comments(boundary);
    const std::optional<plane::Lattice> known = comments.lattice ? comments.lattice : lattice;
    if (!known) {
        throw BadFile(boundary.path + ": the file names no lattice; pass --lattice AX,AY,BX,BY");
    }
    ExtrudedMesh extruded{.lattice = *known,
                          .kind = comments.kind.value_or(plane::MeshKind::kVoronoi)};
    extruded.points = foam_points(foam_mesh_file(files, "points"));
    extruded.faces = foam_faces(foam_mesh_file(files, "faces"));
    extruded.owner = foam_labels(foam_mesh_file(files, "owner"));
    extruded.neighbour = foam_labels(foam_mesh_file(files, "neighbour"));
    read_boundary(boundary, extruded);
    const bool states_lattice = comments.lattice.has_value();
    plane::Tile tile = extruded_base(extruded);
    CellMaterials materials = std::move(comments.materials);
    if (!materials.empty()) foam_mesh_file(files, "cellZones");
    give_notes(boundary, std::move(comments), tile);
    require_materials(boundary.path, materials, n_stated_sites(tile));
    return {.tile = std::move(tile),
            .precision = plane::Precision::kDouble,
            .has_vertex_pairs = false,
            .has_edge_pairs = true,
            .has_wall_edges = true,
            .states_lattice = states_lattice,
            .materials = std::move(materials),
            .thickness = extruded.points.back().z()};
}

}  // namespace pcvt
