#include "io/forms/closed_surfaces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <tuple>
#include <utility>

#include "io/forms/tetrahedra_contacts.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/base/disjoint_sets.hpp"
#include "mesher/space/mesh/cell_faces.hpp"

namespace pcvt {
namespace {

using Triangle = std::array<int, 3>;

Triangle reversed(const Triangle& triangle) { return {triangle[0], triangle[2], triangle[1]}; }

/// The area of a triangle over the square of its longest edge.
double wideness(const std::vector<space::Vec3>& points, const Triangle& triangle) {
    const space::Vec3 p = points[triangle[1]] - points[triangle[0]];
    const space::Vec3 q = points[triangle[2]] - points[triangle[0]];
    const double longest = std::max({p.squaredNorm(), q.squaredNorm(), (q - p).squaredNorm()});
    return longest > 0 ? p.cross(q).norm() / longest : 0;
}

/// The fan of triangles of a face from one of its corners.
std::vector<Triangle> fan_from(std::span<const int> face, int apex) {
    const auto n = static_cast<int>(face.size());
    std::vector<Triangle> fan;
    for (int k = 1; k + 1 < n; ++k) {
        fan.push_back({face[apex], face[(apex + k) % n], face[(apex + k + 1) % n]});
    }
    return fan;
}

/// The corner of a face whose narrowest triangle is the widest.
int best_apex(const std::vector<space::Vec3>& points, std::span<const int> face) {
    int best = 0;
    double widest = -1;
    for (int apex = 0; apex < static_cast<int>(face.size()); ++apex) {
        double narrowest = 1;
        for (const Triangle& triangle : fan_from(face, apex)) {
            narrowest = std::min(narrowest, wideness(points, triangle));
        }
        if (narrowest > widest) {
            widest = narrowest;
            best = apex;
        }
    }
    return best;
}

/// The apex of each face. That of the second side of a seam is the partner of that of the first.
std::vector<int> apices(const space::PolyhedralMesh& mesh) {
    std::vector<int> apex(static_cast<std::size_t>(mesh.n_faces()));
    for (int f = 0; f < mesh.n_faces(); ++f) {
        checkpoint_each(f);
        apex[f] = best_apex(mesh.points, mesh.faces[f]);
    }
    for (std::size_t p = 0; p < mesh.patches.size(); ++p) {
        const FiniteVolumePatch& patch = mesh.patches[p];
        if (patch.partner < static_cast<int>(p)) continue;
        const int there = mesh.patches[patch.partner].first_face;
        for (int k = 0; k < patch.n_faces; ++k) {
            const int n = mesh.faces.size(patch.first_face + k);
            apex[there + k] = (n - apex[patch.first_face + k]) % n;
        }
    }
    return apex;
}

}  // namespace

ClosedSurfaces closed_surfaces(const space::PolyhedralMesh& mesh, SurfaceForm form) {
    ClosedSurfaces surfaces{.form = form, .lattice = mesh.lattice, .points = mesh.points};
    const std::vector<int> apex = apices(mesh);
    const auto add = [&](int face, bool is_reversed) {
        for (const Triangle& triangle : fan_from(mesh.faces[face], apex[face])) {
            surfaces.triangles.push_back(is_reversed ? reversed(triangle) : triangle);
        }
    };
    if (form == SurfaceForm::kBoundary) {
        for (int f = mesh.n_inner_faces(); f < mesh.n_faces(); ++f) add(f, false);
        return surfaces;
    }
    const space::CellFaces cells(mesh);
    for (int s = 0; s < mesh.n_cells; ++s) {
        checkpoint_each(s);
        for (const space::FaceUse& use : cells[s]) add(use.face, use.reversed);
    }
    return surfaces;
}

ClosedSurfaces closed_surfaces(const space::TetrahedralMesh& mesh, SurfaceForm form) {
    // The tetrahedra of a cell that share sides fill one of its pieces.
    DisjointSets pieces(mesh.n_tetrahedra());
    const std::vector<TetrahedronSide> sides = sorted_sides(mesh);
    std::vector<TetrahedronSide> outer;
    for (std::size_t k = 0; k < sides.size();) {
        const bool is_inner = k + 1 < sides.size() && sides[k + 1].points == sides[k].points;
        const int t = sides[k].tetrahedron();
        if (!is_inner) {
            outer.push_back(sides[k]);
        } else if (const int u = sides[k + 1].tetrahedron(); mesh.cell[t] == mesh.cell[u]) {
            pieces.unite(t, u);
        } else if (form == SurfaceForm::kCells) {
            outer.push_back(sides[k]);
            outer.push_back(sides[k + 1]);
        }
        k += is_inner ? 2 : 1;
    }
    // Tetrahedra come cell by cell, so the first ones of pieces do as well.
    const auto key = [&](const TetrahedronSide& side) {
        const int t = side.tetrahedron();
        return std::tuple(form == SurfaceForm::kCells ? pieces.find(t) : 0, t, side.points);
    };
    std::sort(outer.begin(), outer.end(),
              [&](const auto& s, const auto& t) { return key(s) < key(t); });
    ClosedSurfaces surfaces{.form = form, .lattice = mesh.lattice, .points = mesh.points};
    for (const TetrahedronSide& side : outer) {
        const std::array<int, 4>& corners = mesh.tetrahedra[side.tetrahedron()];
        const Triangle& order = space::kOutwardSides[side.apex()];
        surfaces.triangles.push_back({corners[order[0]], corners[order[1]], corners[order[2]]});
    }
    return surfaces;
}

}  // namespace pcvt
