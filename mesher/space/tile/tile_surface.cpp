#include "mesher/space/tile/tile_surface.hpp"

#include "mesher/base/checkpoint.hpp"

namespace pcvt::space {

TileSurface tile_surface(const PolyhedralMesh& mesh, const Points& sites) {
    TileSurface surface{.lattice = mesh.lattice};
    surface.sites = sites;
    const int first = mesh.n_inner_faces();
    // The points of the boundary keep their order.
    std::vector<int> number(mesh.points.size(), -1);
    for (int c = mesh.faces.begin[first]; c < mesh.faces.begin.back(); ++c) {
        number[mesh.faces.corners[c]] = 0;
    }
    for (int v = 0; v < mesh.n_points(); ++v) {
        if (number[v] < 0) continue;
        number[v] = static_cast<int>(surface.points.size());
        surface.points.push_back(mesh.points[v]);
    }
    for (int f = first; f < mesh.n_faces(); ++f) {
        checkpoint_each(f);
        for (const int v : mesh.faces[f]) surface.faces.corners.push_back(number[v]);
        surface.faces.close();
        surface.cell.push_back(mesh.owner[f]);
    }
    for (const FiniteVolumePatch& patch : mesh.patches) {
        const int partner = mesh.patches[patch.partner].first_face - first;
        for (int k = 0; k < patch.n_faces; ++k) {
            surface.partner.push_back(partner + k);
            surface.offset.push_back(patch.offset_as<Offset>());
        }
    }
    return surface;
}

}  // namespace pcvt::space
