#pragma once

#include <array>
#include <vector>

#include "mesher/lattice/lattice.hpp"

namespace pcvt {

/// Whether a vertex lies on a line u = k, and on a line v = l, of a box.
using OnLines = std::array<bool, 2>;

/// Which vertices and edges of cells a cut moves onto its lines.
struct BoxSnaps {
    /// An edge that is bent through a corner of the box.
    struct Bend {
        /// The corner of the cells that the edge leaves.
        int corner;
        /// The corner of the box, in the frame of the cell.
        Offset offset;
        friend bool operator==(const Bend&, const Bend&) = default;
    };
    /// For each vertex of the cells; empty: none is moved.
    std::vector<OnLines> vertices = {};
    std::vector<Bend> bends = {};

    friend bool operator==(const BoxSnaps&, const BoxSnaps&) = default;
};

/// What an earlier cut moved is moved again within this many snapping distances.
inline constexpr double kHeldSnap = 4.0 / 3;

/// The distances within which vertices and edges are moved onto the lines of a box, length units.
struct SnapReach {
    /// Of what an earlier cut did not move.
    double fresh;
    /// Of what it moved.
    double held;
};

/// Decides which vertices and edges are moved.
///
/// Example usage:
///   BoxSnapper snapper(lattice, reach_after(earlier, snap), earlier);
///   const OnLines on = snapper.lines_near(v, u);
///   if (on[0]) u[0] = std::round(u[0]);
class BoxSnapper {
   public:
    BoxSnapper(const Lattice& lattice, const SnapReach& reach, const BoxSnaps& earlier)
        : lattice_(lattice), reach_(reach), earlier_(earlier) {}

    /// Returns the lines of each family onto which vertex v is moved: none, one, or both.
    /// @param u  lattice coordinates.
    OnLines lines_near(int v, const Vec2& u) const;

    /// Whether an edge that passes a corner of the box at a distance is bent through it.
    bool is_bent(const BoxSnaps::Bend& bend, double distance) const;

   private:
    double reach(bool was_moved) const { return was_moved ? reach_.held : reach_.fresh; }

    Lattice lattice_;
    SnapReach reach_;
    const BoxSnaps& earlier_;
};

/// Returns the reach of a cut after an earlier one, of none if `earlier` is empty: what was moved
/// stays longer, and only what is very near is moved in addition. So cuts and small changes of the
/// cells, in turn, soon come to rest.
SnapReach reach_after(const BoxSnaps& earlier, double snap);

}  // namespace pcvt
