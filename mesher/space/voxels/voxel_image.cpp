#include "mesher/space/voxels/voxel_image.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/workers.hpp"
#include "mesher/space/delaunay/power_distance.hpp"

namespace pcvt::space {
namespace {

constexpr int kFractionBits = 50;
constexpr std::int64_t kFractionMask = (std::int64_t{1} << kFractionBits) - 1;

/// A point modulo the lattice: multiples of 2^-50 in coordinates of the reduced basis.
using Fractions = std::array<std::int64_t, 3>;

Fractions operator+(const Fractions& s, const Fractions& t) {
    return {(s[0] + t[0]) & kFractionMask, (s[1] + t[1]) & kFractionMask,
            (s[2] + t[2]) & kFractionMask};
}

Vec3 coordinates_of(const Fractions& f) {
    return Vec3(double(f[0]), double(f[1]), double(f[2])) / kGrid;
}

/// @param u  at least 0, and less than 2^13.
std::int64_t fraction_of(double u) { return std::llround(u * kGrid) & kFractionMask; }

/// The centres of voxels, modulo the lattice.
class CentresOfVoxels {
   public:
    CentresOfVoxels(const Sites& sites, const Metric& metric, const VoxelGrid& grid) {
        const Lattice& reduced = sites.reduction().reduced;
        const Vec3 corner = wrap(reduced.to_lattice(metric.to_round(grid.corner))).fraction;
        for (int d = 0; d < 3; ++d) corner_[d] = fraction_of(corner[d]);
        const std::array<int, 3> counts{grid.counts.x, grid.counts.y, grid.counts.z};
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 period = Vec3::Zero();
            period[axis] = grid.size[axis];
            // A lattice vector: its coordinates are integers up to rounding.
            whole_[axis] = reduced.to_lattice(metric.to_round(period)).array().round();
            fill(whole_[axis], counts[axis], steps_[axis]);
        }
    }

    Fractions row(int l, int m) const { return corner_ + steps_[1][l] + steps_[2][m]; }
    Vec3 in_row(const Fractions& row, int k) const { return coordinates_of(row + steps_[0][k]); }
    /// The period along x, in coordinates of the reduced basis.
    const Vec3& period_along_x() const { return whole_[0]; }

   private:
    /// The coordinates of (2 k + 1) / (2 n) times a lattice vector.
    static void fill(const Vec3& whole, int n, std::vector<Fractions>& steps) {
        const std::int64_t halves = 2 * std::int64_t{n};
        for (int k = 0; k < n; ++k) {
            checkpoint_each(k);
            Fractions step;
            for (int d = 0; d < 3; ++d) {
                const std::int64_t times = std::llround(whole[d]) * (2 * std::int64_t{k} + 1);
                const std::int64_t rest = ((times % halves) + halves) % halves;
                step[d] = fraction_of(static_cast<double>(rest) / static_cast<double>(halves));
            }
            steps.push_back(step);
        }
    }

    Fractions corner_;
    std::array<Vec3, 3> whole_;
    std::array<std::vector<Fractions>, 3> steps_;
};

/// A neighbour of a site in the triangulation.
struct VoxelNeighbour {
    /// From the site to the neighbour, in the unit of the Gram matrix.
    Vec3 to;
    /// A point p is nearer to the neighbour where (p - x) . to > half.
    double half;
    /// The product of `to` with one step along a row.
    double ahead;
    Corner corner;
};

/// The cells of a diagram as the half spaces of their neighbours.
class CellsOfSites {
   public:
    CellsOfSites(const PeriodicDelaunay& delaunay, const Eigen::VectorXd& weights, const Vec3& step)
        : coordinates_(delaunay.sites.coordinates()),
          gram_(gram_of(delaunay.sites.reduction().reduced)),
          weights_(Eigen::VectorXd::Zero(delaunay.sites.n_sites())) {
        const Lattice& reduced = delaunay.sites.reduction().reduced;
        int exponent = 0;
        std::frexp(reduced.a().norm(), &exponent);
        const double unit = std::ldexp(1.0, exponent);
        double reach = 0;
        for (int d = 0; d < 3; ++d) {
            basis_.col(d) = reduced.periods()[d] / unit;
            reach += basis_.col(d).norm();
        }
        if (weights.size() > 0) {
            weights_ = (weights / (unit * unit)).unaryExpr([](double w) {
                return std::nearbyint(w * 0x1p100) * 0x1p-100;
            });
        }
        // Roundings of products of two vectors that are at most twice as long as `reach`: of the
        // basis, of the Gram matrix, of the centres and of sums.
        rounding_ = 0x1p-44 * reach * reach + 0x1p-50 * weights_.cwiseAbs().maxCoeff();
        add_neighbours(delaunay.tetrahedra, basis_ * step);
    }

    /// Moves to the site whose image is nearest to p: the one with the smallest id if there are
    /// several.
    /// @param site  where the walk begins; becomes the site.
    /// @returns the number of steps ahead that certainly stay in its cell.
    double settle(const Vec3& p, SiteId& site) const {
        Corner at = near(p, site);
        for (;;) {
            const Vec3 from_site = basis_ * (p - position(at));
            double inside = std::numeric_limits<double>::infinity();
            // The nearest plane ahead is `to_plane` / `ahead` steps away.
            double to_plane = std::numeric_limits<double>::infinity();
            double ahead = 1;
            const VoxelNeighbour* nearer = nullptr;
            for (const VoxelNeighbour& neighbour : neighbours(at.site)) {
                const double margin = neighbour.half - from_site.dot(neighbour.to);
                if (margin < inside) {
                    inside = margin;
                    nearer = &neighbour;
                }
                if (neighbour.ahead > 0 && margin * ahead < to_plane * neighbour.ahead) {
                    to_plane = margin;
                    ahead = neighbour.ahead;
                }
            }
            site = at.site;
            if (inside > rounding_) return (to_plane - rounding_) / ahead;
            if (inside < -rounding_) {
                at = beside(at, *nearer);
                continue;
            }
            if (!step_exactly(p, at)) {
                site = smallest_id(p, at);
                return 0;
            }
        }
    }

   private:
    Vec3 position(const Corner& at) const { return coordinates_.col(at.site) + at.offset.vector(); }
    /// An image of a site that is near to p.
    Corner near(const Vec3& p, SiteId site) const {
        const Vec3 whole = (p - Vec3(coordinates_.col(site))).array().round();
        return {site, {int(whole.x()), int(whole.y()), int(whole.z())}};
    }
    static Corner beside(const Corner& at, const VoxelNeighbour& neighbour) {
        return {neighbour.corner.site, at.offset + neighbour.corner.offset};
    }
    std::span<const VoxelNeighbour> neighbours(SiteId site) const {
        return {neighbours_.data() + begin_[site], neighbours_.data() + begin_[site + 1]};
    }

    int compare(const Vec3& p, const Corner& s, const Corner& t) const {
        return compare_power_distances(gram_, {position(s) - p, weights_[s.site]},
                                       {position(t) - p, weights_[t.site]});
    }

    /// Moves to a neighbour that is nearer to p. Returns false if there is none.
    bool step_exactly(const Vec3& p, Corner& at) const {
        for (const VoxelNeighbour& neighbour : neighbours(at.site)) {
            const Corner other = beside(at, neighbour);
            if (compare(p, other, at) >= 0) continue;
            at = other;
            return true;
        }
        return false;
    }

    /// The smallest id of all sites that are as near to p as the nearest image `at`.
    SiteId smallest_id(const Vec3& p, const Corner& at) const {
        // Images on a sphere round p: a polyhedron without sites inside, which the triangulation
        // cuts into tetrahedra.
        std::vector<Corner> tied{at};
        SiteId smallest = at.site;
        for (std::size_t k = 0; k < tied.size(); ++k) {
            const Corner from = tied[k];  // A reference would not survive the next push_back().
            for (const VoxelNeighbour& neighbour : neighbours(from.site)) {
                const Corner other = beside(from, neighbour);
                if (compare(p, other, at) != 0) continue;
                if (std::find(tied.begin(), tied.end(), other) != tied.end()) continue;
                tied.push_back(other);
                smallest = std::min(smallest, other.site);
            }
        }
        return smallest;
    }

    void add_neighbours(const TorusTetrahedra& tetrahedra, const Vec3& step) {
        std::vector<std::vector<Corner>> of_site(static_cast<std::size_t>(coordinates_.cols()));
        for (int t = 0; t < tetrahedra.n_tetrahedra(); ++t) {
            checkpoint_each(t);
            const Tetrahedron corners = tetrahedra.tetrahedron(t);
            for (const Corner& from : corners) {
                for (const Corner& to : corners) {
                    const Corner seen{to.site, to.offset - from.offset};
                    std::vector<Corner>& list = of_site[from.site];
                    if (&from == &to || std::find(list.begin(), list.end(), seen) != list.end()) {
                        continue;
                    }
                    list.push_back(seen);
                }
            }
        }
        begin_.push_back(0);
        for (SiteId s = 0; s < coordinates_.cols(); ++s) {
            checkpoint_each(s);
            // The order is that of names, whatever the order of the tetrahedra.
            std::sort(of_site[s].begin(), of_site[s].end());
            for (const Corner& corner : of_site[s]) {
                const Vec3 to = basis_ * (position(corner) - Vec3(coordinates_.col(s)));
                const double half = (to.squaredNorm() + weights_[s] - weights_[corner.site]) / 2;
                neighbours_.push_back({to, half, to.dot(step), corner});
            }
            of_site[s] = {};
            begin_.push_back(neighbours_.size());
        }
    }

    const Points& coordinates_;
    Gram gram_;
    /// The reduced basis, and the weights, in the unit of the Gram matrix.
    Eigen::Matrix3d basis_;
    Eigen::VectorXd weights_;
    double rounding_ = 0;
    /// Those of site s lie from begin_[s] to begin_[s + 1].
    std::vector<std::size_t> begin_;
    std::vector<VoxelNeighbour> neighbours_;
};

/// Rows of voxels that one task labels.
constexpr int kRowsOfATask = 64;

}  // namespace

VoxelImage voxel_image(const PeriodicDelaunay& delaunay, const Eigen::VectorXd& weights,
                       const VoxelGrid& grid, int n_threads, const Metric& metric) {
    const CentresOfVoxels centres(delaunay.sites, metric, grid);
    const CellsOfSites cells(delaunay, weights, centres.period_along_x() / grid.counts.x);
    VoxelImage image{grid, std::vector<SiteId>(grid.n_voxels())};
    const int length = grid.counts.x;
    const int n_rows = static_cast<int>(grid.n_voxels() / static_cast<std::size_t>(length));
    Workers workers(n_threads);
    workers.for_each((n_rows + kRowsOfATask - 1) / kRowsOfATask, [&](int task) {
        const int begin = task * kRowsOfATask;
        SiteId first = 0;
        for (int row = begin; row < std::min(begin + kRowsOfATask, n_rows); ++row) {
            const Fractions start = centres.row(row % grid.counts.y, row / grid.counts.y);
            SiteId* const labels = &image.site[static_cast<std::size_t>(row) * length];
            SiteId site = first;
            for (int k = 0; k < length;) {
                checkpoint_each(k);
                const double n_ahead = cells.settle(centres.in_row(start, k), site);
                const int last = k + static_cast<int>(std::min<double>(n_ahead, length - 1 - k));
                std::fill(labels + k, labels + last + 1, site);
                if (k == 0) first = site;
                k = last + 1;
            }
        }
    });
    return image;
}

}  // namespace pcvt::space
