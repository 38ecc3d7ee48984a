#include "io/openfoam/foam_layer.hpp"

#include <utility>

#include "io/forms/file_tile_builder.hpp"
#include "io/forms/finite.hpp"
#include "io/forms/material_words.hpp"
#include "io/forms/site_notes.hpp"
#include "io/openfoam/foam_lists.hpp"
#include "io/openfoam/foam_reader.hpp"
#include "mesher/finite_volume/extruded_base.hpp"

namespace pcvt {
namespace {

constexpr std::size_t kSitesALine = 16;

/// Appends the site of each cell, or of each point of Delaunay triangles, as comments.
void append_sites(std::string& text, const plane::Tile& tile) {
    const std::vector<SiteId>& sites = tile.sites();
    for (std::size_t k = 0; k < sites.size(); ++k) {
        text += k % kSitesALine == 0 ? (k == 0 ? "// pcvt sites" : "\n// pcvt sites") : "";
        text += ' ';
        append_number(text, sites[k]);
    }
    if (!sites.empty()) text += '\n';
}

std::string layer_notes(const plane::Tile& tile, const CellMaterials& phases) {
    Eigen::Matrix2d periods;
    periods << tile.lattice.a(), tile.lattice.b();
    std::string notes = foam_notes(file_word(tile.kind), periods);
    append_note_comments(notes, "// pcvt ", tile, 0);
    append_sites(notes, tile);
    append_materials(notes, "// pcvt ", phases);
    return notes;
}

/// Returns the zones of the cells, one for each phase.
std::vector<FoamZone> phase_zones(const plane::Tile& tile, const CellMaterials& phases) {
    std::vector<FoamZone> zones;
    for (const std::string& name : phases.phase_names) zones.push_back({phase_group(name), {}});
    if (zones.empty()) return zones;
    for (int f = 0; f < tile.n_faces(); ++f) {
        zones[phases.site_phase[tile.face_site[f]]].cells.push_back(f);
    }
    return zones;
}

/// Reads the comments `// pcvt ...`.
FileTileBuilder read_comments(const EncodedFile& boundary) {
    FileTileBuilder comments{.name = boundary.path, .index_base = 0, .notes = {.short_edges = 0}};
    read_foam_notes(boundary, [&](const LineScanner& scanner, std::string_view key,
                                  std::span<const std::string_view> values) {
        if (comments.take_comment(scanner, key, values)) return;
        if (take_material(scanner, key, values, comments.materials)) return;
        scanner.throw_bad_file("pcvt does not know " + in_quotes(key) + "; remove the line");
    });
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

FoamCase foam_case(const plane::Tile& tile, const FiniteVolumeMesh& layer,
                   const CellMaterials* materials) {
    require_finite(tile);
    // A case states only the phases.
    CellMaterials phases;
    if (materials != nullptr) {
        phases = {.phase_names = materials->phase_names, .site_phase = materials->site_phase};
    }
    return {.cells = FoamCells::kLayer,
            .mesh = layer,
            .flow = cell_flow(DecayingFlow(tile.lattice, tile.walls), tile, layer),
            .notes = layer_notes(tile, phases),
            .zones = phase_zones(tile, phases)};
}

TileFile decode_foam_layer(const std::vector<EncodedFile>& files,
                           const std::optional<plane::Lattice>& lattice) {
    const EncodedFile& boundary = foam_boundary(files);
    FileTileBuilder comments = read_comments(boundary);
    const std::optional<plane::Lattice> known = comments.lattice ? comments.lattice : lattice;
    if (!known) {
        throw UnusableFile(boundary.path +
                           ": the file names no lattice; pass --lattice AX,AY,BX,BY");
    }
    const FiniteVolumeMesh extruded = decode_foam_mesh(files, 2);
    const bool states_lattice = comments.lattice.has_value();
    plane::Tile tile =
        extruded_base(extruded, *known, comments.kind.value_or(plane::MeshKind::kVoronoi));
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
