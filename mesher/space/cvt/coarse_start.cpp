#include "mesher/space/cvt/coarse_start.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <tuple>
#include <vector>

#include "mesher/base/cancellable_sort.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/optimize/level_share.hpp"
#include "mesher/portable/portable_functions.hpp"

namespace pcvt::space {
namespace {

/// By how much the number of sites grows from one level to the next. Random tessellations have
/// 6.9 to 7 edges a site, so that the midpoints suffice.
constexpr double kGrowth = 7.9;
/// Problems with at most this number of sites are not coarsened further.
constexpr int kCoarsest = 30;
/// The RMS residual at which a coarser problem is left for the next one.
constexpr double kRmsTolerance = 1e-4;
/// The longest random move of a coordinate between two levels, in units of h of the finer one.
constexpr double kShake = 0.25;

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
    std::mt19937_64 generator(seed);
    const auto uniform = [&generator] { return std::ldexp(double(generator() >> 11), -52) - 1; };
    const double longest =
        kShake * portable_cbrt(lattice.volume() / static_cast<double>(points.cols()));
    for (double& x : points.reshaped()) x += longest * uniform();
}

/// The numbers of sites of all levels, the finest first.
std::vector<int> levels(int n) {
    std::vector<int> sites{n};
    while (sites.back() > kCoarsest) {
        sites.push_back(static_cast<int>(std::ceil(sites.back() / kGrowth)));
    }
    return sites;
}

}  // namespace

Points coarse_start(const Lattice& lattice, int n, const CoarseStartOptions& options) {
    std::vector<int> sites = levels(n);
    const double n_all = std::accumulate(sites.begin() + 1, sites.end(), 0.0);
    LevelShare done(sites.back(), n_all, kRmsTolerance);
    bool cancelled = false;
    Points points = uniform_points(lattice, sites.back(), options.seed);
    for (; sites.size() > 1; sites.pop_back()) {
        const int n_finer = sites[sites.size() - 2];
        // F is in proportion to n^(-2/3).
        const double length = portable_cbrt(double(sites.back()) / n);
        const double scale = length * length;
        CvtOptions level;
        level.run.tolerance = 0;
        level.run.n_threads = options.n_threads;
        level.run.progress = [&](Progress progress) {
            progress.value *= scale;
            progress.share = done.at(progress.rms_residual);
            cancelled = options.progress && !options.progress(progress);
            return !cancelled && progress.rms_residual > kRmsTolerance;
        };
        const CvtResult result = compute_cvt(lattice, points, level);
        if (cancelled) return Points(3, 0);
        const std::uint64_t seed = options.seed + static_cast<std::uint64_t>(n_finer);
        points = with_midpoints(result.delaunay, n_finer, seed);
        shake(lattice, seed, points);
        done.next_level(n_finer);
    }
    return points;
}

}  // namespace pcvt::space
