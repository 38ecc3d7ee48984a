#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/text.hpp"
#include "io/forms/numbered_items.hpp"
#include "io/forms/site_notes.hpp"
#include "io/forms/tile_file.hpp"

namespace pcvt {

/// Collects the contents of a file until they are known to make up a tile.
///
/// Example usage:
///   FileTileBuilder builder{.name = path, .index_base = 1};
///   builder.points.push_back({x, y});
///   builder.add_face({0, 1, 2}, scanner.line());
///   return finish(std::move(builder), lattice, Precision::kDouble);
///
/// A reader adds vertices, faces and pairs by index, counted from 0, or, where the file numbers
/// them as it likes, to `numbered`; finish() gives the numbered ones their indices. A fault of a
/// face or of a numbered item is reported at its own line.
struct FileTileBuilder {
    /// The file's name for messages.
    std::string name;
    /// The number that the file gives to its first vertex: 1 in OBJ, 0 in PLY.
    int index_base;
    std::optional<plane::MeshKind> kind = {};
    std::optional<plane::Lattice> lattice = {};
    std::vector<plane::Vec2> points = {};
    Faces faces = {};
    /// The line of each face.
    std::vector<int> face_lines = {};
    /// One a face of cells and grains, one a vertex of Delaunay triangles; empty where the file has
    /// none.
    std::vector<SiteId> sites = {};
    SiteNotes notes = {};
    /// The keys of the comments that were read and may be there once.
    std::vector<std::string_view> stated = {};
    std::vector<plane::VertexPair> vertex_pairs = {};
    std::vector<plane::EdgePair> edge_pairs = {};
    /// As Tile::order; the nodes in the middle of edges are not among the points.
    int order = 1;
    CellMaterials materials = {};
    /// As TileFile::site_orbits.
    std::vector<int> site_orbits = {};
    /// Whether comments state them, which have those of sites without elements, too.
    bool states_all_orbits = false;
    NumberedItems numbered = {};

    void add_face(const std::vector<int>& vertices, int line);
    /// Reads the words after the key of the comments `kind ...`, `lattice ax ay bx by`,
    /// `sites s ...` and `site_orbits k ...`, and of those of append_note_comments(). Vertices of
    /// numbered ones are counted from `index_base` in the order of their numbers.
    /// @returns whether the key is one of these.
    /// @throws BadFile if they are malformed or were read before.
    bool take_comment(const LineScanner& scanner, std::string_view key,
                      std::span<const std::string_view> words);
};

/// Gives a tile the sites and the notes of a file, for readers that do not call finish().
/// @throws BadFile if there is not one site for each owner; there are positions of sites without
///         sites or without a kind, or not one weight for each position.
void give_sites(FileTileBuilder builder, plane::Tile& tile);

/// The number of sites that the faces, or the vertices, of a tile name: the largest one plus 1.
std::int64_t n_stated_sites(const plane::Tile& tile);

/// Gives numbered items their indices, checks the laws that every tile needs and returns the tile.
/// A file that does not state its kind holds triangles if all of its faces have three corners, else
/// cells. Numbered vertices and faces are in the order of their numbers; of numbered triangles with
/// six nodes the nodes in the middle of edges are proved and left out.
/// @param lattice  replaces one that the file lacks.
/// @throws BadFile if there is no vertex, no face or no lattice; a face has fewer than three
///         corners, a corner twice, a vertex that does not exist, or not three corners in a
///         triangle tile; a pair names a vertex that does not exist or a huge offset; the number of
///         sites is not that of their owners; a file has positions of sites without sites, or not
///         one weight for each; orbits are not counted in the order of their sites; a number is
///         given twice, or used but not given; a translation is not a lattice vector within 4 ulps.
TileFile finish(FileTileBuilder builder, const std::optional<plane::Lattice>& lattice,
                plane::Precision precision);

}  // namespace pcvt
