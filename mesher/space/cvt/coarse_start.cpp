#include "mesher/space/cvt/coarse_start.hpp"

#include <algorithm>
#include <tuple>
#include <vector>

#include "mesher/base/cancellable_sort.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/portable/portable_functions.hpp"

namespace pcvt::space {
namespace {

/// Random tessellations have 6.9 to 7 edges a site, so that the midpoints suffice.
constexpr LevelGrowth kLevelGrowth{.dimension = 3, .factor = 7.9, .coarsest = 30};

/// An edge of the tetrahedra, from a site to an image of another or of itself.
struct Edge {
    SiteId from;
    SiteId to;
    Offset offset;
    /// Unit of the Gram matrix.
    double squared_length;
};

/// The same edge for both of its directions.
Edge edge_between(const Corner& one, const Corner& other) {
    const Corner first = std::min(one, other);
    const Corner second = std::max(one, other);
    return {first.site, second.site, second.offset - first.offset, 0};
}

auto key(const Edge& edge) { return std::tie(edge.from, edge.to, edge.offset); }

/// Every edge once, from short to long.
std::vector<Edge> edges_of(const PeriodicDelaunay& delaunay) {
    std::vector<Edge> edges;
    for (int t = 0; t < delaunay.tetrahedra.n_tetrahedra(); ++t) {
        checkpoint_each(t);
        const Tetrahedron corners = delaunay.tetrahedra.tetrahedron(t);
        for (int k = 0; k < 4; ++k) {
            for (int m = 0; m < k; ++m) edges.push_back(edge_between(corners[k], corners[m]));
        }
    }
    cancellable_sort(edges.begin(), edges.end(),
                     [](const Edge& e, const Edge& f) { return key(e) < key(f); });
    const auto equal = [](const Edge& e, const Edge& f) { return key(e) == key(f); };
    edges.erase(std::unique(edges.begin(), edges.end(), equal), edges.end());
    const Gram gram = gram_of(delaunay.sites.reduction().reduced);
    const Points& coordinates = delaunay.sites.coordinates();
    for (Edge& e : edges) {
        const Vec3 way = coordinates.col(e.to) + e.offset.vector() - coordinates.col(e.from);
        e.squared_length = gram.squared_length(way.x(), way.y(), way.z());
    }
    cancellable_sort(edges.begin(), edges.end(), [](const Edge& e, const Edge& f) {
        return std::tuple(e.squared_length, key(e)) < std::tuple(f.squared_length, key(f));
    });
    return edges;
}

/// The sites and the midpoints of the shortest edges, n points in all: the faces across long edges
/// are small. Where there are too few edges, the other points are random.
Points with_midpoints(const PeriodicDelaunay& delaunay, int n, std::uint64_t seed) {
    const Sites& sites = delaunay.sites;
    Points points = uniform_points(sites.lattice(), n, seed);
    for (SiteId s = 0; s < sites.n_sites(); ++s) points.col(s) = sites.position(s);
    const Lattice& reduced = sites.reduction().reduced;
    int next = sites.n_sites();
    for (const Edge& e : edges_of(delaunay)) {
        if (next == n) break;
        const Vec3 far = sites.coordinates().col(e.to) + e.offset.vector();
        points.col(next++) = reduced.to_position((sites.coordinates().col(e.from) + far) / 2);
    }
    return points;
}

/// Moves each point by a random fraction of the shake.
void shake(const Lattice& lattice, std::uint64_t seed, Points& points) {
    Shakes shakes(seed);
    const double longest =
        kShake * portable_cbrt(lattice.volume() / static_cast<double>(points.cols()));
    for (double& x : points.reshaped()) x += longest * shakes.next();
}

}  // namespace

Points coarse_start(const Lattice& lattice, int n, std::uint64_t seed, const RunOptions& run) {
    CoarseLevels levels(kLevelGrowth, {.n_orbits = n}, seed, run);
    Points points = uniform_points(lattice, levels.n_coarsest(), seed);
    while (levels.next()) {
        const CvtResult result = compute_cvt(lattice, points, {levels.run()});
        if (levels.cancelled()) return Points(3, 0);
        points = with_midpoints(result.delaunay, levels.n_finer(), levels.seed());
        shake(lattice, levels.seed(), points);
    }
    return points;
}

}  // namespace pcvt::space
