#include "mesher/space/grains/cell_hull.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mesher/base/checkpoint.hpp"
#include "mesher/portable/portable_functions.hpp"
#include "mesher/space/grains/deepest_point.hpp"
#include "mesher/space/grains/tetrahedron_shape.hpp"

namespace pcvt::space {
namespace {

/// Depths over the cube root of the volume: deep enough, and the least, far above rounding.
constexpr double kDeep = 0.15;
constexpr double kLeastDepth = 1e-6;

CellHull numbered(const CellComplex& complex, const GrainSurface& surface,
                  const std::vector<SurfaceTriangle>& triangles) {
    CellHull hull;
    for (const SurfaceTriangle& triangle : triangles) {
        hull.images.insert(hull.images.end(), triangle.begin(), triangle.end());
    }
    std::sort(hull.images.begin(), hull.images.end());
    hull.images.erase(std::unique(hull.images.begin(), hull.images.end()), hull.images.end());
    for (const NodeImage& image : hull.images) {
        hull.points.push_back(surface.position(complex, image));
    }
    for (const auto& [a, b, c] : triangles) {
        hull.triangles.push_back({hull.find(a), hull.find(b), hull.find(c)});
    }
    return hull;
}

/// The centroid of a hull and the cube root of its volume.
std::pair<Vec3, double> centroid_and_size(const CellHull& hull) {
    const Vec3& tip = hull.points[0];
    double volume = 0;
    Vec3 sum = Vec3::Zero();
    for (const auto& [a, b, c] : hull.triangles) {
        const Vec3 from_tip =
            (hull.points[a] - tip) + (hull.points[b] - tip) + (hull.points[c] - tip);
        const double part = volume6(tip, hull.points[a], hull.points[b], hull.points[c]);
        volume += part;
        sum += part * from_tip;
    }
    return {tip + sum / (4 * volume), portable_cbrt(volume / 6)};
}

}  // namespace

int CellHull::find(const NodeImage& image) const {
    const auto found = std::lower_bound(images.begin(), images.end(), image);
    return static_cast<int>(found - images.begin());
}

std::vector<CellHull> cell_hulls(const CellComplex& complex, const GrainSurface& surface) {
    std::vector<std::vector<SurfaceTriangle>> triangles(complex.n_cells);
    for (int f = 0; f < complex.n_faces(); ++f) {
        const CellFace& face = complex.faces[f];
        const auto seen = [&](const NodeImage& image) {
            return NodeImage{image.vertex, image.offset - face.offset};
        };
        for (const SurfaceTriangle& t : surface.triangles[f]) {
            triangles[face.cell].push_back(t);
            triangles[face.neighbour].push_back({seen(t[2]), seen(t[1]), seen(t[0])});
        }
    }
    std::vector<CellHull> hulls;
    for (const auto& some : triangles) {
        checkpoint();
        hulls.push_back(numbered(complex, surface, some));
    }
    return hulls;
}

std::optional<Vec3> kernel_point(const CellHull& hull) {
    constexpr int kSteps = 400;
    constexpr double kFirstStep = 0.3;
    constexpr double kShrink = 0.985;
    std::vector<Vec3> normals;
    for (const auto& [a, b, c] : hull.triangles) {
        normals.push_back(unit_vector(
            cross_product(hull.points[b] - hull.points[a], hull.points[c] - hull.points[a])));
    }
    // The depth below the nearest plane, and the number of that plane.
    const auto depth = [&](const Vec3& x) {
        std::pair<double, std::size_t> least{std::numeric_limits<double>::infinity(), 0};
        for (std::size_t k = 0; k < normals.size(); ++k) {
            const double here = dot_product(normals[k], hull.points[hull.triangles[k][0]] - x);
            if (here < least.first) least = {here, k};
        }
        return least;
    };
    const auto [centroid, size] = centroid_and_size(hull);
    Vec3 best = centroid;
    double deepest = depth(best).first;
    Vec3 x = best;
    double step = kFirstStep * size;
    for (int k = 0; k < kSteps && deepest < kDeep * size; ++k) {
        const auto [here, nearest] = depth(x);
        if (here > deepest) {
            deepest = here;
            best = x;
        }
        x -= step * normals[nearest];
        step *= kShrink;
    }
    if (deepest > kLeastDepth * size) return best;
    // The steps are too long in a cell that is thin or slightly bent.
    std::vector<HalfSpace> inside;
    double extent = 0;
    for (std::size_t k = 0; k < normals.size(); ++k) {
        const Vec3& p = hull.points[hull.triangles[k][0]];
        inside.push_back({normals[k], dot_product(normals[k], p)});
        extent = std::max(extent, distance(p, centroid));
    }
    best = deepest_point(inside, centroid, extent);
    if (!(depth(best).first > kLeastDepth * size)) return std::nullopt;
    return best;
}

}  // namespace pcvt::space
