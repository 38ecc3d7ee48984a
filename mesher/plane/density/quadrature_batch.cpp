#include "mesher/plane/density/quadrature_batch.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/plane/geometry/polygon.hpp"

namespace pcvt::plane {
namespace {

/// Writes the points of a rule in the triangle between `apex` and two corners, lattice coordinates
/// in [0, 1].
void place_points(const Vec2& apex, const Vec2& from, const Vec2& to, const TriangleRule& rule,
                  const DensityProbe& probe, DensityPoint* points) {
    const Vec2 p = from - apex;
    const Vec2 r = to - apex;
    const double* const along_p = rule.along_p.data();
    const double* const along_r = rule.along_r.data();
    const int n = rule.n_points();
    for (int k = 0; k < n; ++k) {
        points[k] = probe.point(apex + (along_p[k] * p + along_r[k] * r));
    }
}

/// The moments about 0 of the fan of triangles (0, previous corner, corner).
Moments fan_moments(std::span<const Vec2> corners, const TriangleRule& rule, const double* rho) {
    const int n = rule.n_points();
    double mass = 0;
    Vec2 first = Vec2::Zero();
    double second = 0;
    Vec2 p = corners.back();
    for (const Vec2& r : corners) {
        Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
        for (int k = 0; k < n; ++k) sum += *rho++ * rule.weights.col(k);
        // Coincident corners make triangles that consist of rounding only.
        sum *= std::max(cross(p, r), 0.0);
        mass += sum[0];
        first += sum[1] * p + sum[2] * r;
        second += sum[3] * p.squaredNorm() + 2 * sum[4] * p.dot(r) + sum[5] * r.squaredNorm();
        p = r;
    }
    return {mass, first, second};
}

}  // namespace

Moments about_site(const Moments& m, const Vec2& place) {
    return {m.mass, m.first + m.mass * place,
            m.second + 2 * place.dot(m.first) + place.squaredNorm() * m.mass};
}

Moments& Moments::operator+=(const Moments& other) {
    mass += other.mass;
    first += other.first;
    second += other.second;
    return *this;
}

void QuadratureBatch::add_fan(CellView polygon, const CellCorner& apex, const Vec2& period, int q) {
    const TriangleRule& rule = triangle_rule(q);
    const int n_points = rule.n_points();
    const std::size_t first_point = probe_.n_reserved();
    DensityPoint* points = probe_.reserve(n_points * polygon.size());
    const Vec2 origin = apex.lattice - period;
    Vec2 from = polygon.back().lattice - period;
    for (const CellCorner& corner : polygon) {
        const Vec2 to = corner.lattice - period;
        place_points(origin, from, to, rule, probe_, points);
        points += n_points;
        from = to;
        corners_.push_back(corner.plane - apex.plane);
    }
    pieces_.push_back(
        {true, apex.plane.isZero(0), q, static_cast<int>(polygon.size()), apex.plane, first_point});
}

void QuadratureBatch::add_parallelogram(const CellCorner& corner, const CellCorner& along,
                                        const CellCorner& up, const Vec2& period, int q) {
    const GaussRule& rule = line_rule(q);
    const std::size_t first_point = probe_.n_reserved();
    DensityPoint* const points = probe_.reserve(std::size_t(q) * q);
    for (int k = 0; k < q * q; ++k) {
        const Vec2 place = corner.lattice - period +
                           rule.nodes[k / q] * (along.lattice - corner.lattice) +
                           rule.nodes[k % q] * (up.lattice - corner.lattice);
        points[k] = probe_.point(place);
    }
    corners_.push_back(along.plane - corner.plane);
    corners_.push_back(up.plane - corner.plane);
    pieces_.push_back({false, false, q, 2, corner.plane, first_point});
}

Moments QuadratureBatch::take_fan(const Piece& piece, const double* rho) {
    const TriangleRule& rule = triangle_rule(piece.q);
    Moments moments = fan_moments({corner_, std::size_t(piece.n_corners)}, rule, rho);
    corner_ += piece.n_corners;
    return moments;
}

Moments QuadratureBatch::take_parallelogram(const Piece& piece, const double* rho) {
    const GaussRule& rule = line_rule(piece.q);
    const int q = piece.q;
    const Vec2 p = *corner_++;
    const Vec2 r = *corner_++;
    const double area = std::abs(cross(p, r));
    Moments sum;
    for (int k = 0; k < q * q; ++k) {
        const Vec2 d = rule.nodes[k / q] * p + rule.nodes[k % q] * r;
        const double mass = area * rule.weights[k / q] * rule.weights[k % q] * *rho++;
        sum += {mass, mass * d, mass * d.squaredNorm()};
    }
    return sum;
}

const std::vector<Moments>& QuadratureBatch::take(std::span<const double> rho) {
    corner_ = corners_.data();
    moments_.clear();
    std::size_t k = 0;
    for (const std::size_t end : end_) {
        Moments sum;
        for (; k < end; ++k) {
            const Piece& piece = pieces_[k];
            const double* const values = rho.data() + piece.first_point;
            const Moments moments =
                piece.is_fan ? take_fan(piece, values) : take_parallelogram(piece, values);
            sum += piece.is_about_site ? moments : about_site(moments, piece.place);
        }
        moments_.push_back(sum);
    }
    pieces_.clear();
    corners_.clear();
    end_.clear();
    return moments_;
}

}  // namespace pcvt::plane
