#pragma once

#include "mesher/plane/geometry/sites.hpp"
#include "mesher/plane/interfaces/interface_nodes.hpp"

namespace pcvt::plane {

/// A piece of an interface, from a node to the next one counter-clockwise round the inclusion: the
/// edge between the cells of two seeds that are mirrored in it.
struct Chord {
    int inclusion;
    /// The seeds on its two sides, numbered as in InterfaceSites.
    SiteId inside;
    SiteId outside;
    /// User's basis: the seed `outside`, translated, is the mirror image of `inside`.
    Offset offset;
    /// The ends, in the frame of the seed `inside` at its position in the reduced domain, length
    /// units.
    Vec2 from;
    Vec2 to;
};

/// A circle round a node, through the seeds of its two chords. While no site lies inside of the
/// circles, chords are edges of the cells.
struct EmptyCircle {
    /// Reduced basis, in [0, 1)^2.
    Vec2 centre;
    /// Length units.
    double radius;
};

/// The pairs of seeds along the interfaces of inclusions; between walls those of the given ones,
/// without their mirror images.
struct InterfaceSites {
    /// 2 x n, reduced basis, multiples of 2^-51 in [0, 1): as Sites stores them. Mirror images are
    /// exact but for the rounding to this grid.
    Points coordinates;
    /// The innermost inclusion in which each seed lies, or -1.
    std::vector<int> inclusion;
    /// InclusionSet::parent() of each inclusion.
    std::vector<int> parents;
    std::vector<Chord> chords;
    /// Between walls with their mirror images.
    std::vector<EmptyCircle> circles;
    /// The chords of each inclusion, in its frame, counter-clockwise.
    std::vector<Polygon> polygons;

    int n_seeds() const { return static_cast<int>(inclusion.size()); }
};

/// Places pairs of seeds along all interfaces: the two-dimensional case of VoroCrust (A. Abdelkader
/// et al. 2020). Nodes divide each curve (interface_nodes.hpp); a circle round each of them
/// intersects those of its neighbours in two points, which are mirrored in the chord between the
/// nodes. At sharp corners the two chords share the seed on the bisector.
///
/// Example usage:
///
///     const InclusionSet set(lattice, {{Circle{{0, 0}, 0.2}, 1, 1}});
///     const InterfaceSites pairs = place_interface_sites(set, [&](const Vec2&) { return h; });
///
/// Laws, tested by number:
///   (1) No seed lies inside of a circle. Exactly four lie on it, at a sharp corner three, and all
///       others are farther away by a hundredth of its radius.
///   (2) Every chord is an edge between the cells of its two seeds, from node to node, in the
///       Voronoi diagram of the seeds, and of the seeds and any sites outside of the circles.
///   (3) The polygon of an inclusion has the area of its shape.
///
/// Where seeds would violate law (1), chords become shorter until they do not.
/// @param spacing  the target length of a chord at a point, length units, anywhere in the plane.
/// @throws InvalidInput naming the line where this never ends, at a corner of some degrees.
InterfaceSites place_interface_sites(const InclusionSet& set,
                                     const std::function<double(const Vec2&)>& spacing);

}  // namespace pcvt::plane
