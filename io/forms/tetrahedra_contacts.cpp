#include "io/forms/tetrahedra_contacts.hpp"

#include <algorithm>
#include <tuple>

#include "mesher/base/cancellable_sort.hpp"
#include "mesher/base/disjoint_sets.hpp"
#include "mesher/space/mesh/midside_nodes.hpp"

namespace pcvt {
namespace {

/// A side on the boundary of the tile: its images of nodes, the first of which has the offset 0.
struct SeamSide {
    std::array<space::Corner, 3> corners;
    space::Offset offset;
    int place;
    friend auto operator<=>(const SeamSide&, const SeamSide&) = default;
};

SharedTriangle triangle_of(int place, int other, space::Offset offset) {
    return {{place / 4, other / 4}, {place % 4, other % 4}, offset};
}

SeamSide seam_side(const space::TetrahedralMesh& mesh, const TetrahedronSide& side) {
    SeamSide found{.corners = {}, .offset = {}, .place = side.place};
    std::transform(side.points.begin(), side.points.end(), found.corners.begin(),
                   [&](int v) { return mesh.corner(v); });
    std::sort(found.corners.begin(), found.corners.end());
    found.offset = found.corners.front().offset;
    for (space::Corner& corner : found.corners) corner.offset = corner.offset - found.offset;
    return found;
}

/// The triangles inside of the tile; adds the sides that no other side meets there.
std::vector<SharedTriangle> inner_triangles(const space::TetrahedralMesh& mesh,
                                            std::vector<SeamSide>& on_seam) {
    const std::vector<TetrahedronSide> sides = sorted_sides(mesh);
    std::vector<SharedTriangle> triangles;
    for (std::size_t k = 0; k < sides.size(); ++k) {
        if (k + 1 < sides.size() && sides[k].points == sides[k + 1].points) {
            triangles.push_back(triangle_of(sides[k].place, sides[k + 1].place, {}));
            ++k;
        } else {
            on_seam.push_back(seam_side(mesh, sides[k]));
        }
    }
    return triangles;
}

void add_seam_triangles(std::vector<SeamSide> sides, std::vector<SharedTriangle>& triangles) {
    cancellable_sort(sides.begin(), sides.end());
    for (std::size_t k = 1; k < sides.size(); ++k) {
        if (sides[k - 1].corners != sides[k].corners) continue;
        triangles.push_back(
            triangle_of(sides[k - 1].place, sides[k].place, sides[k].offset - sides[k - 1].offset));
        ++k;
    }
}

/// Whether each cell consists of one part.
std::vector<char> whole_cells(const space::TetrahedralMesh& mesh,
                              const std::vector<SharedTriangle>& triangles) {
    DisjointSets parts(mesh.n_tetrahedra());
    for (const SharedTriangle& triangle : triangles) {
        const auto [t, u] = triangle.tetrahedra;
        if (!triangle.is_on_seam() && mesh.cell[t] == mesh.cell[u]) parts.unite(t, u);
    }
    std::vector<int> n_parts(static_cast<std::size_t>(mesh.cell.back()) + 1, 0);
    for (int t = 0; t < mesh.n_tetrahedra(); ++t) {
        if (parts.find(t) == t) ++n_parts[mesh.cell[t]];
    }
    std::vector<char> are_whole;
    for (const int n : n_parts) are_whole.push_back(n == 1 ? 1 : 0);
    return are_whole;
}

/// Counts the cells at nodes: each tetrahedron has a part at each of its nodes, and those that meet
/// in a triangle inside of a cell are one.
class CellCount {
   public:
    explicit CellCount(const ElementMesh& mesh)
        : mesh_(mesh),
          n_nodes_(mesh.elements.type().n_nodes),
          parts_(n_nodes_ * mesh.elements.size()) {}

    void join(const SharedTriangle& triangle) {
        const auto [t, u] = triangle.tetrahedra;
        for (int k = 0; k < n_nodes_; ++k) {
            if (!is_on_side(k, triangle.apexes[0])) continue;
            for (int l = 0; l < n_nodes_; ++l) {
                if (is_on_side(l, triangle.apexes[1]) &&
                    are_images(node(t, k), node(u, l), triangle.offset)) {
                    parts_.unite(n_nodes_ * t + k, n_nodes_ * u + l);
                }
            }
        }
    }

    /// The number of cells at the first node of each orbit.
    std::vector<int> count() {
        std::vector<int> n_cells(mesh_.nodes.size(), 0);
        for (int part = 0; part < n_nodes_ * mesh_.elements.size(); ++part) {
            if (parts_.find(part) != part) continue;
            ++n_cells[mesh_.orbit[node(part / n_nodes_, part % n_nodes_)]];
        }
        return n_cells;
    }

   private:
    int node(int t, int k) const { return mesh_.elements.nodes[t][k]; }

    bool are_images(int v, int w, space::Offset offset) const {
        if (mesh_.orbit[v] != mesh_.orbit[w]) return false;
        const std::array<int, 3> by = offset.components();
        for (int i = 0; i < 3; ++i) {
            if (mesh_.offsets[3 * v + i] + by[i] != mesh_.offsets[3 * w + i]) return false;
        }
        return true;
    }

    const ElementMesh& mesh_;
    const int n_nodes_;
    DisjointSets parts_;
};

}  // namespace

std::vector<TetrahedronSide> sorted_sides(const space::TetrahedralMesh& mesh) {
    std::vector<TetrahedronSide> sides;
    sides.reserve(4 * mesh.tetrahedra.size());
    for (const std::array<int, 4>& corners : mesh.tetrahedra) {
        for (std::size_t k = 0; k < 4; ++k) {
            TetrahedronSide side{{corners[(k + 1) % 4], corners[(k + 2) % 4], corners[(k + 3) % 4]},
                                 static_cast<int>(sides.size())};
            std::sort(side.points.begin(), side.points.end());
            sides.push_back(side);
        }
    }
    cancellable_sort(sides.begin(), sides.end());
    return sides;
}

bool is_on_side(std::size_t k, int apex) {
    if (k < 4) return static_cast<int>(k) != apex;
    const auto& [i, j] = space::kEdgeCorners[k - 4];
    return i != apex && j != apex;
}

TetrahedraContacts cell_contacts(const space::TetrahedralMesh& mesh, const ElementMesh& elements) {
    TetrahedraContacts contacts;
    std::vector<SeamSide> on_seam;
    contacts.triangles = inner_triangles(mesh, on_seam);
    add_seam_triangles(std::move(on_seam), contacts.triangles);
    if (mesh.cell.empty()) return contacts;
    const std::vector<char> are_whole = whole_cells(mesh, contacts.triangles);
    CellCount cells(elements);
    for (SharedTriangle& triangle : contacts.triangles) {
        checkpoint_each(triangle.tetrahedra[0]);
        const SiteId cell = mesh.cell[triangle.tetrahedra[0]];
        triangle.is_between_cells = cell != mesh.cell[triangle.tetrahedra[1]] ||
                                    (triangle.is_on_seam() && are_whole[cell] != 0);
        if (!triangle.is_between_cells) cells.join(triangle);
    }
    const std::vector<int> n_cells = cells.count();
    for (int v = 0; v < elements.n_nodes(); ++v) {
        for (int k = 0; k < std::min(n_cells[elements.orbit[v]] - 1, 3); ++k) {
            contacts.nodes[k].push_back(v);
        }
    }
    return contacts;
}

}  // namespace pcvt
