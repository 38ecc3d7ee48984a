#include "mesher/plane/mesh/interface_proof.hpp"

#include <cmath>

#include "mesher/base/checkpoint.hpp"

namespace pcvt::plane {
namespace {

/// In units of the area of the domain.
constexpr double kSameArea = 1e-12;

/// The halfedge of the inner cell that is the chord, or -1.
int halfedge_of(const PeriodicMesh& cells, const Chord& chord) {
    const double near = kSameVertex * std::sqrt(cells.lattice.area() / cells.n_faces());
    const auto is_node = [&](int c, const Vec2& node) {
        return (cells.point(c) - node).norm() <= near;
    };
    for (int c = cells.face_begin[chord.inside]; c < cells.face_begin[chord.inside + 1]; ++c) {
        if (cells.corner_face[cells.opposite[c]] != chord.outside) continue;
        if (cells.frame_across(c) != chord.offset) continue;
        if (is_node(c, chord.from) && is_node(cells.next(c), chord.to)) return c;
    }
    return -1;
}

std::vector<int> chord_halfedges(const PeriodicMesh& cells, const std::vector<Chord>& chords) {
    std::vector<int> halfedges;
    for (const Chord& chord : chords) {
        checkpoint_each(static_cast<long>(halfedges.size()));
        halfedges.push_back(halfedge_of(cells, chord));
    }
    return halfedges;
}

}  // namespace

bool every_chord_is_an_edge(const PeriodicMesh& cells, const std::vector<Chord>& chords) {
    const std::vector<int> halfedges = chord_halfedges(cells, chords);
    return std::find(halfedges.begin(), halfedges.end(), -1) == halfedges.end();
}

std::optional<std::string> interface_violation(const PeriodicMesh& cells,
                                               const InterfaceSites& interfaces,
                                               std::span<const int> inclusion) {
    // Law (1).
    const std::vector<int> halfedges = chord_halfedges(cells, interfaces.chords);
    std::vector<bool> is_chord(static_cast<std::size_t>(cells.n_corners()), false);
    for (std::size_t k = 0; k < halfedges.size(); ++k) {
        if (halfedges[k] < 0) return "chord " + std::to_string(k) + " is not an edge of the cells";
        is_chord[halfedges[k]] = true;
        is_chord[cells.opposite[halfedges[k]]] = true;
    }
    // Law (2).
    const auto n_sites = static_cast<int>(inclusion.size());
    for (int c = 0; c < cells.face_begin[n_sites]; ++c) {
        checkpoint_each(c);
        const int here = cells.corner_face[c];
        const int there = cells.corner_face[cells.opposite[c]];
        const int beyond = there < n_sites ? inclusion[there] : -1;
        if ((inclusion[here] != beyond) == is_chord[c]) continue;
        return "the edge between sites " + std::to_string(here) + " and " + std::to_string(there) +
               (is_chord[c] ? " is a chord inside of one material"
                            : " lies between materials and is not a chord");
    }
    // Law (3).
    std::vector<double> area(interfaces.polygons.size(), 0.0);
    for (int f = 0; f < n_sites; ++f) {
        if (inclusion[f] >= 0) area[inclusion[f]] += polygon_area(face_polygon(cells, f));
    }
    for (std::size_t i = 0; i < area.size(); ++i) {
        const double of_polygon = polygon_area(interfaces.polygons[i]);
        area[i] -= of_polygon;
        const int parent = interfaces.parents[i];
        if (parent >= 0) area[parent] += of_polygon;
    }
    for (std::size_t i = 0; i < area.size(); ++i) {
        if (std::abs(area[i]) <= kSameArea * cells.lattice.area()) continue;
        return "the cells of inclusion " + std::to_string(i) +
               " do not have the area of its polygon";
    }
    return std::nullopt;
}

}  // namespace pcvt::plane
