#include "mesher/plane/energy/triangle_terms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesher/base/target_clones.hpp"
#include "mesher/plane/delaunay/predicates.hpp"

namespace pcvt::plane {
namespace {

/// A triangle is thin if its cross product is below this fraction of its rounding scale.
constexpr double kThin = 0x1p-10;
/// An angle counts as acute only if its cosine is certainly positive.
constexpr double kRightAngle = 1e-14;
/// The ratio of l c / 8 to w = -l c / 12.
constexpr double kMassPerWeight = -1.5;

Vec2 turned(const Vec2& d) { return {-d.y(), d.x()}; }

}  // namespace

TriangleTerms triangle_terms(const Vec2& p, const Vec2& q, const ReducedFrame& frame) {
    const std::array<Vec2, 3> side{p, q - p, -q};
    const std::array<Vec2, 3> d{frame.to_position(side[0]), frame.to_position(side[1]),
                                frame.to_position(side[2])};
    // Choose the cross product with the least rounding: all three are equal in exact arithmetic,
    // and the two shortest sides round least.
    double cross = 0;
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
        const double bound = detail::cross_bound(side[k], side[(k + 1) % 3]);
        if (bound < least) {
            least = bound;
            cross = detail::cross(side[k], side[(k + 1) % 3]);
        }
    }
    const double per_area = 1 / (cross * frame.ax * frame.by);

    // Add the terms of each side (energy.hpp).
    TriangleTerms terms;
    for (int k = 0; k < 3; ++k) {
        const int m = (k + 1) % 3;
        const double l = d[k].squaredNorm();
        const double c = -d[m].dot(d[(k + 2) % 3]) * per_area;
        const double w = -l * c / 12;
        const Vec2 along = w * d[k];
        const Vec2 across = (w * c / 2) * turned(d[k]);
        terms.gradient[k] += along + across;
        terms.gradient[m] += across - along;
        terms.mass[k] += w * kMassPerWeight;
        terms.mass[m] += w * kMassPerWeight;
        const double part = -w * l * (3 + c * c) / 8;
        terms.value += part;
        terms.largest_part = std::max(terms.largest_part, std::abs(part));
        terms.steepest = std::max(terms.steepest, std::abs(c));
    }
    return terms;
}

void TriangleBlock::gather(const TorusTriangulation& triangulation, const Points& coordinates,
                           int first, int n) {
    const SiteId* site = triangulation.corner_sites().data() + 3 * std::size_t(first);
    const CornerOffsets* offsets = triangulation.corner_offsets().data() + first;
    const double* u = coordinates.data();
    // Compute corners 1 and 2 relative to corner 0.
    for (int k = 0; k < n; ++k, site += 3) {
        const double* p0 = u + 2 * std::size_t(site[0]);
        const double* p1 = u + 2 * std::size_t(site[1]);
        const double* p2 = u + 2 * std::size_t(site[2]);
        pu[k] = p1[0] - p0[0];
        pv[k] = p1[1] - p0[1];
        qu[k] = p2[0] - p0[0];
        qv[k] = p2[1] - p0[1];
        if (!offsets[k].all_zero()) {
            pu[k] += offsets[k].i1;
            pv[k] += offsets[k].j1;
            qu[k] += offsets[k].i2;
            qv[k] += offsets[k].j2;
        }
    }
    // Fill up an incomplete block with triangles that cause no division by zero.
    for (int k = n; k < kSize; ++k) {
        pu[k] = qv[k] = 1;
        pv[k] = qu[k] = 0;
    }
}

PCVT_TARGET_CLONES void TriangleBlock::compute(const ReducedFrame& frame) {
    const double ax = frame.ax;
    const double bx = frame.bx;
    const double by = frame.by;
    const double area = ax * by;
    for (int k = 0; k < kSize; ++k) {
        // Compute the sides in the frame.
        const double ru = qu[k] - pu[k];
        const double rv = qv[k] - pv[k];
        const double px = ax * pu[k] + bx * pv[k];
        const double py = by * pv[k];
        const double qx = ax * qu[k] + bx * qv[k];
        const double qy = by * qv[k];
        const double rx = ax * ru + bx * rv;
        const double ry = by * rv;
        // Measure the thickness.
        const double left = pu[k] * qv[k];
        const double right = pv[k] * qu[k];
        const double cross = left - right;
        thick[k] = cross - kThin * (std::abs(left) + std::abs(right));
        // Compute the squared sides 0-1, 1-2, 2-0 and the scaled cosines at corners 2, 0, 1.
        const double l0 = px * px + py * py;
        const double l1 = rx * rx + ry * ry;
        const double l2 = qx * qx + qy * qy;
        const double d0 = qx * rx + qy * ry;
        const double d1 = px * qx + py * qy;
        const double d2 = -(px * rx + py * ry);
        cosine0[k] = d1;
        cosine1[k] = d2;
        cosine2[k] = d0;
        acute[k] = std::min(std::min(d0, d1), d2) - kRightAngle * (l0 + l1 + l2);
        // Compute the cotangents and the terms of the sides.
        const double per_area = 1 / (cross * area);
        const double c0 = d0 * per_area;
        const double c1 = d1 * per_area;
        const double c2 = d2 * per_area;
        const double v0 = l0 * c0 * (-1.0 / 12);
        const double v1 = l1 * c1 * (-1.0 / 12);
        const double v2 = l2 * c2 * (-1.0 / 12);
        const double h0 = v0 * c0 * 0.5;
        const double h1 = v1 * c1 * 0.5;
        const double h2 = v2 * c2 * 0.5;
        value[k] =
            -0.125 * (v0 * l0 * (3 + c0 * c0) + v1 * l1 * (3 + c1 * c1) + v2 * l2 * (3 + c2 * c2));
        m0[k] = (v0 + v2) * kMassPerWeight;
        m1[k] = (v0 + v1) * kMassPerWeight;
        m2[k] = (v1 + v2) * kMassPerWeight;
        // Add up the gradients along and across the sides; side 2 runs from corner 2 to corner 0.
        const double ax0 = v0 * px, ay0 = v0 * py, nx0 = -h0 * py, ny0 = h0 * px;
        const double ax1 = v1 * rx, ay1 = v1 * ry, nx1 = -h1 * ry, ny1 = h1 * rx;
        const double ax2 = -v2 * qx, ay2 = -v2 * qy, nx2 = h2 * qy, ny2 = -h2 * qx;
        gx0[k] = (ax0 - ax2) + (nx0 + nx2);
        gy0[k] = (ay0 - ay2) + (ny0 + ny2);
        gx1[k] = (ax1 - ax0) + (nx0 + nx1);
        gy1[k] = (ay1 - ay0) + (ny0 + ny1);
        gx2[k] = (ax2 - ax1) + (nx1 + nx2);
        gy2[k] = (ay2 - ay1) + (ny1 + ny2);
    }
}

}  // namespace pcvt::plane
