#include "tests/support/space_power_mirrors.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Regular_triangulation_cell_base_3.h>
#include <CGAL/Regular_triangulation_vertex_base_3.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <utility>

namespace pcvt::testing {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertices =
    CGAL::Triangulation_vertex_base_with_info_3<space::Corner, Kernel,
                                                CGAL::Regular_triangulation_vertex_base_3<Kernel>>;
using Structure =
    CGAL::Triangulation_data_structure_3<Vertices, CGAL::Regular_triangulation_cell_base_3<Kernel>>;
using Regular = CGAL::Regular_triangulation_3<Kernel, Structure>;

constexpr int kCopies = 2;

Regular triangulated_copies(const space::Sites& sites, const Eigen::VectorXd& weights) {
    std::vector<std::pair<Kernel::Weighted_point_3, space::Corner>> copies;
    const space::Lattice& reduced = sites.reduction().reduced;
    for (SiteId s = 0; s < sites.n_sites(); ++s) {
        for (int i = -kCopies; i <= kCopies; ++i) {
            for (int j = -kCopies; j <= kCopies; ++j) {
                for (int k = -kCopies; k <= kCopies; ++k) {
                    const space::Corner corner{s, {i, j, k}};
                    const space::Vec3 p =
                        reduced.to_position(image(sites.coordinates(), corner).at);
                    copies.emplace_back(Kernel::Weighted_point_3({p.x(), p.y(), p.z()}, weights[s]),
                                        corner);
                }
            }
        }
    }
    return Regular(copies.begin(), copies.end());
}

}  // namespace

SpacePowerMirrors space_power_mirrors(const space::Sites& sites, const Eigen::VectorXd& weights) {
    const Regular regular = triangulated_copies(sites, weights);
    SpacePowerMirrors mirrors;
    std::vector<bool> has_cell(static_cast<std::size_t>(sites.n_sites()), false);
    for (const auto v : regular.finite_vertex_handles()) {
        if (v->info().offset == space::Offset{}) has_cell[std::size_t(v->info().site)] = true;
    }
    for (SiteId s = 0; s < sites.n_sites(); ++s) {
        if (!has_cell[std::size_t(s)]) mirrors.hidden.push_back(s);
    }
    for (const auto cell : regular.finite_cell_handles()) {
        space::Tetrahedron t;
        for (int k = 0; k < 4; ++k) t[k] = cell->vertex(k)->info();
        std::sort(t.begin(), t.end());
        if (t[0].offset == space::Offset{}) mirrors.tetrahedra.push_back(t);
    }
    std::sort(mirrors.tetrahedra.begin(), mirrors.tetrahedra.end());
    return mirrors;
}

}  // namespace pcvt::testing
