#include "mesher/space/mesh/voronoi_corners.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "mesher/portable/wide_double.hpp"
#include "mesher/torus/offset_disjoint_sets.hpp"

namespace pcvt::space {
namespace {

/// Corners nearer than this part of h are one.
constexpr double kMerged = 1e-9;
/// The height of a tetrahedron above its largest face over its shortest edge below which it is
/// flat. Sites of exact lattices are rounded to 2^-50 of a period, which makes flat tetrahedra of
/// heights near 1e-13; ten million random sites have none below this.
constexpr double kFlat = 1e-11;
/// The same over the rounding of the sites, for sites that are near to each other.
constexpr double kFlatRoundings = 16;

using WideVector = Eigen::Matrix<WideDouble, 3, 1>;
using WideMatrix = Eigen::Matrix<WideDouble, 3, 3>;

struct Centre {
    Vec3 position;
    bool is_determined;
    /// The position is that of a neighbour.
    bool is_borrowed = false;
};

/// By how much the rounding of coordinates to 2^-50 may move a site.
double site_rounding(const Lattice& reduced) {
    double sum = 0;
    for (const Vec3& period : reduced.periods()) sum += period.norm();
    return sum / (2 * kGrid);
}

/// Whether four sites lie in a plane up to their rounding.
/// @param volume  six times that of the tetrahedron.
bool is_flat(const WideMatrix& edges, double volume, double rounding) {
    const Eigen::Matrix3d e = edges.unaryExpr([](const WideDouble& x) { return double(x); });
    const Vec3 a = e.row(0);
    const Vec3 b = e.row(1);
    const Vec3 c = e.row(2);
    const double shortest =
        std::min({a.norm(), b.norm(), c.norm(), (b - a).norm(), (c - a).norm(), (c - b).norm()});
    const double largest_face = std::max(
        {a.cross(b).norm(), b.cross(c).norm(), c.cross(a).norm(), (b - a).cross(c - a).norm()});
    return !(std::abs(volume) >
             std::max(kFlat * shortest, kFlatRoundings * rounding) * largest_face);
}

WideMatrix wide_periods(const Lattice& lattice) {
    WideMatrix periods;
    for (int k = 0; k < 3; ++k) periods.col(k) = lattice.periods()[k].cast<WideDouble>();
    return periods;
}

/// Computes in wide numbers from differences of lattice coordinates, which are exact: nearly
/// flat tetrahedra lose half of the digits.
Centre circumcentre(const Sites& sites, const Eigen::VectorXd& weights, const WideMatrix& periods,
                    const Tetrahedron& corners, double rounding) {
    const Points& u = sites.coordinates();
    const auto first = u.col(corners[0].site);
    WideMatrix edges;
    WideVector halves;
    for (int k = 0; k < 3; ++k) {
        const Offset offset = corners[k + 1].offset - corners[0].offset;
        const Vec3 step = (u.col(corners[k + 1].site) - first) + offset.vector();
        const WideVector edge = periods * step.cast<WideDouble>();
        edges.row(k) = edge.transpose();
        halves[k] = edge.squaredNorm() / 2;
        if (weights.size() == 0) continue;
        const WideDouble weight = weights[corners[0].site];
        halves[k] = halves[k] + (weight - WideDouble(weights[corners[k + 1].site])) / 2;
    }
    const WideDouble volume = edges.determinant();
    if (is_flat(edges, static_cast<double>(volume), rounding)) return {Vec3::Zero(), false};
    const WideVector a = edges.row(0);
    const WideVector b = edges.row(1);
    const WideVector c = edges.row(2);
    const WideVector centre =
        (halves[0] * b.cross(c) + halves[1] * c.cross(a) + halves[2] * a.cross(b)) / volume;
    const WideVector origin = periods * (first + corners[0].offset.vector()).cast<WideDouble>();
    return {(origin + centre).cast<double>(), true};
}

std::vector<Centre> circumcentres(const Sites& sites, const TorusTetrahedra& tetrahedra,
                                  const Eigen::VectorXd& weights) {
    const WideMatrix periods = wide_periods(sites.reduction().reduced);
    const double rounding = site_rounding(sites.reduction().reduced);
    std::vector<Centre> centres;
    centres.reserve(static_cast<std::size_t>(tetrahedra.n_tetrahedra()));
    for (int t = 0; t < tetrahedra.n_tetrahedra(); ++t) {
        checkpoint_each(t);
        centres.push_back(
            circumcentre(sites, weights, periods, tetrahedra.tetrahedron(t), rounding));
    }
    return centres;
}

using Merged = OffsetDisjointSets<Offset>;

void merge_close(const Sites& sites, const TorusTetrahedra& tetrahedra,
                 const std::vector<Centre>& centres, Merged& merged) {
    const Lattice& lattice = sites.reduction().reduced;
    const double radius = kMerged * sites.spacing();
    for (int f = 0; f < tetrahedra.n_facets(); ++f) {
        checkpoint_each(f);
        const int other = tetrahedra.opposite(f);
        if (other < f) continue;
        const Centre& here = centres[f / 4];
        const Centre& there = centres[other / 4];
        // Most centres differ by more than rounding of the translation could bring together.
        const Offset frame = tetrahedra.frame_across(f);
        const Vec3 gap = there.position + lattice.translation(frame) - here.position;
        if (gap.norm() <= radius) merged.join(f / 4, other / 4, frame);
    }
}

/// Gives each flat tetrahedron the centre of a neighbour.
void merge_flat(const Lattice& lattice, const TorusTetrahedra& tetrahedra,
                std::vector<Centre>& centres, Merged& merged) {
    std::vector<int> flat;
    for (int t = 0; t < tetrahedra.n_tetrahedra(); ++t) {
        if (!centres[t].is_determined) flat.push_back(t);
    }
    while (!flat.empty()) {
        std::vector<int> left;
        for (const int t : flat) {
            for (int f = 4 * t; f < 4 * t + 4 && !centres[t].is_determined; ++f) {
                const int neighbour = tetrahedra.opposite(f) / 4;
                if (!centres[neighbour].is_determined) continue;
                const Offset frame = tetrahedra.frame_across(f);
                merged.join(t, neighbour, frame);
                centres[t] = {centres[neighbour].position + lattice.translation(frame), true, true};
            }
            if (!centres[t].is_determined) left.push_back(t);
        }
        if (left.size() == flat.size()) throw InternalError("all tetrahedra are flat");
        flat = std::move(left);
    }
}

}  // namespace

VoronoiCorners voronoi_corners(const Sites& sites, const TorusTetrahedra& tetrahedra,
                               const Eigen::VectorXd& weights) {
    std::vector<Centre> centres = circumcentres(sites, tetrahedra, weights);
    const int n = tetrahedra.n_tetrahedra();
    Merged merged(n);
    // The centres on both sides of a flat tetrahedron may be one.
    merge_flat(sites.reduction().reduced, tetrahedra, centres, merged);
    merge_close(sites, tetrahedra, centres, merged);
    // Number the sets by their first members whose centres are determined.
    VoronoiCorners corners;
    corners.of_tetrahedron.resize(static_cast<std::size_t>(n));
    std::vector<int> number(static_cast<std::size_t>(n), -1);
    std::vector<Offset> frame(static_cast<std::size_t>(n));
    for (int t = 0; t < n; ++t) {
        checkpoint_each(t);
        if (centres[t].is_borrowed) continue;
        const auto [root, offset] = merged.root(t);
        if (number[root] >= 0) continue;
        number[root] = static_cast<int>(corners.positions.size());
        frame[root] = offset;
        corners.positions.push_back(centres[t].position);
    }
    for (int t = 0; t < n; ++t) {
        const auto [root, offset] = merged.root(t);
        corners.of_tetrahedron[t] = {number[root], offset - frame[root]};
    }
    return corners;
}

}  // namespace pcvt::space
