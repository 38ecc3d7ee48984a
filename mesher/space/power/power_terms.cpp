#include "mesher/space/power/power_terms.hpp"

#include <cmath>
#include <cstring>
#include <limits>

#include "mesher/base/simd.hpp"
#include "mesher/base/target_clones.hpp"
#include "mesher/space/power/thin_terms.hpp"

// Functions that return vectors of the widest units are always inlined, so that they have no binary
// interface.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace pcvt::space {
namespace {

/// A tetrahedron is thin if its determinant is below this fraction of the third power of its
/// largest edge at corner 0, where differences of weights count as squares of lengths. More than in
/// the energy, because the volumes of small cells must be exact.
constexpr double kThinPower = 0x1p-14;
/// See kHeightError of tetrahedron_terms.cpp.
constexpr double kPowerHeightError = 0x1p-42;

struct Arrow {
    Lanes x;
    Lanes y;
    Lanes z;
};

[[gnu::always_inline]] inline Arrow operator+(const Arrow& a, const Arrow& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
[[gnu::always_inline]] inline Arrow operator-(const Arrow& a, const Arrow& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
[[gnu::always_inline]] inline Arrow operator*(const Lanes& s, const Arrow& a) {
    return {s * a.x, s * a.y, s * a.z};
}
[[gnu::always_inline]] inline Lanes dot(const Arrow& a, const Arrow& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
[[gnu::always_inline]] inline Arrow cross(const Arrow& a, const Arrow& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[gnu::always_inline]] inline Lanes greater(const Lanes& a, const Lanes& b) {
    return a > b ? a : b;
}
[[gnu::always_inline]] inline Lanes lesser(const Lanes& a, const Lanes& b) { return a < b ? a : b; }
[[gnu::always_inline]] inline Lanes magnitude(const Lanes& a) { return greater(a, -a); }

/// A tetrahedron with corner 0 at the origin.
struct WeightedShape {
    std::array<Arrow, 4> p;
    std::array<Lanes, 4> w;
    /// In the order of PowerBlock::kEdges, from the first to the second corner.
    std::array<Arrow, 6> edge;
    /// The normals of the facets opposite to the corners, inwards, twice their areas long.
    std::array<Arrow, 4> normal;
    Arrow centre;
    /// The heights of the orthocentre above the facets, times |N|, and a bound of their rounding.
    std::array<Lanes, 4> height;
    Lanes rounding;
    Lanes thick;
};

/// The number of the edge between two corners.
constexpr int edge_of(int i, int j) {
    for (int e = 0; e < 6; ++e) {
        const auto [a, b] = PowerBlock::kEdges[e];
        if ((a == i && b == j) || (a == j && b == i)) return e;
    }
    return -1;
}

/// From corner i to corner j.
template <int i, int j>
[[gnu::always_inline]] inline Arrow arrow_between(const WeightedShape& s) {
    const Arrow& d = s.edge[edge_of(i, j)];
    if constexpr (i < j) return d;
    return {-d.x, -d.y, -d.z};
}

[[gnu::always_inline]] inline void set_heights(WeightedShape& s) {
    s.height = {dot(s.centre - s.p[1], s.normal[0]), dot(s.centre, s.normal[1]),
                dot(s.centre, s.normal[2]), dot(s.centre, s.normal[3])};
}

[[gnu::always_inline]] inline WeightedShape weighted_shape(const std::array<Arrow, 4>& p,
                                                           const std::array<Lanes, 4>& w,
                                                           const std::array<Arrow, 6>& edge) {
    WeightedShape s{p, w, edge, {}, {}, {}, {}, {}};
    s.normal = {cross(edge[4], edge[3]), cross(p[2], p[3]), cross(p[3], p[1]), cross(p[1], p[2])};
    const Lanes det = dot(p[1], s.normal[1]);
    const Lanes per_det = 1 / det;
    s.centre = Arrow{};
    Lanes longest{};
    for (int k = 1; k < 4; ++k) {
        const Lanes squared = dot(p[k], p[k]);
        const Lanes lift = w[0] - w[k];
        s.centre = s.centre + (squared + lift) * s.normal[k];
        longest = greater(longest, squared + magnitude(lift));
    }
    s.centre = (0.5 * per_det) * s.centre;
    set_heights(s);
    const Lanes cube = longest * longest * longest;
    s.thick = det * magnitude(det) - kThinPower * kThinPower * cube;
    s.rounding = kPowerHeightError * cube * magnitude(per_det);
    return s;
}

/// The reciprocals of two numbers: a division takes more time than three products.
[[gnu::always_inline]] inline std::array<Lanes, 2> reciprocals(const Lanes& a, const Lanes& b) {
    const Lanes per_both = 1 / (a * b);
    return {b * per_both, a * per_both};
}

/// The sums of a tetrahedron by corner, its conductances by edge.
template <bool with_moments>
struct PowerSumsOf {
    std::array<Lanes, 4> volume{};
    std::array<Lanes, 6> conductance{};
    std::array<Arrow, 4> moment{};
    Lanes value{};
};

/// The quantities of facets that the sums over the edges of a tetrahedron use.
struct FacetsOf {
    /// 1 / |N|^2, q and Phi of the facets opposite to the corners.
    std::array<Lanes, 4> per_nn;
    std::array<Lanes, 4> q;
    std::array<Arrow, 4> foot;
};

/// Adds the terms of edge i j, opposite to the corners k and m.
template <int i, int j, int k, int m, bool with_moments>
[[gnu::always_inline]] inline void add_edge(const WeightedShape& s, const FacetsOf& facets,
                                            const Lanes& squared, const Lanes& per_squared,
                                            PowerSumsOf<with_moments>& sums) {
    const Arrow d = arrow_between<i, j>(s);
    const Lanes alpha_i = squared + (s.w[i] - s.w[j]);
    const Lanes alpha_j = squared - (s.w[i] - s.w[j]);
    const Lanes eighth = 0.125 * per_squared;
    Lanes conductance{};
    // The facets i j k and i j m.
    const auto add_facet = [&]<int third, int apex>() __attribute__((always_inline)) {
        const Arrow to_i = arrow_between<third, i>(s);
        const Arrow to_j = arrow_between<third, j>(s);
        const Lanes b = squared * dot(to_i, to_j) + dot(d, to_j) * (s.w[i] - s.w[third]) -
                        dot(d, to_i) * (s.w[j] - s.w[third]);
        const Lanes part = b * facets.q[apex] * eighth;
        conductance = conductance + part;
        if constexpr (with_moments) {
            const Lanes quarter = 0.25 * per_squared;
            const Lanes bb = 3 * b * b * facets.per_nn[apex] * quarter;
            const Lanes rest = bb + facets.q[apex] * s.height[apex];
            const Lanes abh_i = 2 * part * alpha_i;
            const Lanes abh_j = 2 * part * alpha_j;
            sums.value = sums.value + abh_i * (6 * alpha_i * alpha_i * quarter + rest) +
                         abh_j * (6 * alpha_j * alpha_j * quarter + rest);
            const Arrow foot = s.p[i] + (0.5 * alpha_i * per_squared) * d;
            const Arrow corners = foot + facets.foot[apex] + s.centre;
            const Lanes three = 3 + Lanes{};
            sums.moment[i] = sums.moment[i] + abh_i * (corners - three * s.p[i]);
            sums.moment[j] = sums.moment[j] + abh_j * (corners - three * s.p[j]);
        }
    };
    add_facet.template operator()<k, m>();
    add_facet.template operator()<m, k>();
    sums.conductance[edge_of(i, j)] = conductance;
    sums.volume[i] = sums.volume[i] + conductance * alpha_i;
    sums.volume[j] = sums.volume[j] + conductance * alpha_j;
}

template <bool with_moments>
[[gnu::always_inline]] inline PowerSumsOf<with_moments> power_sums(const WeightedShape& s) {
    FacetsOf facets;
    for (int c = 0; c < 4; c += 2) {
        const auto both =
            reciprocals(dot(s.normal[c], s.normal[c]), dot(s.normal[c + 1], s.normal[c + 1]));
        for (int m = 0; m < 2; ++m) {
            facets.per_nn[c + m] = both[m];
            facets.q[c + m] = s.height[c + m] * both[m];
            if constexpr (with_moments) {
                facets.foot[c + m] = s.centre - facets.q[c + m] * s.normal[c + m];
            }
        }
    }
    std::array<Lanes, 6> l;
    for (int e = 0; e < 6; ++e) l[e] = dot(s.edge[e], s.edge[e]);
    const auto r01 = reciprocals(l[0], l[1]);
    const auto r23 = reciprocals(l[2], l[3]);
    const auto r45 = reciprocals(l[4], l[5]);
    PowerSumsOf<with_moments> sums;
    add_edge<0, 1, 2, 3>(s, facets, l[0], r01[0], sums);
    add_edge<0, 2, 1, 3>(s, facets, l[1], r01[1], sums);
    add_edge<0, 3, 1, 2>(s, facets, l[2], r23[0], sums);
    add_edge<1, 2, 0, 3>(s, facets, l[3], r23[1], sums);
    add_edge<1, 3, 0, 2>(s, facets, l[4], r45[0], sums);
    add_edge<2, 3, 0, 1>(s, facets, l[5], r45[1], sums);
    return sums;
}

[[gnu::always_inline]] inline Lanes loaded(const BlockRow& row, int k) {
    Lanes number;
    std::memcpy(&number, &row[k], sizeof number);
    return number;
}

[[gnu::always_inline]] inline void keep(const Lanes& number, BlockRow& row, int k) {
    std::memcpy(&row[k], &number, sizeof number);
}

/// Stores contributions from number k of a block on.
template <bool with_moments>
[[gnu::always_inline]] inline void store_sums(const PowerSumsOf<with_moments>& sums, int k,
                                              PowerBlock& block) {
    for (int c = 0; c < 4; ++c) keep((1.0 / 3) * sums.volume[c], block.volume[c], k);
    for (int e = 0; e < 6; ++e) keep(sums.conductance[e], block.conductance[e], k);
    if constexpr (with_moments) {
        keep((1.0 / 60) * sums.value, block.value, k);
        for (int c = 0; c < 4; ++c) {
            keep((-1.0 / 12) * sums.moment[c].x, block.gradient[c][0], k);
            keep((-1.0 / 12) * sums.moment[c].y, block.gradient[c][1], k);
            keep((-1.0 / 12) * sums.moment[c].z, block.gradient[c][2], k);
        }
    }
}

template <bool with_moments>
[[gnu::always_inline]] inline void compute_block(PowerBlock& block, const Frame& frame) {
    for (int k = 0; k < PowerBlock::kSize; k += kLanes) {
        std::array<Arrow, 4> p{};
        for (int c = 0; c < 3; ++c) {
            const auto u = loaded(block.corner[c][0], k);
            const auto v = loaded(block.corner[c][1], k);
            const auto w = loaded(block.corner[c][2], k);
            p[c + 1] = {frame.ax * u + frame.bx * v + frame.cx * w, frame.by * v + frame.cy * w,
                        frame.cz * w};
        }
        std::array<Lanes, 4> weight;
        for (int c = 0; c < 4; ++c) weight[c] = loaded(block.weight[c], k);
        std::array<Arrow, 6> edge;
        for (int e = 0; e < 6; ++e) {
            const auto [i, j] = PowerBlock::kEdges[e];
            edge[e] = p[j] - p[i];
        }
        const WeightedShape shape = weighted_shape(p, weight, edge);
        Lanes least = shape.thick;
        for (int c = 0; c < 4; ++c) {
            const Lanes above = shape.height[c] - shape.rounding;
            keep(above, block.height[c], k);
            least = lesser(least, above);
        }
        keep(shape.thick, block.thick, k);
        keep(least, block.certain, k);
        store_sums(power_sums<with_moments>(shape), k, block);
    }
}

}  // namespace

PCVT_TARGET_CLONES void PowerBlock::compute(const Frame& frame) {
    compute_block<false>(*this, frame);
}

PCVT_TARGET_CLONES void PowerBlock::compute_moments(const Frame& frame) {
    compute_block<true>(*this, frame);
}

void PowerBlock::correct(int k, const Frame& frame) {
    std::array<Vec3, 3> at;
    std::array<double, 4> weights;
    for (int c = 0; c < 3; ++c) at[c] = {corner[c][0][k], corner[c][1][k], corner[c][2][k]};
    for (int c = 0; c < 4; ++c) weights[c] = weight[c][k];
    const ThinTerms terms = thin_terms(at, weights, frame);
    for (int c = 0; c < 4; ++c) {
        volume[c][k] = terms.volume[c];
        for (int axis = 0; axis < 3; ++axis) gradient[c][axis][k] = terms.gradient[c][axis];
        height[c][k] = -std::numeric_limits<double>::infinity();
    }
    for (int e = 0; e < 6; ++e) conductance[e][k] = terms.conductance[e];
    value[k] = terms.value;
}

}  // namespace pcvt::space
