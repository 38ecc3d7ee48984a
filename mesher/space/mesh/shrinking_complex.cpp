#include "mesher/space/mesh/shrinking_complex.hpp"

#include <algorithm>
#include <tuple>

#include "mesher/base/checkpoint.hpp"
#include "mesher/portable/portable_functions.hpp"
#include "mesher/space/mesh/polyhedron_graph.hpp"

namespace pcvt::space {
namespace {

/// A cell keeps this part of its volume.
constexpr double kLeastVolume = 0.5;

/// Least distance of a cell's centroid from the planes between its site and its neighbours, in
/// units of the distance between the sites. It exceeds the rounding of positions in files.
constexpr double kLeastDepth = 1e-6;

template <class T>
void keep_once(std::vector<T>& items) {
    std::sort(items.begin(), items.end());
    items.erase(std::unique(items.begin(), items.end()), items.end());
}

/// Sorts edges by their length and leaves each once.
void sort_once(std::vector<ShortEdge>& edges) {
    const auto key = [](const ShortEdge& e) { return std::tie(e.length, e.from, e.to); };
    std::sort(edges.begin(), edges.end(),
              [&](const ShortEdge& s, const ShortEdge& t) { return key(s) < key(t); });
    edges.erase(
        std::unique(edges.begin(), edges.end(),
                    [&](const ShortEdge& s, const ShortEdge& t) { return key(s) == key(t); }),
        edges.end());
}

}  // namespace

ShrinkingComplex::ShrinkingComplex(const CellComplex& complex, double shortest)
    : complex_(complex),
      part_(shortest),
      spacing_(portable_cbrt(complex.reduced.volume() / complex.n_cells)),
      shortest_(shortest * spacing_),
      positions_(complex.vertices),
      moved_(complex.vertices.size(), 0),
      is_left_(complex.vertices.size(), true),
      uses_(static_cast<std::size_t>(complex.n_cells)),
      cells_(complex.vertices.size()) {
    for (int f = 0; f < complex.n_faces(); ++f) {
        checkpoint_each(f);
        const auto corners = complex.corners_of(f);
        faces_.emplace_back(corners.begin(), corners.end());
        const CellFace& face = complex.faces[f];
        uses_[face.cell].push_back({f, false, {}});
        uses_[face.neighbour].push_back({f, true, -face.offset});
        for (const VertexImage& corner : corners) {
            cells_[corner.vertex].push_back(face.cell);
            cells_[corner.vertex].push_back(face.neighbour);
        }
    }
    for (std::vector<SiteId>& cells : cells_) keep_once(cells);
    for (const CellBody& body : cell_bodies(complex)) volumes_.push_back(body.volume);
}

CellComplex ShrinkingComplex::result() const {
    CellComplex left{.reduced = complex_.reduced,
                     .n_cells = complex_.n_cells,
                     .sites = complex_.sites,
                     .short_edges = part_};
    std::vector<int> number(positions_.size());
    for (std::size_t v = 0; v < positions_.size(); ++v) {
        number[v] = static_cast<int>(left.vertices.size());
        if (is_left_[v]) left.vertices.push_back(positions_[v]);
    }
    for (std::size_t f = 0; f < faces_.size(); ++f) {
        if (faces_[f].empty()) continue;
        left.faces.push_back(complex_.faces[f]);
        for (const VertexImage& corner : faces_[f]) {
            left.corners.push_back({number[corner.vertex], corner.offset});
        }
        left.begin.push_back(static_cast<int>(left.corners.size()));
    }
    return left;
}

Vec3 ShrinkingComplex::position(const VertexImage& image) const {
    return positions_[image.vertex] + complex_.reduced.translation(image.offset);
}

double ShrinkingComplex::length(const ShortEdge& edge) const {
    return (position(edge.to) - positions_[edge.from]).norm();
}

/// How far a point of an edge is from the vertices of the diagram that would lie there.
double ShrinkingComplex::would_move(const ShortEdge& edge, const Vec3& end) const {
    return std::max((end - positions_[edge.from]).norm() + moved_[edge.from],
                    (end - position(edge.to)).norm() + moved_[edge.to.vertex]);
}

ShortEdge ShrinkingComplex::edge_of(int f, std::size_t k) const {
    const VertexImage& a = faces_[f][k];
    const VertexImage& b = faces_[f][(k + 1) % faces_[f].size()];
    const auto& [from, to] = a.vertex < b.vertex ? std::tie(a, b) : std::tie(b, a);
    ShortEdge edge{0, from.vertex, {to.vertex, to.offset - from.offset}};
    edge.length = length(edge);
    return edge;
}

void ShrinkingComplex::add_edges_below(double limit, int f, std::vector<ShortEdge>& edges) const {
    checkpoint_each(f);
    for (std::size_t k = 0; k < faces_[f].size(); ++k) {
        const ShortEdge edge = edge_of(f, k);
        if (edge.from != edge.to.vertex && edge.length < limit) edges.push_back(edge);
    }
}

std::vector<ShortEdge> ShrinkingComplex::edges_below(double length) const {
    std::vector<ShortEdge> edges;
    for (int f = 0; f < n_faces(); ++f) add_edges_below(length, f, edges);
    sort_once(edges);
    return edges;
}

std::vector<ShortEdge> ShrinkingComplex::edges_below(double length,
                                                     const std::vector<int>& faces) const {
    std::vector<ShortEdge> edges;
    for (const int f : faces) add_edges_below(length, f, edges);
    sort_once(edges);
    return edges;
}

bool ShrinkingComplex::is_short(const ShortEdge& edge) const {
    return is_left_[edge.from] && is_left_[edge.to.vertex] && length(edge) < shortest_;
}

std::vector<int> ShrinkingComplex::faces_at(const std::vector<int>& vertices) const {
    std::vector<int> faces;
    for (const int v : vertices) {
        for (const SiteId cell : cells_[v]) {
            for (const Use& use : uses_[cell]) faces.push_back(use.face);
        }
    }
    keep_once(faces);
    std::erase_if(faces, [&](int f) {
        return std::none_of(faces_[f].begin(), faces_[f].end(), [&](const VertexImage& corner) {
            return std::binary_search(vertices.begin(), vertices.end(), corner.vertex);
        });
    });
    return faces;
}

double ShrinkingComplex::sharpest_of(const std::vector<int>& faces) const {
    double sharpest = 180;
    for (const int f : faces) {
        if (faces_[f].empty()) continue;
        sharpest = std::min(sharpest, sharpest_corner(faces_[f], [&](const VertexImage& corner) {
                                return position(corner);
                            }));
    }
    return sharpest;
}

ShrinkingComplex::State ShrinkingComplex::state_of(const std::vector<int>& vertices,
                                                   const std::vector<int>& faces) const {
    State state{vertices, faces};
    for (const int v : vertices) {
        state.positions.push_back(positions_[v]);
        state.moved.push_back(moved_[v]);
        state.cells.push_back(cells_[v]);
    }
    for (const int f : faces) state.corners.push_back(faces_[f]);
    return state;
}

void ShrinkingComplex::restore(const State& state) {
    for (std::size_t k = 0; k < state.vertices.size(); ++k) {
        const int v = state.vertices[k];
        is_left_[v] = true;
        positions_[v] = state.positions[k];
        moved_[v] = state.moved[k];
        cells_[v] = state.cells[k];
    }
    for (std::size_t k = 0; k < state.faces.size(); ++k) faces_[state.faces[k]] = state.corners[k];
}

std::vector<SiteId> ShrinkingComplex::cells_at(const ShortEdge& edge) const {
    std::vector<SiteId> cells = cells_[edge.from];
    const std::vector<SiteId>& others = cells_[edge.to.vertex];
    cells.insert(cells.end(), others.begin(), others.end());
    keep_once(cells);
    return cells;
}

/// The faces that a cell has without an edge, seen from outside, in its frame.
std::vector<Corners> ShrinkingComplex::faces_without(const ShortEdge& edge, SiteId cell) const {
    std::vector<Corners> faces;
    for (const Use& use : uses_[cell]) {
        Corners corners = shrunk(faces_[use.face], edge);
        if (corners.size() < 3) continue;
        for (VertexImage& corner : corners) corner.offset = corner.offset + use.shift;
        // The first corner stays, so that the fan of the face does.
        if (use.reversed) std::reverse(corners.begin() + 1, corners.end());
        faces.push_back(std::move(corners));
    }
    return faces;
}

/// The position of a corner when the first end of an edge comes to lie at `end`.
Vec3 ShrinkingComplex::position_with(const ShortEdge& edge, const Vec3& end,
                                     const VertexImage& corner) const {
    if (corner.vertex != edge.from) return position(corner);
    return end + complex_.reduced.translation(corner.offset);
}

CellBody ShrinkingComplex::body(const std::vector<Corners>& faces, const ShortEdge& edge,
                                const Vec3& end) const {
    std::vector<Vec3> points;
    PyramidSum sum(position_with(edge, end, faces[0][0]));
    for (const Corners& face : faces) {
        points.clear();
        for (const VertexImage& corner : face) {
            points.push_back(position_with(edge, end, corner));
        }
        sum.add(points);
    }
    return sum.body();
}

/// Whether a centroid is nearer to the site of its cell than to those of all neighbours that
/// share a face with the cell when an edge is removed.
bool ShrinkingComplex::is_on_its_side(const Vec3& centroid, const ShortEdge& edge,
                                      SiteId cell) const {
    const Vec3& site = complex_.sites[cell];
    return std::all_of(uses_[cell].begin(), uses_[cell].end(), [&](const Use& use) {
        if (shrunk(faces_[use.face], edge).size() < 3) return true;
        const CellFace& face = complex_.faces[use.face];
        const Vec3 to_other = complex_.sites[use.reversed ? face.cell : face.neighbour] +
                              complex_.reduced.translation(use.reversed ? use.shift : face.offset) -
                              site;
        const double along = (centroid - site).dot(to_other) / to_other.squaredNorm();
        return along < 0.5 - kLeastDepth;
    });
}

bool ShrinkingComplex::may_remove(const ShortEdge& edge, const Vec3& end) const {
    if (would_move(edge, end) > shortest_) return false;
    for (const SiteId cell : cells_at(edge)) {
        const std::vector<Corners> faces = faces_without(edge, cell);
        if (!is_polyhedron(faces)) return false;
        const CellBody left = body(faces, edge, end);
        if (!(left.volume >= kLeastVolume * volumes_[cell])) return false;
        if (!is_on_its_side(left.centroid, edge, cell)) return false;
    }
    return true;
}

/// The sharpest corner, degrees, of the faces at the ends of an edge: as they are, or where
/// the edge has shrunk to a point.
double ShrinkingComplex::sharpest_at(const ShortEdge& edge, const Vec3* end) const {
    double sharpest = 180;
    for (const SiteId cell : cells_at(edge)) {
        for (const Use& use : uses_[cell]) {
            const Corners& whole = faces_[use.face];
            const Corners corners = end == nullptr ? whole : shrunk(whole, edge);
            if (corners.size() < 3) continue;
            const auto is_end = [&](const VertexImage& corner) {
                return corner.vertex == edge.from || corner.vertex == edge.to.vertex;
            };
            if (std::none_of(corners.begin(), corners.end(), is_end)) continue;
            const auto at = [&](const VertexImage& corner) {
                return end == nullptr ? position(corner) : position_with(edge, *end, corner);
            };
            sharpest = std::min(sharpest, sharpest_corner(corners, at));
        }
    }
    return sharpest;
}

std::optional<Vec3> ShrinkingComplex::middle_of(const ShortEdge& edge) const {
    const Vec3 half = (positions_[edge.from] + position(edge.to)) / 2;
    return may_remove(edge, half) ? std::optional<Vec3>(half) : std::nullopt;
}

std::optional<Vec3> ShrinkingComplex::widest_of(const ShortEdge& edge) const {
    const Vec3 half = (positions_[edge.from] + position(edge.to)) / 2;
    std::optional<Vec3> best;
    double widest = std::min(kSharpCorner, sharpest_at(edge, nullptr) - kCornerGain);
    for (const Vec3& end : {half, positions_[edge.from], position(edge.to)}) {
        const double sharpest = sharpest_at(edge, &end);
        if (!(sharpest > widest + kCornerGain) || !may_remove(edge, end)) continue;
        widest = sharpest;
        best = end;
    }
    return best;
}

void ShrinkingComplex::remove(const ShortEdge& edge, const Vec3& end) {
    const double moved = would_move(edge, end);
    const std::vector<SiteId> cells = cells_at(edge);
    for (const SiteId cell : cells) {
        for (const Use& use : uses_[cell]) {
            Corners& face = faces_[use.face];
            face = shrunk(std::move(face), edge);
            if (face.size() < 3) face.clear();
        }
    }
    positions_[edge.from] = end;
    moved_[edge.from] = moved;
    cells_[edge.from] = cells;
    is_left_[edge.to.vertex] = false;
}

}  // namespace pcvt::space
