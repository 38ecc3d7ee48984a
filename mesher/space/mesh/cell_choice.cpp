#include "mesher/space/mesh/cell_choice.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/disjoint_sets.hpp"

namespace pcvt::space {
namespace {

/// Centroids this near below the upper sides of the domain count as beyond them, so that rounding
/// does not scatter the cells of a grid; periods.
constexpr double kRounding = 1e-9;

Offset image_in_domain(const Vec3& u, const Vec3& corner) {
    const Vec3 whole = (u - corner).array() + kRounding;
    return {-static_cast<int>(std::floor(whole.x())), -static_cast<int>(std::floor(whole.y())),
            -static_cast<int>(std::floor(whole.z()))};
}

/// The translation of the neighbour that would join it to the cell across the face.
Offset missing_translation(const CellFace& face, const std::vector<Offset>& images) {
    return images[face.cell] + face.offset - images[face.neighbour];
}

DisjointSets joined_parts(const CellComplex& complex, const std::vector<Offset>& images) {
    DisjointSets parts(complex.n_cells);
    for (const CellFace& face : complex.faces) {
        if (missing_translation(face, images) == Offset{}) parts.unite(face.cell, face.neighbour);
    }
    return parts;
}

/// Moves one part so that it has most faces in common with the largest part.
void join_one_part(const CellComplex& complex, DisjointSets& parts, std::vector<Offset>& images) {
    std::vector<int> size(images.size(), 0);
    for (int s = 0; s < complex.n_cells; ++s) ++size[parts.find(s)];
    const int largest = static_cast<int>(std::max_element(size.begin(), size.end()) - size.begin());
    // The number of faces that each translation of each part would join to the largest.
    std::map<std::pair<int, Offset>, int> gained;
    for (const CellFace& face : complex.faces) {
        const int here = parts.find(face.cell);
        const int there = parts.find(face.neighbour);
        if ((here == largest) == (there == largest)) continue;
        const Offset missing = missing_translation(face, images);
        if (here == largest) {
            ++gained[{there, missing}];
        } else {
            ++gained[{here, -missing}];
        }
    }
    const auto best =
        std::max_element(gained.begin(), gained.end(),
                         [](const auto& s, const auto& t) { return s.second < t.second; });
    const auto [part, translation] = best->first;
    for (int s = 0; s < complex.n_cells; ++s) {
        if (parts.find(s) == part) images[s] = images[s] + translation;
    }
}

}  // namespace

Vec3 domain_corner(const Lattice& lattice, const Reduction& reduction, const Vec3& origin) {
    const Vec3 centre =
        reduction.reduced.to_lattice(origin + lattice.to_position(Vec3::Constant(0.5)));
    return centre - Vec3::Constant(0.5);
}

std::vector<Offset> chosen_images(const CellComplex& complex, const std::vector<CellBody>& bodies,
                                  const Vec3& corner) {
    if (!complex.piece_cell.empty()) return std::vector<Offset>(bodies.size());
    std::vector<Offset> images;
    images.reserve(bodies.size());
    for (const CellBody& body : bodies) {
        images.push_back(image_in_domain(complex.reduced.to_lattice(body.centroid), corner));
    }
    for (;;) {
        checkpoint();
        DisjointSets parts = joined_parts(complex, images);
        bool connected = true;
        for (int s = 0; s < complex.n_cells; ++s) connected = connected && parts.find(s) == 0;
        if (connected) return images;
        join_one_part(complex, parts, images);
    }
}

}  // namespace pcvt::space
