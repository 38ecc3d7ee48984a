#include "mesher/plane/symmetry/folded_density.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "mesher/base/simd.hpp"
#include "mesher/plane/symmetry/folded_columns.hpp"

namespace pcvt::plane {
namespace {

/// In periods: images of one break line differ by rounding.
constexpr double kSameLine = 1e-12;

double fraction(double u) {
    const double part = u - std::floor(u);
    return part < 1 ? part : 0;
}

/// Adds the images of the break lines along u and v under the operations that map such lines to
/// such lines.
void add_images(const PlaneGroup& group, Density& density) {
    const std::array own{density.u_breaks, density.v_breaks};
    std::array all{own};
    for (const LatticeIsometry& g : group.given_operations()) {
        for (int from = 0; from < 2; ++from) {
            for (int to = 0; to < 2; ++to) {
                // The coordinate `to` of the image depends only on the coordinate `from`.
                if (g.m[2 * to + from] == 0 || g.m[2 * to + 1 - from] != 0) continue;
                for (const double at : own[from]) {
                    all[to].push_back(fraction(g.m[2 * to + from] * at + 0.5 * g.halves[to]));
                }
            }
        }
    }
    for (auto& breaks : all) {
        if (group.row().system != LatticeSystem::kHexagonal) {
            breaks.insert(breaks.end(), {0.25, 0.5, 0.75});
        }
        std::sort(breaks.begin(), breaks.end());
        const auto same = [](double p, double q) { return q - p <= kSameLine; };
        breaks.erase(std::unique(breaks.begin(), breaks.end(), same), breaks.end());
    }
    density.u_breaks = std::move(all[0]);
    density.v_breaks = std::move(all[1]);
}

/// A density on the lattice of the mirrored domain, for one thread.
class MirroredDensity {
   public:
    MirroredDensity(DensityFunction function, const std::array<double, 2>& scale)
        : function_(std::move(function)), scale_(scale) {}

    void operator()(std::span<const DensityPoint> points, std::span<double> rho) {
        moved_.assign(points.begin(), points.end());
        for (DensityPoint& p : moved_) {
            p.u = std::min(scale_[0] * p.u, kBelowOne);
            p.v = std::min(scale_[1] * p.v, kBelowOne);
        }
        function_(moved_, rho);
    }
    void operator()(const PointColumns& points, double* rho) {
        PointColumns moved = points;
        for (const std::size_t axis : {0, 1}) {
            const double* const from = points.coordinate[2 + axis];
            if (from == nullptr) continue;
            column_[axis].resize(points.n + kLanes);
            for (std::size_t k = 0; k < points.n; ++k) {
                column_[axis][k] = std::min(scale_[axis] * from[k], kBelowOne);
            }
            moved.coordinate[2 + axis] = column_[axis].data();
        }
        function_(moved, rho);
    }

   private:
    DensityFunction function_;
    std::array<double, 2> scale_;
    std::vector<DensityPoint> moved_;
    std::array<std::vector<double>, 2> column_;
};

}  // namespace

Vec2 folded_point(const PlaneGroup& group, const Vec2& u) {
    Vec2 least = u;
    for (const LatticeIsometry& g : group.given_operations()) {
        const Vec2 moved = g(u);
        const Vec2 image(fraction(moved.x()), fraction(moved.y()));
        if (std::tuple(image.x(), image.y()) < std::tuple(least.x(), least.y())) least = image;
    }
    return least;
}

namespace {

/// A folded density for one thread.
class FoldedDensity {
   public:
    FoldedDensity(DensityFunction function, const PlaneGroup& group)
        : function_(std::move(function)), group_(group) {}

    void operator()(std::span<const DensityPoint> points, std::span<double> rho) {
        const std::size_t n = points.size();
        given_[0].resize(n);
        given_[1].resize(n);
        for (std::size_t k = 0; k < n; ++k) {
            given_[0][k] = points[k].u;
            given_[1][k] = points[k].v;
        }
        fold(given_[0].data(), given_[1].data(), n);
        moved_.resize(n);
        for (std::size_t k = 0; k < n; ++k) {
            moved_[k] = {column_[0][k], column_[1][k], column_[2][k], column_[3][k]};
        }
        function_(moved_, rho);
    }
    /// @param points  the columns u and v.
    void operator()(const PointColumns& points, double* rho) {
        fold(points.coordinate[2], points.coordinate[3], points.n);
        function_(PointColumns{{column_[0].data(), column_[1].data(), column_[2].data(),
                                column_[3].data()},
                               points.n},
                  rho);
    }

   private:
    /// Writes the coordinates of the folded points.
    void fold(const double* given_u, const double* given_v, std::size_t n) {
        for (std::vector<double>& column : column_) column.resize(n + kLanes);
        double* const u = column_[2].data();
        double* const v = column_[3].data();
        fold_columns(group_.given_operations(), given_u, given_v, n, u, v);
        for (const int axis : {0, 1}) {
            const double a = group_.lattice().a()[axis];
            const double b = group_.lattice().b()[axis];
            double* const x = column_[static_cast<std::size_t>(axis)].data();
            for (std::size_t k = 0; k < n; ++k) x[k] = a * u[k] + b * v[k];
        }
    }

    DensityFunction function_;
    PlaneGroup group_;
    std::vector<DensityPoint> moved_;
    std::array<std::vector<double>, 2> given_;
    /// x, y, u and v.
    std::array<std::vector<double>, 4> column_;
};

}  // namespace

Density folded_density(const Density& density, const PlaneGroup& group) {
    if (group.order() == 1) return density;
    Density folded = density;
    folded.pixels = nullptr;
    folded.make_function = [make = density.make_function, group]() -> DensityFunction {
        const DensityFunction function = make();
        if (!function.takes_columns()) return FoldedDensity(function, group);
        return {FoldedDensity(function, group),
                FoldedDensity(make(), group),
                {false, false, true, true}};
    };
    add_images(group, folded);
    return folded;
}

Density mirrored_density(const Density& density, Walls walls) {
    const std::array scale{has_walls_across(walls, 0) ? 2.0 : 1.0,
                           has_walls_across(walls, 1) ? 2.0 : 1.0};
    Density mirrored = density;
    mirrored.pixels = nullptr;
    mirrored.make_function = [make = density.make_function, scale]() -> DensityFunction {
        const DensityFunction function = make();
        if (!function.takes_columns()) return MirroredDensity(function, scale);
        return {MirroredDensity(function, scale), MirroredDensity(make(), scale), function.uses()};
    };
    for (double& u : mirrored.u_breaks) u /= scale[0];
    for (double& v : mirrored.v_breaks) v /= scale[1];
    return mirrored;
}

}  // namespace pcvt::plane
