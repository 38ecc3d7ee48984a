#include "io/tile_formats.hpp"

#include <algorithm>
#include <filesystem>

#include "io/gltf/gltf_reader.hpp"
#include "io/gltf/gltf_writer.hpp"
#include "io/graphics/obj_reader.hpp"
#include "io/graphics/obj_writer.hpp"
#include "io/graphics/om_reader.hpp"
#include "io/graphics/om_writer.hpp"
#include "io/graphics/ply_reader.hpp"
#include "io/graphics/ply_writer.hpp"
#include "io/openfoam/foam_reader.hpp"
#include "io/openfoam/foam_writer.hpp"
#include "io/pictures/svg_writer.hpp"
#include "io/solvers/inp_reader.hpp"
#include "io/solvers/inp_writer.hpp"
#include "io/solvers/msh_reader.hpp"
#include "io/solvers/msh_writer.hpp"
#include "io/solvers/vtu_reader.hpp"
#include "io/solvers/vtu_writer.hpp"

namespace pcvt {
namespace {

std::vector<std::string> only(const std::string& path) { return {path}; }

using ArrayEncoder = std::vector<EncodedFile>(const Tile& tile, const std::string& path);

/// An encoder that needs the arrays alone.
template <ArrayEncoder* kEncode>
std::vector<EncodedFile> arrays(const OpenMeshTile&, const Tile& flat, const std::string& path) {
    return kEncode(flat, path);
}

std::vector<EncodedFile> mesh(const OpenMeshTile& mesh, const Tile&, const std::string& path) {
    return encode_om(mesh, path);
}

std::string lower_case(std::string text) {
    for (char& c : text) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return text;
}

}  // namespace

const std::vector<TileFormat>& tile_formats() {
    static const std::vector<TileFormat> formats{
        {".obj", "Wavefront OBJ, with .mtl and .seam.json beside it", obj_paths, arrays<encode_obj>,
         decode_obj},
        {".ply", "PLY, ASCII with double coordinates", only, arrays<encode_ply>, decode_ply},
        {".glb", "glTF 2.0, one binary file", only, arrays<encode_glb>, decode_gltf},
        {".gltf", "glTF 2.0, one text file", only, arrays<encode_gltf>, decode_gltf},
        {".om", "OpenMesh, with the identification as properties", only, mesh, decode_om},
        {".msh", "Gmsh MSH 4.1 with $Periodic, triangles only", only, arrays<encode_msh>,
         decode_msh, true, true},
        {".inp", "Abaqus and CalculiX with *EQUATION, triangles only", only, arrays<encode_inp>,
         decode_inp, true, true},
        {".vtu", "VTK unstructured grid, ASCII, with double coordinates", only, arrays<encode_vtu>,
         decode_vtu, false, true},
        {".svg", "a picture", only, arrays<encode_svg>, nullptr},
        {".foam", "OpenFOAM, a case folder that icoFoam runs", foam_paths, arrays<encode_foam>,
         decode_foam, false, false, true, true},
    };
    return formats;
}

std::vector<EncodedFile> encode_tile(const TileFormat& format, const OpenMeshTile& tile,
                                     const std::string& path) {
    return format.encode(tile, flatten(tile), path);
}

const TileFormat* find_tile_format(const std::string& path) {
    const std::string extension = lower_case(std::filesystem::path(path).extension().string());
    const auto& formats = tile_formats();
    const auto found = std::find_if(formats.begin(), formats.end(), [&](const TileFormat& format) {
        return format.extension == extension;
    });
    return found == formats.end() ? nullptr : &*found;
}

}  // namespace pcvt
