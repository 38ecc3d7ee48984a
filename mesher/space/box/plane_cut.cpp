#include "mesher/space/box/plane_cut.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <tuple>
#include <utility>

#include "mesher/base/checkpoint.hpp"
#include "mesher/space/box/cut_edges.hpp"
#include "mesher/space/box/face_parts.hpp"
#include "mesher/space/mesh/vector_area.hpp"

namespace pcvt::space {
namespace {

/// The sine of the angle between a plane and a face that may have a part in it, and that of a
/// corner between two edges that are not one line.
constexpr double kShallow = 0.1;
constexpr double kTurn = 0.1;

class PlaneCut {
   public:
    PlaneCut(int axis, const Vec3& origin, const Nearness& near, CutCells& cells)
        : axis_(axis),
          near_(near),
          cells_(cells),
          complex_(cells.complex),
          planes_(complex_.reduced, axis, origin) {}

    bool run() {
        find_levels();
        add_crossings();
        number_pieces();
        for (int f = 0; f < complex_.n_faces() && is_sound_; ++f) {
            checkpoint_each(f);
            cut_face(f);
        }
        add_cut_faces();
        if (is_sound_) finish();
        return is_sound_;
    }

   private:
    using Polygon = std::span<const VertexImage>;

    int along(const Offset& offset) const { return offset.components()[axis_]; }
    int level(const VertexImage& image) const {
        return cells_.level[image.vertex][axis_] + 2 * along(image.offset);
    }
    void find_levels() {
        const std::vector<int> levels = put_on_planes(planes_, near_, complex_);
        for (std::size_t v = 0; v < levels.size(); ++v) cells_.level[v][axis_] = levels[v];
    }

    /// The vertex on a plane between two corners of a face on different sides of it.
    VertexImage crossing(VertexImage a, VertexImage b, int plane) {
        if (std::tie(b.vertex, b.offset) < std::tie(a.vertex, a.offset)) std::swap(a, b);
        const Offset step = b.offset - a.offset;
        const int in_frame = plane - along(a.offset);
        const auto next = static_cast<int>(complex_.vertices.size());
        const auto [found, is_new] =
            crossings_.try_emplace({a.vertex, b.vertex, step, in_frame}, next);
        if (is_new) {
            const Vec3 from = complex_.vertices[a.vertex];
            const Vec3 to = complex_.position({b.vertex, step});
            const double u = planes_.height(from);
            Vec3 p = from + (in_frame - u) / (planes_.height(to) - u) * (to - from);
            planes_.put_on(in_frame, p);
            complex_.vertices.push_back(p);
            cells_.level.push_back(between(cells_.level[a.vertex], cells_.level[b.vertex], step));
            cells_.level.back()[axis_] = 2 * in_frame;
        }
        return {found->second, a.offset};
    }

    /// The levels of a point between two vertices, both in one slab of each axis cut before.
    static std::array<int, 3> between(const std::array<int, 3>& a, std::array<int, 3> b,
                                      const Offset& step) {
        for (int k = 0; k < 3; ++k) {
            b[k] += 2 * step.components()[k];
            b[k] = a[k] == b[k] ? a[k] : (std::min(a[k], b[k]) | 1);
        }
        return b;
    }

    /// Adds the crossings of all edges to the corners of the faces.
    void add_crossings() {
        std::vector<VertexImage> corners;
        std::vector<int> begin{0};
        for (int f = 0; f < complex_.n_faces(); ++f) {
            checkpoint_each(f);
            const Polygon face = complex_.corners_of(f);
            for (std::size_t k = 0; k < face.size(); ++k) {
                const VertexImage here = face[k];
                const VertexImage next = face[(k + 1) % face.size()];
                corners.push_back(here);
                const int from = level(here);
                const int to = level(next);
                for (int p = (from >> 1) + 1; 2 * p < to; ++p) {
                    corners.push_back(crossing(here, next, p));
                }
                for (int p = (from - 1) >> 1; 2 * p > to; --p) {
                    corners.push_back(crossing(here, next, p));
                }
            }
            begin.push_back(static_cast<int>(corners.size()));
        }
        complex_.corners = std::move(corners);
        complex_.begin = std::move(begin);
    }

    LevelRange range_of(Polygon face) const {
        LevelRange range;
        for (const VertexImage& corner : face) range.add(level(corner));
        return range;
    }

    void number_pieces() {
        ranges_.resize(static_cast<std::size_t>(complex_.n_cells));
        for (int f = 0; f < complex_.n_faces(); ++f) {
            const CellFace& face = complex_.faces[f];
            const auto [low, high] = range_of(complex_.corners_of(f));
            for (const int end : {low, high}) {
                ranges_[face.cell].add(end);
                ranges_[face.neighbour].add(end - 2 * along(face.offset));
            }
        }
        for (SiteId c = 0; c < complex_.n_cells; ++c) {
            first_piece_.push_back(static_cast<int>(piece_cell_.size()));
            is_sound_ &= ranges_[c].first_slab() <= ranges_[c].last_slab();
            for (int s = ranges_[c].first_slab(); s <= ranges_[c].last_slab(); ++s) {
                piece_cell_.push_back(c);
                piece_slab_.push_back(s);
            }
        }
    }

    int piece(SiteId cell, int slab) {
        const LevelRange& range = ranges_[cell];
        is_sound_ &= slab >= range.first_slab() && slab <= range.last_slab();
        return first_piece_[cell] + slab - range.first_slab();
    }

    void add_face(const CellFace& face, Polygon corners) {
        is_sound_ &= corners.size() >= 3;
        faces_.push_back(face);
        corners_.insert(corners_.end(), corners.begin(), corners.end());
        begin_.push_back(static_cast<int>(corners_.size()));
    }

    /// Adds an edge of the face of both cells at face f; seen from the neighbour, it runs
    /// backwards.
    void add_edge(const CellFace& face, int plane, const VertexImage& from, const VertexImage& to) {
        edges_.push_back({face.cell, plane, from, to});
        edges_.push_back({face.neighbour,
                          plane - along(face.offset),
                          {to.vertex, to.offset - face.offset},
                          {from.vertex, from.offset - face.offset}});
    }

    void cut_face(int f) {
        const CellFace& face = complex_.faces[f];
        const LevelRange range = range_of(complex_.corners_of(f));
        std::vector<VertexImage> rest(complex_.corners_of(f).begin(), complex_.corners_of(f).end());
        for (int p = (range.low + 1) >> 1; 2 * p <= range.high; ++p) {
            FaceParts parts = parts_at(p, rest);
            is_sound_ &= parts.is_sound;
            if (!parts.below.empty()) {
                add_part(face, p - 1, parts.below);
                add_edges(face, p, parts.below, false);
            }
            if (!parts.inside.empty()) add_face_in_plane(face, p, parts.inside);
            // An edge of a face above belongs to the face of the piece below in reverse.
            if (!parts.above.empty()) add_edges(face, p, parts.above, true);
            rest = std::move(parts.above);
        }
        if (!rest.empty()) add_part(face, range.last_slab(), rest);
    }

    /// Divides what a plane and those below it leave of a face.
    FaceParts parts_at(int plane, Polygon corners) const {
        std::vector<SidedCorner> sided;
        for (const VertexImage& corner : corners) {
            const int above = level(corner) - 2 * plane;
            sided.push_back({corner, (above > 0 ? 1 : 0) - (above < 0 ? 1 : 0)});
        }
        return face_parts(sided, [&](Polygon on) { return is_shallow(corners) && turns(on); });
    }

    /// Whether a face is nearly parallel to the planes.
    bool is_shallow(Polygon corners) const {
        const Vec3 up = planes_.up();
        const Vec3 area = area2_of(corners);
        return area.cross(up).norm() < kShallow * area.norm() * up.norm();
    }

    /// Whether corners are not on one line: a face that only touches the plane there would have
    /// triangles in it.
    bool turns(Polygon corners) const {
        Vec3 at = complex_.position(corners.back());
        Vec3 last = at - complex_.position(corners[corners.size() - 2]);
        return std::any_of(corners.begin(), corners.end(), [&](const VertexImage& corner) {
            const Vec3 next = complex_.position(corner) - at;
            const double sine = last.cross(next).norm() / (last.norm() * next.norm());
            at += next;
            last = next;
            return sine > kTurn;
        });
    }

    Vec3 area2_of(Polygon corners) const {
        return twice_vector_area(
            corners, [&](const VertexImage& corner) { return complex_.position(corner); });
    }

    void add_part(const CellFace& face, int slab, Polygon corners) {
        const int here = piece(face.cell, slab);
        const int there = piece(face.neighbour, slab - along(face.offset));
        add_face({here, there, face.offset}, corners);
    }

    /// Adds the edges in a plane of a part of a face, or their reverses.
    void add_edges(const CellFace& face, int plane, Polygon corners, bool reversed) {
        for_each_edge_in(plane, corners, [&](VertexImage from, VertexImage to) {
            if (reversed) std::swap(from, to);
            add_edge(face, plane, from, to);
        });
    }

    template <class Task>
    void for_each_edge_in(int plane, Polygon corners, const Task& task) {
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const VertexImage& from = corners[k];
            const VertexImage& to = corners[(k + 1) % corners.size()];
            if (level(from) == 2 * plane && level(to) == 2 * plane) task(from, to);
        }
    }

    /// A face in a plane belongs to the piece below of one cell and to that above of the other.
    void add_face_in_plane(const CellFace& face, int plane, Polygon corners) {
        const LevelRange& range = ranges_[face.cell];
        const bool is_below = range.high == 2 * plane ||
                              (range.low != 2 * plane && planes_.up().dot(area2_of(corners)) > 0);
        const int below = is_below ? 1 : 0;
        const int here = piece(face.cell, plane - below);
        const int there = piece(face.neighbour, plane - 1 + below - along(face.offset));
        add_face({here, there, face.offset}, corners);
        // The piece above of the neighbour sees the edges of the piece below.
        for_each_edge_in(plane, corners, [&](VertexImage from, VertexImage to) {
            if (!is_below) std::swap(from, to);
            edges_.push_back({face.cell, plane, from, to});
            edges_.push_back({face.neighbour,
                              plane - along(face.offset),
                              {from.vertex, from.offset - face.offset},
                              {to.vertex, to.offset - face.offset}});
        });
    }

    /// Adds a face wherever a plane cuts a cell: seen from above, it runs through its edges in
    /// reverse.
    void add_cut_faces() {
        edges_ = boundaries_of(std::move(edges_));
        std::size_t n_cuts = 0;
        for (std::size_t begin = 0; begin < edges_.size() && is_sound_;) {
            const auto [cell, plane, from, to] = edges_[begin];
            std::size_t end = begin;
            while (end < edges_.size() && edges_[end].cell == cell && edges_[end].plane == plane) {
                ++end;
            }
            if (2 * plane > ranges_[cell].low && 2 * plane < ranges_[cell].high) {
                add_cut_face(std::span(edges_).subspan(begin, end - begin));
                ++n_cuts;
            }
            begin = end;
        }
        // Each of the other pieces of a cell has one face to the piece below it.
        is_sound_ &= n_cuts + complex_.n_cells == piece_cell_.size();
    }

    void add_cut_face(std::span<const CutEdge> edges) {
        std::vector<VertexImage> cycle = cycle_of(edges);
        is_sound_ &= !cycle.empty();
        if (!is_sound_) return;
        std::reverse(cycle.begin(), cycle.end());
        const auto [cell, plane, from, to] = edges[0];
        const int below = piece(cell, plane - 1);
        add_face({below, piece(cell, plane), {}}, cycle);
    }

    void finish() {
        std::vector<SiteId> cell;
        std::vector<std::array<int, 3>> slab;
        for (std::size_t p = 0; p < piece_cell_.size(); ++p) {
            cell.push_back(cells_.cell[piece_cell_[p]]);
            slab.push_back(cells_.slab[piece_cell_[p]]);
            slab.back()[axis_] = piece_slab_[p];
        }
        cells_.cell = std::move(cell);
        cells_.slab = std::move(slab);
        complex_.n_cells = static_cast<int>(piece_cell_.size());
        complex_.faces = std::move(faces_);
        complex_.begin = std::move(begin_);
        complex_.corners = std::move(corners_);
    }

    int axis_;
    Nearness near_;
    CutCells& cells_;
    CellComplex& complex_;
    AxisPlanes planes_;
    bool is_sound_ = true;
    /// By the vertices of an edge, the offset of the second, and the plane in the frame of the
    /// first.
    std::map<std::tuple<int, int, Offset, int>, int> crossings_;
    /// For each cell its levels and its first piece; for each piece its cell and its slab.
    std::vector<LevelRange> ranges_;
    std::vector<int> first_piece_;
    std::vector<SiteId> piece_cell_;
    std::vector<int> piece_slab_;
    std::vector<CutEdge> edges_;
    /// As in CellComplex.
    std::vector<CellFace> faces_;
    std::vector<int> begin_{0};
    std::vector<VertexImage> corners_;
};

}  // namespace

bool cut_along(int axis, const Vec3& origin, const Nearness& near, CutCells& cells) {
    return PlaneCut(axis, origin, near, cells).run();
}

}  // namespace pcvt::space
