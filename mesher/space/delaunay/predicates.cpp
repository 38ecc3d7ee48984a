#include "mesher/space/delaunay/predicates.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "mesher/space/delaunay/power_distance.hpp"
#include "mesher/space/delaunay/power_predicates.hpp"
#include "mesher/space/geometry/wide_integer.hpp"

namespace pcvt::space {
namespace {

/// A difference has 54 bits and a determinant of three of them 165. The Gram matrix has at most 101
/// bits (its largest entry is below 2^41), a squared length 213, and their product 380. Weights
/// below 2^43 are multiples of 2^-100, so that a height has no more bits.
using Determinant = WideInteger<3>;
using SquaredLength = WideInteger<4>;
using Product = WideInteger<6>;

/// Error bounds in units of the product of the largest entries of each column. Differences are
/// exact; a determinant adds 6 products, each with at most 5 roundings on its way, and in_sphere 4
/// products of such a determinant with a height, which has 7 more. Both are rounded up.
constexpr double kOrientationError = 64 * 0x1p-53;
constexpr double kInSphereError = 1024 * 0x1p-53;
/// The unit in which the Gram matrix is an integer.
constexpr double kGramGrid = 0x1p60;
/// Products below this may have lost bits to underflow.
constexpr double kSmallestBound = 1e-290;

int sign(double x) { return (x > 0) - (x < 0); }

template <class Number>
Components<Number> cross(const Components<Number>& p, const Components<Number>& q) {
    return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}

template <class Number>
Number determinant(const Components<Number>& p, const Components<Number>& q,
                   const Components<Number>& r) {
    return p.x * (q.y * r.z - q.z * r.y) + p.y * (q.z * r.x - q.x * r.z) +
           p.z * (q.x * r.y - q.y * r.x);
}

Displacement difference(const Image& from, const Image& to) {
    return {to.at.x() - from.at.x(), to.at.y() - from.at.y(), to.at.z() - from.at.z()};
}

Determinant integer(double difference) {
    return Determinant(static_cast<std::int64_t>(difference * kGrid));
}

Components<Determinant> integers(const Displacement& d) {
    return {integer(d.x), integer(d.y), integer(d.z)};
}

/// A multiple of 2^-bits with at most 53 digits, times 2^bits, below 2^177.
SquaredLength scaled_integer(double number, int bits) {
    int exponent = 0;
    const double mantissa = std::frexp(number, &exponent);
    const int shift = std::max(exponent - 53 + bits, 0);
    const double digits = std::ldexp(mantissa, exponent + bits - shift);
    const SquaredLength low(static_cast<std::int64_t>(digits));
    const SquaredLength scaled = low * SquaredLength(std::int64_t{1} << std::min(shift, 62));
    return shift <= 62 ? scaled : scaled * SquaredLength(std::int64_t{1} << (shift - 62));
}

SquaredLength gram_integer(double entry) { return scaled_integer(entry, 60); }

/// The difference of two weights, times 2^160.
SquaredLength weight_difference(double of, double from) {
    const auto number = [](double w) { return scaled_integer(w, kWeightBits); };
    return (number(of) - number(from)) * SquaredLength(std::int64_t{1} << (160 - kWeightBits));
}

/// The squared length of a difference, times 2^160.
SquaredLength squared_length(const Gram& g, const Displacement& d) {
    const auto number = [](double x) {
        return SquaredLength(static_cast<std::int64_t>(x * kGrid));
    };
    const SquaredLength x = number(d.x);
    const SquaredLength y = number(d.y);
    const SquaredLength z = number(d.z);
    const SquaredLength two(2);
    return x * (gram_integer(g.aa) * x + two * (gram_integer(g.ab) * y + gram_integer(g.ac) * z)) +
           y * (gram_integer(g.bb) * y + two * (gram_integer(g.bc) * z)) +
           gram_integer(g.cc) * z * z;
}

Displacement largest(const Displacement& s, const Displacement& t) {
    return {std::max(s.x, std::abs(t.x)), std::max(s.y, std::abs(t.y)),
            std::max(s.z, std::abs(t.z))};
}

/// @param height  of the displacements, times 2^160.
int exact_in_sphere(const std::array<Displacement, 4>& d,
                    const std::array<SquaredLength, 4>& height) {
    const std::array<Components<Determinant>, 4> e{integers(d[0]), integers(d[1]), integers(d[2]),
                                                   integers(d[3])};
    const auto term = [&](int k, const Determinant& minor) {
        return Product(height[k]) * Product(minor);
    };
    const Product value =
        term(0, determinant(e[1], e[2], e[3])) - term(1, determinant(e[0], e[2], e[3])) +
        term(2, determinant(e[0], e[1], e[3])) - term(3, determinant(e[0], e[1], e[2]));
    return value.sign();
}

/// The coordinates of a point without that of an axis, in cyclic order.
std::array<double, 2> projected(int axis, const Displacement& d) {
    if (axis == 0) return {d.y, d.z};
    if (axis == 1) return {d.z, d.x};
    return {d.x, d.y};
}

Determinant projected_cross(int axis, const Displacement& d, const Displacement& e) {
    const auto p = projected(axis, d);
    const auto q = projected(axis, e);
    return integer(p[0]) * integer(q[1]) - integer(p[1]) * integer(q[0]);
}

/// G^-1 v.
Vec3 divided(const Gram& gram, const Vec3& v) {
    const Vec3 rows[3] = {
        {gram.aa, gram.ab, gram.ac}, {gram.ab, gram.bb, gram.bc}, {gram.ac, gram.bc, gram.cc}};
    const Vec3 yz = rows[1].cross(rows[2]);
    return (v.x() * yz + v.y() * rows[2].cross(rows[0]) + v.z() * rows[0].cross(rows[1])) /
           rows[0].dot(yz);
}

}  // namespace

double gram_unit(const Lattice& reduced) {
    int exponent = 0;
    std::frexp(reduced.a().norm(), &exponent);
    return std::ldexp(1.0, exponent);
}

Gram gram_of(const Lattice& reduced) {
    const double unit = gram_unit(reduced);
    const auto entry = [unit](const Vec3& p, const Vec3& q) {
        const double product = (p / unit).dot(q / unit);
        return std::nearbyint(product * kGramGrid) / kGramGrid;
    };
    const auto& [a, b, c] = reduced.periods();
    return {entry(a, a), entry(a, b), entry(a, c), entry(b, b), entry(b, c), entry(c, c)};
}

double in_sphere_rounding(const Gram& gram, const Displacement& most) {
    const auto& [x, y, z] = most;
    const Gram g{gram.aa, std::abs(gram.ab), std::abs(gram.ac),
                 gram.bb, std::abs(gram.bc), gram.cc};
    return kInSphereError * x * y * z * g.squared_length(x, y, z) + kSmallestBound;
}

double determinant_rounding(const Displacement& most) {
    return kOrientationError * most.x * most.y * most.z;
}

int orientation(const Image& p, const Image& q, const Image& r, const Image& s) {
    const auto d = difference(p, q);
    const auto e = difference(p, r);
    const auto f = difference(p, s);
    const double value = determinant(d, e, f);
    const auto scale = largest(largest(largest({0, 0, 0}, d), e), f);
    const double bound = determinant_rounding(scale);
    if (std::abs(value) > bound) return sign(value);
    if (bound == 0) return 0;
    return determinant(integers(d), integers(e), integers(f)).sign();
}

int in_sphere(const Gram& gram, const Image& p, const Image& q, const Image& r, const Image& s,
              const Image& t) {
    const std::array<Displacement, 4> d{difference(t, p), difference(t, q), difference(t, r),
                                        difference(t, s)};
    const auto height = [&](int k) { return gram.squared_length(d[k].x, d[k].y, d[k].z); };
    const double value = in_sphere_determinant(d, {height(0), height(1), height(2), height(3)});
    const auto m = largest(largest(largest(largest({0, 0, 0}, d[0]), d[1]), d[2]), d[3]);
    if (std::abs(value) > in_sphere_rounding(gram, m)) return sign(value);
    return exact_in_sphere(d, {squared_length(gram, d[0]), squared_length(gram, d[1]),
                               squared_length(gram, d[2]), squared_length(gram, d[3])});
}

int in_power_sphere(const Gram& gram, const WeightedImage& p, const WeightedImage& q,
                    const WeightedImage& r, const WeightedImage& s, const WeightedImage& t) {
    const std::array<Displacement, 4> d{difference(t.at, p.at), difference(t.at, q.at),
                                        difference(t.at, r.at), difference(t.at, s.at)};
    const std::array<double, 4> weight{p.weight, q.weight, r.weight, s.weight};
    std::array<double, 4> height;
    Displacement m{0, 0, 0};
    double largest_difference = 0;
    for (int k = 0; k < 4; ++k) {
        const double w = weight[k] - t.weight;
        height[k] = gram.squared_length(d[k].x, d[k].y, d[k].z) - w;
        m = largest(m, d[k]);
        largest_difference = std::max(largest_difference, std::abs(w));
    }
    const double value = in_sphere_determinant(d, height);
    const double bound =
        in_sphere_rounding(gram, m) + kInSphereError * m.x * m.y * m.z * largest_difference;
    if (std::abs(value) > bound) return sign(value);
    const auto exact_height = [&](int k) {
        return squared_length(gram, d[k]) - weight_difference(weight[k], t.weight);
    };
    return exact_in_sphere(d, {exact_height(0), exact_height(1), exact_height(2), exact_height(3)});
}

namespace {

/// The rule of violates_delaunay() for ties.
bool tie_violates(const Image& p, const Image& q, const Image& r, const Image& s, const Image& t) {
    // The greatest point whose perturbation changes the determinant decides.
    std::array<const Image*, 5> order{&p, &q, &r, &s, &t};
    std::sort(order.begin(), order.end(), [](const Image* one, const Image* other) {
        return is_lexicographically_less(*other, *one);
    });
    for (const Image* const point : order) {
        if (point == &t) return false;
        const auto or_t = [&](const Image& corner) -> const Image& {
            return &corner == point ? t : corner;
        };
        const int turn = orientation(or_t(p), or_t(q), or_t(r), or_t(s));
        if (turn != 0) return turn > 0;
    }
    return false;
}

}  // namespace

bool violates_delaunay(const Gram& gram, const Image& p, const Image& q, const Image& r,
                       const Image& s, const Image& t) {
    const int side = in_sphere(gram, p, q, r, s, t);
    return side != 0 ? side > 0 : tie_violates(p, q, r, s, t);
}

bool violates_regularity(const Gram& gram, const WeightedImage& p, const WeightedImage& q,
                         const WeightedImage& r, const WeightedImage& s, const WeightedImage& t) {
    const int side = in_power_sphere(gram, p, q, r, s, t);
    return side != 0 ? side > 0 : tie_violates(p.at, q.at, r.at, s.at, t.at);
}

int in_coplanar_circle(const Gram& gram, const Image& p, const Image& q, const Image& r,
                       const Image& t) {
    int axis = 2;
    while (axis > 0 && projected_orientation(axis, p, q, r) == 0) --axis;
    const std::array<Displacement, 3> d{difference(t, p), difference(t, q), difference(t, r)};
    const auto term = [&](int k, int l, int m) {
        return Product(squared_length(gram, d[k])) * Product(projected_cross(axis, d[l], d[m]));
    };
    const Product value = term(0, 1, 2) + term(1, 2, 0) + term(2, 0, 1);
    return value.sign() * projected_orientation(axis, p, q, r);
}

int projected_orientation(int axis, const Image& p, const Image& q, const Image& r) {
    return projected_cross(axis, difference(p, q), difference(p, r)).sign();
}

Vec3 circumcentre(const Gram& gram, const Image& p, const Image& q, const Image& r,
                  const Image& s) {
    const std::array<Vec3, 3> d{q.at - p.at, r.at - p.at, s.at - p.at};
    // Solve 2 d_k . G c = |d_k|^2 for G c, then for c.
    const Vec3 first = d[1].cross(d[2]);
    const double twice_det = 2 * d[0].dot(first);
    const auto height = [&](int k) { return gram.squared_length(d[k].x(), d[k].y(), d[k].z()); };
    return divided(
        gram, (height(0) * first + height(1) * d[2].cross(d[0]) + height(2) * d[0].cross(d[1])) /
                  twice_det);
}

namespace {

/// The point c with 2 d_k . c = height k for k = 0, 1, 2.
/// @param height  times 2^160.
Vec3 exact_centre(const Gram& gram, const std::array<Displacement, 3>& edge,
                  const std::array<SquaredLength, 3>& height) {
    const std::array<Components<Determinant>, 3> e{integers(edge[0]), integers(edge[1]),
                                                   integers(edge[2])};
    std::array<Product, 3> sum{Product(0), Product(0), Product(0)};
    for (int k = 0; k < 3; ++k) {
        const Product times(height[k]);
        const auto minor = cross(e[(k + 1) % 3], e[(k + 2) % 3]);
        sum[0] = sum[0] + times * Product(minor.x);
        sum[1] = sum[1] + times * Product(minor.y);
        sum[2] = sum[2] + times * Product(minor.z);
    }
    // The sums are multiples of 2^-260, the determinant of 2^-150.
    const double twice_det = 2 * determinant(e[0], e[1], e[2]).rounded();
    const auto quotient = [&](int k) { return std::ldexp(sum[k].rounded() / twice_det, -110); };
    return divided(gram, {quotient(0), quotient(1), quotient(2)});
}

std::array<Displacement, 3> displacements(const std::array<Vec3, 3>& d) {
    const auto vector = [](const Vec3& p) { return Displacement{p.x(), p.y(), p.z()}; };
    return {vector(d[0]), vector(d[1]), vector(d[2])};
}

}  // namespace

Vec3 exact_circumcentre(const Gram& gram, const std::array<Vec3, 3>& d) {
    const auto edge = displacements(d);
    return exact_centre(gram, edge,
                        {squared_length(gram, edge[0]), squared_length(gram, edge[1]),
                         squared_length(gram, edge[2])});
}

Vec3 exact_orthocentre(const Gram& gram, const std::array<Vec3, 3>& d,
                       const std::array<double, 4>& weight) {
    const auto edge = displacements(d);
    const auto height = [&](int k) {
        return squared_length(gram, edge[k]) - weight_difference(weight[k + 1], weight[0]);
    };
    return exact_centre(gram, edge, {height(0), height(1), height(2)});
}

int compare_power_distances(const Gram& gram, const SeenImage& p, const SeenImage& q) {
    const auto square = [&gram](const Vec3& d) {
        return squared_length(gram, {d.x(), d.y(), d.z()});
    };
    return (square(p.displacement) - square(q.displacement) - weight_difference(p.weight, q.weight))
        .sign();
}

}  // namespace pcvt::space
