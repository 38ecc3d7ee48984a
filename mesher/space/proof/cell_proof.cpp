#include "mesher/space/proof/cell_proof.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/disjoint_sets.hpp"
#include "mesher/base/law_violation.hpp"
#include "mesher/portable/portable_functions.hpp"
#include "mesher/space/mesh/cell_faces.hpp"

namespace pcvt::space {
namespace {

constexpr const char* kOrder = "(1), order of the faces";
constexpr const char* kCells = "(2), cells";
/// Corners within this part of h are one, so that faces are plane within it.
constexpr double kMergedCorners = 1e-9;

std::string words(const char* item, int number) {
    return std::string(item) + " " + std::to_string(number);
}

void prove_corners(const PolyhedralMesh& mesh) {
    for (int f = 0; f < mesh.n_faces(); ++f) {
        checkpoint_each(f);
        const auto face = mesh.faces[f];
        std::vector<int> corners(face.begin(), face.end());
        std::sort(corners.begin(), corners.end());
        const bool repeats = std::adjacent_find(corners.begin(), corners.end()) != corners.end();
        if (corners.size() < 3 || repeats) {
            throw_violation(kOrder, words("face", f) + " has not three or more different points");
        }
    }
}

/// The sides of the faces of one cell, seen from outside.
std::vector<std::pair<int, int>> sides_of(const PolyhedralMesh& mesh,
                                          std::span<const FaceUse> uses) {
    std::vector<std::pair<int, int>> sides;
    for (const FaceUse& use : uses) {
        int from = mesh.faces[use.face].back();
        for (const int v : mesh.faces[use.face]) {
            sides.push_back(use.reversed ? std::pair(v, from) : std::pair(from, v));
            from = v;
        }
    }
    std::sort(sides.begin(), sides.end());
    return sides;
}

/// The faces of a cell form a sphere: each side occurs once and is answered once, and V - E + F =
/// 2.
/// @returns the points of the cell.
std::vector<int> prove_closed(const PolyhedralMesh& mesh, int cell, std::span<const FaceUse> uses) {
    const auto sides = sides_of(mesh, uses);
    std::vector<int> points;
    for (std::size_t k = 0; k < sides.size(); ++k) {
        const auto [from, to] = sides[k];
        const bool twice = k > 0 && sides[k] == sides[k - 1];
        if (twice || !std::binary_search(sides.begin(), sides.end(), std::pair(to, from))) {
            throw_violation(kCells, "the faces of " + words("cell", cell) +
                                        " do not close at the edge " + edge_in_words(from, to));
        }
        if (points.empty() || points.back() != from) points.push_back(from);
    }
    const auto characteristic = static_cast<std::ptrdiff_t>(points.size()) -
                                static_cast<std::ptrdiff_t>(sides.size() / 2) +
                                static_cast<std::ptrdiff_t>(uses.size());
    if (characteristic != 2) {
        throw_violation(kCells, words("cell", cell) + " is not a ball: V - E + F = " +
                                    std::to_string(characteristic));
    }
    return points;
}

/// The plane of a face, with its normal pointing out of the cell.
struct FacePlane {
    Vec3 point;
    Vec3 normal;
    /// The area over the longest diagonal from the first corner.
    double width;
};

FacePlane plane_of(const PolyhedralMesh& mesh, const FaceUse& use) {
    const auto corners = mesh.faces[use.face];
    const Vec3 first = mesh.points[corners[0]];
    Vec3 normal = Vec3::Zero();
    Vec3 mean = Vec3::Zero();
    double longest = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vec3 here = mesh.points[corners[k]] - first;
        const Vec3 next = mesh.points[corners[(k + 1) % corners.size()]] - first;
        normal += here.cross(next) / 2;
        mean += here / static_cast<double>(corners.size());
        longest = std::max(longest, here.norm());
    }
    const double area = normal.norm();
    const double sign = use.reversed ? -1 : 1;
    return {first + mean, sign * normal / area, area / longest};
}

/// All points of a cell lie behind the planes of its faces, as far as their corners determine them.
void prove_convex(const PolyhedralMesh& mesh, int cell, std::span<const FaceUse> uses,
                  const std::vector<int>& points, double error) {
    for (const FaceUse& use : uses) {
        const FacePlane plane = plane_of(mesh, use);
        if (!(plane.width > error)) continue;
        for (const int v : points) {
            const Vec3 to_point = mesh.points[v] - plane.point;
            const double height = to_point.dot(plane.normal);
            if (height <= error * (4 + 4 * to_point.norm() / plane.width)) continue;
            throw_violation(kCells, words("cell", cell) + " is not convex: " + words("point", v) +
                                        " lies " + in_words(height) + " in front of " +
                                        words("face", use.face));
        }
    }
}

void prove_connected(const PolyhedralMesh& mesh) {
    DisjointSets parts(mesh.n_cells);
    for (int f = 0; f < mesh.n_inner_faces(); ++f) parts.unite(mesh.owner[f], mesh.neighbour[f]);
    for (int s = 0; s < mesh.n_cells; ++s) {
        if (parts.find(s) == 0) continue;
        throw_violation("(5), connection",
                        "no inner faces lead from cell 0 to " + words("cell", s));
    }
}

}  // namespace

void prove_face_order(const PolyhedralMesh& mesh) {
    require_face_order(mesh, kOrder);
    if (last_cell(mesh) >= mesh.n_cells) {
        throw_violation(kOrder, words("cell", last_cell(mesh)) + " is none of the " +
                                    std::to_string(mesh.n_cells) + " cells");
    }
    for (const FiniteVolumePatch& patch : mesh.patches) {
        if (patch.n_faces < 1) throw_violation(kOrder, "patch " + patch.name + " has no face");
    }
    prove_corners(mesh);
}

double prove_cells(const PolyhedralMesh& mesh, double tolerance) {
    const CellFaces cells(mesh);
    const std::vector<CellBody> bodies = cell_bodies(mesh);
    const double h = portable_cbrt(mesh.lattice.volume() / mesh.n_cells);
    // Corners were merged in the round space of the metric.
    const double merged = kMergedCorners * mesh.metric.largest_stretch_back();
    const double error = tolerance + std::max(merged, mesh.short_edges) * h;
    double sum = 0;
    for (int s = 0; s < mesh.n_cells; ++s) {
        checkpoint_each(s, 64);
        const std::vector<int> points = prove_closed(mesh, s, cells[s]);
        if (!(bodies[s].volume > 0)) {
            throw_violation(kCells,
                            words("cell", s) + " has the volume " + in_words(bodies[s].volume));
        }
        prove_convex(mesh, s, cells[s], points, error);
        sum += bodies[s].volume;
    }
    prove_connected(mesh);
    return sum;
}

}  // namespace pcvt::space
