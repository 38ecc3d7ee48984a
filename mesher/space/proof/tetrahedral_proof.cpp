#include "mesher/space/proof/tetrahedral_proof.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "mesher/base/disjoint_sets.hpp"
#include "mesher/base/law_violation.hpp"

namespace pcvt::space {
namespace {

/// Positions of partners may differ by this many double ulps of the largest coordinate.
constexpr double kUlps = 4;
/// The volumes may sum to another one than that of the domain by this part of it: rounding.
constexpr double kVolumeError = 1e-9;

std::string tetrahedron_in_words(int t) { return "tetrahedron " + std::to_string(t); }

double longest_edge(const TetrahedralMesh& mesh, int t) {
    double square = 0;
    const std::array<int, 4>& v = mesh.tetrahedra[t];
    for (std::size_t k = 0; k < 4; ++k) {
        for (std::size_t l = 0; l < k; ++l) {
            square = std::max(square, (mesh.points[v[k]] - mesh.points[v[l]]).squaredNorm());
        }
    }
    return std::sqrt(square);
}

/// The volume that a tetrahedron must exceed.
double least_volume(double longest, double mean_cell) {
    return kFlatTetrahedron * std::min(mean_cell, longest * longest * longest);
}

double largest_coordinate(const TetrahedralMesh& mesh) {
    double largest = 0;
    for (const Vec3& p : mesh.points) largest = std::max(largest, p.lpNorm<Eigen::Infinity>());
    return largest;
}

/// Images of sites, sorted, of which the first has the offset 0: the same for all translations.
template <std::size_t n>
std::array<Corner, n> orbit(const TetrahedralMesh& mesh, std::array<int, n> points) {
    std::array<Corner, n> corners;
    std::transform(points.begin(), points.end(), corners.begin(),
                   [&](int v) { return mesh.corner(v); });
    std::sort(corners.begin(), corners.end());
    const Offset base = corners.front().offset;
    for (Corner& corner : corners) corner.offset = corner.offset - base;
    return corners;
}

/// The tolerance of positions.
double tolerance_of(const TetrahedralMesh& mesh, double least) {
    return std::max(kUlps * std::numeric_limits<double>::epsilon() * largest_coordinate(mesh),
                    least);
}

/// Requires that no point is farther from its image than the tolerance.
/// @param worst  the point that is farthest.
void require_images(const TetrahedralProof& proof, int worst) {
    if (proof.mismatch <= proof.tolerance) return;
    throw SeamMismatch(
        violation_in_words("(2), points", "point " + std::to_string(worst) + " is off by " +
                                              in_words(proof.mismatch)),
        proof.mismatch);
}

void prove_points(const TetrahedralMesh& mesh, TetrahedralProof& proof) {
    int worst = 0;
    std::map<SiteId, int> first;
    std::set<Corner> images;
    for (int v = 0; v < mesh.n_points(); ++v) {
        const int w = first.emplace(mesh.point_site[v], v).first->second;
        const Vec3 expected = mesh.points[w] + mesh.lattice.translation(mesh.point_offset[v]);
        const double off = (mesh.points[v] - expected).lpNorm<Eigen::Infinity>();
        if (!std::isfinite(off)) {
            throw_violation("(2), points", "point " + std::to_string(v) + " is not finite");
        }
        if (off > proof.mismatch) {
            proof.mismatch = off;
            worst = v;
        }
        if (!images.insert({mesh.point_site[v], mesh.point_offset[v]}).second) {
            throw_violation("(2), points", "point " + std::to_string(v) + " occurs twice");
        }
    }
    require_images(proof, worst);
    proof.n_sites = static_cast<int>(first.size());
    if (first.empty() || first.begin()->first != 0 || first.rbegin()->first != proof.n_sites - 1) {
        throw_violation("(2), points", "the sites are not 0 ... n - 1");
    }
}

void prove_volumes(const TetrahedralMesh& mesh, TetrahedralProof& proof) {
    const double domain = mesh.lattice.volume();
    proof.smallest_volume = domain;
    for (int t = 0; t < mesh.n_tetrahedra(); ++t) {
        const double volume = tetrahedron_volume(mesh, t);
        if (!(volume > least_volume(longest_edge(mesh, t), domain / proof.n_sites))) {
            throw_violation("(1), volumes", tetrahedron_in_words(t) +
                                                " is flat or turned over, its volume is " +
                                                in_words(volume));
        }
        proof.volume += volume;
        proof.smallest_volume = std::min(proof.smallest_volume, volume);
    }
    if (!(std::abs(proof.volume - domain) <= kVolumeError * domain)) {
        throw_violation("(4), volumes",
                        "they sum to " + in_words(proof.volume) + ", not to " + in_words(domain));
    }
}

/// A triangle of a tetrahedron, counter-clockwise seen from outside of it.
struct Side {
    int tetrahedron;
    std::array<int, 3> points;
};

/// The points of the triangle in the order of their images, and whether that order is an even
/// permutation of the triangle.
struct SortedSide {
    std::array<int, 3> points;
    bool even;
};

SortedSide sorted(const TetrahedralMesh& mesh, std::array<int, 3> points) {
    bool even = true;
    const auto order = [&](int k, int l) {
        if (!(mesh.corner(points[l]) < mesh.corner(points[k]))) return;
        std::swap(points[k], points[l]);
        even = !even;
    };
    order(0, 1);
    order(1, 2);
    order(0, 1);
    return {points, even};
}

/// The translation from one triangle to another, which have the same orbit.
Offset translation_between(const TetrahedralMesh& mesh, const SortedSide& from,
                           const SortedSide& to) {
    return mesh.point_offset[to.points.front()] - mesh.point_offset[from.points.front()];
}

/// Appends the pair with the points of the first triangle in its own order.
void append_pair(const TetrahedralMesh& mesh, const std::array<int, 3>& first,
                 const SortedSide& from, const SortedSide& to, TetrahedralProof& proof) {
    TrianglePair pair{.first = first, .second = {}, .offset = translation_between(mesh, from, to)};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto place = std::find(from.points.begin(), from.points.end(), first[k]);
        pair.second[k] = to.points[static_cast<std::size_t>(place - from.points.begin())];
    }
    proof.pairs.push_back(pair);
}

void prove_sides(const TetrahedralMesh& mesh, TetrahedralProof& proof) {
    // The sides of all tetrahedra by their orbits.
    std::map<std::array<Corner, 3>, std::vector<Side>> triangles;
    for (int t = 0; t < mesh.n_tetrahedra(); ++t) {
        for (const auto& [i, j, k] : TorusTetrahedra::kFacetCorners) {
            const std::array<int, 4>& v = mesh.tetrahedra[t];
            const std::array<int, 3> outside{v[i], v[k], v[j]};
            triangles[orbit(mesh, outside)].push_back({t, outside});
        }
    }
    // Two sides of each orbit are one triangle, or a pair of the seam.
    DisjointSets parts(mesh.n_tetrahedra());
    for (const auto& [images, sides] : triangles) {
        const Side& side = sides.front();
        if (sides.size() != 2) {
            throw_violation("(3), seam", "a triangle of " + tetrahedron_in_words(side.tetrahedron) +
                                             " has " + std::to_string(sides.size() - 1) +
                                             " partners");
        }
        const SortedSide one = sorted(mesh, side.points);
        const SortedSide other = sorted(mesh, sides[1].points);
        if (one.even == other.even) {
            throw_violation("(3), seam", tetrahedron_in_words(side.tetrahedron) + " and " +
                                             tetrahedron_in_words(sides[1].tetrahedron) +
                                             " lie on the same side of a triangle");
        }
        const Offset offset = translation_between(mesh, one, other);
        if (offset == Offset{}) {
            parts.unite(side.tetrahedron, sides[1].tetrahedron);
        } else if (offset > Offset{}) {
            append_pair(mesh, side.points, one, other, proof);
        } else {
            append_pair(mesh, sides[1].points, other, one, proof);
        }
    }
    for (int t = 1; t < mesh.n_tetrahedra(); ++t) {
        if (parts.find(t) == 0) continue;
        throw_violation("(5), connection", tetrahedron_in_words(t) + " is not joined to the first");
    }
    proof.n_triangles = static_cast<int>(triangles.size());
}

void prove_euler_number(const TetrahedralMesh& mesh, TetrahedralProof& proof) {
    std::set<std::array<Corner, 2>> edges;
    for (const std::array<int, 4>& v : mesh.tetrahedra) {
        for (std::size_t k = 0; k < 4; ++k) {
            for (std::size_t l = 0; l < k; ++l) {
                edges.insert(orbit<2>(mesh, {v[k], v[l]}));
            }
        }
    }
    proof.n_edges = static_cast<int>(edges.size());
    const int euler = proof.n_sites - proof.n_edges + proof.n_triangles - mesh.n_tetrahedra();
    if (euler != 0) {
        throw_violation("(4), gluing", "the Euler number is " + std::to_string(euler) + ", not 0");
    }
}

}  // namespace

double tetrahedron_volume(const TetrahedralMesh& mesh, int t) {
    const auto& [a, b, c, d] = mesh.tetrahedra[t];
    const Vec3& p = mesh.points[a];
    const Vec3 n = (mesh.points[b] - p).cross(mesh.points[c] - p);
    const Vec3 arm = mesh.points[d] - p;
    // Files state volumes, and Eigen's dot() adds in another order on other platforms.
    return (n.x() * arm.x() + n.y() * arm.y() + n.z() * arm.z()) / 6;
}

std::vector<int> flat_tetrahedra(const TetrahedralMesh& mesh, int n_sites) {
    const double mean_cell = mesh.lattice.volume() / n_sites;
    const double rounding =
        kUlps * std::numeric_limits<double>::epsilon() * largest_coordinate(mesh);
    std::vector<int> flat;
    for (int t = 0; t < mesh.n_tetrahedra(); ++t) {
        const double longest = longest_edge(mesh, t);
        const double least = least_volume(longest, mean_cell);
        const double volume = tetrahedron_volume(mesh, t);
        const double turned = std::max(least, rounding * longest * longest);
        if (volume <= least && volume >= -turned) flat.push_back(t);
    }
    return flat;
}

int n_untied_points(const TetrahedralMesh& mesh, const TetrahedralProof& proof) {
    std::vector<bool> is_slave(mesh.points.size(), false);
    for (const TrianglePair& pair : proof.pairs) {
        for (const int v : pair.second) is_slave[v] = true;
    }
    const auto n_free = std::count(is_slave.begin(), is_slave.end(), false);
    return static_cast<int>(n_free) - proof.n_sites;
}

TetrahedralProof prove_tetrahedra(const TetrahedralMesh& mesh, double least_tolerance) {
    TetrahedralProof proof{.tolerance = tolerance_of(mesh, least_tolerance)};
    prove_points(mesh, proof);
    prove_volumes(mesh, proof);
    prove_sides(mesh, proof);
    prove_euler_number(mesh, proof);
    return proof;
}

std::string flat_in_words(const TetrahedralMesh& mesh, const std::vector<int>& flat) {
    std::string sites;
    for (const int v : mesh.tetrahedra[flat.front()]) {
        sites += (sites.empty() ? "" : ", ") + std::to_string(mesh.point_site[v]);
    }
    const std::string number = flat.size() == 1
                                   ? "one tetrahedron of these sites is flat, that of sites "
                                   : std::to_string(flat.size()) +
                                         " tetrahedra of these sites are flat, the first that of "
                                         "sites ";
    return number + sites +
           ", which lie in one plane up to rounding, as where more than four sites lie on a sphere";
}

}  // namespace pcvt::space
