#include "tests/support/engine_twin.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "mesher/plane/delaunay/mirror_diagram.hpp"
#include "mesher/plane/geometry/polygon.hpp"

namespace pcvt::testing {
namespace {

constexpr double kSameAsFresh = 1e-12;
/// The corners of pieces have rounding errors near 1e-15 of the domain.
constexpr double kSameAsPieces = 1e-11;

template <class... Words>
std::string words(const Words&... word) {
    std::ostringstream text;
    text.precision(17);
    (text << ... << word);
    return text.str();
}

std::string broken_topology(const plane::TorusTriangulation& t) {
    if (t.n_triangles() != 2 * t.n_sites()) return words("there are ", t.n_triangles());
    for (int h = 0; h < t.n_halfedges(); ++h) {
        const int o = t.opposite(h);
        const bool linked = o != h && t.opposite(o) == h && t.edge_offset(o) == -t.edge_offset(h) &&
                            t.corner(o).site == t.corner(plane::TorusTriangulation::next(h)).site;
        if (!linked) return words("halfedges ", h, " and ", o, " are not opposite");
    }
    return {};
}

std::string broken_coordinates(const plane::Points& coordinates) {
    for (const double u : coordinates.reshaped()) {
        const bool on_grid = std::nearbyint(u * 0x1p51) == u * 0x1p51;
        if (!on_grid || !(u >= -1.5 && u < 2.5)) return words("coordinate ", u, " is not allowed");
    }
    return {};
}

/// Origin, target, offset from origin to target; wrapped sites in the caller's order.
using Edge = std::tuple<SiteId, SiteId, plane::Offset>;

std::string in_words(const Edge& edge) {
    const auto& [from, to, offset] = edge;
    return words(from, "-", to, " (", offset.i, ", ", offset.j, ")");
}

/// The edges whose two triangles are not exactly cocircular: they belong to every Delaunay
/// triangulation of the sites.
template <class Original>
std::vector<Edge> firm_edges(const plane::TorusTriangulation& t, const plane::Points& coordinates,
                             const plane::Gram& gram, const Original& original) {
    const auto at = [&](const plane::Corner& c) { return image(coordinates, c.site, c.offset); };
    const auto whole = [&](SiteId s) {
        const plane::Vec2 floor = coordinates.col(s).array().floor();
        return plane::Offset{static_cast<int>(floor.x()), static_cast<int>(floor.y())};
    };
    std::vector<Edge> edges;
    for (int h = 0; h < t.n_halfedges(); ++h) {
        const plane::Corner from = t.corner(h);
        const plane::Corner to = t.corner(plane::TorusTriangulation::next(h));
        const plane::Corner apex = t.corner(plane::TorusTriangulation::previous(h));
        if (in_circle(gram, at(from), at(to), at(apex), at(t.apex_across(h))) == 0) continue;
        edges.emplace_back(original(from.site), original(to.site),
                           t.edge_offset(h) + whole(to.site) - whole(from.site));
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

std::string first_difference(const std::vector<Edge>& ours, const std::vector<Edge>& theirs) {
    std::vector<Edge> only;
    std::set_difference(ours.begin(), ours.end(), theirs.begin(), theirs.end(),
                        std::back_inserter(only));
    if (!only.empty())
        return words("edge ", in_words(only.front()), " is not in the mirror diagram");
    std::set_difference(theirs.begin(), theirs.end(), ours.begin(), ours.end(),
                        std::back_inserter(only));
    if (!only.empty()) return words("edge ", in_words(only.front()), " of the mirrors is missing");
    return {};
}

/// An energy in the caller's order.
struct OrderedEnergy {
    double value = 0;
    plane::Points gradient;
    Eigen::VectorXd mass;
};

OrderedEnergy in_callers_order(const plane::MovingDelaunay& delaunay, const Energy& energy) {
    const int n = delaunay.n_sites();
    OrderedEnergy ordered{energy.value, plane::Points(2, n), Eigen::VectorXd(n)};
    for (SiteId s = 0; s < n; ++s) {
        ordered.gradient.col(delaunay.original_id(s)) = energy.gradient.segment<2>(2 * s);
        ordered.mass[delaunay.original_id(s)] = energy.mass[s];
    }
    return ordered;
}

/// The gradient of a cell whose site is as far from its centroid as points of the domain are from
/// their sites, in the root mean square: 0.8 h^3 for regular cells, more for thin ones.
double gradient_scale(const OrderedEnergy& energy) {
    return 2 * energy.mass.maxCoeff() * std::sqrt(energy.value / energy.mass.sum());
}

std::string difference(const OrderedEnergy& ours, const OrderedEnergy& theirs, double tolerance) {
    const double value = std::abs(ours.value - theirs.value) / theirs.value;
    if (!(value <= tolerance)) return words("F differs by ", value, " F");
    const double longest = std::sqrt(theirs.gradient.colwise().squaredNorm().maxCoeff());
    const double gradient = (ours.gradient - theirs.gradient).cwiseAbs().maxCoeff() /
                            std::max(longest, gradient_scale(theirs));
    if (!(gradient <= tolerance)) return words("the gradient differs by ", gradient);
    const double mass = (ours.mass - theirs.mass).cwiseAbs().maxCoeff() / theirs.mass.maxCoeff();
    if (!(mass <= tolerance)) return words("the masses differ by ", mass);
    return {};
}

/// Adds the integrals of |p - x|^2, -2 (p - x) and 1 over a polygon, with x at the origin.
void integrate(const plane::Polygon& polygon, SiteId site, OrderedEnergy& sum) {
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const plane::Vec2& p = polygon[k];
        const plane::Vec2& q = polygon[(k + 1) % polygon.size()];
        const double twice = plane::cross(p, q);
        sum.mass[site] += twice / 2;
        sum.gradient.col(site) -= twice / 3 * (p + q);
        sum.value += twice / 12 * (p.squaredNorm() + p.dot(q) + q.squaredNorm());
    }
}

}  // namespace

plane::Sites sites_of(const plane::MovingDelaunay& delaunay, const plane::Sites& original) {
    plane::Points coordinates(2, delaunay.n_sites());
    for (SiteId s = 0; s < delaunay.n_sites(); ++s) {
        coordinates.col(delaunay.original_id(s)) = delaunay.coordinates().col(s);
    }
    return {original.lattice(), original.reduction(), std::move(coordinates)};
}

std::string broken_law(const plane::MovingDelaunay& delaunay, const plane::Sites& sites) {
    plane::TorusTriangulation triangulation = delaunay.triangulation();
    if (auto fault = broken_topology(triangulation); !fault.empty()) return fault;
    if (auto fault = broken_coordinates(delaunay.coordinates()); !fault.empty()) return fault;
    const plane::LawsonFlips look(triangulation, delaunay.coordinates(),
                                  gram_of(sites.reduction().reduced));
    for (int t = 0; t < triangulation.n_triangles(); ++t) {
        if (!look.is_counter_clockwise(t)) {
            return words("triangle ", t, " is not counter-clockwise");
        }
    }
    for (int h = 0; h < triangulation.n_halfedges(); ++h) {
        if (!look.is_locally_delaunay(h)) return words("edge ", h, " is not locally Delaunay");
    }
    return {};
}

std::string difference_from_mirrors(const plane::MovingDelaunay& delaunay,
                                    const plane::Sites& sites) {
    const plane::Gram gram = gram_of(sites.reduction().reduced);
    const plane::TorusTriangulation mirrors(sites.n_sites(), mirror_diagram(sites).triangles);
    return first_difference(
        firm_edges(delaunay.triangulation(), delaunay.coordinates(), gram,
                   [&](SiteId s) { return delaunay.original_id(s); }),
        firm_edges(mirrors, sites.coordinates(), gram, [](SiteId s) { return s; }));
}

std::string difference_from_new_build(const plane::MovingDelaunay& delaunay, const Energy& energy,
                                      const plane::Sites& sites) {
    plane::MovingDelaunay rebuilt(sites);
    Workers one(1);
    Energy rebuilt_energy;
    if (!plane::EnergyPass(rebuilt, one).evaluate(rebuilt_energy)) return "a new build failed";
    if (rebuilt.counts().n_flips + rebuilt.counts().n_rebuilds > 0)
        return "a new build was repaired";
    const auto difference_words =
        difference(in_callers_order(delaunay, energy), in_callers_order(rebuilt, rebuilt_energy),
                   kSameAsFresh);
    return difference_words.empty() ? "" : difference_words + " from a new build";
}

std::string difference_from_pieces(const plane::MovingDelaunay& delaunay, const Energy& energy,
                                   const plane::Sites& sites) {
    const int n = sites.n_sites();
    OrderedEnergy sum{0, plane::Points::Zero(2, n), Eigen::VectorXd::Zero(n)};
    for (const plane::Piece& piece : mirror_diagram(sites, plane::WithPieces::kYes).pieces) {
        const plane::Vec2 origin =
            sites.coordinates().col(piece.site) + plane::Vec2(piece.offset.i, piece.offset.j);
        plane::Polygon polygon;
        for (const plane::Vec2& u : piece.polygon) {
            polygon.push_back(delaunay.frame().to_position(u - origin));
        }
        integrate(polygon, piece.site, sum);
    }
    const auto difference_words =
        difference(in_callers_order(delaunay, energy), sum, kSameAsPieces);
    return difference_words.empty() ? "" : difference_words + " from the pieces";
}

}  // namespace pcvt::testing
