#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "mesher/base/error.hpp"
#include "mesher/plane/geometry/lattice.hpp"

namespace pcvt::plane {

/// A point of the torus, given by its image in the parallelogram of the user's basis: lattice
/// coordinates u, v in [0, 1), and (x, y) = u a + v b in length units.
struct DensityPoint {
    double x;
    double y;
    double u;
    double v;
};

/// Points by columns: x[k], y[k], u[k], v[k] are point k. A coordinate that a function does not use
/// may be null. The arrays have room for whole_lanes(n) numbers.
struct PointColumns {
    std::array<const double*, 4> coordinate;
    std::size_t n;
};

/// Writes rho for each of the given points. A function of points by columns, if there is one, gives
/// the same bits in less time.
///
/// Example usage:
///
///     DensityFunction one = [](std::span<const DensityPoint> points, std::span<double> rho) {
///         std::fill_n(rho.begin(), points.size(), 1.0);
///     };
class DensityFunction {
   public:
    using OfPoints = std::function<void(std::span<const DensityPoint>, std::span<double>)>;
    using OfColumns = std::function<void(const PointColumns&, double* rho)>;

    template <class Function>
    requires(std::is_invocable_v<Function&, std::span<const DensityPoint>, std::span<double>> &&
             !std::is_same_v<std::remove_cvref_t<Function>, DensityFunction>)
        DensityFunction(Function function)
        : of_points_(std::move(function)) {}
    /// @param uses  whether the columns x, y, u and v are given: x and y, or u and v, or all.
    DensityFunction(OfPoints of_points, OfColumns of_columns, const std::array<bool, 4>& uses)
        : of_points_(std::move(of_points)), of_columns_(std::move(of_columns)), uses_(uses) {}

    void operator()(std::span<const DensityPoint> points, std::span<double> rho) const {
        of_points_(points, rho);
    }
    /// Only for a function that takes columns.
    void operator()(const PointColumns& points, double* rho) const { of_columns_(points, rho); }
    bool takes_columns() const { return of_columns_ != nullptr; }
    const std::array<bool, 4>& uses() const { return uses_; }

   private:
    OfPoints of_points_;
    OfColumns of_columns_;
    std::array<bool, 4> uses_{true, true, true, true};
};

class PixelGrid;

/// A density rho > 0 on the torus. It is only evaluated in the parallelogram of the user's basis
/// and is therefore periodic for any formula: a formula that differs at opposite sides jumps there.
///
/// Example usage:
///
///     Density density = shared_density([](const DensityPoint& p) { return p.u < 0.5 ? 4 : 1; });
///     density.u_breaks = {0.5};
///     const std::vector<double> rho = densities_at(density, lattice, points);
struct Density {
    /// Creates a function for one thread. Each function is called by one thread at a time, several
    /// functions concurrently.
    std::function<DensityFunction()> make_function;
    /// Break lines, where the density may have a kink or a jump: coordinates along u and along v in
    /// [0, 1), ascending. Integrals are cut there and remain as accurate as for a smooth density.
    /// They are always cut at 0, the seam.
    std::vector<double> u_breaks = {};
    std::vector<double> v_breaks = {};
    /// The picture whose density this is, if any (pixel_grid.hpp).
    std::shared_ptr<const PixelGrid> pixels = nullptr;
};

/// Evaluates a function of one point at many points.
/// @param function  double(const DensityPoint&)
template <class Function>
DensityFunction pointwise(Function function) {
    return [function = std::move(function)](std::span<const DensityPoint> points,
                                            std::span<double> rho) mutable {
        for (std::size_t k = 0; k < points.size(); ++k) rho[k] = function(points[k]);
    };
}

/// Creates a density from a function of one point that several threads may call concurrently.
template <class Function>
Density shared_density(Function function) {
    return {[function = std::move(function)] { return pointwise(function); }};
}

/// The same density for a run on another lattice with the same lattice coordinates u and v, such as
/// that of the round space of a metric (metric.hpp): its function gets x and y on `lattice`.
Density fixed_to_lattice(Density density, const Lattice& lattice);

/// The largest lattice coordinate in [0, 1).
inline constexpr double kBelowOne = 1 - 0x1p-53;

/// Limits of a density, and of the ratio of its largest to its least value.
inline constexpr double kLeastDensity = 1e-60;
inline constexpr double kGreatestDensity = 1e60;
inline constexpr double kMostContrast = 1e12;

/// The density is not positive and finite at a point, or its contrast is too large.
class BadDensity : public InvalidInput {
   public:
    using InvalidInput::InvalidInput;
};

/// Statistics of the evaluations of a density. Sums and extremes do not depend on the order of
/// evaluations.
struct DensityRange {
    double least = kGreatestDensity;
    double greatest = kLeastDensity;
    std::int64_t n_evaluations = 0;

    void add(const DensityRange& other);
    /// @throws BadDensity where the contrast is above kMostContrast.
    void require_contrast() const;
};

/// Evaluates a density for one thread and checks every value.
class DensityProbe {
   public:
    DensityProbe(const Lattice& lattice, DensityFunction function)
        : a_(lattice.a()), b_(lattice.b()), function_(std::move(function)) {}

    /// The period vectors as columns.
    Eigen::Matrix2d basis() const { return (Eigen::Matrix2d() << a_, b_).finished(); }
    /// The point at lattice coordinates in [0, 1]; 1 is replaced by the next smaller double.
    DensityPoint point(const Vec2& place) const {
        const Vec2 u = place.cwiseMin(kBelowOne);
        const Vec2 x = a_ * u.x() + b_ * u.y();
        return {x.x(), x.y(), u.x(), u.y()};
    }
    DensityPoint point(double u, double v) const { return point(Vec2(u, v)); }
    /// The change of a point with lattice coordinates, a linear map.
    DensityPoint change(const Vec2& u) const {
        const Vec2 x = a_ * u.x() + b_ * u.y();
        return {x.x(), x.y(), u.x(), u.y()};
    }
    /// Evaluates rho at many points. The result is valid until the next call and is followed by
    /// kLanes readable numbers.
    /// @throws BadDensity naming the first point where rho is not a number in [1e-60, 1e60].
    std::span<const double> evaluate(std::span<const DensityPoint> points);
    /// Reserves n more points, to be filled in before evaluate_reserved. The pointer is valid until
    /// the next call.
    DensityPoint* reserve(std::size_t n);
    std::size_t n_reserved() const { return n_reserved_; }
    /// Whether reserve_columns() may be used.
    bool takes_columns() const { return function_.takes_columns(); }
    /// Reserves points by columns, to be filled in before evaluate_reserved: those coordinates that
    /// the density uses; the others are null. Valid until the next call.
    /// @param n          a multiple of kLanes.
    /// @param n_repeats  of them repeat others and do not count as evaluations.
    std::array<double*, 4> reserve_columns(std::size_t n, std::size_t n_repeats);
    std::size_t n_reserved_columns() const { return n_columns_; }
    /// Evaluates rho at all reserved points, in order, and releases them: first those that were not
    /// reserved by columns.
    std::span<const double> evaluate_reserved();
    /// Adds evaluations that were made without this probe.
    void add(const DensityRange& range) { range_.add(range); }
    /// Returns the statistics since the last call.
    DensityRange take_range() { return std::exchange(range_, {}); }

   private:
    void check(std::size_t n, const std::function<DensityPoint(std::size_t)>& point);
    DensityPoint column_point(std::size_t k) const;
    PointColumns columns() const;

    Vec2 a_;
    Vec2 b_;
    DensityFunction function_;
    DensityRange range_;
    /// The first n_reserved_ points are reserved.
    std::vector<DensityPoint> points_;
    std::size_t n_reserved_ = 0;
    /// The first n_columns_ numbers of each used coordinate are reserved.
    std::array<std::vector<double>, 4> columns_;
    std::size_t n_columns_ = 0;
    std::size_t n_repeats_ = 0;
    std::vector<double> rho_;
};

/// A pool of probes of one density, one for each concurrent task.
class DensityProbes {
   public:
    DensityProbes(const Lattice& lattice, const Density& density)
        : lattice_(lattice), density_(density) {}

    /// Calls work(probe) with a probe that no other task uses. Any thread may call this function at
    /// any time.
    void with_probe(const std::function<void(DensityProbe&)>& work);
    /// The statistics of all finished calls.
    const DensityRange& range() const { return range_; }

   private:
    std::unique_ptr<DensityProbe> take();

    Lattice lattice_;
    const Density& density_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<DensityProbe>> idle_;
    DensityRange range_;
};

/// Evaluates rho at points, 2 x n, length units, anywhere in the plane, on the calling thread.
/// @throws BadDensity as DensityProbe does.
std::vector<double> densities_at(const Density& density, const Lattice& lattice,
                                 const Points& points);

}  // namespace pcvt::plane
