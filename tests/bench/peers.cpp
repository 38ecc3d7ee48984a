#include "tests/bench/peers.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_2.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_traits_2.h>

#include <algorithm>
#include <cmath>
#include <vector>
#include <voro++/voro++.hh>

#include "mesher/plane/delaunay/mirror_diagram.hpp"
#include "mesher/plane/geometry/sites.hpp"

namespace pcvt::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Plain = CGAL::Delaunay_triangulation_2<Kernel>;
using PeriodicTraits = CGAL::Periodic_2_Delaunay_triangulation_traits_2<Kernel>;
using Periodic = CGAL::Periodic_2_Delaunay_triangulation_2<PeriodicTraits>;

/// The thickness of voro++'s prisms, in units of sqrt(area / n), and the number of cells in one of
/// its blocks. Measured from 0.01 to 3 and from 1.5 to 8: the time has a flat minimum near these
/// values.
constexpr double kThickness = 0.3;
constexpr double kCellsPerBlock = 4;

template <class Point>
void append_copy(const plane::Points& points, double dx, double dy, std::vector<Point>& copies) {
    for (Eigen::Index s = 0; s < points.cols(); ++s) {
        copies.emplace_back(points(0, s) + dx, points(1, s) + dy);
    }
}

template <class Triangulation>
std::shared_ptr<Triangulation> inserted(std::vector<typename Triangulation::Point> points) {
    auto triangulation = std::make_shared<Triangulation>();
    triangulation->insert(points.begin(), points.end());
    return triangulation;
}

bool in_unit_square(const Kernel::Point_2& p) {
    return p.x() >= 0 && p.x() < 1 && p.y() >= 0 && p.y() < 1;
}

/// Triangles whose lexicographically least corner lies in the unit square: one of each orbit.
std::int64_t count_orbits(const Plain& copies) {
    std::int64_t n_orbits = 0;
    for (const auto face : copies.finite_face_handles()) {
        const auto& least = std::min(
            {face->vertex(0)->point(), face->vertex(1)->point(), face->vertex(2)->point()});
        n_orbits += in_unit_square(least) ? 1 : 0;
    }
    return n_orbits;
}

template <class Triangulation>
std::int64_t n_vertices_of(const Triangulation& triangulation) {
    return static_cast<std::int64_t>(triangulation.tds().number_of_vertices());
}

template <class Triangulation>
std::int64_t n_triangles_of(const Triangulation& triangulation) {
    return static_cast<std::int64_t>(triangulation.number_of_faces());
}

/// A container for `points` with sqrt(area / n) as the unit of length, because voro++'s tolerances
/// are absolute.
std::shared_ptr<voro::container> filled_container(const plane::Points& points) {
    const double side = std::sqrt(static_cast<double>(points.cols()));
    const int n_blocks = std::max(1, static_cast<int>(side / std::sqrt(kCellsPerBlock)));
    auto container = std::make_shared<voro::container>(0, side, 0, side, 0, kThickness, n_blocks,
                                                       n_blocks, 1, true, true, false, 8);
    for (Eigen::Index s = 0; s < points.cols(); ++s) {
        container->put(static_cast<int>(s), side * points(0, s), side * points(1, s),
                       kThickness / 2);
    }
    return container;
}

}  // namespace

Diagram cgal_plain(const plane::Points& points) {
    std::vector<Kernel::Point_2> copy;
    copy.reserve(static_cast<std::size_t>(points.cols()));
    append_copy(points, 0, 0, copy);
    const auto plain = inserted<Plain>(std::move(copy));
    return {n_vertices_of(*plain) - 1, n_triangles_of(*plain), {}, plain};
}

Diagram cgal_nine_copies(const plane::Points& points) {
    std::vector<Kernel::Point_2> copies;
    copies.reserve(9 * static_cast<std::size_t>(points.cols()));
    for (const int i : {-1, 0, 1}) {
        for (const int j : {-1, 0, 1}) append_copy(points, i, j, copies);
    }
    const auto plain = inserted<Plain>(std::move(copies));
    return {n_vertices_of(*plain) - 1, count_orbits(*plain), {}, plain};
}

Diagram cgal_periodic(const plane::Points& points) {
    std::vector<Periodic::Point> copy;
    copy.reserve(static_cast<std::size_t>(points.cols()));
    append_copy(points, 0, 0, copy);
    const auto periodic = inserted<Periodic>(std::move(copy));
    return {n_vertices_of(*periodic), n_triangles_of(*periodic), {}, periodic};
}

Diagram mirrors(const plane::Points& points) {
    const plane::Sites sites(plane::Lattice::rectangle(1, 1), points);
    const auto diagram = std::make_shared<plane::MirrorDiagram>(mirror_diagram(sites));
    return {sites.n_sites(), static_cast<std::int64_t>(diagram->triangles.size()), {}, diagram};
}

Diagram voro_prisms(const plane::Points& points) {
    const auto container = filled_container(points);
    voro::voronoicell cell;
    voro::c_loop_all loop(*container);
    std::int64_t n_cells = 0;
    std::int64_t n_sides = 0;
    double volume = 0;
    if (loop.start()) {
        do {
            if (!container->compute_cell(cell, loop)) continue;
            n_cells += 1;
            n_sides += cell.number_of_faces() - 2;
            volume += cell.volume();
        } while (loop.inc());
    }
    const double area = volume / (kThickness * static_cast<double>(points.cols()));
    return {n_cells, n_sides / 3, area, container};
}

}  // namespace pcvt::bench
