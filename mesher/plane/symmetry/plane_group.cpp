#include "mesher/plane/symmetry/plane_group.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesher/base/error.hpp"

namespace pcvt::plane {
namespace {

/// Relative to |a| |b|: a lattice fits a group if the Gram matrix changes by at most this.
constexpr double kSameGram = 1e-12;

using IntegerMatrix = std::array<int, 4>;
using Halves = std::array<int, 2>;

constexpr LatticeIsometry kHalfTurn{{-1, 0, 0, -1}, {0, 0}};
constexpr LatticeIsometry kQuarterTurn{{0, -1, 1, 0}, {0, 0}};
// In a basis with 120 degrees between a and b.
constexpr LatticeIsometry kThirdTurn{{0, -1, 1, -1}, {0, 0}};
constexpr LatticeIsometry kSixthTurn{{1, -1, 1, 0}, {0, 0}};
constexpr LatticeIsometry kMirrorAlongSum{{0, 1, 1, 0}, {0, 0}};
constexpr LatticeIsometry kMirrorAcrossSum{{0, -1, -1, 0}, {0, 0}};
constexpr LatticeIsometry kCentring{{1, 0, 0, 1}, {1, 1}};

/// (u, v) -> (u, -v) + halves / 2: a mirror along a, or a glide.
constexpr LatticeIsometry along_a(int half_u, int half_v) {
    return {{1, 0, 0, -1}, {half_u, half_v}};
}

/// Generators besides the identity, in the group's own setting.
std::vector<LatticeIsometry> generators(PlaneGroupName name) {
    switch (name) {
        case PlaneGroupName::kP1:
            return {};
        case PlaneGroupName::kP2:
            return {kHalfTurn};
        case PlaneGroupName::kPm:
            return {along_a(0, 0)};
        case PlaneGroupName::kPg:
            return {along_a(1, 0)};
        case PlaneGroupName::kCm:
            return {along_a(0, 0), kCentring};
        case PlaneGroupName::kPmm:
            return {kHalfTurn, along_a(0, 0)};
        case PlaneGroupName::kPmg:
            return {kHalfTurn, along_a(0, 1)};
        case PlaneGroupName::kPgg:
            return {kHalfTurn, along_a(1, 1)};
        case PlaneGroupName::kCmm:
            return {kHalfTurn, along_a(0, 0), kCentring};
        case PlaneGroupName::kP4:
            return {kQuarterTurn};
        case PlaneGroupName::kP4m:
            return {kQuarterTurn, along_a(0, 0)};
        case PlaneGroupName::kP4g:
            return {kQuarterTurn, along_a(1, 1)};
        case PlaneGroupName::kP3:
            return {kThirdTurn};
        case PlaneGroupName::kP3m1:
            return {kThirdTurn, kMirrorAcrossSum};
        case PlaneGroupName::kP31m:
            return {kThirdTurn, kMirrorAlongSum};
        case PlaneGroupName::kP6:
            return {kSixthTurn};
        case PlaneGroupName::kP6m:
            return {kSixthTurn, kMirrorAlongSum};
    }
    throw InternalError("a plane group without generators");
}

int wrapped_half(int half) { return ((half % 2) + 2) % 2; }

IntegerMatrix product(const IntegerMatrix& p, const IntegerMatrix& q) {
    return {p[0] * q[0] + p[1] * q[2], p[0] * q[1] + p[1] * q[3], p[2] * q[0] + p[3] * q[2],
            p[2] * q[1] + p[3] * q[3]};
}

Halves product(const IntegerMatrix& p, const Halves& t) {
    return {wrapped_half(p[0] * t[0] + p[1] * t[1]), wrapped_half(p[2] * t[0] + p[3] * t[1])};
}

/// @pre the determinant is +1 or -1.
IntegerMatrix inverse(const IntegerMatrix& p) {
    const int det = p[0] * p[3] - p[1] * p[2];
    return {det * p[3], -det * p[1], -det * p[2], det * p[0]};
}

/// The same isometry in coordinates u' = change u.
LatticeIsometry changed(const IntegerMatrix& change, const LatticeIsometry& g) {
    return {product(product(change, g.m), inverse(change)), product(change, g.halves)};
}

std::vector<LatticeIsometry> closure(const std::vector<LatticeIsometry>& generators) {
    std::vector<LatticeIsometry> group{LatticeIsometry{}};
    for (std::size_t k = 0; k < group.size(); ++k) {
        for (const LatticeIsometry& g : generators) {
            const LatticeIsometry next = composed(g, group[k]);
            if (std::find(group.begin(), group.end(), next) == group.end()) group.push_back(next);
        }
    }
    return group;
}

bool is_isometry(const Lattice& lattice, const IntegerMatrix& m) {
    // Column k of m is the image of the period vector k.
    const Vec2 a = m[0] * lattice.a() + m[2] * lattice.b();
    const Vec2 b = m[1] * lattice.a() + m[3] * lattice.b();
    const double largest = std::max(lattice.a().squaredNorm(), lattice.b().squaredNorm());
    const auto same = [largest](double p, double q) {
        return std::abs(p - q) <= kSameGram * largest;
    };
    return same(a.squaredNorm(), lattice.a().squaredNorm()) &&
           same(b.squaredNorm(), lattice.b().squaredNorm()) &&
           same(a.dot(b), lattice.a().dot(lattice.b()));
}

const char* fitting_lattices(LatticeSystem system) {
    switch (system) {
        case LatticeSystem::kOblique:
            return "any lattice";
        case LatticeSystem::kRectangular:
            return "rectangles, such as the period 2,1";
        case LatticeSystem::kSquare:
            return "squares, such as the period 1,1";
        case LatticeSystem::kHexagonal:
            return "hexagonal lattices, with two equal lengths at 60 or 120 degrees, such as "
                   "1,0,0.5,0.8660254037844386";
    }
    return "";
}

}  // namespace

std::array<int, 2> mirror_direction(const LatticeIsometry& isometry) {
    // The columns of m + 1 lie along the axis.
    const auto& m = isometry.m;
    const bool first = m[0] + 1 != 0 || m[2] != 0;
    const int u = first ? m[0] + 1 : m[1];
    const int v = first ? m[2] : m[3] + 1;
    const int divisor = std::gcd(u, v) * (u < 0 || (u == 0 && v < 0) ? -1 : 1);
    return {u / divisor, v / divisor};
}

LatticeIsometry composed(const LatticeIsometry& first, const LatticeIsometry& second) {
    const Halves moved = product(first.m, second.halves);
    return {product(first.m, second.m),
            {wrapped_half(moved[0] + first.halves[0]), wrapped_half(moved[1] + first.halves[1])}};
}

PlaneGroupName parse_plane_group(std::string_view word) {
    if (const PlaneGroupRow* row = find_word(kPlaneGroups, word)) return row->name;
    throw InvalidInput("symmetry " + std::string(word) + ": not a plane group; take " +
                       listed_words(kPlaneGroups, ", ", " or "));
}

PlaneGroup::PlaneGroup(PlaneGroupName name, const Lattice& lattice, MirrorAxis axis)
    : name_(name), lattice_(lattice), reduction_(reduce(lattice)) {
    // Change from the group's own setting to the basis given: exchanged period vectors, or 60
    // degrees, where u a + v (b - a) = (u - v) a + v b.
    IntegerMatrix setting{1, 0, 0, 1};
    if (axis == MirrorAxis::kAlongB) setting = {0, 1, 1, 0};
    const bool acute = lattice.a().dot(lattice.b()) > 0;
    if (row().system == LatticeSystem::kHexagonal && acute) {
        setting = product({1, -1, 0, 1}, setting);
    }
    for (const LatticeIsometry& g : closure(generators(name))) {
        if (!is_isometry(lattice, changed(setting, g).m)) {
            throw InvalidInput(std::string("the symmetry ") + row().word +
                               " does not fit this lattice; it fits " +
                               fitting_lattices(row().system));
        }
        given_operations_.push_back(changed(setting, g));
    }
    // u a + v b = u' a' + v' b' with (u, v) = m^T (u', v').
    const auto& m = reduction_.m;
    const IntegerMatrix to_reduced = inverse({m[0], m[2], m[1], m[3]});
    for (const LatticeIsometry& g : given_operations_) {
        operations_.push_back(changed(to_reduced, g));
    }
}

Lattice example_lattice(PlaneGroupName name) {
    if (plane_group_row(name).system != LatticeSystem::kHexagonal) return Lattice::rectangle(1, 1);
    return {Vec2(1, 0), Vec2(0.5, std::sqrt(0.75))};
}

}  // namespace pcvt::plane
