#include "io/pictures/svg_domain.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pcvt {
namespace {

/// The domain is drawn in the reduced basis if the typed basis has a diagonal longer by this
/// factor.
constexpr double kOblique = 1.5;
/// Lattice coordinates that should agree differ by less than this.
constexpr double kLatticeRounding = 1e-9;

double longest_diagonal(const plane::Lattice& lattice) {
    return std::max((lattice.a() + lattice.b()).norm(), (lattice.a() - lattice.b()).norm());
}

/// Returns the lower corner of a box outline, whose extent in lattice coordinates is at most 1;
/// `nullopt` for a whole outline.
std::optional<plane::Vec2> box_corner(const plane::Tile& tile) {
    if (tile.whole_sides.empty()) return std::nullopt;
    plane::Vec2 low = tile.lattice.to_lattice(tile.points[0]);
    plane::Vec2 high = low;
    for (const plane::Vec2& p : tile.points) {
        const plane::Vec2 u = tile.lattice.to_lattice(p);
        low = low.cwiseMin(u);
        high = high.cwiseMax(u);
    }
    if ((high - low).maxCoeff() > 1 + kLatticeRounding) return std::nullopt;
    return tile.lattice.to_position(low);
}

}  // namespace

SvgDomain drawn_domain(const plane::Tile& tile) {
    if (const auto corner = box_corner(tile)) {
        const plane::Vec2& a = tile.lattice.a();
        const plane::Vec2& b = tile.lattice.b();
        return {{*corner, *corner + a, *corner + a + b, *corner + b}, "domain"};
    }
    const plane::Lattice reduced = reduce(tile.lattice).reduced;
    const bool oblique = longest_diagonal(tile.lattice) > kOblique * longest_diagonal(reduced);
    const plane::Lattice& basis = oblique ? reduced : tile.lattice;
    plane::Vec2 low = tile.points[0];
    plane::Vec2 high = low;
    for (const plane::Vec2& p : tile.points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const plane::Vec2 middle = basis.to_lattice(low + (high - low) / 2);
    const plane::Vec2 corner =
        basis.to_position((middle - plane::Vec2(0.5, 0.5)).array().round().matrix());
    return {{corner, corner + basis.a(), corner + basis.a() + basis.b(), corner + basis.b()},
            oblique ? "reduced domain" : "domain"};
}

}  // namespace pcvt
