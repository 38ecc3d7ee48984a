#include "tests/support/exact_delaunay.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <map>

namespace pcvt::testing {
namespace {

using Integer = boost::multiprecision::int512_t;
using Triple = std::array<Integer, 3>;

/// A coordinate of an image times 2^50.
Integer scaled(double coordinate, int offset) {
    return Integer(std::ldexp(coordinate, 50)) + (Integer(offset) << 50);
}

Triple operator-(const Triple& p, const Triple& q) {
    return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

Integer dot(const Triple& p, const Triple& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }

Triple exact_cross(const Triple& p, const Triple& q) {
    return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

/// The lattice as rows of a Gram matrix times 2^60.
class ExactMetric {
   public:
    explicit ExactMetric(const space::Gram& g) {
        const auto integer = [](double entry) { return Integer(std::ldexp(entry, 60)); };
        rows_ = {{{integer(g.aa), integer(g.ab), integer(g.ac)},
                  {integer(g.ab), integer(g.bb), integer(g.bc)},
                  {integer(g.ac), integer(g.bc), integer(g.cc)}}};
        rounded_ << g.aa, g.ab, g.ac, g.ab, g.bb, g.bc, g.ac, g.bc, g.cc;
    }

    Integer squared_length(const Triple& d) const {
        return dot(d, {dot(rows_[0], d), dot(rows_[1], d), dot(rows_[2], d)});
    }
    const Eigen::Matrix3d& rounded() const { return rounded_; }

   private:
    std::array<Triple, 3> rows_;
    Eigen::Matrix3d rounded_;
};

/// A tetrahedron p, p + d_1, p + d_2, p + d_3 and its circumsphere. With the determinant D of the
/// d_k and M_k the cross product of the other two, the point t = p + x has the power
/// |x|^2 - x . N / D, N = sum of |d_k|^2 M_k. A rule for ties adds to the squared height of each
/// point its own infinitesimal, which is larger by orders for a greater point.
struct Sphere {
    std::array<Triple, 4> corner;
    std::array<Triple, 3> minor;
    Integer determinant;
    Triple normal;

    Sphere(const ExactMetric& metric, const std::array<Triple, 4>& corners) : corner(corners) {
        const std::array<Triple, 3> d{corner[1] - corner[0], corner[2] - corner[0],
                                      corner[3] - corner[0]};
        minor = {exact_cross(d[1], d[2]), exact_cross(d[2], d[0]), exact_cross(d[0], d[1])};
        determinant = dot(d[0], minor[0]);
        for (int axis = 0; axis < 3; ++axis) {
            normal[axis] = 0;
            for (int k = 0; k < 3; ++k) {
                normal[axis] += metric.squared_length(d[k]) * minor[k][axis];
            }
        }
    }

    /// @pre determinant > 0.
    bool contains(const ExactMetric& metric, const Triple& t) const {
        const Triple x = t - corner[0];
        const Integer power = metric.squared_length(x) * determinant - dot(x, normal);
        if (power != 0) return power < 0;
        return tie_contains(t);
    }

   private:
    bool tie_contains(const Triple& t) const {
        const Triple x = t - corner[0];
        // How much the power grows with the infinitesimal of each point.
        std::vector<std::pair<Triple, Integer>> growth{{t, determinant}};
        Integer of_first = -determinant;
        for (int k = 0; k < 3; ++k) {
            const Integer part = dot(x, minor[k]);
            growth.emplace_back(corner[k + 1], -part);
            of_first += part;
        }
        growth.emplace_back(corner[0], of_first);
        std::sort(growth.begin(), growth.end());
        for (auto g = growth.rbegin(); g != growth.rend(); ++g) {
            if (g->second != 0) return g->second < 0;
        }
        return false;
    }
};

/// The corners of a facet relative to the least one, and whether an even permutation sorts them.
std::pair<std::array<space::Corner, 3>, bool> canonical_facet(std::array<space::Corner, 3> facet) {
    bool even = true;
    for (const auto& [i, j] : {std::pair(0, 1), std::pair(1, 2), std::pair(0, 1)}) {
        if (facet[j] < facet[i]) {
            std::swap(facet[i], facet[j]);
            even = !even;
        }
    }
    const space::Offset first = facet[0].offset;
    for (space::Corner& corner : facet) corner.offset = corner.offset - first;
    return {facet, even};
}

/// Law (1) but for volumes.
std::string facet_fault(const space::TorusTetrahedra& tetrahedra) {
    std::map<std::array<space::Corner, 3>, std::array<int, 2>> sides;
    for (int t = 0; t < tetrahedra.n_tetrahedra(); ++t) {
        const space::Tetrahedron c = tetrahedra.tetrahedron(t);
        for (const auto& facet : {std::array{c[1], c[3], c[2]}, std::array{c[0], c[2], c[3]},
                                  std::array{c[0], c[3], c[1]}, std::array{c[0], c[1], c[2]}}) {
            const auto [key, even] = canonical_facet(facet);
            ++sides[key][even ? 0 : 1];
        }
    }
    for (const auto& [facet, count] : sides) {
        if (count != std::array{1, 1}) return "a facet has not one tetrahedron on each side";
    }
    return "";
}

/// The offsets for which an image of u lies in [low, high], with a margin for rounding.
std::pair<int, int> offset_range(double u, double low, double high) {
    constexpr double kMargin = 1e-3;
    return {static_cast<int>(std::ceil(low - u - kMargin)),
            static_cast<int>(std::floor(high - u + kMargin))};
}

class Checker {
   public:
    Checker(const space::TorusTetrahedra& tetrahedra, const space::Points& coordinates,
            const space::Gram& gram)
        : tetrahedra_(tetrahedra), coordinates_(coordinates), metric_(gram) {}

    std::string fault() const {
        if (std::string words = facet_fault(tetrahedra_); !words.empty()) return words;
        Integer volume = 0;
        for (int t = 0; t < tetrahedra_.n_tetrahedra(); ++t) {
            const space::Tetrahedron corners = tetrahedra_.tetrahedron(t);
            const Sphere sphere(metric_,
                                {at(corners[0]), at(corners[1]), at(corners[2]), at(corners[3])});
            if (sphere.determinant <= 0) return "tetrahedron " + std::to_string(t) + " is flat";
            volume += sphere.determinant;
            if (std::string words = sphere_fault(corners, sphere); !words.empty()) {
                return "tetrahedron " + std::to_string(t) + words;
            }
        }
        return volume == Integer(6) << 150 ? "" : "the volumes do not sum to one domain";
    }

   private:
    Triple at(const space::Corner& corner) const {
        const auto u = coordinates_.col(corner.site);
        return {scaled(u.x(), corner.offset.i), scaled(u.y(), corner.offset.j),
                scaled(u.z(), corner.offset.k)};
    }

    /// Law (2) for one tetrahedron.
    std::string sphere_fault(const space::Tetrahedron& corners, const Sphere& sphere) const {
        // The centre and the radius, from quotients of integers that are each rounded once.
        space::Vec3 dual;
        for (int axis = 0; axis < 3; ++axis) {
            dual[axis] = std::ldexp(static_cast<double>(sphere.normal[axis]), -260) /
                         std::ldexp(static_cast<double>(sphere.determinant), -150) / 2;
        }
        const Eigen::Matrix3d inverse = metric_.rounded().inverse();
        const space::Vec3 half = inverse * dual;
        const double radius = std::sqrt(dual.dot(half));
        const space::Vec3 centre = image(coordinates_, corners[0]).at + half;
        const space::Vec3 reach = radius * inverse.diagonal().cwiseSqrt();
        for (SiteId s = 0; s < static_cast<SiteId>(coordinates_.cols()); ++s) {
            std::array<std::pair<int, int>, 3> range;
            for (int axis = 0; axis < 3; ++axis) {
                range[axis] = offset_range(coordinates_(axis, s), centre[axis] - reach[axis],
                                           centre[axis] + reach[axis]);
            }
            for (int i = range[0].first; i <= range[0].second; ++i) {
                for (int j = range[1].first; j <= range[1].second; ++j) {
                    for (int k = range[2].first; k <= range[2].second; ++k) {
                        const space::Corner other{s, {i, j, k}};
                        if (std::find(corners.begin(), corners.end(), other) != corners.end()) {
                            continue;
                        }
                        if (sphere.contains(metric_, at(other))) {
                            return ": its sphere contains an image of site " + std::to_string(s);
                        }
                    }
                }
            }
        }
        return "";
    }

    const space::TorusTetrahedra& tetrahedra_;
    const space::Points& coordinates_;
    ExactMetric metric_;
};

}  // namespace

std::string delaunay_fault(const space::TorusTetrahedra& tetrahedra,
                           const space::Points& coordinates, const space::Gram& gram) {
    return Checker(tetrahedra, coordinates, gram).fault();
}

}  // namespace pcvt::testing
