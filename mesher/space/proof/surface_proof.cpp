#include "mesher/space/proof/surface_proof.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <tuple>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/disjoint_sets.hpp"
#include "mesher/base/law_violation.hpp"
#include "mesher/portable/portable_functions.hpp"
#include "mesher/space/mesh/cell_sites.hpp"
#include "mesher/space/mesh/seam_pairs.hpp"

namespace pcvt::space {
namespace {

constexpr const char* kFaces = "(1), points and faces";
constexpr const char* kManifold = "(2), a closed manifold";
constexpr const char* kPairs = "(3), pairs of faces";
/// The largest relative error of the volume; summation of 10^7 faces rounds by less.
constexpr double kEnclosedError = 1e-10;

std::string face_name(int f) { return "face " + std::to_string(f); }

void require_faces(const TileSurface& surface) {
    std::vector<bool> used(surface.points.size(), false);
    std::vector<int> corners;
    for (int f = 0; f < surface.n_faces(); ++f) {
        checkpoint_each(f);
        corners.assign(surface.faces[f].begin(), surface.faces[f].end());
        std::sort(corners.begin(), corners.end());
        const bool repeats = std::adjacent_find(corners.begin(), corners.end()) != corners.end();
        if (corners.size() < 3 || repeats) {
            throw_violation(kFaces, face_name(f) + " has fewer than three distinct corners");
        }
        for (const int v : corners) used[v] = true;
    }
    for (std::size_t v = 0; v < used.size(); ++v) {
        if (!surface.points[v].allFinite()) {
            throw_violation(kFaces, "point " + std::to_string(v) + " is not finite");
        }
        if (!used[v]) throw_violation(kFaces, "no face has point " + std::to_string(v));
    }
}

/// A directed edge of a face, from the corner with the index `corner` to that with `next`.
struct DirectedEdge {
    int from;
    int to;
    int corner;
    int next;
};

/// The edges, each beside its reverse.
std::vector<DirectedEdge> paired_edges(const TileSurface& surface) {
    std::vector<DirectedEdge> edges;
    edges.reserve(surface.faces.corners.size());
    for (int f = 0; f < surface.n_faces(); ++f) {
        const int begin = surface.faces.begin[f];
        const int n = surface.faces.size(f);
        for (int k = 0; k < n; ++k) {
            const int next = begin + (k + 1) % n;
            edges.push_back(
                {surface.faces.corners[begin + k], surface.faces.corners[next], begin + k, next});
        }
    }
    std::sort(edges.begin(), edges.end(), [](const DirectedEdge& s, const DirectedEdge& t) {
        return std::tuple(std::min(s.from, s.to), std::max(s.from, s.to), s.from) <
               std::tuple(std::min(t.from, t.to), std::max(t.from, t.to), t.from);
    });
    return edges;
}

/// @returns the number of edges, each counted once.
int require_manifold(const TileSurface& surface) {
    const std::vector<DirectedEdge> edges = paired_edges(surface);
    // Corners of faces at one point belong to one fan if they share an edge there.
    DisjointSets fans(static_cast<int>(surface.faces.corners.size()));
    for (std::size_t k = 0; k < edges.size(); k += 2) {
        checkpoint_each(static_cast<long>(k));
        const DirectedEdge& edge = edges[k];
        const bool has_reverse =
            k + 1 < edges.size() && edges[k + 1].from == edge.to && edges[k + 1].to == edge.from;
        const bool is_repeated =
            has_reverse && k + 2 < edges.size() &&
            std::minmax(edges[k + 2].from, edges[k + 2].to) == std::minmax(edge.from, edge.to);
        if (!has_reverse || is_repeated) {
            throw_violation(kManifold, "the edge from point " + std::to_string(edge.from) +
                                           " to point " + std::to_string(edge.to) +
                                           " has not two faces in opposite directions");
        }
        fans.unite(edge.corner, edges[k + 1].next);
        fans.unite(edge.next, edges[k + 1].corner);
    }
    std::vector<int> fan_of(surface.points.size(), -1);
    for (std::size_t c = 0; c < surface.faces.corners.size(); ++c) {
        int& fan = fan_of[surface.faces.corners[c]];
        const int found = fans.find(static_cast<int>(c));
        if (fan < 0) fan = found;
        if (fan == found) continue;
        throw_violation(kManifold, "the faces at point " +
                                       std::to_string(surface.faces.corners[c]) +
                                       " are more than one fan");
    }
    return static_cast<int>(edges.size() / 2);
}

/// Whether the corners of `there` are those of `here` plus the translation, traversed backwards.
bool matches(const TileSurface& surface, std::span<const int> here, std::span<const int> there,
             const Vec3& translation, double tolerance) {
    const std::size_t n = here.size();
    if (there.size() != n) return false;
    for (std::size_t start = 0; start < n; ++start) {
        std::size_t k = 0;
        while (k < n &&
               (surface.points[here[k]] + translation - surface.points[there[(start + n - k) % n]])
                       .cwiseAbs()
                       .maxCoeff() <= tolerance) {
            ++k;
        }
        if (k == n) return true;
    }
    return false;
}

void require_pairs(const TileSurface& surface) {
    double largest = 0;
    for (const Vec3& p : surface.points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
    const double tolerance = kPositionUlps * std::numeric_limits<double>::epsilon() * largest;
    for (int f = 0; f < surface.n_faces(); ++f) {
        checkpoint_each(f);
        const int partner = surface.partner[f];
        const Offset offset = surface.offset[f];
        if (partner < 0 || partner >= surface.n_faces() || surface.partner[partner] != f ||
            surface.offset[partner] != -offset || offset == Offset{}) {
            throw_violation(kPairs, "the partner of " + face_name(f) + " has another partner");
        }
        if (matches(surface, surface.faces[f], surface.faces[partner],
                    surface.lattice.translation(offset), tolerance)) {
            continue;
        }
        throw_violation(kPairs, face_name(f) + " plus its translation is not its partner");
    }
}

/// The volume, from the tetrahedra over the triangles of each face and the first point.
double enclosed_volume(const TileSurface& surface) {
    double volume = 0;
    const Vec3& origin = surface.points.front();
    for (int f = 0; f < surface.n_faces(); ++f) {
        const auto corners = surface.faces[f];
        const Vec3 first = surface.points[corners[0]] - origin;
        for (std::size_t k = 2; k < corners.size(); ++k) {
            const Vec3 second = surface.points[corners[k - 1]] - origin;
            volume += first.cross(second).dot(surface.points[corners[k]] - origin) / 6;
        }
    }
    return volume;
}

/// @returns the largest distance of a corner from the plane between its sites, in units of h.
double require_sites(const TileSurface& surface) {
    const auto n = static_cast<int>(surface.sites.cols());
    if (n == 0) return 0;
    const double spacing = portable_cbrt(surface.lattice.volume() / n);
    double largest = 0;
    for (int f = 0; f < surface.n_faces(); ++f) {
        checkpoint_each(f);
        const int behind = surface.cell[f];
        const int front = surface.cell[surface.partner[f]];
        if (behind < 0 || behind >= n || front < 0 || front >= n) {
            throw_violation(kSiteLaw, face_name(f) + " has a cell without a site");
        }
        const Vec3 site = surface.sites.col(behind);
        const Vec3 other =
            Vec3(surface.sites.col(front)) - surface.lattice.translation(surface.offset[f]);
        // A box cuts a cell between two pieces with one site.
        if ((other - site).norm() <= kBisectorTolerance * spacing) continue;
        const Vec3 direction = (other - site).normalized();
        const Vec3 middle = (site + other) / 2;
        for (const int v : surface.faces[f]) {
            const double off = std::abs((surface.points[v] - middle).dot(direction)) / spacing;
            if (off <= kBisectorTolerance) {
                largest = std::max(largest, off);
                continue;
            }
            throw_violation(kSiteLaw, face_name(f) + " is not halfway between two sites, by " +
                                          in_words(off) + " h");
        }
    }
    return largest;
}

int count_parts(const TileSurface& surface) {
    DisjointSets joined(static_cast<int>(surface.points.size()));
    auto n_parts = static_cast<int>(surface.points.size());
    for (int f = 0; f < surface.n_faces(); ++f) {
        for (const int v : surface.faces[f]) {
            if (joined.unite(v, surface.faces[f].front())) --n_parts;
        }
    }
    return n_parts;
}

}  // namespace

SurfaceProof prove_surface(const TileSurface& surface) {
    if (surface.n_faces() == 0) throw_violation(kFaces, "there is no face");
    require_faces(surface);
    const int n_edges = require_manifold(surface);
    require_pairs(surface);
    SurfaceProof proof{.n_points = static_cast<int>(surface.points.size()),
                       .n_faces = surface.n_faces()};
    proof.volume = enclosed_volume(surface);
    const double wanted = surface.lattice.volume();
    if (!(std::abs(proof.volume - wanted) <= kEnclosedError * wanted)) {
        throw_violation("(4), the volume", "the surface encloses " + std::to_string(proof.volume) +
                                               ", not " + std::to_string(wanted));
    }
    proof.from_bisector = require_sites(surface);
    proof.euler = proof.n_points - n_edges + proof.n_faces;
    proof.n_parts = count_parts(surface);
    const std::set<Offset> offsets(surface.offset.begin(), surface.offset.end());
    proof.n_translations = static_cast<int>(offsets.size() / 2);
    return proof;
}

}  // namespace pcvt::space
