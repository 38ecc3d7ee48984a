#include "mesher/polyhedra/cell_faces.hpp"

#include <numeric>

#include "mesher/base/checkpoint.hpp"

namespace pcvt {

CellFaces::CellFaces(const PolyhedralMesh& mesh)
    : begin_(static_cast<std::size_t>(mesh.n_cells) + 1, 0) {
    const auto visit = [&](const auto& use) {
        for (int f = 0; f < mesh.n_faces(); ++f) {
            checkpoint_each(f);
            use(mesh.owner[f], f, false);
            if (f < mesh.n_inner_faces()) use(mesh.neighbour[f], f, true);
        }
    };
    visit([&](int cell, int, bool) { ++begin_[cell + 1]; });
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    uses_.resize(static_cast<std::size_t>(begin_.back()));
    std::vector<int> next = begin_;
    visit([&](int cell, int face, bool reversed) { uses_[next[cell]++] = {face, reversed}; });
}

std::vector<CellBody> cell_bodies(const PolyhedralMesh& mesh) {
    const CellFaces cells(mesh);
    std::vector<CellBody> bodies(static_cast<std::size_t>(mesh.n_cells));
    std::vector<Vec3> corners;
    for (int s = 0; s < cells.n_cells(); ++s) {
        checkpoint_each(s);
        if (cells[s].empty()) continue;
        PyramidSum sum(mesh.points[mesh.faces[cells[s][0].face][0]]);
        for (const FaceUse& use : cells[s]) {
            corners.clear();
            for (const int v : mesh.faces[use.face]) corners.push_back(mesh.points[v]);
            sum.add(corners, use.reversed ? -1 : 1);
        }
        bodies[s] = sum.body();
    }
    return bodies;
}

}  // namespace pcvt
