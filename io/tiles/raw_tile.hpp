#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/text.hpp"
#include "io/tiles/tile_file.hpp"

namespace pcvt {

/// Offsets beyond this are refused, so that sums of offsets stay integers.
inline constexpr int kLargestOffset = 1 << 28;

/// What a text reader gathers line by line, before it is known to make up a tile.
///
/// Vertices are counted from 0 here; the fault of a face is reported at the face's own line.
struct RawTile {
    /// The file's name for messages.
    std::string name;
    /// The number that the file gives to its first vertex: 1 in OBJ, 0 in PLY.
    int index_base;
    std::optional<MeshKind> kind;
    std::optional<Lattice> lattice;
    std::vector<Vec2> points;
    std::vector<int> face_begin{0};
    std::vector<int> corners;
    /// The line of each face.
    std::vector<int> face_lines;
    /// One a face of cells and grains, one a vertex of Delaunay triangles; empty where the file has
    /// none.
    std::vector<SiteId> sites;
    std::vector<VertexPair> vertex_pairs;
    std::vector<EdgePair> edge_pairs;
    /// As Tile::order; the nodes in the middle of edges are not among the points.
    int order = 1;

    void add_face(const std::vector<int>& vertices, int line);
    /// Take the words after the key of our comments `kind ...` and `lattice ax ay bx by`.
    /// @throws BadFile unless they are what they should be and come for the first time.
    void take_kind(const LineScanner& scanner, std::span<const std::string_view> words);
    void take_lattice(const LineScanner& scanner, std::span<const std::string_view> words);
};

/// `cells`, `triangles` or `grains`, as the files spell it.
std::string kind_word(MeshKind kind);
std::optional<MeshKind> kind_of_word(std::string_view word);

/// Checks what any tile needs and hands it over. A file that does not tell its kind holds triangles
/// if all of its faces have three corners, else cells.
/// @param lattice  stands in for one that the file lacks.
/// @throws BadFile if there is no vertex, no face or no lattice; a face has fewer than three
/// corners,
///         a corner twice, a vertex that does not exist, or not three corners in a triangle tile; a
///         pair names a vertex that does not exist or a huge offset; the number of sites is not
///         that of their owners.
TileFile finish(RawTile raw, const std::optional<Lattice>& lattice, Precision precision);

}  // namespace pcvt
