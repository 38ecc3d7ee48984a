#include "mesher/space/mesh/cell_faces.hpp"

#include <cmath>
#include <numeric>

#include "mesher/base/checkpoint.hpp"

namespace pcvt::space {

namespace {

/// A face as finite-volume solvers see it.
struct SolverFace {
    Vec3 area;
    Vec3 centre;
};

/// Files state volumes, and Eigen's dot() adds in another order on other platforms.
double dot(const Vec3& p, const Vec3& q) { return p.x() * q.x() + p.y() * q.y() + p.z() * q.z(); }

SolverFace solver_face(const PolyhedralMesh& mesh, int f) {
    const auto& corners = mesh.faces[f];
    Vec3 mean = Vec3::Zero();
    for (const int v : corners) mean += mesh.points[v];
    mean /= double(corners.size());
    Vec3 area = Vec3::Zero();
    Vec3 moment = Vec3::Zero();
    double sum = 0;
    Vec3 from = mesh.points[corners.back()];
    for (const int v : corners) {
        const Vec3 to = mesh.points[v];
        const Vec3 triangle = (from - mean).cross(to - mean) / 2;
        const double size = std::sqrt(dot(triangle, triangle));
        area += triangle;
        sum += size;
        moment += size * (from + to + mean) / 3;
        from = to;
    }
    return {area, sum > 0 ? Vec3(moment / sum) : mean};
}

void set_solver_volumes(const PolyhedralMesh& mesh, const CellFaces& cells,
                        std::vector<CellBody>& bodies) {
    std::vector<SolverFace> faces;
    for (int f = 0; f < mesh.n_faces(); ++f) faces.push_back(solver_face(mesh, f));
    for (int s = 0; s < cells.n_cells(); ++s) {
        checkpoint_each(s);
        double sum = 0;
        for (const auto& [face, reversed] : cells[s]) {
            const Vec3 arm = faces[face].centre - bodies[s].centroid;
            sum += (reversed ? -1 : 1) * dot(faces[face].area, arm);
        }
        bodies[s].volume = sum / 3;
    }
}

}  // namespace

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
    if (mesh.short_edges > 0) set_solver_volumes(mesh, cells, bodies);
    return bodies;
}

}  // namespace pcvt::space
