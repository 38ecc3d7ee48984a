#include "mesher/space/box/plane_cut.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <tuple>
#include <utility>

#include "mesher/base/checkpoint.hpp"

namespace pcvt::space {
namespace {

/// An edge of a cut face: two of its corners in the frame of a cell, in the order in which the face
/// of the piece below the plane runs through them.
struct CutEdge {
    SiteId cell;
    int plane;
    VertexImage from;
    VertexImage to;

    friend auto operator<=>(const CutEdge&, const CutEdge&) = default;
};

/// The lowest and the highest level of something.
struct LevelRange {
    int low = std::numeric_limits<int>::max();
    int high = std::numeric_limits<int>::min();

    void add(int level) {
        low = std::min(low, level);
        high = std::max(high, level);
    }
    int first_slab() const { return low >> 1; }
    int last_slab() const { return (high - 1) >> 1; }
};

class PlaneCut {
   public:
    PlaneCut(int axis, const Vec3& origin, const Nearness& near, CutCells& cells)
        : axis_(axis), origin_(origin), near_(near), cells_(cells), complex_(cells.complex) {}

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
    double height(const Vec3& p) const { return complex_.reduced.to_lattice(p - origin_)[axis_]; }
    void put_on(int plane, Vec3& p) const {
        p += (plane - height(p)) * complex_.reduced.periods()[axis_];
    }

    /// For each vertex how near to a plane it lies on it.
    std::vector<double> nearness() const {
        const std::size_t n = complex_.vertices.size();
        if (near_.snapped == 0) return std::vector<double>(n, near_.all);
        std::vector<double> shortest(n, kEdgeOverSnap * near_.snapped);
        for (int f = 0; f < complex_.n_faces(); ++f) {
            const Polygon corners = complex_.corners_of(f);
            for (std::size_t k = 0; k < corners.size(); ++k) {
                const VertexImage& a = corners[k];
                const VertexImage& b = corners[(k + 1) % corners.size()];
                const double edge = (complex_.position(b) - complex_.position(a)).norm();
                for (const int v : {a.vertex, b.vertex}) shortest[v] = std::min(shortest[v], edge);
            }
        }
        for (double& edge : shortest) edge = std::max(near_.all, edge / kEdgeOverSnap);
        return shortest;
    }

    void find_levels() {
        const double spacing = complex_.reduced.heights()[axis_];
        const std::vector<double> near = nearness();
        for (std::size_t v = 0; v < complex_.vertices.size(); ++v) {
            const double u = height(complex_.vertices[v]);
            const double plane = std::round(u);
            const bool is_on = std::abs(u - plane) <= near[v] / spacing;
            if (is_on) put_on(static_cast<int>(plane), complex_.vertices[v]);
            cells_.level[v][axis_] =
                is_on ? 2 * static_cast<int>(plane) : 2 * static_cast<int>(std::floor(u)) + 1;
        }
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
            const double u = height(from);
            Vec3 p = from + (in_frame - u) / (height(to) - u) * (to - from);
            put_on(in_frame, p);
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
        const Polygon corners = complex_.corners_of(f);
        const LevelRange range = range_of(corners);
        if (range.low == range.high && range.low % 2 == 0) {
            add_face_in_plane(face, range.low / 2, corners);
            return;
        }
        std::vector<VertexImage> part;
        for (int s = range.first_slab(); s <= range.last_slab(); ++s) {
            part.clear();
            for (const VertexImage& corner : corners) {
                if (level(corner) >= 2 * s && level(corner) <= 2 * s + 2) part.push_back(corner);
            }
            const int here = piece(face.cell, s);
            const int there = piece(face.neighbour, s - along(face.offset));
            add_face({here, there, face.offset}, part);
        }
        for (int p = (range.low + 1) >> 1; 2 * p <= range.high; ++p) {
            find_cut_edge(face, p, corners, range);
        }
    }

    /// The cell lies wholly on one side of a face in a plane.
    void add_face_in_plane(const CellFace& face, int plane, Polygon corners) {
        const LevelRange& range = ranges_[face.cell];
        is_sound_ &= range.high == 2 * plane || range.low == 2 * plane;
        const int below = range.high == 2 * plane ? 1 : 0;
        const int here = piece(face.cell, plane - below);
        const int there = piece(face.neighbour, plane - 1 + below - along(face.offset));
        add_face({here, there, face.offset}, corners);
    }

    /// Finds where a plane p cuts a face, or touches it along an edge.
    void find_cut_edge(const CellFace& face, int plane, Polygon corners, const LevelRange& range) {
        std::vector<VertexImage> on;
        std::size_t n_ups = 0;
        VertexImage first_up{};
        for (std::size_t k = 0; k < corners.size(); ++k) {
            if (level(corners[k]) != 2 * plane) continue;
            on.push_back(corners[k]);
            if (level(corners[(k + 1) % corners.size()]) > 2 * plane) {
                first_up = corners[k];
                ++n_ups;
            }
        }
        if (on.size() == 2 && range.low < 2 * plane && range.high > 2 * plane) {
            // The face of the lower piece runs from where this one rises to where it comes down.
            is_sound_ &= n_ups == 1;
            const VertexImage& other = on[0] == first_up ? on[1] : on[0];
            add_edge(face, plane, first_up, other);
        } else if (on.size() == 2) {
            // An edge of a face above belongs to the face of the piece below in reverse.
            VertexImage from = on[0];
            VertexImage to = on[1];
            if (corners.front() == from && corners.back() == to) std::swap(from, to);
            if (range.low == 2 * plane) std::swap(from, to);
            add_edge(face, plane, from, to);
        } else {
            is_sound_ &= on.size() == 1 && (range.low == 2 * plane || range.high == 2 * plane);
        }
    }

    /// Adds a face wherever a plane cuts a cell: seen from above, it runs through its edges in
    /// reverse.
    void add_cut_faces() {
        std::sort(edges_.begin(), edges_.end());
        edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
        for (std::size_t begin = 0; begin < edges_.size() && is_sound_;) {
            const auto [cell, plane, from, to] = edges_[begin];
            std::size_t end = begin;
            while (end < edges_.size() && edges_[end].cell == cell && edges_[end].plane == plane) {
                ++end;
            }
            if (2 * plane > ranges_[cell].low && 2 * plane < ranges_[cell].high) {
                add_cut_face(std::span(edges_).subspan(begin, end - begin));
            }
            begin = end;
        }
    }

    void add_cut_face(std::span<const CutEdge> edges) {
        std::vector<VertexImage> cycle;
        VertexImage at = edges[0].from;
        do {
            const auto next = std::lower_bound(
                edges.begin(), edges.end(), at,
                [](const CutEdge& e, const VertexImage& image) { return e.from < image; });
            is_sound_ &= next != edges.end() && next->from == at && cycle.size() < edges.size();
            if (!is_sound_) return;
            cycle.push_back(at);
            at = next->to;
        } while (at != edges[0].from);
        is_sound_ &= cycle.size() == edges.size();
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
    const Vec3& origin_;
    Nearness near_;
    CutCells& cells_;
    CellComplex& complex_;
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
