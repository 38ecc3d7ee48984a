#pragma once

#include <random>
#include <string>

#include "mesher/plane/energy/energy.hpp"

namespace pcvt::testing {

/// Moves for MovingDelaunay::step: one displacement per site in its order, frame and unit. Moves
/// are rounded to single precision and end only near their goal; repeated moves reach it exactly.

/// Independent normal displacements with standard deviation `size`.
Eigen::VectorXf normal_move(const plane::MovingDelaunay& delaunay, std::mt19937_64& random,
                            double size);
/// The same displacement for all sites.
Eigen::VectorXf drift(const plane::MovingDelaunay& delaunay, const plane::Vec2& periods);
/// Moves each site by a whole number of periods.
Eigen::VectorXf period_jumps(const plane::MovingDelaunay& delaunay, std::mt19937_64& random);
/// Moves each site to its cell's centroid.
Eigen::VectorXf lloyd_move(const plane::MovingDelaunay& delaunay, const Energy& energy);

/// The fraction of sites that a move concerns, and the generator that selects them.
struct Some {
    std::mt19937_64& random;
    double share = 1;
};
/// Moves sites towards a point, so that their distances from it are multiplied by `factor`.
Eigen::VectorXf collapse(const plane::MovingDelaunay& delaunay, Some some, const plane::Vec2& place,
                         double factor);
/// Moves sites to the nearest points with lattice coordinates (i / columns, j / rows), which
/// several sites may share.
Eigen::VectorXf snap(const plane::MovingDelaunay& delaunay, Some some, int columns, int rows);
/// Moves all sites to different points of a grid with that many columns, in their order.
Eigen::VectorXf grid_move(const plane::MovingDelaunay& delaunay, int columns);

/// Moves one site towards an image of the other by `times` their distance: with 1 they meet, with 2
/// they pass through each other.
Eigen::VectorXf meet(const plane::MovingDelaunay& delaunay, SiteId site, SiteId other,
                     double times = 1);
/// Exchanges the positions of two sites.
Eigen::VectorXf exchange(const plane::MovingDelaunay& delaunay, SiteId site, SiteId other);

/// A move of any of these kinds; the first kinds are short, or concern few sites.
struct NamedMove {
    std::string name;
    Eigen::VectorXf direction;
};
inline constexpr int kLocalMoveKinds = 9;
inline constexpr int kMoveKinds = 17;
NamedMove any_move(const plane::MovingDelaunay& delaunay, const Energy& energy,
                   std::mt19937_64& random, int kind);

}  // namespace pcvt::testing
