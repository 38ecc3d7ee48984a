#include "mesher/space/delaunay/orbit_insertion.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <span>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "mesher/space/delaunay/growing_orbits.hpp"
#include "mesher/space/delaunay/mirror_diagram.hpp"
#include "mesher/space/geometry/insertion_order.hpp"

namespace pcvt::space {
namespace {

/// The random sites that mirrors triangulate first, and how many more where their spheres extend
/// too far.
constexpr int kFirstSites = 32;
constexpr int kMoreSites = 4;
constexpr int kMostFirstSites = 2048;
/// Numbers of sites at which the growth of the number of tetrahedra is measured.
constexpr int kFewMeasured = 96;
constexpr int kManyMeasured = 384;

/// Moves the coordinates along each axis so that their widest gap lies at the end of the period,
/// and stretches them to the period: so that the curve on which sites are sorted resolves a
/// cluster.
Points stretched(const Points& coordinates) {
    Points stretched(3, coordinates.cols());
    std::vector<double> sorted(static_cast<std::size_t>(coordinates.cols()));
    for (int axis = 0; axis < 3; ++axis) {
        std::copy(coordinates.row(axis).begin(), coordinates.row(axis).end(), sorted.begin());
        std::sort(sorted.begin(), sorted.end());
        double begin = sorted.front();
        double widest = sorted.front() + 1 - sorted.back();
        for (std::size_t k = 1; k < sorted.size(); ++k) {
            checkpoint_each(static_cast<long>(k), 1 << 14);
            const double gap = sorted[k] - sorted[k - 1];
            if (!(gap > widest)) continue;
            widest = gap;
            begin = sorted[k];
        }
        // A little more, so that rounding leaves the last one in the period.
        const double length = std::max((1 - widest) * (1 + 1e-9), 1e-15);
        for (Eigen::Index s = 0; s < coordinates.cols(); ++s) {
            const double u = coordinates(axis, s) - begin;
            stretched(axis, s) = std::clamp((u < 0 ? u + 1 : u) / length, 0.0, 1 - 1e-12);
        }
    }
    return stretched;
}

/// Draws k of n sites, the same ones each time.
std::vector<SiteId> random_sites(int n, int k) {
    std::vector<SiteId> sites(static_cast<std::size_t>(n));
    std::iota(sites.begin(), sites.end(), 0);
    std::mt19937_64 random(0);
    for (int m = 0; m < k; ++m) {
        std::swap(sites[m], sites[m + int(random() % std::uint64_t(n - m))]);
    }
    sites.resize(static_cast<std::size_t>(k));
    return sites;
}

/// Whether every sphere is small enough for GrowingOrbits.
bool have_exact_spheres(const Sites& sites, const Gram& gram,
                        const std::vector<Tetrahedron>& tetrahedra) {
    const Lattice& reduced = sites.reduction().reduced;
    const double unit = reduced.a().norm() / std::sqrt(gram.aa);
    const double most = GrowingOrbits::kLargestExtent * reduced.heights().minCoeff() / (2 * unit);
    return std::all_of(tetrahedra.begin(), tetrahedra.end(), [&](const Tetrahedron& t) {
        const auto at = [&](int k) { return image(sites.coordinates(), t[k]).at; };
        const Vec3 c = exact_circumcentre(gram, {at(1) - at(0), at(2) - at(0), at(3) - at(0)});
        return std::sqrt(gram.squared_length(c.x(), c.y(), c.z())) < most;
    });
}

/// Tetrahedra of the first sites of an order; nullopt if their spheres are too large.
std::optional<TorusTetrahedra> first_tetrahedra(const Sites& sites, const Gram& gram,
                                                const std::vector<SiteId>& order) {
    const int most = std::min(static_cast<int>(order.size()), kMostFirstSites);
    for (int n = kFirstSites; n <= most; n *= kMoreSites) {
        const Sites first = some_of(sites, std::span(order).first(std::size_t(n)));
        const std::vector<Tetrahedron> tetrahedra = mirror_diagram(first).tetrahedra;
        if (have_exact_spheres(first, gram, tetrahedra)) return TorusTetrahedra(n, tetrahedra);
    }
    return std::nullopt;
}

}  // namespace

std::optional<TorusTetrahedra> orbit_tetrahedra(const Sites& sites) {
    const int n = sites.n_sites();
    if (n < kFewestForOrbits) return std::nullopt;
    const Gram gram = gram_of(sites.reduction().reduced);
    const std::vector<SiteId> order = insertion_order(stretched(sites.coordinates()), {});
    const std::optional<TorusTetrahedra> first = first_tetrahedra(sites, gram, order);
    if (!first) return std::nullopt;
    const Sites ordered = some_of(sites, order);
    GrowingOrbits growing(gram, ordered.coordinates(), *first);
    for (SiteId s = first->n_sites(); s < n; ++s) {
        checkpoint_each(s, 16);
        if (!growing.insert(s)) throw InternalError("two sites coincide");
    }
    std::vector<Tetrahedron> tetrahedra = growing.tetrahedra();
    for (Tetrahedron& t : tetrahedra) {
        for (Corner& corner : t) corner.site = order[corner.site];
    }
    put_in_canonical_order(n, tetrahedra);
    return TorusTetrahedra(n, tetrahedra);
}

double expected_tetrahedra(const Sites& sites) {
    const double n = sites.n_sites();
    if (n <= kManyMeasured) return kTetrahedraPerSite * n;
    const Gram gram = gram_of(sites.reduction().reduced);
    const std::vector<SiteId> order = random_sites(sites.n_sites(), kManyMeasured);
    const std::optional<TorusTetrahedra> first = first_tetrahedra(sites, gram, order);
    if (!first || first->n_sites() > kFewMeasured) return kTetrahedraPerSite * n;
    const Sites some = some_of(sites, order);
    GrowingOrbits growing(gram, some.coordinates(), *first);
    double few = 0;
    for (SiteId s = first->n_sites(); s < kManyMeasured; ++s) {
        checkpoint();
        growing.insert(s);
        if (s + 1 == kFewMeasured) few = growing.n_tetrahedra();
    }
    const double many = growing.n_tetrahedra();
    const double power =
        std::log(many / few) / std::log(double(kManyMeasured) / double(kFewMeasured));
    return many * std::pow(n / kManyMeasured, std::clamp(power, 1.0, 2.0));
}

}  // namespace pcvt::space
