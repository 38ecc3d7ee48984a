#pragma once

#include <Eigen/Core>
#include <optional>

#include "mesher/plane/delaunay/periodic_delaunay.hpp"
#include "mesher/plane/mesh/tile_options.hpp"

namespace pcvt::plane {

/// Edges shorter than this, in units of h = sqrt(area / number of cells), must be removed before
/// cells are meshed (short_edges.hpp).
inline constexpr double kShortGrainEdge = 0.02;
/// Vertices nearer to the box than this, in units of h, must be moved onto it before the pieces are
/// meshed (box_outline.hpp), so that fewer pieces are slivers.
inline constexpr double kGrainSnap = 0.03;

/// The cells or triangles of columns x rows domains as a mesh of their torus.
struct TorusMesh {
    /// Without short edges, and in pieces if it is cut along the box; between walls with the mirror
    /// images.
    PeriodicMesh mesh;
    /// The corner of the domain along which it is cut, or round which its faces are to lie, length
    /// units.
    Vec2 corner;
    /// With weights: those by which the cells have their areas again, one a site, length^2.
    Eigen::VectorXd weights = {};
    /// With weights, the largest relative error of the areas of cells.
    std::optional<double> area_error = {};
    /// The shortest edge that the cut has made, in units of h; nullopt: the mesh is not cut.
    std::optional<double> box_shortest_edge = {};
    /// The opposite corner of the domain.
    Vec2 opposite_corner = Vec2::Zero();

    bool is_cut() const { return box_shortest_edge.has_value(); }
};

/// The cells of one domain, between the walls if there are some, or the triangles of the torus, in
/// the plane of the user.
PeriodicMesh domain_mesh(const PeriodicDelaunay& delaunay, const TileOptions& options);

/// Repeats the mesh of a domain, removes its short edges, gives power cells back their areas, and
/// cuts it along the box, as the options say.
///
/// Example usage:
///   const TileOptions options{.outline = Outline::kBox, .repeat = {2, 1}};
///   const TorusMesh torus = torus_mesh(domain_mesh(delaunay, options), delaunay, options);
///
/// @param domain  domain_mesh().
TorusMesh torus_mesh(PeriodicMesh domain, const PeriodicDelaunay& delaunay,
                     const TileOptions& options);

}  // namespace pcvt::plane
