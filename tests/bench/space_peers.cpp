#include "tests/bench/space_peers.hpp"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_3.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_traits_3.h>

#include <vector>

namespace pcvt::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using PlainSpace = CGAL::Delaunay_triangulation_3<Kernel>;
using SpaceTraits = CGAL::Periodic_3_Delaunay_triangulation_traits_3<Kernel>;
using PeriodicSpace = CGAL::Periodic_3_Delaunay_triangulation_3<SpaceTraits>;

template <class Point>
std::vector<Point> converted(const space::Points& points) {
    std::vector<Point> copy;
    copy.reserve(static_cast<std::size_t>(points.cols()));
    for (const auto& p : points.colwise()) copy.emplace_back(p.x(), p.y(), p.z());
    return copy;
}

}  // namespace

SpaceTriangulation cgal_plain_in_space(const space::Points& points) {
    const auto copy = converted<Kernel::Point_3>(points);
    const auto plain = std::make_shared<PlainSpace>(copy.begin(), copy.end());
    return {static_cast<std::int64_t>(plain->number_of_vertices()),
            static_cast<std::int64_t>(plain->number_of_finite_cells()), plain};
}

SpaceTriangulation cgal_periodic_in_space(const space::Points& points) {
    const auto copy = converted<PeriodicSpace::Point>(points);
    const auto periodic = std::make_shared<PeriodicSpace>();
    periodic->insert(copy.begin(), copy.end(), true);
    return {static_cast<std::int64_t>(periodic->number_of_vertices()),
            static_cast<std::int64_t>(periodic->number_of_cells()), periodic};
}

}  // namespace pcvt::bench
