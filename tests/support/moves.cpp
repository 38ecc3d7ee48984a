#include "tests/support/moves.hpp"

#include <cmath>
#include <limits>

#include "tests/support/random_numbers.hpp"

namespace pcvt::testing {
namespace {

/// Interpolates between 10^from and 10^to, for 0 <= x < 1.
double power_of_ten(double from, double to, double x) {
    return std::pow(10, from + (to - from) * x);
}

plane::Vec2 any_vector(std::mt19937_64& random, double from, double to) {
    const double x = random_number(random);
    const double y = random_number(random);
    return {from + (to - from) * x, from + (to - from) * y};
}

int small_number(std::mt19937_64& random) { return 1 + static_cast<int>(random() % 8); }

SiteId any_site(const plane::MovingDelaunay& delaunay, std::mt19937_64& random) {
    return static_cast<SiteId>(random() % static_cast<unsigned>(delaunay.n_sites()));
}

/// Moves each site by displacement(site), in lattice coordinates.
template <class Displacement>
Eigen::VectorXf displaced(const plane::MovingDelaunay& delaunay, const Displacement& displacement) {
    Eigen::VectorXf move(2 * delaunay.n_sites());
    for (SiteId s = 0; s < delaunay.n_sites(); ++s) {
        const plane::Vec2 d = displacement(s);
        move.segment<2>(2 * s) = delaunay.frame().to_position(d).cast<float>();
    }
    return move;
}

/// Reduces a difference of lattice coordinates by whole periods.
plane::Vec2 shortened(const plane::Vec2& d) { return (d.array() - d.array().round()).matrix(); }

/// A random point in lattice coordinates, every other time on the seam.
plane::Vec2 any_place(std::mt19937_64& random) {
    const plane::Vec2 place = any_vector(random, 0, 1);
    return random() % 2 == 0 ? place : plane::Vec2(0, place.y());
}

Eigen::VectorXf broken_move(const plane::MovingDelaunay& delaunay, std::mt19937_64& random) {
    Eigen::VectorXf move = normal_move(delaunay, random, 1);
    move[2 * any_site(delaunay, random)] = random() % 2 == 0
                                               ? std::numeric_limits<float>::quiet_NaN()
                                               : std::numeric_limits<float>::infinity();
    return move;
}

}  // namespace

Eigen::VectorXf normal_move(const plane::MovingDelaunay& delaunay, std::mt19937_64& random,
                            double size) {
    std::normal_distribution<double> normal(0, size);
    Eigen::VectorXf move(2 * delaunay.n_sites());
    for (float& x : move) x = static_cast<float>(normal(random));
    return move;
}

Eigen::VectorXf drift(const plane::MovingDelaunay& delaunay, const plane::Vec2& periods) {
    return displaced(delaunay, [&](SiteId) { return periods; });
}

Eigen::VectorXf period_jumps(const plane::MovingDelaunay& delaunay, std::mt19937_64& random) {
    std::uniform_int_distribution<int> whole(-3, 3);
    return displaced(delaunay, [&](SiteId) {
        const int i = whole(random);
        return plane::Vec2(i, whole(random));
    });
}

Eigen::VectorXf lloyd_move(const plane::MovingDelaunay& delaunay, const Energy& energy) {
    Eigen::VectorXf move(2 * delaunay.n_sites());
    for (SiteId s = 0; s < delaunay.n_sites(); ++s) {
        move.segment<2>(2 * s) =
            (energy.gradient.segment<2>(2 * s) / (-2 * energy.mass[s])).cast<float>();
    }
    return move;
}

Eigen::VectorXf collapse(const plane::MovingDelaunay& delaunay, Some some, const plane::Vec2& place,
                         double factor) {
    return displaced(delaunay, [&](SiteId s) -> plane::Vec2 {
        if (random_number(some.random) >= some.share) return plane::Vec2::Zero();
        return (1 - factor) * shortened(place - delaunay.coordinates().col(s));
    });
}

Eigen::VectorXf snap(const plane::MovingDelaunay& delaunay, Some some, int columns, int rows) {
    return displaced(delaunay, [&](SiteId s) -> plane::Vec2 {
        if (random_number(some.random) >= some.share) return plane::Vec2::Zero();
        const plane::Vec2 u = delaunay.coordinates().col(s);
        return plane::Vec2(std::round(u.x() * columns) / columns, std::round(u.y() * rows) / rows) -
               u;
    });
}

Eigen::VectorXf grid_move(const plane::MovingDelaunay& delaunay, int columns) {
    const int rows = (delaunay.n_sites() + columns - 1) / columns;
    return displaced(delaunay, [&](SiteId s) {
        const plane::Vec2 place(double(s / rows) / columns, double(s % rows) / rows);
        return shortened(place - delaunay.coordinates().col(s));
    });
}

Eigen::VectorXf meet(const plane::MovingDelaunay& delaunay, SiteId site, SiteId other,
                     double times) {
    return displaced(delaunay, [&](SiteId s) -> plane::Vec2 {
        if (s != site) return plane::Vec2::Zero();
        return times *
               shortened(delaunay.coordinates().col(other) - delaunay.coordinates().col(site));
    });
}

Eigen::VectorXf exchange(const plane::MovingDelaunay& delaunay, SiteId site, SiteId other) {
    return meet(delaunay, site, other) + meet(delaunay, other, site);
}

NamedMove any_move(const plane::MovingDelaunay& delaunay, const Energy& energy,
                   std::mt19937_64& random, int kind) {
    // Drawn in separate statements, since the compiler chooses the order in which arguments are
    // evaluated.
    const int n = delaunay.n_sites();
    const SiteId site = any_site(delaunay, random);
    const SiteId other = any_site(delaunay, random);
    const SiteId neighbour = delaunay.triangulation().corner_sites()[random() % (6u * n)];
    const plane::Vec2 place = any_place(random);
    const plane::Vec2 periods = any_vector(random, -2, 2);
    const double x = random_number(random);
    const double share = random_number(random);
    const double closer = random() % 4 == 0 ? 0 : power_of_ten(-6, 0, x);
    const int columns = small_number(random) * small_number(random);
    const int rows = small_number(random) * small_number(random);
    const Some few{random, std::min(1.0, 3.0 / n)};
    const auto in_h = [&](double from, double to) {
        return delaunay.spacing() * power_of_ten(from, to, x);
    };
    switch (kind) {
        case 0:
            return {"tremble", normal_move(delaunay, random, in_h(-16, -3))};
        case 1:
            return {"small step", normal_move(delaunay, random, in_h(-3, -0.5))};
        case 2:
            return {"Lloyd step", lloyd_move(delaunay, energy)};
        case 3:
            return {"long Lloyd step", 1.9f * lloyd_move(delaunay, energy)};
        case 4:
            return {"few collapse", collapse(delaunay, few, place, power_of_ten(-3, 0, x))};
        case 5:
            return {"few snap", snap(delaunay, few, columns, rows)};
        case 6:
            return {"pass by", meet(delaunay, site, neighbour, 1 + 2 * x) +
                                   normal_move(delaunay, random, in_h(-9, -1))};
        case 7:
            return {"exchange", exchange(delaunay, site, other)};
        case 8:
            return {"meet", meet(delaunay, site, other)};
        case 9:
            return {"jump", normal_move(delaunay, random, in_h(-1, 4))};
        case 10:
            return {"collapse", collapse(delaunay, {random}, place, closer)};
        case 11:
            return {"part collapses", collapse(delaunay, {random, share}, place, closer)};
        case 12:
            return {"drift",
                    drift(delaunay, periods) + normal_move(delaunay, random, in_h(-9, -1))};
        case 13:
            return {"period jumps", period_jumps(delaunay, random)};
        case 14:
            return {"snap", snap(delaunay, {random}, columns, rows)};
        case 15:
            return {"grid", grid_move(delaunay, std::min(n, columns))};
        default:
            return {"broken", broken_move(delaunay, random)};
    }
}

}  // namespace pcvt::testing
