#include "mesher/space/delaunay/site_insertion.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "mesher/space/delaunay/growing_tetrahedra.hpp"
#include "mesher/space/delaunay/mirror_diagram.hpp"
#include "mesher/space/geometry/insertion_order.hpp"

namespace pcvt::space {
namespace {

using Cell = GrowingTetrahedra::Cell;

/// The sample has one site a box. Spheres through sites near the middles of boxes have about the
/// diameter of two box widths, so that boxes of the first width are just narrow enough where there
/// are many sites to choose from; a sample that is too coarse is refined.
constexpr double kWidestBox = 0.2;
constexpr double kRefinement = 0.75;
/// A sample of more than this fraction of the sites is not worth while.
constexpr int kSitesPerBox = 4;
/// Spheres of the sample must be clearly smaller than half a period, because their radii are
/// rounded; tetrahedra so thin that this margin might not suffice are refused.
constexpr double kLargestSphere = 0.45;
constexpr double kThinnest = 0x1p-44;

/// Boxes with edges of about one length, `width` of the shortest height of the lattice.
std::array<int, 3> boxes_of(const Lattice& reduced, double width) {
    const Vec3 heights = reduced.heights();
    std::array<int, 3> n_boxes;
    for (int k = 0; k < 3; ++k) {
        n_boxes[k] = int(std::ceil(heights[k] / (width * heights.minCoeff())));
    }
    return n_boxes;
}

/// Whether every sphere extends by less than half a period in each coordinate.
bool has_small_spheres(const Sites& sites, const Gram& gram,
                       const std::vector<Tetrahedron>& tetrahedra) {
    const Lattice& reduced = sites.reduction().reduced;
    const double unit = reduced.a().norm() / std::sqrt(gram.aa);
    const double widest = unit / reduced.heights().minCoeff();
    return std::all_of(tetrahedra.begin(), tetrahedra.end(), [&](const Tetrahedron& t) {
        const auto at = [&](int k) { return image(sites.coordinates(), t[k]); };
        const Image p = at(0);
        const Vec3 d = at(1).at - p.at;
        const Vec3 e = at(2).at - p.at;
        const Vec3 f = at(3).at - p.at;
        const double largest = std::max({d.squaredNorm(), e.squaredNorm(), f.squaredNorm()});
        if (!(d.dot(e.cross(f)) > kThinnest * largest * std::sqrt(largest))) return false;
        const Vec3 c = circumcentre(gram, p, at(1), at(2), at(3));
        const double radius = std::sqrt(gram.squared_length(c.x(), c.y(), c.z()));
        return 2 * radius * widest < kLargestSphere;
    });
}

/// A sample with small spheres, and its triangulation.
struct Start {
    std::vector<SiteId> sample;
    TorusTetrahedra tetrahedra;
};

std::optional<Start> find_start(const Sites& sites, const Gram& gram) {
    for (double width = kWidestBox;; width *= kRefinement) {
        const auto n_boxes = boxes_of(sites.reduction().reduced, width);
        const double n_all = double(n_boxes[0]) * n_boxes[1] * n_boxes[2];
        if (kSitesPerBox * n_all > sites.n_sites()) return std::nullopt;
        std::vector<SiteId> sample = spread_sample(sites.coordinates(), n_boxes);
        if (2 * double(sample.size()) < n_all) return std::nullopt;
        const Sites few = some_of(sites, sample);
        const std::vector<Tetrahedron> tetrahedra = mirror_diagram(few).tetrahedra;
        if (!has_small_spheres(few, gram, tetrahedra)) continue;
        return Start{std::move(sample), TorusTetrahedra(few.n_sites(), tetrahedra)};
    }
}

/// The numbers that cells get when they are sorted by their smallest site; -1 for gaps.
std::vector<int> sorted_numbers(const std::vector<Cell>& cells, const std::vector<SiteId>& order) {
    std::vector<int> begin(order.size() + 1, 0);
    const auto smallest = [&](const Cell& cell) {
        const auto& [a, b, c, d] = cell.site;
        return std::min({order[a], order[b], order[c], order[d]});
    };
    for (const Cell& cell : cells) {
        if (!cell.is_gap()) ++begin[smallest(cell) + 1];
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<int> number(cells.size(), -1);
    for (std::size_t t = 0; t < cells.size(); ++t) {
        checkpoint_each(long(t));
        if (!cells[t].is_gap()) number[t] = begin[smallest(cells[t])]++;
    }
    return number;
}

/// Writes the offsets of corners 1, 2 and 3 relative to corner 0, those of their nearest images.
/// @returns six times the volume of the tetrahedron, in units of the domain.
double unwrap(const Cell& cell, const Points& coordinates, TetrahedronOffsets& offsets) {
    std::array<Vec3, 3> edge;
    for (int k = 0; k < 3; ++k) {
        const Vec3 d = coordinates.col(cell.site[k + 1]) - coordinates.col(cell.site[0]);
        // Adding 0.5 is exact, or rounds numbers that are far from the next integer.
        const Vec3 whole = -(d.array() + 0.5).floor();
        edge[k] = d + whole;
        for (int axis = 0; axis < 3; ++axis) {
            offsets.relative[3 * k + axis] = std::int8_t(whole[axis]);
        }
    }
    return edge[0].dot(edge[1].cross(edge[2]));
}

TorusTetrahedra finished(const std::vector<Cell>& cells, const Points& coordinates,
                         const std::vector<SiteId>& order) {
    const std::vector<int> number = sorted_numbers(cells, order);
    const auto n = static_cast<std::size_t>(
        std::count_if(number.begin(), number.end(), [](int t) { return t >= 0; }));
    std::vector<SiteId> sites(4 * n);
    std::vector<int> opposite(4 * n);
    std::vector<TetrahedronOffsets> offsets(n);
    double volume = 0;
    for (std::size_t t = 0; t < cells.size(); ++t) {
        checkpoint_each(long(t));
        if (number[t] < 0) continue;
        for (int k = 0; k < 4; ++k) {
            const int o = cells[t].opposite[k];
            sites[4 * number[t] + k] = order[cells[t].site[k]];
            opposite[4 * number[t] + k] = 4 * number[o / 4] + o % 4;
        }
        volume += unwrap(cells[t], coordinates, offsets[number[t]]);
    }
    if (!(std::abs(volume - 6) < 1e-6)) {
        throw InternalError("the tetrahedra of inserted sites do not fill the torus");
    }
    return {static_cast<int>(order.size()), std::move(sites), std::move(opposite),
            std::move(offsets)};
}

}  // namespace

std::optional<TorusTetrahedra> inserted_tetrahedra(const Sites& sites) {
    const Gram gram = gram_of(sites.reduction().reduced);
    const std::optional<Start> start = find_start(sites, gram);
    if (!start) return std::nullopt;
    const std::vector<SiteId> order = insertion_order(sites.coordinates(), start->sample);
    const Sites ordered = some_of(sites, order);
    GrowingTetrahedra growing(gram, ordered.coordinates(), start->tetrahedra);
    for (SiteId s = start->tetrahedra.n_sites(); s < sites.n_sites(); ++s) {
        checkpoint_each(s, 64);
        if (!growing.insert(s)) throw InternalError("two sites coincide");
    }
    return finished(growing.cells(), ordered.coordinates(), order);
}

}  // namespace pcvt::space
