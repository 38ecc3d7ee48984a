#pragma once

#include <span>
#include <vector>

namespace pcvt {

/// Polygons on numbered vertices in two arrays.
///
/// Example usage:
///   Faces faces;
///   faces.add(std::vector{0, 1, 2});
///   for (const int v : faces[0]) polygon.push_back(points[v]);
struct Faces {
    /// Face f has the corners corners[begin[f]] ... corners[begin[f + 1] - 1].
    std::vector<int> begin{0};
    /// Vertex indices, counter-clockwise.
    std::vector<int> corners;

    int n_faces() const { return static_cast<int>(begin.size()) - 1; }
    int size(int f) const { return begin[f + 1] - begin[f]; }
    std::span<const int> operator[](int f) const {
        return {corners.data() + begin[f], corners.data() + begin[f + 1]};
    }
    void add(std::span<const int> face) {
        corners.insert(corners.end(), face.begin(), face.end());
        close();
    }
    /// Makes a face of the corners that were appended to `corners` since the last face.
    void close() { begin.push_back(static_cast<int>(corners.size())); }

    friend bool operator==(const Faces&, const Faces&) = default;
};

}  // namespace pcvt
