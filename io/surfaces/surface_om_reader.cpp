#include "io/surfaces/surface_om_reader.hpp"

#include "io/graphics/om_mesh.hpp"

namespace pcvt {
namespace {

space::Lattice lattice_of(const OmMesh& mesh) {
    const std::vector<double> n = mesh.numbers("pcvt_lattice");
    if (n.size() != 9) mesh.throw_bad_file("has too little or too much pcvt_lattice");
    try {
        return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}};
    } catch (const InvalidInput& fault) {
        mesh.throw_other_fault(fault);
    }
}

}  // namespace

bool is_surface_om(const EncodedFile& file) {
    return file.bytes.starts_with("OM") &&
           file.bytes.find("pcvt_face_partner") != std::string::npos;
}

space::TileSurface decode_surface_om(const EncodedFile& om) {
    const OmMesh mesh(om.path, om.bytes);
    space::TileSurface surface{.lattice = lattice_of(mesh)};
    for (const auto& [x, y, z] : mesh.points()) surface.points.emplace_back(x, y, z);
    surface.faces = mesh.faces();
    surface.cell = mesh.integers("pcvt_face_cell", 1, mesh.n_faces());
    surface.partner = mesh.integers("pcvt_face_partner", 1, mesh.n_faces());
    const std::vector<int> offsets = mesh.offsets("pcvt_face_offset", 3, mesh.n_faces());
    for (std::size_t k = 0; k < offsets.size(); k += 3) {
        surface.offset.push_back({offsets[k], offsets[k + 1], offsets[k + 2]});
    }
    const std::vector<double> sites = mesh.numbers("pcvt_sites");
    if (sites.size() % 3 != 0) mesh.throw_bad_file("has too little or too much pcvt_sites");
    surface.sites = Eigen::Map<const space::Points>(sites.data(), 3,
                                                    static_cast<Eigen::Index>(sites.size() / 3));
    return surface;
}

}  // namespace pcvt
