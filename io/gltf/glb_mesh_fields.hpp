#pragma once

#include "io/gltf/glb_mesh_reader.hpp"

namespace pcvt {

/// Proves the fields of a GLB that pcvt wrote with a node for each part: its JSON, its indices and
/// its normals are those that encode_glb_mesh() gives for the faces of the file, and the site of
/// each cell, mirrored in any face of that cell, is an image of a site; each side of a seam meets
/// the other one by its translation. All of this holds within
/// the rounding of single precision. Files of other programs, and the single node of many parts,
/// state less and are not compared.
///
/// Example usage:
///     const GlbSurfaces glb = decode_glb_surfaces(file);
///     prove_glb_surfaces(glb);
///     compare_glb_surfaces(file, glb);
///
/// @throws BadFile   naming the file: a field is another one.
/// @throws NotATile  a site is another one.
void compare_glb_surfaces(const EncodedFile& file, const GlbSurfaces& glb);

}  // namespace pcvt
