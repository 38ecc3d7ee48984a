#pragma once

#include <optional>
#include <vector>

#include "mesher/space/mesh/shrunk_face.hpp"

namespace pcvt::space {

/// A Voronoi diagram that loses short edges: each shrinks to a point, which is one of its ends from
/// then on, and the other end is no vertex any more. Numbers of faces and vertices are those of the
/// diagram.
///
/// Example usage:
///     ShrinkingComplex shrinking(complex, 1e-3);
///     for (const ShortEdge& edge : shrinking.edges_below(shrinking.shortest())) {
///         if (!shrinking.is_short(edge)) continue;
///         if (const auto end = shrinking.middle_of(edge)) shrinking.remove(edge, *end);
///     }
///     const CellComplex left = shrinking.result();
///
/// Laws, tested by number: (1) to (3) and (5) of without_short_edges().
class ShrinkingComplex {
   public:
    /// @param shortest  a part of h. Shorter edges are short.
    ShrinkingComplex(const CellComplex& complex, double shortest);

    int n_vertices() const { return static_cast<int>(positions_.size()); }
    int n_faces() const { return static_cast<int>(faces_.size()); }
    /// None of a face that has vanished.
    const Corners& corners_of(int face) const { return faces_[face]; }
    /// The mean spacing of the sites and the length of short edges, length units.
    double spacing() const { return spacing_; }
    double shortest() const { return shortest_; }

    /// The edge of a face from corner k to the next one. It begins at the vertex with the lower
    /// number, since the neighbours of the face see it the other way round.
    ShortEdge edge_of(int face, std::size_t k) const;
    /// Edges of all faces, or of some, between different vertices and below a length; each once,
    /// the shortest first.
    std::vector<ShortEdge> edges_below(double length) const;
    std::vector<ShortEdge> edges_below(double length, const std::vector<int>& faces) const;
    /// Whether an edge is still there and short.
    bool is_short(const ShortEdge& edge) const;
    /// Ascending numbers of the faces with one of these vertices, which are ascending, too.
    std::vector<int> faces_at(const std::vector<int>& vertices) const;
    /// The sharpest corner of faces, degrees.
    double sharpest_of(const std::vector<int>& faces) const;

    /// The middle of an edge, if the edge may shrink to it.
    std::optional<Vec3> middle_of(const ShortEdge& edge) const;
    /// The middle of an edge or one of its ends: where the sharpest corner of the faces there is
    /// widest, if the edge may shrink to it and that corner is not below 15 degrees and sharper
    /// than before.
    std::optional<Vec3> widest_of(const ShortEdge& edge) const;
    void remove(const ShortEdge& edge, const Vec3& end);

    /// Vertices and faces while edges between these vertices are removed.
    struct State {
        std::vector<int> vertices;
        std::vector<int> faces;
        std::vector<Vec3> positions = {};
        std::vector<double> moved = {};
        std::vector<std::vector<SiteId>> cells = {};
        std::vector<Corners> corners = {};
    };
    State state_of(const std::vector<int>& vertices, const std::vector<int>& faces) const;
    void restore(const State& state);

    CellComplex result() const;

   private:
    /// A face of a cell: translated by `shift` it is in the frame of the cell.
    struct Use {
        int face;
        bool reversed;
        Offset shift;
    };

    Vec3 position(const VertexImage& image) const;
    Vec3 position_with(const ShortEdge& edge, const Vec3& end, const VertexImage& corner) const;
    double length(const ShortEdge& edge) const;
    double would_move(const ShortEdge& edge, const Vec3& end) const;
    void add_edges_below(double limit, int face, std::vector<ShortEdge>& edges) const;
    std::vector<SiteId> cells_at(const ShortEdge& edge) const;
    std::vector<Corners> faces_without(const ShortEdge& edge, SiteId cell) const;
    CellBody body(const std::vector<Corners>& faces, const ShortEdge& edge, const Vec3& end) const;
    bool is_on_its_side(const Vec3& centroid, const ShortEdge& edge, SiteId cell) const;
    bool may_remove(const ShortEdge& edge, const Vec3& end) const;
    double sharpest_at(const ShortEdge& edge, const Vec3* end) const;

    const CellComplex& complex_;
    double part_;
    double spacing_;
    double shortest_;
    std::vector<Vec3> positions_;
    /// The largest distance between a vertex and those of the diagram that lie there now.
    std::vector<double> moved_;
    std::vector<bool> is_left_;
    std::vector<Corners> faces_;
    std::vector<std::vector<Use>> uses_;
    /// The cells round each vertex.
    std::vector<std::vector<SiteId>> cells_;
    /// The volumes of the cells of the diagram.
    std::vector<double> volumes_;
};

/// The greatest corner, degrees, that counts as sharp, and the least difference of two corners.
inline constexpr double kSharpCorner = 15;
inline constexpr double kCornerGain = 1e-6;

}  // namespace pcvt::space
