#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mesher/base/choices.hpp"
#include "mesher/plane/geometry/lattice.hpp"

namespace pcvt::plane {

/// The 17 plane groups (International Tables for Crystallography A, 2016), by their short names.
enum class PlaneGroupName {
    kP1,
    kP2,
    kPm,
    kPg,
    kCm,
    kPmm,
    kPmg,
    kPgg,
    kCmm,
    kP4,
    kP4m,
    kP4g,
    kP3,
    kP3m1,
    kP31m,
    kP6,
    kP6m
};

/// The lattices that a group fits: any; a and b perpendicular; perpendicular and equally long;
/// equally long at 60 or 120 degrees.
enum class LatticeSystem { kOblique, kRectangular, kSquare, kHexagonal };

/// The map u -> m u + halves / 2 of lattice coordinates. A lattice isometry maps multiples of 2^-51
/// to such multiples exactly.
struct LatticeIsometry {
    /// Row by row, determinant +1 or -1.
    std::array<int, 4> m{1, 0, 0, 1};
    /// In half periods, 0 or 1.
    std::array<int, 2> halves{0, 0};

    int determinant() const { return m[0] * m[3] - m[1] * m[2]; }
    /// Not wrapped.
    Vec2 operator()(const Vec2& u) const {
        return {m[0] * u.x() + m[1] * u.y() + 0.5 * halves[0],
                m[2] * u.x() + m[3] * u.y() + 0.5 * halves[1]};
    }
    friend bool operator==(const LatticeIsometry&, const LatticeIsometry&) = default;
};

/// The shortest period along the axis of a reflection or glide, in the same coordinates.
std::array<int, 2> mirror_direction(const LatticeIsometry& isometry);

/// `first` after `second`, with the translation wrapped.
LatticeIsometry composed(const LatticeIsometry& first, const LatticeIsometry& second);

/// A group in options, reports and runs.
struct PlaneGroupRow {
    PlaneGroupName name;
    /// In options and reports.
    const char* word;
    /// The number of the group in interfaces, as in the other tables of choices.
    int abi_value;
    LatticeSystem system;
};

/// In the order of the enumerators.
inline constexpr std::array kPlaneGroups{
    PlaneGroupRow{PlaneGroupName::kP1, "p1", 1, LatticeSystem::kOblique},
    PlaneGroupRow{PlaneGroupName::kP2, "p2", 2, LatticeSystem::kOblique},
    PlaneGroupRow{PlaneGroupName::kPm, "pm", 3, LatticeSystem::kRectangular},
    PlaneGroupRow{PlaneGroupName::kPg, "pg", 4, LatticeSystem::kRectangular},
    PlaneGroupRow{PlaneGroupName::kCm, "cm", 5, LatticeSystem::kRectangular},
    PlaneGroupRow{PlaneGroupName::kPmm, "pmm", 6, LatticeSystem::kRectangular},
    PlaneGroupRow{PlaneGroupName::kPmg, "pmg", 7, LatticeSystem::kRectangular},
    PlaneGroupRow{PlaneGroupName::kPgg, "pgg", 8, LatticeSystem::kRectangular},
    PlaneGroupRow{PlaneGroupName::kCmm, "cmm", 9, LatticeSystem::kRectangular},
    PlaneGroupRow{PlaneGroupName::kP4, "p4", 10, LatticeSystem::kSquare},
    PlaneGroupRow{PlaneGroupName::kP4m, "p4m", 11, LatticeSystem::kSquare},
    PlaneGroupRow{PlaneGroupName::kP4g, "p4g", 12, LatticeSystem::kSquare},
    PlaneGroupRow{PlaneGroupName::kP3, "p3", 13, LatticeSystem::kHexagonal},
    PlaneGroupRow{PlaneGroupName::kP3m1, "p3m1", 14, LatticeSystem::kHexagonal},
    PlaneGroupRow{PlaneGroupName::kP31m, "p31m", 15, LatticeSystem::kHexagonal},
    PlaneGroupRow{PlaneGroupName::kP6, "p6", 16, LatticeSystem::kHexagonal},
    PlaneGroupRow{PlaneGroupName::kP6m, "p6m", 17, LatticeSystem::kHexagonal}};

constexpr const PlaneGroupRow& plane_group_row(PlaneGroupName name) {
    return kPlaneGroups[static_cast<std::size_t>(name)];
}

/// @throws InvalidInput for a word that names no group.
PlaneGroupName parse_plane_group(std::string_view word);

/// The period vector along which the mirrors and glides of pm, pg and cm lie, and the mirrors of
/// pmg.
enum class MirrorAxis { kAlongA, kAlongB };

/// The operations of a plane group on a lattice: isometries modulo the periods.
///
/// The origin lies on a centre of the highest order, or else on a mirror or a glide. Mirrors of pm
/// and pmm pass through it and through the middle of the period, so that sites with the symmetry pm
/// fill a channel 0 <= v <= 1/2, and with pmm a box.
///
/// Example usage:
///
///     const PlaneGroup channel(PlaneGroupName::kPm, Lattice::rectangle(1, 2 * height));
///     for (const LatticeIsometry& g : channel.operations()) image(g(sites.coordinates().col(s)));
///
/// Laws, tested by number:
///   (1) The operations are closed under composition.
///   (2) Each one leaves the Gram matrix unchanged, up to rounding.
class PlaneGroup {
   public:
    /// @param axis  kAlongB is the group on the lattice with a and b exchanged.
    /// @throws InvalidInput naming the lattices that fit.
    PlaneGroup(PlaneGroupName name, const Lattice& lattice, MirrorAxis axis = MirrorAxis::kAlongA);

    const PlaneGroupRow& row() const { return plane_group_row(name_); }
    /// The number of operations modulo the periods, the centring of cm and cmm included.
    int order() const { return static_cast<int>(operations_.size()); }
    const Lattice& lattice() const { return lattice_; }
    const Reduction& reduction() const { return reduction_; }
    /// In coordinates of the reduced basis, as those of Sites; the first one is the identity.
    std::span<const LatticeIsometry> operations() const { return operations_; }
    /// The same in coordinates of the given basis.
    std::span<const LatticeIsometry> given_operations() const { return given_operations_; }

   private:
    PlaneGroupName name_;
    Lattice lattice_;
    Reduction reduction_;
    std::vector<LatticeIsometry> operations_;
    std::vector<LatticeIsometry> given_operations_;
};

/// A lattice that the group fits: the unit square, or period vectors of length 1 at 60 degrees.
Lattice example_lattice(PlaneGroupName name);

}  // namespace pcvt::plane
