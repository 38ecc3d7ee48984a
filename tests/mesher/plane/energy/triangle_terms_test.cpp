#include "mesher/plane/energy/triangle_terms.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <functional>

#include "mesher/plane/delaunay/moving_delaunay.hpp"
#include "mesher/plane/delaunay/predicates.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/wide_terms.hpp"

namespace pcvt::plane {
namespace {

using testing::lattices;

ReducedFrame frame_of(const Lattice& lattice) {
    return MovingDelaunay(Sites(lattice, uniform_points(lattice, 1, 0))).frame();
}

/// Corners 1 and 2 relative to corner 0, multiples of 2^-51.
struct Corners {
    Vec2 p;
    Vec2 q;
};

Vec2 snapped(const Vec2& u) {
    return {std::nearbyint(u.x() * 0x1p51) / 0x1p51, std::nearbyint(u.y() * 0x1p51) / 0x1p51};
}

std::array<Image, 3> images(const Corners& c) {
    return {Image{0, 0, 0, {}}, Image{c.p.x(), c.p.y(), 1, {}}, Image{c.q.x(), c.q.y(), 2, {}}};
}

bool counter_clockwise(const Corners& c) {
    const auto at = images(c);
    return orientation(at[0], at[1], at[2]) > 0;
}

/// Counter-clockwise triangles of any shape; the k-th has two corners up to 10^-(k % 10) apart, or
/// a corner that close to the opposite side.
std::vector<Corners> random_triangles(int n, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::vector<Corners> list;
    while (static_cast<int>(list.size()) < n) {
        const int k = static_cast<int>(list.size());
        const double near = std::pow(10, -(k % 10));
        const Vec2 p = snapped({uniform(random), uniform(random)});
        const Vec2 along = k % 4 == 0 ? Vec2(uniform(random) * p) : k % 4 == 1 ? p : Vec2(0, 0);
        const Vec2 q = snapped(along + near * Vec2{uniform(random), uniform(random)});
        const std::array<Corners, 3> turned{Corners{p, q}, Corners{q - p, -p}, Corners{-q, p - q}};
        if (counter_clockwise({p, q})) list.push_back(turned[k % 3]);
    }
    return list;
}

/// Compares relative to the sums of absolute values.
void expect_terms(const TriangleTerms& actual, const Corners& corners, const ReducedFrame& frame,
                  double tolerance) {
    const testing::WideTerms expected = testing::wide_terms(corners.p, corners.q, frame);
    ASSERT_NEAR(actual.value, expected.value, tolerance * expected.value_size);
    for (int k = 0; k < 3; ++k) {
        ASSERT_LT((actual.gradient[k] - expected.gradient[k]).norm(),
                  tolerance * expected.gradient_size);
        ASSERT_NEAR(actual.mass[k], expected.mass[k], tolerance * expected.mass_size);
    }
}

TEST(TriangleTerms, AreTheIntegralsOverTheRightAngledParts) {
    for (const auto& [name, lattice] : lattices()) {
        SCOPED_TRACE(name);
        const ReducedFrame frame = frame_of(lattice);
        for (const Corners& c : random_triangles(150, 1)) {
            const double cross = detail::cross(c.p, c.q);
            const double thinness = detail::cross_bound(c.p, c.q) / cross;
            expect_terms(triangle_terms(c.p, c.q, frame), c, frame, 1e-14 * thinness);
        }
    }
}

/// Converts a vector of the plane to coordinates of the reduced basis.
Vec2 to_lattice(const ReducedFrame& frame, const Vec2& d) {
    const double v = d.y() / frame.by;
    return snapped({(d.x() - frame.bx * v) / frame.ax, v});
}

/// Triangles with a side from corner 0 to corner 1 and a second side from corner 0 at `angle` to
/// it, `near` times as long; the corners are rotated by `first`.
Corners corners_at_angle(const ReducedFrame& frame, const Vec2& p, double angle, double near,
                         int first) {
    const Vec2 side = frame.to_position(p);
    const Vec2 q = to_lattice(frame, near * (Eigen::Rotation2Dd(angle) * side));
    const std::array<Corners, 3> turned{Corners{p, q}, Corners{q - p, -p}, Corners{-q, p - q}};
    return turned[first % 3];
}

// Two corners almost coincide; no digit is lost for any pair of corners.
TEST(TriangleTerms, OfNeedlesKeepThirteenDigits) {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (const auto& [name, lattice] : lattices()) {
        SCOPED_TRACE(name);
        const ReducedFrame frame = frame_of(lattice);
        for (int k = 0; k < 200; ++k) {
            const Vec2 p = snapped({uniform(random), uniform(random)});
            const double angle = M_PI_2 * (1 + 0.8 * uniform(random));
            const Corners c = corners_at_angle(frame, p, angle, std::pow(10, -(k % 10)), k);
            expect_terms(triangle_terms(c.p, c.q, frame), c, frame, 1e-13);
        }
    }
}

TEST(TriangleTerms, ReportTheSteepestCotangent) {
    const ReducedFrame frame = frame_of(Lattice::rectangle(1, 1));
    EXPECT_NEAR(triangle_terms({0.5, 0}, {0, 0.125}, frame).steepest, 4, 1e-15);
    EXPECT_NEAR(triangle_terms({0.5, 0}, {-0.5, 0.0625}, frame).steepest, 16, 4);
}

/// Triangle k of a block.
TriangleTerms terms_of(const TriangleBlock& b, int k) {
    TriangleTerms terms;
    terms.value = b.value[k];
    terms.gradient = {Vec2(b.gx0[k], b.gy0[k]), Vec2(b.gx1[k], b.gy1[k]), Vec2(b.gx2[k], b.gy2[k])};
    terms.mass = {b.m0[k], b.m1[k], b.m2[k]};
    return terms;
}

using Check = std::function<void(const TriangleBlock& block, int k, const Corners& corners)>;

/// Computes triangles block by block and checks each of them.
void for_blocks(const std::vector<Corners>& list, const ReducedFrame& frame, const Check& check) {
    TriangleBlock block;
    for (std::size_t first = 0; first + TriangleBlock::kSize <= list.size();
         first += TriangleBlock::kSize) {
        for (int k = 0; k < TriangleBlock::kSize; ++k) {
            const Corners& c = list[first + k];
            block.pu[k] = c.p.x();
            block.pv[k] = c.p.y();
            block.qu[k] = c.q.x();
            block.qv[k] = c.q.y();
        }
        block.compute(frame);
        for (int k = 0; k < TriangleBlock::kSize; ++k) check(block, k, list[first + k]);
    }
}

// The results of a block are final for triangles that are not thin.
TEST(TriangleBlock, EqualsTheTermsOfOneTriangle) {
    for (const auto& [name, lattice] : lattices()) {
        SCOPED_TRACE(name);
        const ReducedFrame frame = frame_of(lattice);
        int n_thick = 0;
        for_blocks(random_triangles(256, 3), frame,
                   [&](const auto& block, int k, const Corners& c) {
                       if (!(block.thick[k] > 0)) return;
                       ++n_thick;
                       expect_terms(terms_of(block, k), c, frame, 1e-12);
                   });
        EXPECT_GT(n_thick, 80);
    }
}

TEST(TriangleBlock, ComputesTheCosines) {
    const ReducedFrame frame = frame_of(Lattice({1, 0}, {0.37, 0.81}));
    for_blocks(random_triangles(640, 4), frame, [&](const auto& block, int k, const Corners& c) {
        const Vec2 p = frame.to_position(c.p);
        const Vec2 q = frame.to_position(c.q);
        const Vec2 r = frame.to_position(c.q - c.p);
        ASSERT_NEAR(block.cosine0[k], p.dot(q), 1e-14 * p.norm() * q.norm());
        ASSERT_NEAR(block.cosine1[k], -p.dot(r), 1e-14 * p.norm() * r.norm());
        ASSERT_NEAR(block.cosine2[k], q.dot(r), 1e-14 * q.norm() * r.norm());
    });
}

/// Collinear up to a few units in the last place, to either side.
std::vector<Corners> flat_triangles(int n) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::vector<Corners> list;
    for (int k = 0; k < n; ++k) {
        const Vec2 p = snapped({uniform(random), uniform(random)});
        const double part = 2 * uniform(random);
        list.push_back({p, snapped(part * p) + 0x1p-51 * Vec2(k % 3 - 1, k / 3 % 3 - 1)});
    }
    return list;
}

TEST(TriangleBlock, NeverCertifiesAThinOrInvertedTriangle) {
    const ReducedFrame frame = frame_of(Lattice::rectangle(1, 1));
    std::vector<Corners> list = flat_triangles(64 * 50);
    for (Corners c : random_triangles(640, 6)) {
        list.push_back({c.q, c.p});
        list.push_back({c.p, c.p});
    }
    for_blocks(list, frame, [&](const auto& block, int k, const Corners& c) {
        ASSERT_TRUE(!(block.thick[k] > 0) || counter_clockwise(c));
    });
    for_blocks(random_triangles(640, 6), frame, [&](const auto& block, int k, const Corners& c) {
        if (detail::cross(c.p, c.q) > 0.01 * detail::cross_bound(c.p, c.q)) {
            ASSERT_GT(block.thick[k], 0);
        }
    });
}

/// The angle at `apex` is acute if the fourth corner of the parallelogram lies outside of the
/// circle: the two angles opposite to the side p q then sum to less than two right angles.
bool exactly_acute(const Gram& gram, const Image& p, const Image& q, const Image& apex) {
    const Image fourth{p.u + q.u - apex.u, p.v + q.v - apex.v, 3, {}};
    return in_circle(gram, p, q, apex, fourth) < 0;
}

/// Right angles up to rounding, at any corner, with legs of any ratio.
std::vector<Corners> right_triangles(const ReducedFrame& frame, int n) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::vector<Corners> list;
    for (int k = 0; k < n; ++k) {
        const Vec2 p = snapped({uniform(random), uniform(random)});
        const double deviation = std::ldexp(uniform(random), -40 - k % 16);
        const double near = std::pow(10, -(k / 16 % 8));
        list.push_back(corners_at_angle(frame, p, M_PI_2 + deviation, near, k));
    }
    return list;
}

TEST(TriangleBlock, NeverCertifiesAnAngleThatIsNotAcute) {
    int n_not_acute = 0;
    for (const auto& [name, lattice] : lattices()) {
        SCOPED_TRACE(name);
        const ReducedFrame frame = frame_of(lattice);
        const Gram gram = gram_of(reduce(lattice).reduced);
        const auto check = [&](const auto& block, int k, const Corners& c) {
            const auto [p, q, r] = images(c);
            const bool acute = exactly_acute(gram, p, q, r) && exactly_acute(gram, q, r, p) &&
                               exactly_acute(gram, r, p, q);
            n_not_acute += !acute;
            ASSERT_TRUE(!(block.acute[k] > 0) || acute);
        };
        for_blocks(right_triangles(frame, 640), frame, check);
        for_blocks(random_triangles(640, 8), frame, check);
    }
    EXPECT_GT(n_not_acute, 1000);
}

TEST(TriangleBlock, CertifiesNearlyRegularTrianglesAsAcute) {
    for (const auto& [name, lattice] : lattices()) {
        const ReducedFrame frame = frame_of(lattice);
        std::vector<Corners> list;
        for (int k = 0; k < TriangleBlock::kSize; ++k) {
            const double angle = (50 + k % 30) * M_PI / 180;
            list.push_back(corners_at_angle(frame, snapped({0.1 + 0.01 * k, 0.3}), angle, 1, k));
        }
        for_blocks(list, frame, [&, &name = name](const auto& block, int k, const Corners&) {
            ASSERT_GT(block.acute[k], 0) << name;
        });
    }
}

}  // namespace
}  // namespace pcvt::plane
