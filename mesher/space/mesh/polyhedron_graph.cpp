#include "mesher/space/mesh/polyhedron_graph.hpp"

#include <algorithm>

namespace pcvt::space {
namespace {

bool has_corner(const Corners& face, const VertexImage& corner) {
    return std::find(face.begin(), face.end(), corner) != face.end();
}

/// Whether the corners that a face shares with another one follow each other.
bool meets_in_one_chain(const Corners& face, const Corners& other) {
    int n_chains = 0;
    bool before = has_corner(other, face.back());
    for (const VertexImage& corner : face) {
        const bool here = has_corner(other, corner);
        if (here && !before) ++n_chains;
        before = here;
    }
    return n_chains <= 1;
}

}  // namespace

bool is_polyhedron(const std::vector<Corners>& faces) {
    if (faces.size() < 4) return false;
    std::vector<std::pair<VertexImage, VertexImage>> sides;
    Corners points;
    for (const Corners& face : faces) {
        for (std::size_t k = 0; k < face.size(); ++k) {
            sides.emplace_back(face[k], face[(k + 1) % face.size()]);
        }
        points.insert(points.end(), face.begin(), face.end());
        Corners sorted = face;
        std::sort(sorted.begin(), sorted.end());
        if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return false;
    }
    std::sort(sides.begin(), sides.end());
    if (std::adjacent_find(sides.begin(), sides.end()) != sides.end()) return false;
    for (const auto& [from, to] : sides) {
        if (!std::binary_search(sides.begin(), sides.end(), std::pair(to, from))) return false;
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() + faces.size() != sides.size() / 2 + 2) return false;
    for (std::size_t k = 0; k < faces.size(); ++k) {
        for (std::size_t l = 0; l < faces.size(); ++l) {
            if (l != k && !meets_in_one_chain(faces[k], faces[l])) return false;
        }
    }
    return true;
}

}  // namespace pcvt::space
