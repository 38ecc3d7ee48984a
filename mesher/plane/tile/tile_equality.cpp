#include "mesher/plane/tile/tile_equality.hpp"

#include <algorithm>
#include <compare>
#include <numeric>
#include <vector>

#include "mesher/base/bucket_sort.hpp"

namespace pcvt::plane {
namespace {

/// The faces by rising corners.
/// @pre every face has corners, and all of them exist.
std::vector<int> faces_in_order(const Tile& tile) {
    std::vector<int> order(static_cast<std::size_t>(tile.n_faces()));
    std::iota(order.begin(), order.end(), 0);
    bucket_sort(
        order, tile.n_vertices(), [&](int f) { return tile.faces[f].front(); },
        [&](int f, int g) {
            const auto a = tile.faces[f];
            const auto b = tile.faces[g];
            return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
        });
    return order;
}

bool can_be_ordered(const Tile& tile) {
    for (int f = 0; f < tile.n_faces(); ++f) {
        if (tile.face_size(f) < 1) return false;
    }
    return std::all_of(tile.faces.corners.begin(), tile.faces.corners.end(),
                       [&](int v) { return v >= 0 && v < tile.n_vertices(); });
}

/// Whether the faces in these orders have the same sites; true where one tile has none.
bool same_face_sites(const Tile& s, const std::vector<int>& of_s, const Tile& t,
                     const std::vector<int>& of_t) {
    if (s.face_site.size() != of_s.size() || t.face_site.size() != of_t.size()) {
        return s.face_site.empty() || t.face_site.empty();
    }
    return std::equal(of_s.begin(), of_s.end(), of_t.begin(),
                      [&](int f, int g) { return s.face_site[f] == t.face_site[g]; });
}

bool same_faces(const Tile& s, const Tile& t) {
    if (s.faces == t.faces && s.face_site == t.face_site) return true;
    if (s.n_faces() != t.n_faces() || !can_be_ordered(s) || !can_be_ordered(t)) return false;
    const std::vector<int> of_s = faces_in_order(s);
    const std::vector<int> of_t = faces_in_order(t);
    return std::equal(of_s.begin(), of_s.end(), of_t.begin(),
                      [&](int f, int g) {
                          const auto a = s.faces[f];
                          const auto b = t.faces[g];
                          return std::equal(a.begin(), a.end(), b.begin(), b.end());
                      }) &&
           same_face_sites(s, of_s, t, of_t);
}

bool same_vertex_sites(const Tile& s, const Tile& t) {
    return s.vertex_site.empty() || t.vertex_site.empty() || s.vertex_site == t.vertex_site;
}

}  // namespace

bool same_geometry(const Tile& s, const Tile& t) {
    return s.lattice.a() == t.lattice.a() && s.lattice.b() == t.lattice.b() &&
           s.points == t.points && same_faces(s, t) && same_vertex_sites(s, t);
}

}  // namespace pcvt::plane
