#include "mesher/space/energy/tetrahedron_terms.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "mesher/base/target_clones.hpp"

namespace pcvt::space {
namespace {

/// A tetrahedron is thin if its determinant is below this fraction of the third power of its
/// largest edge at corner 0.
constexpr double kThin = 0x1p-20;
/// A height is a polynomial of degree 6 in the edges, divided by the determinant. Its rounding
/// stays below some 100 units of the largest term, 2^-46 of the sixth power of the largest edge at
/// corner 0; here rounded up.
constexpr double kHeightError = 0x1p-42;

struct Vector {
    double x;
    double y;
    double z;
};

inline Vector operator+(const Vector& a, const Vector& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector operator-(const Vector& a, const Vector& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector operator*(double s, const Vector& a) { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector cross(const Vector& a, const Vector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// A facet: four times its w of the edges (energy.hpp), and its circumcentre.
struct Facet {
    double value;
    std::array<double, 3> w;
    Vector centre;
};

/// @param height     q |N|^2.
/// @param per_nn     1 / |N|^2.
/// @param length     the squared lengths of the facet's edges.
/// @param cosine     D of the edges: the dot product at the corner opposite to each.
[[gnu::always_inline]] inline Facet facet_terms(const Vector& normal, double height, double per_nn,
                                                const std::array<double, 3>& length,
                                                const std::array<double, 3>& cosine,
                                                const Vector& centre) {
    const double q = height * per_nn;
    Facet facet{0, {}, centre - q * normal};
    const double hh = q * height;
    for (int e = 0; e < 3; ++e) {
        const double ld = length[e] * cosine[e];
        facet.w[e] = ld * q;
        facet.value += facet.w[e] * (1.5 * length[e] + 0.75 * ld * cosine[e] * per_nn + hh);
    }
    return facet;
}

/// A tetrahedron 0123 with corner 0 at the origin.
struct Shape {
    Vector p1, p2, p3;
    Vector p12, p13, p23;
    /// The normals of the facets opposite to the corners, inwards.
    std::array<Vector, 4> normal;
    Vector centre;
    /// The heights of the circumcentre above the facets, times |N|, and a bound of their rounding.
    std::array<double, 4> height;
    double rounding;
    /// The squared lengths of the edges at corner 0.
    double l1, l2, l3;
    double thick;
};

[[gnu::always_inline]] inline std::array<double, 4> heights(const Shape& s) {
    return {dot(s.centre - s.p1, s.normal[0]), dot(s.centre, s.normal[1]),
            dot(s.centre, s.normal[2]), dot(s.centre, s.normal[3])};
}

[[gnu::always_inline]] inline Shape shape_of(const Vector& p1, const Vector& p2, const Vector& p3) {
    Shape s{p1, p2, p3, p2 - p1, p3 - p1, p3 - p2, {}, {}, {}, 0, 0, 0, 0, 0};
    s.normal = {cross(s.p13, s.p12), cross(p2, p3), cross(p3, p1), cross(p1, p2)};
    const double det = dot(p1, s.normal[1]);
    s.l1 = dot(p1, p1);
    s.l2 = dot(p2, p2);
    s.l3 = dot(p3, p3);
    const double per_det = 1 / det;
    s.centre = (0.5 * per_det) * (s.l1 * s.normal[1] + s.l2 * s.normal[2] + s.l3 * s.normal[3]);
    s.height = heights(s);
    const double longest = std::max(std::max(s.l1, s.l2), s.l3);
    const double cube = longest * longest * longest;
    s.thick = det * std::abs(det) - kThin * kThin * cube;
    s.rounding = kHeightError * cube * std::abs(per_det);
    return s;
}

/// The facets opposite to the corners. Their edges are, in order: 12, 13, 23; 02, 03, 23;
/// 01, 03, 13; 01, 02, 12.
[[gnu::always_inline]] inline std::array<Facet, 4> facets_of(const Shape& s) {
    const double l12 = dot(s.p12, s.p12);
    const double l13 = dot(s.p13, s.p13);
    const double l23 = dot(s.p23, s.p23);
    std::array<double, 4> per_nn;
    for (int c = 0; c < 4; c += 2) {
        // A division takes more time than three products.
        const double one = dot(s.normal[c], s.normal[c]);
        const double other = dot(s.normal[c + 1], s.normal[c + 1]);
        const double per_both = 1 / (one * other);
        per_nn[c] = other * per_both;
        per_nn[c + 1] = one * per_both;
    }
    const auto facet = [&](int c, const std::array<double, 3>& length,
                           const std::array<double, 3>& cosine) {
        return facet_terms(s.normal[c], s.height[c], per_nn[c], length, cosine, s.centre);
    };
    return {facet(0, {l12, l13, l23}, {dot(s.p13, s.p23), -dot(s.p12, s.p23), dot(s.p12, s.p13)}),
            facet(1, {s.l2, s.l3, l23}, {dot(s.p3, s.p23), -dot(s.p2, s.p23), dot(s.p2, s.p3)}),
            facet(2, {s.l1, s.l3, l13}, {dot(s.p3, s.p13), -dot(s.p1, s.p13), dot(s.p1, s.p3)}),
            facet(3, {s.l1, s.l2, l12}, {dot(s.p2, s.p12), -dot(s.p1, s.p12), dot(s.p1, s.p2)})};
}

/// The sums of the weights w, and of the moments w (m + Phi + C - 3 p), at each corner.
struct CornerSums {
    std::array<double, 4> weight;
    std::array<Vector, 4> moment;
};

[[gnu::always_inline]] inline CornerSums corner_sums(const Shape& s,
                                                     const std::array<Facet, 4>& facets) {
    const auto& [f0, f1, f2, f3] = facets;
    const double w01 = f3.w[0] + f2.w[0];
    const double w02 = f3.w[1] + f1.w[0];
    const double w03 = f2.w[1] + f1.w[1];
    const double w12 = f3.w[2] + f0.w[0];
    const double w13 = f2.w[2] + f0.w[1];
    const double w23 = f1.w[2] + f0.w[2];
    const double w0 = w01 + w02 + w03;
    const double w1 = w01 + w12 + w13;
    const double w2 = w02 + w12 + w23;
    const double w3 = w03 + w13 + w23;
    const Vector m01 = (0.5 * w01) * s.p1;
    const Vector m02 = (0.5 * w02) * s.p2;
    const Vector m03 = (0.5 * w03) * s.p3;
    const Vector m12 = (0.5 * w12) * (s.p1 + s.p2);
    const Vector m13 = (0.5 * w13) * (s.p1 + s.p3);
    const Vector m23 = (0.5 * w23) * (s.p2 + s.p3);
    return {{w0, w1, w2, w3},
            {(m01 + m02 + m03) + (f3.w[0] + f3.w[1]) * f3.centre + (f2.w[0] + f2.w[1]) * f2.centre +
                 (f1.w[0] + f1.w[1]) * f1.centre + w0 * s.centre,
             (m01 + m12 + m13) + (f3.w[0] + f3.w[2]) * f3.centre + (f2.w[0] + f2.w[2]) * f2.centre +
                 (f0.w[0] + f0.w[1]) * f0.centre + w1 * (s.centre - 3 * s.p1),
             (m02 + m12 + m23) + (f3.w[1] + f3.w[2]) * f3.centre + (f1.w[0] + f1.w[2]) * f1.centre +
                 (f0.w[0] + f0.w[2]) * f0.centre + w2 * (s.centre - 3 * s.p2),
             (m03 + m13 + m23) + (f2.w[1] + f2.w[2]) * f2.centre + (f1.w[1] + f1.w[2]) * f1.centre +
                 (f0.w[1] + f0.w[2]) * f0.centre + w3 * (s.centre - 3 * s.p3)}};
}

/// Stores the contributions of a tetrahedron as number k of a block.
[[gnu::always_inline]] inline void store(const Shape& shape, int k, TetrahedronBlock& block) {
    const auto facets = facets_of(shape);
    block.value[k] =
        (1.0 / 120) * ((facets[0].value + facets[1].value) + (facets[2].value + facets[3].value));
    const CornerSums sums = corner_sums(shape, facets);
    for (int c = 0; c < 4; ++c) {
        block.terms[c][0][k] = (-1.0 / 48) * sums.moment[c].x;
        block.terms[c][1][k] = (-1.0 / 48) * sums.moment[c].y;
        block.terms[c][2][k] = (-1.0 / 48) * sums.moment[c].z;
        block.terms[c][3][k] = (1.0 / 24) * sums.weight[c];
    }
}

Vector vector(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

}  // namespace

PCVT_TARGET_CLONES void TetrahedronBlock::compute(const Frame& frame) {
    const Frame f = frame;
    for (int k = 0; k < kSize; ++k) {
        const auto edge = [&](int c) -> Vector {
            const double u = corner[c][0][k];
            const double v = corner[c][1][k];
            const double w = corner[c][2][k];
            return {f.ax * u + f.bx * v + f.cx * w, f.by * v + f.cy * w, f.cz * w};
        };
        const Shape shape = shape_of(edge(0), edge(1), edge(2));
        thick[k] = shape.thick;
        std::array<double, 4> above;
        for (int c = 0; c < 4; ++c) above[c] = shape.height[c] - shape.rounding;
        for (int c = 0; c < 4; ++c) height[c][k] = above[c];
        // A difference after the minimum would become a branch, and the loop could not be
        // vectorised.
        const double least = std::min(std::min(above[0], above[1]), std::min(above[2], above[3]));
        certain[k] = std::min(least, shape.thick);
        store(shape, k, *this);
    }
}

void TetrahedronBlock::correct(int k, const Frame& frame) {
    std::array<Vec3, 3> d;
    std::array<Vector, 3> edge;
    for (int c = 0; c < 3; ++c) {
        d[c] = {corner[c][0][k], corner[c][1][k], corner[c][2][k]};
        edge[c] = vector(frame.to_position(d[c]));
    }
    Shape shape = shape_of(edge[0], edge[1], edge[2]);
    shape.p12 = vector(frame.to_position(d[1] - d[0]));
    shape.p13 = vector(frame.to_position(d[2] - d[0]));
    shape.p23 = vector(frame.to_position(d[2] - d[1]));
    shape.normal[0] = cross(shape.p13, shape.p12);
    shape.centre = vector(frame.to_position(exact_circumcentre(frame.gram, d)));
    shape.height = heights(shape);
    store(shape, k, *this);
    for (auto& row : height) row[k] = -std::numeric_limits<double>::infinity();
}

}  // namespace pcvt::space
