#include "mesher/plane/symmetry/folded_columns.hpp"

#include <algorithm>

#include "mesher/base/target_clones.hpp"

namespace pcvt::plane {
namespace {

/// The part of a number after its floor, for moderate numbers.
[[gnu::always_inline]] inline double part_of(double x) {
    const double whole = static_cast<double>(static_cast<int>(x));
    // The sum with 0 has the sign of floor's difference where both are 0.
    const double part = (x - (whole - (whole > x ? 1.0 : 0.0))) + 0.0;
    return part < 1 ? part : 0.0;
}

/// u -> m u + shift.
struct Map {
    double m[4];
    double shift[2];
};

/// Replaces points by their images where these have less coordinates.
PCVT_TARGET_CLONES void take_lesser(const Map& map, const double* __restrict u,
                                    const double* __restrict v, std::size_t n,
                                    double* __restrict least_u, double* __restrict least_v) {
    const double uu = map.m[0], uv = map.m[1], vu = map.m[2], vv = map.m[3];
    const double shift_u = map.shift[0], shift_v = map.shift[1];
    for (std::size_t k = 0; k < n; ++k) {
        const double image_u = part_of(uu * u[k] + uv * v[k] + shift_u);
        const double image_v = part_of(vu * u[k] + vv * v[k] + shift_v);
        const double old_u = least_u[k];
        const double old_v = least_v[k];
        const bool is_less = (image_u < old_u) | ((image_u == old_u) & (image_v < old_v));
        least_u[k] = is_less ? image_u : old_u;
        least_v[k] = is_less ? image_v : old_v;
    }
}

}  // namespace

void fold_columns(std::span<const LatticeIsometry> operations, const double* u, const double* v,
                  std::size_t n, double* least_u, double* least_v) {
    std::copy_n(u, n, least_u);
    std::copy_n(v, n, least_v);
    for (const LatticeIsometry& g : operations) {
        Map map{};
        for (int k = 0; k < 4; ++k) map.m[k] = g.m[k];
        for (int k = 0; k < 2; ++k) map.shift[k] = 0.5 * g.halves[k];
        take_lesser(map, u, v, n, least_u, least_v);
    }
}

}  // namespace pcvt::plane
