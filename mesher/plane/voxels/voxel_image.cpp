#include "mesher/plane/voxels/voxel_image.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/workers.hpp"
#include "mesher/plane/delaunay/power_distance.hpp"

namespace pcvt::plane {
namespace {

/// Units of a coordinate in a period.
constexpr int kFractionBits = 51;
constexpr std::uint64_t kFractionMask = (std::uint64_t{1} << kFractionBits) - 1;

/// A lattice coordinate as a sum of an integer and a multiple of 2^-51 in [0, 1).
struct FixedPoint {
    std::int64_t whole = 0;
    std::uint64_t fraction = 0;

    static FixedPoint rounded(double u) {
        const double floor = std::floor(u);
        const Wrapped rest = wrap(u - floor);
        return {static_cast<std::int64_t>(floor) + rest.whole,
                static_cast<std::uint64_t>(std::ldexp(rest.fraction, kFractionBits))};
    }
    double fraction_value() const {
        return std::ldexp(static_cast<double>(fraction), -kFractionBits);
    }
    friend FixedPoint operator+(FixedPoint s, FixedPoint t) {
        const std::uint64_t sum = s.fraction + t.fraction;
        return {s.whole + t.whole + static_cast<std::int64_t>(sum >> kFractionBits),
                sum & kFractionMask};
    }
};

/// m u + n v, exactly. @pre |m|, |n|, |u|, |v| < 2^21.
FixedPoint combination(int m, FixedPoint u, int n, FixedPoint v) {
    // Unsigned products wrap at 2^64, of which 2^51 is a divisor.
    const std::uint64_t fraction = (static_cast<std::uint64_t>(std::int64_t{m}) * u.fraction +
                                    static_cast<std::uint64_t>(std::int64_t{n}) * v.fraction) &
                                   kFractionMask;
    const FixedPoint only_fraction{0, fraction};
    // An integer up to a rounding of 2^-30.
    const double carry = m * u.fraction_value() + n * v.fraction_value();
    const std::int64_t whole =
        m * u.whole + n * v.whole + std::llround(carry - only_fraction.fraction_value());
    return {whole, fraction};
}

/// The two coordinates of a point in one basis.
struct FixedPair {
    FixedPoint u;
    FixedPoint v;
    friend FixedPair operator+(const FixedPair& s, const FixedPair& t) {
        return {s.u + t.u, s.v + t.v};
    }
};

/// times (2 k + 1) / (2 n)
FixedPoint half_step(std::int64_t times, int k, int n) {
    const std::int64_t numerator = times * (2 * std::int64_t{k} + 1);
    const std::int64_t denominator = 2 * std::int64_t{n};
    std::int64_t whole = numerator / denominator;
    if (whole * denominator > numerator) --whole;
    const double rest = static_cast<double>(numerator - whole * denominator);
    return FixedPoint{whole, 0} + FixedPoint::rounded(rest / static_cast<double>(denominator));
}

/// The centres of voxels as points that predicates take.
class VoxelCentres {
   public:
    VoxelCentres(const Sites& sites, const Metric& metric, const VoxelGrid& grid)
        : m_(sites.reduction().m), determinant_(m_[0] * m_[3] - m_[1] * m_[2]) {
        const Lattice& lattice = sites.lattice();
        const auto coordinates = [&](const Vec2& p) {
            return lattice.to_lattice(metric.to_round(p));
        };
        const Vec2 corner = coordinates(grid.corner);
        corner_ = {FixedPoint::rounded(corner.x()), FixedPoint::rounded(corner.y())};
        fill(coordinates({grid.size.x(), 0}), grid.counts.x, columns_);
        fill(coordinates({0, grid.size.y()}), grid.counts.y, rows_);
    }

    /// The centre of voxel (k, l), in coordinates of the reduced basis.
    Image operator()(int k, int l) const {
        const FixedPair at = corner_ + columns_[k] + rows_[l];
        const FixedPoint u = combination(determinant_ * m_[3], at.u, -determinant_ * m_[2], at.v);
        const FixedPoint v = combination(-determinant_ * m_[1], at.u, determinant_ * m_[0], at.v);
        return {.u = u.fraction_value(),
                .v = v.fraction_value(),
                .site = -1,
                .offset = {static_cast<int>(u.whole), static_cast<int>(v.whole)}};
    }

   private:
    /// @param period  a lattice vector, its coordinates up to rounding.
    static void fill(const Vec2& period, int n, std::vector<FixedPair>& steps) {
        const std::int64_t i = std::llround(period.x());
        const std::int64_t j = std::llround(period.y());
        for (int k = 0; k < n; ++k) {
            checkpoint_each(k);
            steps.push_back({half_step(i, k, n), half_step(j, k, n)});
        }
    }

    std::array<int, 4> m_;
    int determinant_;
    FixedPair corner_;
    std::vector<FixedPair> columns_;
    std::vector<FixedPair> rows_;
};

/// Finds the nearest sites of points by steps between neighbours.
class NearestSites {
   public:
    explicit NearestSites(const PeriodicDelaunay& delaunay)
        : delaunay_(delaunay),
          triangulation_(delaunay.triangulation()),
          first_halfedge_(static_cast<std::size_t>(triangulation_.n_sites())) {
        for (int h = 0; h < triangulation_.n_halfedges(); ++h) {
            checkpoint_each(h);
            first_halfedge_[triangulation_.corner(h).site] = h;
        }
        const double unit = gram_unit(delaunay.sites().reduction().reduced);
        weight_ = delaunay.weights() / (unit * unit);
    }

    /// Moves `at` to an image that is nearest to p. Returns whether a neighbour is as near.
    bool walk(const Image& p, Corner& at) const {
        for (;;) {
            bool tied = false;
            std::optional<Corner> nearer;
            for_neighbours(at, [&](const Corner& other) {
                const int comparison = compare(p, other, at);
                if (comparison < 0) nearer = other;
                tied = tied || comparison == 0;
                return comparison < 0;
            });
            if (!nearer) return tied;
            at = *nearer;
        }
    }

    /// The smallest id of all sites that are as near to p as the nearest image `at`.
    SiteId smallest_id(const Image& p, const Corner& at) const {
        // Points of the circle round p: a polygon without points inside, which the triangulation
        // cuts into triangles.
        std::vector<Corner> tied{at};
        SiteId smallest = at.site;
        for (std::size_t k = 0; k < tied.size(); ++k) {
            const Corner from = tied[k];  // A reference would not survive the next push_back().
            for_neighbours(from, [&](const Corner& other) {
                if (compare(p, other, at) != 0 || contains(tied, other)) return false;
                tied.push_back(other);
                smallest = std::min(smallest, other.site);
                return false;
            });
        }
        return smallest;
    }

   private:
    static bool contains(const std::vector<Corner>& corners, const Corner& corner) {
        return std::any_of(corners.begin(), corners.end(), [&](const Corner& c) {
            return c.site == corner.site && c.offset == corner.offset;
        });
    }

    int compare(const Image& p, const Corner& q, const Corner& r) const {
        return compare_power_distances(delaunay_.gram(), p, weighted(q), weighted(r));
    }

    WeightedImage weighted(const Corner& corner) const {
        return {image(delaunay_.sites(), corner.site, corner.offset),
                weight_.size() == 0 ? 0 : weight_[corner.site]};
    }

    /// Calls visit(neighbour) for each neighbour of a site, until it returns true.
    template <class Visit>
    void for_neighbours(const Corner& at, const Visit& visit) const {
        const int first = first_halfedge_[at.site];
        int h = first;
        do {
            const Offset offset = at.offset + triangulation_.edge_offset(h);
            if (visit({triangulation_.corner(TorusTriangulation::next(h)).site, offset})) return;
            h = triangulation_.next_round_site(h);
        } while (h != first);
    }

    const PeriodicDelaunay& delaunay_;
    const TorusTriangulation& triangulation_;
    std::vector<int> first_halfedge_;
    Eigen::VectorXd weight_;
};

/// Lines of voxels that one task labels.
constexpr int kLinesPerTask = 16;

}  // namespace

VoxelImage voxel_image(const PeriodicDelaunay& delaunay, const Metric& metric,
                       const VoxelGrid& grid, int n_threads) {
    const VoxelCentres centres(delaunay.sites(), metric, grid);
    const NearestSites nearest(delaunay);
    VoxelImage image{grid, std::vector<SiteId>(grid.n_voxels())};
    // Lines run along the direction with more voxels, so that the walk from the first voxel of a
    // line to that of the next one is short.
    const bool along_x = grid.counts.x >= grid.counts.y;
    const int n_lines = along_x ? grid.counts.y : grid.counts.x;
    const int length = along_x ? grid.counts.x : grid.counts.y;
    Workers workers(n_threads);
    workers.for_each((n_lines + kLinesPerTask - 1) / kLinesPerTask, [&](int task) {
        const int begin = task * kLinesPerTask;
        Corner line_start{0, centres(along_x ? 0 : begin, along_x ? begin : 0).offset};
        for (int line = begin; line < std::min(begin + kLinesPerTask, n_lines); ++line) {
            Corner at = line_start;
            for (int step = 0; step < length; ++step) {
                checkpoint_each(step);
                const int k = along_x ? step : line;
                const int l = along_x ? line : step;
                const Image p = centres(k, l);
                const bool tied = nearest.walk(p, at);
                if (step == 0) line_start = at;
                image.site[static_cast<std::size_t>(l) * grid.counts.x + k] =
                    tied ? nearest.smallest_id(p, at) : at.site;
            }
        }
    });
    return image;
}

}  // namespace pcvt::plane
