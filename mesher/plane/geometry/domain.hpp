#pragma once

#include "mesher/plane/geometry/lattice.hpp"

namespace pcvt::plane {

/// The parallelogram in which tiles and sites are placed: one period of a lattice at an origin.
///
/// Example usage:
///   const Domain domain(Lattice::rectangle(2, 1), {0, 0});
///   const Vec2 inside = p + lattice.translation(domain.offset_into(p));  // in [0, 2) x [0, 1)
///
/// If the basis of the lattice is reduced but for the order and the signs of its vectors, as that
/// of every rectangle is, the domain is the parallelogram of the basis with its corner at the
/// origin. Otherwise it is the parallelogram of the reduced basis, with the same centre. Laws,
/// tested by number:
///   (1) The domain contains p + translation(offset_into(p)), up to rounding.
///   (2) The centre is origin + (a + b) / 2.
class Domain {
   public:
    /// @param lattice  offsets are in its basis.
    /// @param origin   length units.
    /// @throws InvalidInput as reduce().
    Domain(const Lattice& lattice, const Vec2& origin);

    /// The vectors of the parallelogram.
    const Lattice& basis() const { return basis_; }

    /// The corners with the lattice coordinates (0, 0) and (1, 1) of the domain's own basis.
    const Vec2& corner() const { return corner_; }
    Vec2 opposite_corner() const { return corner_ + basis_.a() + basis_.b(); }
    Vec2 centre() const { return corner_ + (basis_.a() + basis_.b()) / 2; }

    /// The offset of the translation that moves p into the half-open domain.
    Offset offset_into(const Vec2& p) const;

   private:
    Reduction reduction_;
    /// Whether basis_ is the reduced basis, not the one that was given.
    bool is_reduced_;
    Lattice basis_;
    Vec2 corner_;
};

}  // namespace pcvt::plane
