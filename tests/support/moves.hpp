#pragma once

#include <random>
#include <string>

#include "mesher/energy/energy.hpp"

namespace pcvt::testing {

/// Moves for MovingDelaunay::step: one displacement a site in its order, frame and unit. A move is
/// rounded to single precision, so that it ends near its goal only; repeated, it ends there
/// exactly.

/// Normal with standard deviation `size`, each site for itself.
Eigen::VectorXf normal_move(const MovingDelaunay& delaunay, std::mt19937_64& random, double size);
/// The same for all sites.
Eigen::VectorXf drift(const MovingDelaunay& delaunay, const Vec2& periods);
/// Each site to where it is again, some periods away.
Eigen::VectorXf period_jumps(const MovingDelaunay& delaunay, std::mt19937_64& random);
/// Each site to its cell's centroid.
Eigen::VectorXf lloyd_move(const MovingDelaunay& delaunay, const Energy& energy);

/// The shares of the sites that a move concerns, drawn one by one.
struct Some {
    std::mt19937_64& random;
    double share = 1;
};
/// Sites towards a place, so that their distances from it become `factor` times as large.
Eigen::VectorXf collapse(const MovingDelaunay& delaunay, Some some, const Vec2& place,
                         double factor);
/// Sites to the nearest places at lattice coordinates (i / columns, j / rows), shared or not.
Eigen::VectorXf snap(const MovingDelaunay& delaunay, Some some, int columns, int rows);
/// All sites to different places of a grid with that many columns, in their order.
Eigen::VectorXf grid_move(const MovingDelaunay& delaunay, int columns);

/// One site `times` the way to an image of the other: 1 lets them meet, 2 pass through each other.
Eigen::VectorXf meet(const MovingDelaunay& delaunay, SiteId site, SiteId other, double times = 1);
/// Two sites to each other's places.
Eigen::VectorXf exchange(const MovingDelaunay& delaunay, SiteId site, SiteId other);

/// A move of any of these kinds; the first ones are short, or concern few sites.
struct NamedMove {
    std::string name;
    Eigen::VectorXf direction;
};
inline constexpr int kLocalMoveKinds = 9;
inline constexpr int kMoveKinds = 17;
NamedMove any_move(const MovingDelaunay& delaunay, const Energy& energy, std::mt19937_64& random,
                   int kind);

}  // namespace pcvt::testing
