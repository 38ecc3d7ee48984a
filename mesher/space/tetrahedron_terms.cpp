#include "mesher/space/tetrahedron_terms.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "mesher/base/target_clones.hpp"

namespace pcvt {
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

/// A facet: four times its w of the edges (space_energy.hpp), and its circumcentre.
struct Facet {
    double value;
    std::array<double, 3> w;
    Vector centre;
};

/// @param height     q |N|^2.
/// @param per_nn     1 / |N|^2.
/// @param length     the squared lengths of the facet's edges.
/// @param cosine     D of the edges: the dot product at the corner opposite to each.
inline Facet facet_terms(const Vector& normal, double height, double nn,
                         const std::array<double, 3>& length, const std::array<double, 3>& cosine,
                         const Vector& centre) {
    const double per_nn = 1 / nn;
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

}  // namespace

SpaceFrame::SpaceFrame(const SpaceLattice& reduced, double unit) {
    const Vec3 a = reduced.a() / unit;
    const Vec3 b = reduced.b() / unit;
    const Vec3 c = reduced.c() / unit;
    ax = a.norm();
    bx = a.dot(b) / ax;
    const Vec3 ab = a.cross(b);
    by = ab.norm() / ax;
    cx = a.dot(c) / ax;
    cy = ab.cross(a).dot(c) / (ab.norm() * ax);
    cz = ab.dot(c) / ab.norm();
}

// One loop body, so that the compiler keeps all terms in registers of several tetrahedra.
// NOLINTNEXTLINE(readability-function-size)
PCVT_TARGET_CLONES void TetrahedronBlock::compute(const SpaceFrame& frame) {
    const SpaceFrame f = frame;
    for (int k = 0; k < kSize; ++k) {
        // Compute the edges in the frame.
        const auto edge = [&](int c) -> Vector {
            const double u = corner[c][0][k];
            const double v = corner[c][1][k];
            const double w = corner[c][2][k];
            return {f.ax * u + f.bx * v + f.cx * w, f.by * v + f.cy * w, f.cz * w};
        };
        const Vector p1 = edge(0);
        const Vector p2 = edge(1);
        const Vector p3 = edge(2);
        const Vector p12 = p2 - p1;
        const Vector p13 = p3 - p1;
        const Vector p23 = p3 - p2;
        // Compute the normals of the facets, inwards, and the circumcentre.
        const Vector n1 = cross(p2, p3);
        const Vector n2 = cross(p3, p1);
        const Vector n3 = cross(p1, p2);
        const Vector n0 = cross(p13, p12);
        const double det = dot(p1, n1);
        const double l1 = dot(p1, p1);
        const double l2 = dot(p2, p2);
        const double l3 = dot(p3, p3);
        const double per_det = 1 / det;
        const Vector c = (0.5 * per_det) * (l1 * n1 + l2 * n2 + l3 * n3);
        // Compute the heights of the circumcentre above the facets, times |N|.
        const double h1 = dot(c, n1);
        const double h2 = dot(c, n2);
        const double h3 = dot(c, n3);
        const double h0 = dot(c - p1, n0);
        const double longest = std::max(std::max(l1, l2), l3);
        const double cube = longest * longest * longest;
        thick[k] = det * std::abs(det) - kThin * kThin * cube;
        const double rounding = kHeightError * cube * std::abs(per_det);
        inside[0][k] = h0 - rounding;
        inside[1][k] = h1 - rounding;
        inside[2][k] = h2 - rounding;
        inside[3][k] = h3 - rounding;
        // Compute the terms of the facets; edges in the order in which the comments name them.
        const double l12 = dot(p12, p12);
        const double l13 = dot(p13, p13);
        const double l23 = dot(p23, p23);
        const double d1 = dot(p2, p3);
        const double d2 = dot(p1, p3);
        const double d3 = dot(p1, p2);
        // 01, 02, 12
        const Facet f3 =
            facet_terms(n3, h3, dot(n3, n3), {l1, l2, l12}, {dot(p2, p12), -dot(p1, p12), d3}, c);
        // 01, 03, 13
        const Facet f2 =
            facet_terms(n2, h2, dot(n2, n2), {l1, l3, l13}, {dot(p3, p13), -dot(p1, p13), d2}, c);
        // 02, 03, 23
        const Facet f1 =
            facet_terms(n1, h1, dot(n1, n1), {l2, l3, l23}, {dot(p3, p23), -dot(p2, p23), d1}, c);
        // 12, 13, 23
        const Facet f0 = facet_terms(n0, h0, dot(n0, n0), {l12, l13, l23},
                                     {dot(p13, p23), -dot(p12, p23), dot(p12, p13)}, c);
        value[k] = (1.0 / 120) * ((f0.value + f1.value) + (f2.value + f3.value));
        // Sum the weights by edge, and by corner and facet.
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
        volume[0][k] = (1.0 / 24) * w0;
        volume[1][k] = (1.0 / 24) * w1;
        volume[2][k] = (1.0 / 24) * w2;
        volume[3][k] = (1.0 / 24) * w3;
        // Sum the moments w (m + Phi + C - 3 p) at each corner.
        const Vector m01 = (0.5 * w01) * p1;
        const Vector m02 = (0.5 * w02) * p2;
        const Vector m03 = (0.5 * w03) * p3;
        const Vector m12 = (0.5 * w12) * (p1 + p2);
        const Vector m13 = (0.5 * w13) * (p1 + p3);
        const Vector m23 = (0.5 * w23) * (p2 + p3);
        const Vector g0 = (m01 + m02 + m03) + (f3.w[0] + f3.w[1]) * f3.centre +
                          (f2.w[0] + f2.w[1]) * f2.centre + (f1.w[0] + f1.w[1]) * f1.centre +
                          w0 * c;
        const Vector g1 = (m01 + m12 + m13) + (f3.w[0] + f3.w[2]) * f3.centre +
                          (f2.w[0] + f2.w[2]) * f2.centre + (f0.w[0] + f0.w[1]) * f0.centre +
                          w1 * (c - 3 * p1);
        const Vector g2 = (m02 + m12 + m23) + (f3.w[1] + f3.w[2]) * f3.centre +
                          (f1.w[0] + f1.w[2]) * f1.centre + (f0.w[0] + f0.w[2]) * f0.centre +
                          w2 * (c - 3 * p2);
        const Vector g3 = (m03 + m13 + m23) + (f2.w[1] + f2.w[2]) * f2.centre +
                          (f1.w[1] + f1.w[2]) * f1.centre + (f0.w[1] + f0.w[2]) * f0.centre +
                          w3 * (c - 3 * p3);
        const auto store = [&](int at, const Vector& g) {
            gradient[at][0][k] = (-1.0 / 48) * g.x;
            gradient[at][1][k] = (-1.0 / 48) * g.y;
            gradient[at][2][k] = (-1.0 / 48) * g.z;
        };
        store(0, g0);
        store(1, g1);
        store(2, g2);
        store(3, g3);
    }
}

}  // namespace pcvt
