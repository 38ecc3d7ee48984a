#include "mesher/space/grains/star_shape.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/base/target_clones.hpp"

namespace pcvt::space {
namespace {

struct Arm {
    double x;
    double y;
    double z;
};

[[gnu::always_inline]] inline Arm cross(const Arm& p, const Arm& q) {
    return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}

[[gnu::always_inline]] inline double dot(const Arm& p, const Arm& q) {
    return p.x * q.x + p.y * q.y + p.z * q.z;
}

[[gnu::always_inline]] inline Arm arm_of(const double (&corner)[3][8], int lane,
                                         const double* way) {
    return {corner[0][lane] - way[0], corner[1][lane] - way[1], corner[2][lane] - way[2]};
}

}  // namespace

void StarShape::clear() {
    blocks_.clear();
    n_ = 0;
}

void StarShape::add(const CellTetrahedra& cell, int t, int v) {
    const ThreeCorners triangle = cell.triangle(t, cell.index_of(t, v));
    const Vec3& from = cell.point(v);
    const Vec3 a = difference(cell.point(triangle[0]), from);
    const Vec3 b = difference(cell.point(triangle[1]), from);
    const Vec3 c = difference(cell.point(triangle[2]), from);
    const Vec3 normal = cross_product(difference(b, a), difference(c, a));
    const int first = n_++ % kLanes;
    if (first == 0) blocks_.emplace_back();
    Block& block = blocks_.back();
    const double at_feature = cell.is_at_feature(cell.corners(t)) ? 1 : 0;
    // The lanes behind it repeat the last tetrahedron.
    const int end = first == 0 ? kLanes : first + 1;
    for (int lane = first; lane < end; ++lane) {
        for (int k = 0; k < 3; ++k) {
            block.a[k][lane] = a[k];
            block.b[k][lane] = b[k];
            block.c[k][lane] = c[k];
            block.normal[k][lane] = normal[k];
        }
        block.square[lane] = squared_length(normal);
        block.at_feature[lane] = at_feature;
        block.edge[0][lane] = squared_distance(b, c);
        block.edge[1][lane] = squared_distance(c, a);
        block.edge[2][lane] = squared_distance(a, b);
    }
}

/// The shape of the tetrahedron of a moved vertex and the three corners in one lane.
struct StarShape::LaneShape {
    /// As CellTetrahedra::quality_of().
    double quality;
    /// Six times the volume, and the sum of the squared edges.
    double volume6;
    double sum_of_squares;
};

[[gnu::always_inline]] inline StarShape::LaneShape StarShape::shape_in(const Block& block, int lane,
                                                                       const double* way) {
    const Arm a = arm_of(block.a, lane, way);
    const Arm b = arm_of(block.b, lane, way);
    const Arm c = arm_of(block.c, lane, way);
    const Arm normal{block.normal[0][lane], block.normal[1][lane], block.normal[2][lane]};
    const Arm bc = cross(b, c);
    const Arm ca = cross(c, a);
    const Arm ab = cross(a, b);
    const double a_face = dot(bc, bc);
    const double b_face = dot(ca, ca);
    const double c_face = dot(ab, ab);
    const double x_face = block.square[lane];
    const double aa = dot(a, a);
    const double bb = dot(b, b);
    const double cc = dot(c, c);
    double least = aa * (x_face * a_face);
    const auto lower = [&least](double other) { least = other < least ? other : least; };
    lower(bb * (x_face * b_face));
    lower(cc * (x_face * c_face));
    lower(block.edge[0][lane] * (b_face * c_face));
    lower(block.edge[1][lane] * (c_face * a_face));
    lower(block.edge[2][lane] * (a_face * b_face));
    const double product = (x_face * a_face) * (b_face * c_face);
    const double volume6 = dot(normal, a);
    const double sine = volume6 * std::sqrt(least / product);
    const double lifted = quality_at_feature(sine);
    const double quality = block.at_feature[lane] > 0 ? lifted : sine;
    return {.quality = product > 0 ? quality : -1,
            .volume6 = volume6,
            .sum_of_squares =
                aa + bb + cc + (block.edge[0][lane] + block.edge[1][lane] + block.edge[2][lane])};
}

PCVT_TARGET_CLONES void StarShape::qualities_of(const Block& block, const double* way,
                                                double* __restrict qualities) {
    for (int lane = 0; lane < kLanes; ++lane) qualities[lane] = shape_in(block, lane, way).quality;
}

PCVT_TARGET_CLONES void StarShape::qualities_and_ratios_of(const Block& block, const double* way,
                                                           double* __restrict qualities,
                                                           double* __restrict ratios) {
    for (int lane = 0; lane < kLanes; ++lane) {
        const LaneShape shape = shape_in(block, lane, way);
        qualities[lane] = shape.quality;
        ratios[lane] = shape.volume6 / (shape.sum_of_squares * std::sqrt(shape.sum_of_squares));
    }
}

double StarShape::least_quality(const Vec3& way, double stop) const {
    double least = kUnlimited;
    double qualities[kLanes];
    for (const Block& block : blocks_) {
        qualities_of(block, way.data(), qualities);
        least = std::min(least, *std::min_element(qualities, qualities + kLanes));
        if (least <= stop) break;
    }
    return least;
}

StarShape::Measure StarShape::measure(const Vec3& way, double bound) const {
    Measure all{.least_quality = kUnlimited, .sum_of_ratios = 0};
    double qualities[kLanes];
    double ratios[kLanes];
    int n_left = n_;
    for (const Block& block : blocks_) {
        qualities_and_ratios_of(block, way.data(), qualities, ratios);
        const int n_here = std::min(n_left, kLanes);
        n_left -= kLanes;
        for (int lane = 0; lane < n_here; ++lane) {
            all.least_quality = std::min(all.least_quality, qualities[lane]);
            all.sum_of_ratios += ratios[lane];
        }
        if (all.least_quality < bound) break;
    }
    return all;
}

/// The volume times the centre of the sphere through the vertex and the corners a, b and c is a
/// polynomial.
StarShape::Centres StarShape::centres() const {
    double volume = 0;
    Vec3 spheres = Vec3::Zero();
    Vec3 corners = Vec3::Zero();
    for (int k = 0; k < n_; ++k) {
        const Block& block = blocks_[k / kLanes];
        const int lane = k % kLanes;
        const auto corner = [lane](const double(&from)[3][kLanes]) {
            return Vec3(from[0][lane], from[1][lane], from[2][lane]);
        };
        const Vec3 a = corner(block.a);
        const Vec3 b = corner(block.b);
        const Vec3 c = corner(block.c);
        const Vec3 bc = cross_product(b, c);
        const double part = dot_product(a, bc);
        volume += part;
        spheres += squared_length(a) * bc + squared_length(b) * cross_product(c, a) +
                   squared_length(c) * cross_product(a, b);
        corners += part * (a + b + c);
    }
    return {.of_spheres = spheres / (2 * volume), .of_corners = corners / (4 * volume)};
}

}  // namespace pcvt::space
