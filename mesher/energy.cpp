#include "mesher/energy.hpp"

namespace pcvt {
namespace {

/// Adds what the directed edge i -> j = i + d contributes, c the cotangent of the opposite angle.
void add_edge(Energy& sum, SiteId i, SiteId j, const Vec2& d, double c) {
    const double l = d.squaredNorm();
    const double w = -l * c / 12;
    const Vec2 turned(-d.y(), d.x());
    const Vec2 along = w * d;
    const Vec2 across = (w * c / 2) * turned;
    sum.gradient.col(i) += along + across;
    sum.gradient.col(j) += across - along;
    sum.value += l * l * c * (3 + c * c) / 96;
    sum.mass[i] += l * c / 8;
    sum.mass[j] += l * c / 8;
}

}  // namespace

Energy energy(const PeriodicDelaunay& delaunay) {
    const Sites& sites = delaunay.sites();
    const TorusTriangulation& triangulation = delaunay.triangulation();
    const Lattice& reduced = sites.reduction().reduced;
    Eigen::Matrix2d basis;
    basis << reduced.a(), reduced.b();

    const int n = sites.n_sites();
    Energy sum{0, Points::Zero(2, n), Eigen::VectorXd::Zero(n)};
    for (int h = 0; h < triangulation.n_halfedges(); h += 3) {
        const std::array<Corner, 3> corner{triangulation.corner(h), triangulation.corner(h + 1),
                                           triangulation.corner(h + 2)};
        const Image p = image(sites, corner[0].site, corner[0].offset);
        const Image q = image(sites, corner[1].site, corner[1].offset);
        const Image r = image(sites, corner[2].site, corner[2].offset);
        const std::array<Vec2, 3> edge{basis * difference(p, q), basis * difference(q, r),
                                       basis * difference(r, p)};
        const double doubled_area = edge[0].x() * edge[1].y() - edge[0].y() * edge[1].x();
        for (int k = 0; k < 3; ++k) {
            const double cotangent = -edge[(k + 1) % 3].dot(edge[(k + 2) % 3]) / doubled_area;
            add_edge(sum, corner[k].site, corner[(k + 1) % 3].site, edge[k], cotangent);
        }
    }
    return sum;
}

}  // namespace pcvt
