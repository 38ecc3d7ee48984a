#pragma once

#include <functional>

#include "mesher/plane/interfaces/inclusion_set.hpp"
#include "mesher/plane/interfaces/size_limits.hpp"

namespace pcvt::plane {

/// The target lengths of the chords along an interface.
struct InterfaceSizing {
    /// The target length of a chord at a point, length units, anywhere in the plane.
    std::function<double(const Vec2&)> spacing;
    /// The limits of the chords of each inclusion, in its frame.
    std::vector<std::vector<SizeLimit>> limits;
};

/// A corner of the polygon of chords that replaces the curve of an inclusion, and the circle on
/// which the seeds beside its two chords lie.
struct InterfaceNode {
    Vec2 point;
    double radius;
    /// At a sharp corner one seed on the bisector is beside both chords: +1 inside of the
    /// inclusion, -1 outside; else 0.
    int shared_side = 0;
};

/// A number of seeds, two a chord, that the curve of a shape has at least, for any spacing.
double fewest_seeds(const Shape& shape);

/// Refuses a number of sites that cannot suffice for the seeds of many shapes, before any work.
/// @throws InvalidInput with the number that is needed.
void require_enough_sites(int n_sites, double n_seeds);

/// Divides the curve of inclusion k into chords, shorter than the spacing where the curve is bent,
/// where another part of the interface is near, and at the limits. Corners of a polygon are nodes.
/// The polygon of the nodes has the area of the shape; those of ellipses lie somewhat outside of
/// the curve.
/// @returns the nodes, counter-clockwise, in the frame of the inclusion.
/// @throws InvalidInput naming the line if a gap is so narrow that more than 10^7 steps are needed.
std::vector<InterfaceNode> interface_nodes(const InclusionSet& set, int k,
                                           const InterfaceSizing& sizing);

}  // namespace pcvt::plane
