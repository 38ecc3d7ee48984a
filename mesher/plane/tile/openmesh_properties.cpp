#include "mesher/plane/tile/openmesh_properties.hpp"

namespace pcvt::plane {
namespace {

template <class Mesh, class Handle>
void attach_property(Mesh& mesh, Handle& handle, const char* name, bool persistent = true) {
    if (!mesh.get_property_handle(handle, name)) mesh.add_property(handle, name);
    if (persistent) mesh.property(handle).set_persistent(true);
}

template <class Mesh, class Handle>
void attach_mesh_property(Mesh& mesh, Handle& handle, const char* name) {
    if (!mesh.get_property_handle(handle, name)) mesh.add_property(handle, name);
    mesh.mproperty(handle).set_persistent(true);
}

template <class Mesh>
void attach_all(Mesh& mesh, OpenMeshProperties& id) {
    attach_property(mesh, id.partner, "pcvt_partner");
    attach_property(mesh, id.partner_offset, "pcvt_partner_offset");
    attach_property(mesh, id.orbit, "pcvt_orbit");
    attach_property(mesh, id.orbit_offset, "pcvt_orbit_offset");
    attach_property(mesh, id.face_site, "pcvt_face_site");
    attach_property(mesh, id.vertex_site, "pcvt_vertex_site");
    attach_property(mesh, id.site_point, "pcvt_site_point", false);
    attach_property(mesh, id.whole_sides, "pcvt_whole_sides", false);
    attach_mesh_property(mesh, id.lattice, "pcvt_lattice");
    attach_mesh_property(mesh, id.sites, "pcvt_sites");
    attach_mesh_property(mesh, id.site_weights, "pcvt_site_weights");
    attach_mesh_property(mesh, id.metric, "pcvt_metric");
    attach_mesh_property(mesh, id.walls, "pcvt_walls");
    attach_mesh_property(mesh, id.holes, "pcvt_holes");
}

}  // namespace

void OpenMeshProperties::attach(CellMesh& mesh) { attach_all(mesh, *this); }
void OpenMeshProperties::attach(TriangleMesh& mesh) { attach_all(mesh, *this); }

}  // namespace pcvt::plane
