#pragma once

#include <vector>

#include "mesher/plane/interfaces/torus_grid.hpp"

namespace pcvt::plane {

/// Places on the torus in a tree, to find all within a distance also where they are dense in one
/// region and sparse in another; torus_grid.hpp is for places that are spread evenly, and for ones
/// that come one by one.
///
/// Example usage:
///
///     const PlaceTree tree(reduced, places);
///     for (const auto& [place, offset] : tree.within(u, distance)) ...
///
/// Law, tested by number:
///   (1) within() returns the same places as a loop over all places and offsets.
class PlaceTree {
   public:
    /// The place, translated by the offset.
    struct Found {
        int place;
        Offset offset;

        friend bool operator==(const Found&, const Found&) = default;
    };

    /// @param reduced  a reduced basis, in which coordinates and offsets are.
    /// @param places   2 x n, each coordinate in [0, 1).
    PlaceTree(const Lattice& reduced, Points places);

    /// The images nearer to the point with the coordinates u than `distance`, in the order in which
    /// a TorusGrid of as many items visits them.
    std::vector<Found> within(const Vec2& u, double distance) const;

   private:
    struct Node {
        int first;
        int last;
        int second;
        Vec2 low;
        Vec2 high;
    };

    int add_node(int first, int last);

    Lattice reduced_;
    TorusGrid grid_;
    Points places_;
    /// The places in the order of the nodes.
    std::vector<int> order_;
    /// The first child of a node follows it.
    std::vector<Node> nodes_;
};

}  // namespace pcvt::plane
