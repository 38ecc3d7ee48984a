#include "mesher/plane/tile/texture_coordinates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcvt::plane {
namespace {

/// Tiles nearer than this to 0 keep their lattice coordinates.
constexpr double kNear = 8;

/// Returns the lattice coordinates of each vertex.
std::vector<Vec2> lattice_coordinates(const Tile& tile) {
    std::vector<Vec2> coordinates;
    coordinates.reserve(tile.points.size());
    for (const Vec2& p : tile.points) coordinates.push_back(tile.lattice.to_lattice(p));
    return coordinates;
}

/// Returns the whole periods of a distant tile with these lattice coordinates.
Vec2 distant_periods(const std::vector<Vec2>& coordinates) {
    Vec2 low = coordinates.front();
    Vec2 high = low;
    for (const Vec2& u : coordinates) {
        low = low.cwiseMin(u);
        high = high.cwiseMax(u);
    }
    Vec2 periods = (low + (high - low) / 2).array().round().matrix();
    for (double& n : periods) {
        if (std::abs(n) <= kNear) n = 0;
    }
    return periods;
}

/// Returns the finest power of two, at most 1, of which float32 represents every multiple up to
/// the largest coordinate.
double finest_step(const std::vector<Vec2>& coordinates) {
    double largest = 1;
    for (const Vec2& u : coordinates) {
        // 1 - v counts as well.
        largest = std::max({largest, std::abs(u.x()) + 1, std::abs(u.y()) + 1});
    }
    int exponent = 0;
    std::frexp(largest, &exponent);
    return std::ldexp(1, std::min(exponent - std::numeric_limits<float>::digits, 0));
}

}  // namespace

Vec2 distant_periods(const Tile& tile) { return distant_periods(lattice_coordinates(tile)); }

std::vector<TextureCoordinate> texture_coordinates(const Tile& tile) {
    std::vector<Vec2> coordinates = lattice_coordinates(tile);
    const Vec2 periods = distant_periods(coordinates);
    for (Vec2& u : coordinates) u -= periods;
    const double step = finest_step(coordinates);
    for (Vec2& u : coordinates) u = step * (u / step).array().round().matrix();
    // A vertex of the seam is its representative plus whole periods.
    for (const VertexPair& pair : tile.vertex_pairs) {
        coordinates[pair.w] = coordinates[pair.v] + Vec2(pair.offset.i, pair.offset.j);
    }
    std::vector<TextureCoordinate> result;
    result.reserve(coordinates.size());
    for (const Vec2& u : coordinates) {
        result.push_back({static_cast<float>(u.x()), static_cast<float>(u.y())});
    }
    return result;
}

}  // namespace pcvt::plane
