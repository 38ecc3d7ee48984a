#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "mesher/base/error.hpp"
#include "mesher/lattice/lattice.hpp"

namespace pcvt {

/// A point of the torus, told by its image in the typed parallelogram: lattice coordinates u, v in
/// [0, 1) of the user's basis, and x, y in length units, (x, y) = u a + v b.
struct DensityPoint {
    double x;
    double y;
    double u;
    double v;
};

/// Fills in rho at many points, as many numbers.
using DensityFunction = std::function<void(std::span<const DensityPoint>, std::span<double>)>;

/// A density rho > 0 on the torus. It is only ever asked at points of the typed parallelogram, so
/// that it is periodic whatever its formula: one that differs at opposite sides jumps there.
struct Density {
    /// Makes a function for one thread: each is asked by one thread at a time, several at once.
    std::function<DensityFunction()> make_function;
    /// Where along u, and along v, the density may have a kink or a jump: coordinates in [0, 1),
    /// rising. Integrals are cut there, so they stay as exact as of a smooth density. They are
    /// always cut at 0, the seam.
    std::vector<double> u_breaks = {};
    std::vector<double> v_breaks = {};
};

/// Asks a function of one point for many.
/// @param function  double(const DensityPoint&)
template <class Function>
DensityFunction pointwise(Function function) {
    return [function = std::move(function)](std::span<const DensityPoint> points,
                                            std::span<double> rho) mutable {
        for (std::size_t k = 0; k < points.size(); ++k) rho[k] = function(points[k]);
    };
}

/// The density of a function of one point that several threads may ask at once.
template <class Function>
Density shared_density(Function function) {
    return {[function = std::move(function)] { return pointwise(function); }};
}

/// Densities are accepted within these limits, and with this ratio of the largest to the least.
inline constexpr double kLeastDensity = 1e-60;
inline constexpr double kGreatestDensity = 1e60;
inline constexpr double kMostContrast = 1e12;

/// The density is not positive and finite at a point, or its contrast is too large.
class BadDensity : public InvalidInput {
   public:
    using InvalidInput::InvalidInput;
};

/// What was asked of a density so far. Sums and extremes: the order of the questions is no matter.
struct DensityRange {
    double least = kGreatestDensity;
    double greatest = kLeastDensity;
    std::int64_t n_evaluations = 0;

    void add(const DensityRange& other);
    /// @throws BadDensity where the contrast is above kMostContrast.
    void require_contrast() const;
};

/// A density under control, for one thread.
class DensityProbe {
   public:
    DensityProbe(const Lattice& lattice, DensityFunction function)
        : a_(lattice.a()), b_(lattice.b()), function_(std::move(function)) {}

    /// The point at lattice coordinates in [0, 1], where 1 counts as the double below it.
    DensityPoint point(const Vec2& place) const {
        const Vec2 u = place.cwiseMin(kBelowOne);
        const Vec2 x = a_ * u.x() + b_ * u.y();
        return {x.x(), x.y(), u.x(), u.y()};
    }
    DensityPoint point(double u, double v) const { return point(Vec2(u, v)); }
    /// How a point changes with lattice coordinates, which is linear.
    DensityPoint change(const Vec2& u) const {
        const Vec2 x = a_ * u.x() + b_ * u.y();
        return {x.x(), x.y(), u.x(), u.y()};
    }
    /// rho at many points; stays until the next call, with kLanes numbers behind that may be read.
    /// @throws BadDensity naming the first place where it is not a number in [1e-60, 1e60].
    std::span<const double> evaluate(std::span<const DensityPoint> points);
    /// Room for n more points, to be filled before they are asked; stays until the next call.
    DensityPoint* reserve(std::size_t n);
    std::size_t n_reserved() const { return n_reserved_; }
    /// Asks all points that wait, in order; none waits any more.
    std::span<const double> evaluate_reserved() {
        return evaluate({points_.data(), std::exchange(n_reserved_, 0)});
    }
    /// What was asked since the last call.
    DensityRange take_range() { return std::exchange(range_, {}); }

   private:
    static constexpr double kBelowOne = 1 - 0x1p-53;

    Vec2 a_;
    Vec2 b_;
    DensityFunction function_;
    DensityRange range_;
    /// The first of them wait.
    std::vector<DensityPoint> points_;
    std::size_t n_reserved_ = 0;
    std::vector<double> rho_;
};

/// The probes of one density, lent to tasks: as many as run at once.
class DensityProbes {
   public:
    DensityProbes(const Lattice& lattice, const Density& density)
        : lattice_(lattice), density_(density) {}

    /// Calls work(probe) with a probe that nobody else has. Any thread may call it at any time.
    void with_probe(const std::function<void(DensityProbe&)>& work);
    /// What was asked in all works that have returned.
    const DensityRange& range() const { return range_; }

   private:
    std::unique_ptr<DensityProbe> take();

    Lattice lattice_;
    const Density& density_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<DensityProbe>> idle_;
    DensityRange range_;
};

/// rho at points, 2 x n, length units, anywhere in the plane; asked on the calling thread.
/// @throws BadDensity as DensityProbe does.
std::vector<double> densities_at(const Density& density, const Lattice& lattice,
                                 const Points& points);

}  // namespace pcvt
