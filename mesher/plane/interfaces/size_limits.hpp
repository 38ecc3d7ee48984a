#pragma once

#include <vector>

#include "mesher/plane/geometry/lattice.hpp"

namespace pcvt::plane {

/// A limit on the length of chords at a point; from there it grows with the distance.
struct SizeLimit {
    Vec2 point;
    double size;
};

/// The least size at p that the limits allow.
double size_at(const std::vector<SizeLimit>& limits, const Vec2& p);

/// The same for many points: limits in a tree of bounding boxes.
///
/// Example usage:
///
///     const SizeLimits limits(list);
///     for (const Vec2& p : points) sizes.push_back(limits.at(p));
///
/// Law, tested by number:
///   (1) at(p) is size_at(list, p).
class SizeLimits {
   public:
    explicit SizeLimits(const std::vector<SizeLimit>& limits);

    double at(const Vec2& p) const;

   private:
    /// A range of limits, their bounding box and the least of their sizes. The first child of a
    /// node follows it.
    struct Node {
        int first;
        int last;
        int second;
        Vec2 low;
        Vec2 high;
        double least;
    };

    int add_node(int first, int last);
    void search(const Vec2& p, int n, double& size) const;

    std::vector<SizeLimit> limits_;
    std::vector<Node> nodes_;
};

}  // namespace pcvt::plane
