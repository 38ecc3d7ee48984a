#include "mesher/space/tile/openmesh_surface.hpp"

#include <string>
#include <utility>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"

namespace pcvt::space {
namespace {

template <class Handle>
void add(plane::CellMesh& mesh, Handle& handle, const char* name) {
    mesh.add_property(handle, name);
    mesh.property(handle).set_persistent(true);
}

void add_faces(const TileSurface& surface, OpenMeshSurface& built) {
    std::vector<OpenMesh::VertexHandle> corners;
    for (int f = 0; f < surface.n_faces(); ++f) {
        checkpoint_each(f);
        corners.clear();
        for (const int v : surface.faces[f]) corners.emplace_back(v);
        const OpenMesh::FaceHandle face = built.mesh.add_face(corners);
        if (!face.is_valid()) {
            throw InvalidInput("no OpenMesh structure holds the boundary: at face " +
                               std::to_string(f) + " it touches itself; take other sites");
        }
        const Offset offset = surface.offset[f];
        built.mesh.property(built.partner, face) = surface.partner[f];
        built.mesh.property(built.offset, face) = {offset.i, offset.j, offset.k};
        built.mesh.property(built.cell, face) = surface.cell[f];
    }
}

}  // namespace

OpenMeshSurface::OpenMeshSurface() {
    add(mesh, partner, "pcvt_face_partner");
    add(mesh, offset, "pcvt_face_offset");
    add(mesh, cell, "pcvt_face_cell");
    for (const auto& [handle, name] :
         {std::pair{&lattice, "pcvt_lattice"}, {&sites, "pcvt_sites"}}) {
        mesh.add_property(*handle, name);
        mesh.mproperty(*handle).set_persistent(true);
    }
}

OpenMeshSurface openmesh_surface(const TileSurface& surface) {
    OpenMeshSurface built;
    for (const Vec3& period : surface.lattice.periods()) {
        std::vector<double>& numbers = built.mesh.property(built.lattice);
        numbers.insert(numbers.end(), period.begin(), period.end());
    }
    const Points& sites = surface.sites;
    built.mesh.property(built.sites).assign(sites.data(), sites.data() + sites.size());
    for (const Vec3& p : surface.points) {
        built.mesh.add_vertex(OpenMesh::Vec3d(p.x(), p.y(), p.z()));
    }
    add_faces(surface, built);
    return built;
}

TileSurface tile_surface(const OpenMeshSurface& surface) {
    const plane::CellMesh& mesh = surface.mesh;
    const std::vector<double>& n = mesh.property(surface.lattice);
    if (n.size() != 9) throw InvalidInput("the lattice of the surface has not nine numbers");
    TileSurface arrays{.lattice =
                           Lattice({n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]})};
    const std::vector<double>& sites = mesh.property(surface.sites);
    if (sites.size() % 3 != 0) throw InvalidInput("the sites of the surface are not triples");
    arrays.sites =
        Eigen::Map<const Points>(sites.data(), 3, static_cast<Eigen::Index>(sites.size() / 3));
    for (const auto v : mesh.vertices()) {
        const OpenMesh::Vec3d& p = mesh.point(v);
        arrays.points.emplace_back(p[0], p[1], p[2]);
    }
    for (const auto f : mesh.faces()) {
        for (const auto v : mesh.fv_range(f)) arrays.faces.corners.push_back(v.idx());
        arrays.faces.close();
        const OpenMesh::Vec3i& offset = mesh.property(surface.offset, f);
        arrays.partner.push_back(mesh.property(surface.partner, f));
        arrays.offset.push_back({offset[0], offset[1], offset[2]});
        arrays.cell.push_back(mesh.property(surface.cell, f));
    }
    return arrays;
}

}  // namespace pcvt::space
