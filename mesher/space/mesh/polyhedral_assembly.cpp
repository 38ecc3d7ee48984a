#include "mesher/space/mesh/polyhedral_assembly.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/law_violation.hpp"
#include "mesher/space/mesh/cell_faces.hpp"
#include "mesher/space/mesh/seam_pairs.hpp"
#include "mesher/torus/offset_disjoint_sets.hpp"

namespace pcvt::space {
namespace {

/// A face of the list, by its points in rising order.
struct ListedFace {
    std::vector<int> points;
    int cell;
    int face;
};

std::vector<ListedFace> sorted_faces(const PolyhedronList& cells) {
    std::vector<ListedFace> listed;
    for (int s = 0; s < cells.n_cells(); ++s) {
        checkpoint_each(s);
        for (int f = cells.cell_begin[s]; f < cells.cell_begin[s + 1]; ++f) {
            std::vector<int> points(cells.faces[f].begin(), cells.faces[f].end());
            std::sort(points.begin(), points.end());
            listed.push_back({std::move(points), s, f});
        }
    }
    std::sort(listed.begin(), listed.end(), [](const ListedFace& s, const ListedFace& t) {
        return std::tie(s.points, s.cell, s.face) < std::tie(t.points, t.cell, t.face);
    });
    return listed;
}

struct InnerFace {
    int owner;
    int neighbour;
    int face;
    friend auto operator<=>(const InnerFace&, const InnerFace&) = default;
};

/// Adds the inner faces, and after them those that belong to only one cell, in one patch.
void add_faces(const PolyhedronList& cells, PolyhedralMesh& mesh) {
    const std::vector<ListedFace> listed = sorted_faces(cells);
    std::vector<InnerFace> inner;
    std::vector<std::pair<int, int>> outer;
    for (std::size_t k = 0; k < listed.size();) {
        std::size_t end = k + 1;
        while (end < listed.size() && listed[end].points == listed[k].points) ++end;
        if (end - k > 2) {
            throw_violation("(1), order of the faces", "more than two cells share a face of cell " +
                                                           std::to_string(listed[k].cell));
        }
        if (end - k == 2) {
            inner.push_back({listed[k].cell, listed[k + 1].cell, listed[k].face});
        } else {
            outer.emplace_back(listed[k].face, listed[k].cell);
        }
        k = end;
    }
    std::sort(inner.begin(), inner.end());
    std::sort(outer.begin(), outer.end());
    for (const InnerFace& face : inner) {
        mesh.faces.add(cells.faces[face.face]);
        mesh.owner.push_back(face.owner);
        mesh.neighbour.push_back(face.neighbour);
    }
    for (const auto& [face, cell] : outer) {
        mesh.faces.add(cells.faces[face]);
        mesh.owner.push_back(cell);
    }
}

/// Puts the boundary faces in the order of the pairs, and makes partners match point by point.
void order_boundary(std::vector<FacePair> pairs, PolyhedralMesh& mesh) {
    std::sort(pairs.begin(), pairs.end(), [&mesh](const FacePair& s, const FacePair& t) {
        return std::tuple(s.offset, mesh.owner[s.first], mesh.owner[s.second], s.first) <
               std::tuple(t.offset, mesh.owner[t.first], mesh.owner[t.second], t.first);
    });
    const Faces faces = mesh.faces;
    const std::vector<int> owner = mesh.owner;
    mesh.faces = {};
    for (int f = 0; f < mesh.n_inner_faces(); ++f) mesh.faces.add(faces[f]);
    mesh.owner.resize(mesh.neighbour.size());
    const auto add = [&](int face, int start) {
        const auto corners = faces[face];
        std::vector<int> turned(corners.begin(), corners.end());
        std::rotate(turned.begin(), turned.begin() + start, turned.end());
        mesh.faces.add(turned);
        mesh.owner.push_back(owner[face]);
    };
    for (std::size_t begin = 0; begin < pairs.size();) {
        std::size_t end = begin;
        while (end < pairs.size() && pairs[end].offset == pairs[begin].offset) ++end;
        add_seam_patches(pairs[begin].offset, static_cast<int>(end - begin), mesh);
        for (std::size_t k = begin; k < end; ++k) add(pairs[k].first, 0);
        for (std::size_t k = begin; k < end; ++k) add(pairs[k].second, pairs[k].start);
        begin = end;
    }
}

void set_orbits(const std::vector<FacePair>& pairs, PolyhedralMesh& mesh) {
    OffsetDisjointSets<Offset> joined(mesh.n_points());
    for (const FacePair& pair : pairs) {
        const auto here = mesh.faces[pair.first];
        const auto there = mesh.faces[pair.second];
        const int n = static_cast<int>(here.size());
        for (int k = 0; k < n; ++k) {
            joined.join(there[(pair.start - k + n) % n], here[k], pair.offset);
        }
    }
    for (int v = 0; v < mesh.n_points(); ++v) {
        const auto [orbit, offset] = joined.root(v);
        mesh.point_orbit.push_back(orbit);
        mesh.point_offset.push_back(offset);
    }
}

/// The tolerance of prove_polyhedra().
double tolerance_of(const std::vector<Vec3>& points) {
    double largest = 0;
    for (const Vec3& p : points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
    return kPositionUlps * std::numeric_limits<double>::epsilon() * largest;
}

}  // namespace

PolyhedronList polyhedron_list(const PolyhedralMesh& mesh) {
    PolyhedronList list;
    list.points = mesh.points;
    const CellFaces cells(mesh);
    for (int s = 0; s < mesh.n_cells; ++s) {
        checkpoint_each(s);
        for (const FaceUse& use : cells[s]) {
            const auto corners = mesh.faces[use.face];
            std::vector<int> face(corners.begin(), corners.end());
            if (use.reversed) std::reverse(face.begin() + 1, face.end());
            list.faces.add(face);
        }
        list.cell_begin.push_back(list.faces.n_faces());
    }
    return list;
}

PolyhedralMesh assembled_mesh(const Lattice& lattice, const PolyhedronList& cells,
                              double least_tolerance) {
    PolyhedralMesh mesh{{.n_cells = cells.n_cells()}, lattice};
    mesh.points = cells.points;
    add_faces(cells, mesh);
    const double tolerance = std::max(tolerance_of(mesh.points), least_tolerance);
    const std::vector<FacePair> pairs = seam_pairs(mesh, tolerance);
    set_orbits(pairs, mesh);
    order_boundary(pairs, mesh);
    return mesh;
}

}  // namespace pcvt::space
