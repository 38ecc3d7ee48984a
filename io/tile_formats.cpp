#include "io/tile_formats.hpp"

#include <algorithm>
#include <filesystem>

#include "io/gltf_reader.hpp"
#include "io/gltf_writer.hpp"
#include "io/inp_reader.hpp"
#include "io/inp_writer.hpp"
#include "io/msh_reader.hpp"
#include "io/msh_writer.hpp"
#include "io/obj_reader.hpp"
#include "io/obj_writer.hpp"
#include "io/om_reader.hpp"
#include "io/om_writer.hpp"
#include "io/ply_reader.hpp"
#include "io/ply_writer.hpp"
#include "io/svg_writer.hpp"
#include "io/vtu_reader.hpp"
#include "io/vtu_writer.hpp"

namespace pcvt {
namespace {

std::vector<std::string> only(const std::string& path) { return {path}; }

std::string lower_case(std::string text) {
    for (char& c : text) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return text;
}

}  // namespace

const std::vector<TileFormat>& tile_formats() {
    static const std::vector<TileFormat> formats{
        {".obj", "Wavefront OBJ, with .mtl and .seam.json beside it", obj_paths, encode_obj,
         decode_obj},
        {".ply", "PLY, ASCII with double coordinates", only, encode_ply, decode_ply},
        {".glb", "glTF 2.0, one binary file", only, encode_glb, decode_gltf},
        {".gltf", "glTF 2.0, one text file", only, encode_gltf, decode_gltf},
        {".om", "OpenMesh, with the identification as properties", only, encode_om, decode_om},
        {".msh", "Gmsh MSH 4.1 with $Periodic, triangles only", only, encode_msh, decode_msh, true,
         true},
        {".inp", "Abaqus and CalculiX with *EQUATION, triangles only", only, encode_inp, decode_inp,
         true, true},
        {".vtu", "VTK unstructured grid, ASCII, with double coordinates", only, encode_vtu,
         decode_vtu, false, true},
        {".svg", "a picture", only, encode_svg, nullptr},
    };
    return formats;
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
