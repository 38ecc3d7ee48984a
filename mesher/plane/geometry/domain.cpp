#include "mesher/plane/geometry/domain.hpp"

namespace pcvt::plane {
namespace {

/// Whether the reduction only exchanges the vectors and changes their signs.
bool is_signed_permutation(const std::array<int, 4>& m) {
    return (m[1] == 0 && m[2] == 0) || (m[0] == 0 && m[3] == 0);
}

}  // namespace

Domain::Domain(const Lattice& lattice, const Vec2& origin)
    : reduction_(reduce(lattice)),
      is_reduced_(!is_signed_permutation(reduction_.m)),
      basis_(is_reduced_ ? reduction_.reduced : lattice),
      corner_(origin) {
    if (is_reduced_) corner_ += (lattice.a() + lattice.b() - basis_.a() - basis_.b()) / 2;
}

Offset Domain::offset_into(const Vec2& p) const {
    const Vec2 u = basis_.to_lattice(p - corner_);
    const Offset offset{-wrap(u.x()).whole, -wrap(u.y()).whole};
    return is_reduced_ ? reduction_.to_original(offset) : offset;
}

}  // namespace pcvt::plane
