#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "io/forms/material_words.hpp"
#include "mesher/plane/tile/texture_coordinates.hpp"

namespace pcvt {

/// The statements of an OBJ that say how its faces look.
struct ObjAppearance {
    struct Material {
        std::string_view name;
        /// The material's faces begin here.
        int first_face;
    };

    /// One per `vt`.
    std::vector<plane::TextureCoordinate> coordinates = {};
    /// Whether a corner of a face names a texture coordinate.
    bool has_corners = false;
    /// The line of the first corner whose texture coordinate has another index than its vertex; 0
    /// if there is none.
    int other_index_line = 0;
    /// One per `usemtl`.
    std::vector<Material> materials = {};
    /// The first face of each `g`.
    std::vector<int> groups = {};
    /// One per `mtllib`.
    std::vector<std::string_view> libraries = {};
};

/// The materials of faces, with names that outlive the file.
std::vector<MaterialRun> material_runs(const ObjAppearance& appearance);

/// Proves that the tile has the appearance that encode_obj() gives it:
///   - texture coordinates are the lattice coordinates of the vertices, one each, within 4 ulps of
///     float32;
///   - every face has a material, one for all faces of a site; `sides_N` of a whole cell has its
///     number of sides;
///   - the material file is the one beside the OBJ, and defines each material once.
/// A file without texture coordinates, materials or a material file lacks them altogether.
/// @param materials  the .mtl file beside the OBJ; nullptr if there is none.
/// @throws BadFile naming `path` or the material file.
void require_own_appearance(const plane::Tile& tile, const ObjAppearance& appearance,
                            const std::string& path, const EncodedFile* materials);

}  // namespace pcvt
