#include "mesher/space/power/thin_terms.hpp"

#include "mesher/portable/wide_double.hpp"
#include "mesher/space/delaunay/power_predicates.hpp"
#include "mesher/space/power/power_terms.hpp"

namespace pcvt::space {
namespace {

using Vector = Eigen::Matrix<WideDouble, 3, 1>;

Vector position(const Vec3& u, const Frame& f) {
    const Vector v = u.cast<WideDouble>();
    return {f.ax * v.x() + f.bx * v.y() + f.cx * v.z(), f.by * v.y() + f.cy * v.z(), f.cz * v.z()};
}

Vector cross(const Vector& a, const Vector& b) {
    return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
            a.x() * b.y() - a.y() * b.x()};
}

Vec3 rounded(const Vector& v) { return v.cast<double>(); }

/// A tetrahedron with its exact orthocentre.
struct ThinShape {
    /// The corners and the orthocentre relative to corner 0; edge[i][j] leads from corner i to j.
    std::array<Vector, 4> p;
    Vector centre;
    std::array<std::array<Vector, 4>, 4> edge;
    std::array<std::array<WideDouble, 4>, 4> squared;
    /// w_i - w_j
    std::array<std::array<WideDouble, 4>, 4> lift;
    /// 1 / |N|^2, q and Phi of the facets opposite to the corners.
    std::array<WideDouble, 4> q;
    std::array<Vec3, 4> foot;
    std::array<double, 4> per_nn;
    /// q^2 |N|^2
    std::array<double, 4> height_squared;
};

void set_facet(ThinShape& s, int apex) {
    const int i = apex == 0 ? 1 : 0;
    const int j = apex <= 1 ? 2 : 1;
    const int k = apex <= 2 ? 3 : 2;
    Vector normal = cross(s.edge[i][j], s.edge[i][k]);
    // The corners 0, 1, 2 and 3 turn to the right or to the left by their number.
    if (apex % 2 == 0) normal = -normal;
    const WideDouble square = normal.squaredNorm();
    const WideDouble height = (s.centre - s.p[i]).dot(normal);
    s.q[apex] = height / square;
    s.per_nn[apex] = 1 / double(square);
    s.foot[apex] = rounded(s.centre - s.q[apex] * normal);
    s.height_squared[apex] = double(height) * double(s.q[apex]);
}

ThinShape shape_of(const std::array<Vec3, 3>& corner, const std::array<double, 4>& weight,
                   const Frame& frame) {
    ThinShape s;
    const std::array<Vec3, 4> u{Vec3::Zero(), corner[0], corner[1], corner[2]};
    std::array<double, 4> of_gram;
    for (int i = 0; i < 4; ++i) {
        s.p[i] = position(u[i], frame);
        of_gram[i] = rounded_weight(weight[i] * frame.gram_per_square);
        for (int j = 0; j < 4; ++j) {
            s.lift[i][j] = WideDouble(weight[i]) - weight[j];
            if (i >= j) continue;
            // Differences of coordinates are exact.
            s.edge[i][j] = position(u[j] - u[i], frame);
            s.edge[j][i] = -s.edge[i][j];
            s.squared[i][j] = s.squared[j][i] = s.edge[i][j].squaredNorm();
        }
    }
    s.centre = position(exact_orthocentre(frame.gram, corner, of_gram), frame);
    for (int apex = 0; apex < 4; ++apex) set_facet(s, apex);
    return s;
}

/// B of the edge i j in the facet i j k.
WideDouble across(const ThinShape& s, int i, int j, int k) {
    const WideDouble& squared = s.squared[i][j];
    const WideDouble at_k = s.edge[k][i].dot(s.edge[k][j]);
    const WideDouble at_j = s.edge[j][i].dot(s.edge[j][k]);
    if (double(squared) <= double(s.squared[i][k]) && double(squared) <= double(s.squared[j][k])) {
        return squared * (at_k + s.lift[j][k]) + at_j * s.lift[i][j];
    }
    const WideDouble at_i = s.edge[i][j].dot(s.edge[i][k]);
    return squared * at_k + at_j * s.lift[i][k] + at_i * s.lift[j][k];
}

/// Adds the terms of edge e, i j, in the facet i j k.
void add_facet(const ThinShape& s, int e, int k, std::array<WideDouble, 4>& volume,
               WideDouble& conductance, ThinTerms& terms) {
    const auto [i, j] = PowerBlock::kEdges[e];
    const int apex = 6 - i - j - k;
    const WideDouble b = across(s, i, j, k);
    const WideDouble squared = s.squared[i][j];
    const WideDouble part = b * s.q[apex] / (8 * squared);
    conductance += part;
    const double l = double(squared);
    const double rest = 0.75 * double(b) * double(b) * s.per_nn[apex] / l + s.height_squared[apex];
    for (const auto [at, to] : {std::array{i, j}, std::array{j, i}}) {
        const WideDouble alpha = squared + s.lift[at][to];
        volume[at] += part * alpha;
        const double abh = 2 * double(part * alpha);
        const double a = double(alpha);
        terms.value += abh * (1.5 * a * a / l + rest) / 60;
        const Vec3 foot =
            rounded(s.p[i]) + 0.5 * double(squared + s.lift[i][j]) / l * rounded(s.edge[i][j]);
        const Vec3 corners = foot + s.foot[apex] + rounded(s.centre);
        terms.gradient[at] -= abh / 12 * (corners - 3 * rounded(s.p[at]));
    }
}

}  // namespace

ThinTerms thin_terms(const std::array<Vec3, 3>& corner, const std::array<double, 4>& weight,
                     const Frame& frame) {
    const ThinShape shape = shape_of(corner, weight, frame);
    ThinTerms terms;
    std::array<WideDouble, 4> volume{};
    for (int e = 0; e < 6; ++e) {
        const auto [i, j] = PowerBlock::kEdges[e];
        WideDouble conductance;
        for (int k = 0; k < 4; ++k) {
            if (k != i && k != j) add_facet(shape, e, k, volume, conductance, terms);
        }
        terms.conductance[e] = double(conductance);
    }
    for (int c = 0; c < 4; ++c) terms.volume[c] = double(volume[c] / 3);
    return terms;
}

}  // namespace pcvt::space
