#pragma once

#include <array>
#include <vector>

#include "mesher/plane/geometry/lattice.hpp"

namespace pcvt::plane {

/// An image of a vertex orbit.
struct BoxNode {
    int vertex;
    Offset offset;
    friend bool operator==(const BoxNode&, const BoxNode&) = default;
};

/// Corners in counter-clockwise order.
using BoxPolygon = std::vector<BoxNode>;

/// The lines u = k, parallel to b (axis 0), and v = l, parallel to a (axis 1), in lattice
/// coordinates with the corner of the box at 0, together with vertex orbits on and between the
/// lines.
///
/// A representative lies in the half-open box; it lies on a line if and only if its coordinate is
/// exactly 0. Integer offsets therefore decide on which side of a line an image lies, never
/// comparisons of coordinates.
///
/// Example usage:
///   BoxLines lines(lattice);
///   BoxPolygon cell;
///   for (const Vec2& u : representatives) cell.push_back({lines.add_vertex(u), {0, 0}});
///   for (const BoxPolygon& piece : lines.split(cell)) store(piece);
class BoxLines {
   public:
    static constexpr std::array kAxes{0, 1};
    static int whole(Offset o, int axis) { return axis == 0 ? o.i : o.j; }
    static Offset along(int axis, int k) { return axis == 0 ? Offset{k, 0} : Offset{0, k}; }

    explicit BoxLines(const Lattice& lattice) : lattice_(lattice) {}

    int n_vertices() const { return static_cast<int>(vertices_.size()); }
    /// Returns the lattice coordinates of the representative, in [0, 1).
    const Vec2& vertex(int v) const { return vertices_[v]; }
    bool on_line(int v, int axis) const { return vertices_[v][axis] == 0; }
    bool on_any_line(int v) const { return on_line(v, 0) || on_line(v, 1); }
    int add_vertex(const Vec2& u) {
        vertices_.push_back(u);
        if (corner_ < 0 && u == Vec2::Zero()) corner_ = n_vertices() - 1;
        return n_vertices() - 1;
    }
    /// Returns the vertex at the corner of the box and adds it if there is none yet.
    int corner_vertex() { return corner_ < 0 ? add_vertex({0, 0}) : corner_; }

    bool is_corner(int v) const { return v == corner_; }

    double coordinate(const BoxNode& node, int axis) const {
        return whole(node.offset, axis) + vertices_[node.vertex][axis];
    }
    Vec2 coordinates(const BoxNode& node) const {
        return {coordinate(node, 0), coordinate(node, 1)};
    }
    /// The lines of a family strictly between two nodes; empty if first > last.
    struct Range {
        int first;
        int last;
    };
    Range lines_between(const BoxNode& p, const BoxNode& q, int axis) const;

    /// Returns the parts into which the lines cut a simple polygon; each lies in one image of the
    /// box.
    /// @pre The polygon has a node wherever a line crosses one of its sides.
    std::vector<BoxPolygon> split(const BoxPolygon& polygon);

   private:
    /// Line k of a family, directed so that the side `kept` lies on its left.
    struct Line {
        int axis;
        int k;
        int kept;
    };
    /// A part of a polygon's boundary on the kept side whose ends lie on the line.
    struct Chain {
        BoxPolygon nodes;
        bool taken = false;
    };

    int side(const BoxNode& node, int axis, int k) const;
    bool comes_before(const BoxNode& p, const BoxNode& q, const Line& line) const;
    bool turns_left(const BoxNode& p, const BoxNode& q, const BoxNode& r) const;
    BoxPolygon corners_on_line(const BoxNode& from, const BoxNode& to, const Line& line);
    BoxPolygon nodes_on_line(const BoxPolygon& polygon, const Line& line);
    std::vector<Chain> chains_of(const BoxPolygon& polygon, const Line& line) const;
    std::vector<BoxPolygon> kept_parts(const BoxPolygon& polygon, const Line& line);
    void split_by(const BoxPolygon& polygon, int axis, int k, std::vector<BoxPolygon>& before,
                  std::vector<BoxPolygon>& behind);
    std::vector<BoxPolygon> split_along(const std::vector<BoxPolygon>& polygons, int axis);

    Lattice lattice_;
    std::vector<Vec2> vertices_;
    int corner_ = -1;
};

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
    /// For each vertex of the cells whether it stays where it is, with the edges between two of
    /// these; empty: none does.
    std::vector<bool> still = {};

    bool is_still(int v) const { return !still.empty() && still[v]; }

    friend bool operator==(const BoxSnaps&, const BoxSnaps&) = default;
};

/// Vertices and edges that an earlier cut moved are moved again within this many snapping
/// distances.
inline constexpr double kHeldSnap = 4.0 / 3;

/// The distances within which vertices and edges are moved onto the lines of a box, length units.
struct SnapReach {
    /// Snapping distance of vertices and edges that the earlier cut left in place.
    double fresh;
    /// Snapping distance of vertices and edges that the earlier cut moved.
    double held;
    /// Snapping distance of vertices that stay where they are, for rounding errors only.
    double still;
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
    /// @param is_still  both of its ends are.
    bool is_bent(const BoxSnaps::Bend& bend, double distance, bool is_still) const;

   private:
    double reach(bool was_moved, bool is_still) const {
        return is_still ? reach_.still : was_moved ? reach_.held : reach_.fresh;
    }

    Lattice lattice_;
    SnapReach reach_;
    const BoxSnaps& earlier_;
};

/// Returns the reach of a cut after an earlier one; `earlier` is empty for a first cut. Vertices
/// and edges that the earlier cut moved are moved again from farther away; others only from very
/// near. So cuts and small changes of the cells, in turn, soon come to rest.
/// @param least  SnapReach::still.
SnapReach reach_after(const BoxSnaps& earlier, double snap, double least);

}  // namespace pcvt::plane
