#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "mesher/base/choices.hpp"

namespace pcvt::plane {

/// `kVoronoi`: Voronoi cells or pieces of them. `kDelaunay`: Delaunay triangles. `kGrains`:
/// triangles inside the cells, which are then called grains.
enum class MeshKind { kVoronoi, kDelaunay, kGrains };

/// The properties of a kind that need no mesh of it.
///
///   std::string name = mesh_kind_row(tile.kind).word;      // "delaunay"
///   if (const auto kind = mesh_kind_of_file_word("cells")) ...
struct MeshKindRow {
    MeshKind kind;
    /// In options, summaries and, behind a hyphen, names of files.
    const char* word;
    /// In files.
    const char* file_word;
    /// PCVT_VORONOI, ... of pcvt.h.
    int abi_value;
    /// Whether each face belongs to a site; otherwise each vertex is a site.
    bool faces_have_sites;
    /// Whether the box outline may cut it.
    bool box_outline;
    /// Whether it can lose short edges of cells.
    bool short_edges;
    /// Whether its triangles have a size that the user chooses.
    bool grain_size;
    /// Whether its triangles may have mid-side nodes.
    bool order_2;
    /// Whether there is such a mesh of space.
    bool in_space;
};

/// In the order of the enumerators.
inline constexpr std::array kMeshKinds{MeshKindRow{.kind = MeshKind::kVoronoi,
                                                   .word = "voronoi",
                                                   .file_word = "cells",
                                                   .abi_value = 0,
                                                   .faces_have_sites = true,
                                                   .box_outline = true,
                                                   .short_edges = true,
                                                   .grain_size = false,
                                                   .order_2 = false,
                                                   .in_space = true},
                                       MeshKindRow{.kind = MeshKind::kDelaunay,
                                                   .word = "delaunay",
                                                   .file_word = "triangles",
                                                   .abi_value = 1,
                                                   .faces_have_sites = false,
                                                   .box_outline = false,
                                                   .short_edges = false,
                                                   .grain_size = false,
                                                   .order_2 = false,
                                                   .in_space = true},
                                       MeshKindRow{.kind = MeshKind::kGrains,
                                                   .word = "grains",
                                                   .file_word = "grains",
                                                   .abi_value = 2,
                                                   .faces_have_sites = true,
                                                   .box_outline = true,
                                                   .short_edges = true,
                                                   .grain_size = true,
                                                   .order_2 = true,
                                                   .in_space = true}};

constexpr const MeshKindRow& mesh_kind_row(MeshKind kind) {
    return kMeshKinds[static_cast<std::size_t>(kind)];
}

/// Whether each face belongs to a site; otherwise each vertex is a site.
constexpr bool faces_have_sites(MeshKind kind) { return mesh_kind_row(kind).faces_have_sites; }

/// The word of a kind in files, and the kind of such a word; `nullopt` for any other word.
inline std::string file_word(MeshKind kind) { return mesh_kind_row(kind).file_word; }
constexpr std::optional<MeshKind> mesh_kind_of_file_word(std::string_view word) {
    const auto* row = find_row(kMeshKinds, [word](const auto& r) { return r.file_word == word; });
    return row ? std::optional(row->kind) : std::nullopt;
}

}  // namespace pcvt::plane
