#include "mesher/space/proof/polyhedral_proof.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/disjoint_sets.hpp"
#include "mesher/base/law_violation.hpp"
#include "mesher/cells/set_names.hpp"
#include "mesher/space/mesh/boundary_surface.hpp"
#include "mesher/space/mesh/seam_pairs.hpp"
#include "mesher/space/proof/cell_proof.hpp"

namespace pcvt::space {
namespace {

/// The volumes of a million cells, summed, err by less.
constexpr double kTotalError = 1e-11;

constexpr const char* kSeam = "(3), seam";
constexpr const char* kGluing = "(4), gluing";
constexpr const char* kOrbits = "(6), orbits of points";

double largest_coordinate(const PolyhedralMesh& mesh) {
    double largest = 0;
    for (const Vec3& p : mesh.points) {
        if (!p.allFinite()) throw_violation(kOrbits, "a point is not finite");
        largest = std::max(largest, p.cwiseAbs().maxCoeff());
    }
    return largest;
}

/// The patches state the pairs that were found.
void prove_patches(const PolyhedralMesh& mesh, const std::vector<FacePair>& pairs) {
    std::size_t next = 0;
    const int n_patches = static_cast<int>(mesh.patches.size());
    for (int p = 0; p < n_patches; ++p) {
        const FiniteVolumePatch& patch = mesh.patches[p];
        const Offset offset = patch.offset_as<Offset>();
        const bool known = patch.partner >= 0 && patch.partner < n_patches;
        if (!known || mesh.patches[patch.partner].partner != p ||
            mesh.patches[patch.partner].offset_as<Offset>() != -offset ||
            mesh.patches[patch.partner].n_faces != patch.n_faces) {
            throw_violation(kSeam, "the patch " + patch.name + " has no partner");
        }
        if (patch.name != seam_name(offset) ||
            patch.separation != mesh.lattice.translation(offset)) {
            throw_violation(kSeam, "the patch " + patch.name + " states another translation");
        }
        if (offset < Offset{}) continue;
        const int first = mesh.patches[patch.partner].first_face;
        for (int k = 0; k < patch.n_faces; ++k, ++next) {
            const FacePair stated{patch.first_face + k, first + k, offset, 0};
            const bool found = next < pairs.size() && pairs[next].first == stated.first &&
                               pairs[next].second == stated.second &&
                               pairs[next].offset == stated.offset && pairs[next].start == 0;
            if (!found) {
                throw_violation(kSeam, "face " + std::to_string(stated.first) +
                                           " does not match its partner in the patch " +
                                           patch.name);
            }
        }
    }
}

using Edge = std::pair<int, int>;

std::vector<Edge> edges_of(const PolyhedralMesh& mesh) {
    std::vector<Edge> edges;
    for (int f = 0; f < mesh.n_faces(); ++f) {
        checkpoint_each(f);
        int from = mesh.faces[f].back();
        for (const int v : mesh.faces[f]) {
            edges.emplace_back(std::min(from, v), std::max(from, v));
            from = v;
        }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

/// Vertices, edges and faces after gluing.
class Gluing {
   public:
    Gluing(const PolyhedralMesh& mesh, const std::vector<FacePair>& pairs)
        : n_points_(mesh.n_points()),
          points_(n_points_),
          edges_(edges_of(mesh)),
          edge_sets_(static_cast<int>(edges_.size())),
          n_faces_(mesh.n_inner_faces() + static_cast<int>(pairs.size())) {
        for (const FacePair& pair : pairs) {
            const auto here = mesh.faces[pair.first];
            const auto there = mesh.faces[pair.second];
            const int n = static_cast<int>(here.size());
            for (int k = 0; k < n; ++k) {
                const int v = here[k];
                const int v_next = here[(k + 1) % n];
                const int w = there[(pair.start - k + n) % n];
                const int w_next = there[(pair.start - k - 1 + n) % n];
                points_.unite(v, w);
                edge_sets_.unite(edge(v, v_next), edge(w, w_next));
            }
        }
    }

    DisjointSets& points() { return points_; }
    long characteristic(int n_cells) {
        return long{count(points_, n_points_)} -
               count(edge_sets_, static_cast<int>(edges_.size())) + n_faces_ - n_cells;
    }

   private:
    int edge(int v, int w) const {
        const Edge wanted(std::min(v, w), std::max(v, w));
        return static_cast<int>(std::lower_bound(edges_.begin(), edges_.end(), wanted) -
                                edges_.begin());
    }
    static int count(DisjointSets& sets, int n) {
        int roots = 0;
        for (int k = 0; k < n; ++k) roots += sets.find(k) == k ? 1 : 0;
        return roots;
    }

    int n_points_;
    DisjointSets points_;
    std::vector<Edge> edges_;
    DisjointSets edge_sets_;
    int n_faces_;
};

/// The stored orbits are those of the gluing, and each point is its representative plus a
/// translation.
void prove_orbits(const PolyhedralMesh& mesh, DisjointSets& glued, double tolerance) {
    for (int v = 0; v < mesh.n_points(); ++v) {
        checkpoint_each(v);
        const int first = mesh.point_orbit[v];
        if (first != glued.find(v)) {
            throw_violation(kOrbits, "point " + std::to_string(v) + " is on the orbit of point " +
                                         std::to_string(glued.find(v)));
        }
        const Vec3 image = mesh.points[first] + mesh.lattice.translation(mesh.point_offset[v]);
        if (!((image - mesh.points[v]).cwiseAbs().maxCoeff() <= tolerance)) {
            throw_violation(kOrbits, "point " + std::to_string(v) +
                                         " is not its representative plus the stated translation");
        }
    }
}

/// The largest distance of a point from its representative plus the translation, in one coordinate.
double largest_mismatch(const PolyhedralMesh& mesh) {
    double largest = 0;
    for (int v = 0; v < mesh.n_points(); ++v) {
        const int first = mesh.point_orbit[v];
        if (first < 0 || first >= mesh.n_points()) continue;
        const Vec3 image = mesh.points[first] + mesh.lattice.translation(mesh.point_offset[v]);
        largest = std::max(largest, (image - mesh.points[v]).cwiseAbs().maxCoeff());
    }
    return largest;
}

}  // namespace

PolyhedralProof prove_polyhedra(const PolyhedralMesh& mesh, double least_tolerance) {
    const double tolerance =
        std::max(kPositionUlps * std::numeric_limits<double>::epsilon() * largest_coordinate(mesh),
                 least_tolerance);
    prove_face_order(mesh);
    const double volume = prove_cells(mesh, tolerance);
    const std::vector<FacePair> pairs = seam_pairs(mesh, tolerance);
    prove_patches(mesh, pairs);
    Gluing gluing(mesh, pairs);
    if (const long characteristic = gluing.characteristic(mesh.n_cells); characteristic != 0) {
        throw_violation(kGluing, "vertices - edges + faces - cells = " +
                                     std::to_string(characteristic) + ", not 0");
    }
    const double excess = volume / mesh.lattice.volume() - 1;
    if (!(std::abs(excess) <= kTotalError)) {
        throw_violation(kGluing,
                        "the volumes sum to that of the domain times 1 + " + in_words(excess));
    }
    prove_orbits(mesh, gluing.points(), tolerance);
    return {.n_cells = mesh.n_cells,
            .n_faces = mesh.n_faces(),
            .n_boundary_pairs = static_cast<int>(pairs.size()),
            .n_translations = static_cast<int>(mesh.patches.size()) / 2,
            .volume = volume,
            .tolerance = tolerance,
            .mismatch = largest_mismatch(mesh),
            .boundary_is_manifold = boundary_is_manifold(mesh)};
}

}  // namespace pcvt::space
