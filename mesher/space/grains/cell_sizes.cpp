#include "mesher/space/grains/cell_sizes.hpp"

#include <algorithm>

#include "mesher/base/checkpoint.hpp"
#include "mesher/portable/portable_functions.hpp"
#include "mesher/space/grains/grain_surface.hpp"
#include "mesher/space/grains/tetrahedron_shape.hpp"

namespace pcvt::space {
namespace {

constexpr double kDefaultPart = 1.0 / 3;

/// The width of each cell: the least of its extents normal to its faces, length units.
std::vector<double> widths(const CellComplex& complex) {
    std::vector<std::vector<Vec3>> corners(complex.n_cells);
    for (int f = 0; f < complex.n_faces(); ++f) {
        const CellFace& face = complex.faces[f];
        const Vec3 shift = complex.reduced.translation(face.offset);
        for (const VertexImage& corner : complex.corners_of(f)) {
            corners[face.cell].push_back(complex.position(corner));
            corners[face.neighbour].push_back(corners[face.cell].back() - shift);
        }
    }
    std::vector<double> widths(complex.n_cells, kUnlimited);
    const auto lower = [&](SiteId cell, const Vec3& origin, const Vec3& outward) {
        double extent = 0;
        for (const Vec3& p : corners[cell]) {
            extent = std::max(extent, dot_product(outward, origin - p));
        }
        widths[cell] = std::min(widths[cell], extent);
    };
    for (int f = 0; f < complex.n_faces(); ++f) {
        checkpoint_each(f);
        const CellFace& face = complex.faces[f];
        const FacePlane plane = face_plane(complex, f);
        lower(face.cell, plane.origin, plane.normal);
        lower(face.neighbour, plane.origin - complex.reduced.translation(face.offset),
              -plane.normal);
    }
    return widths;
}

}  // namespace

CellSizes cell_sizes(const CellComplex& complex, double size) {
    const std::vector<double> width = widths(complex);
    const std::vector<CellBody> bodies = cell_bodies(complex);
    std::vector<double> volumes(bodies.size(), 0);
    for (int c = 0; c < complex.n_cells; ++c) volumes[complex.site_of(c)] += bodies[c].volume;
    // In a thin piece that a box cuts off, larger tetrahedra could be flat.
    const bool are_cut = !complex.piece_cell.empty();
    CellSizes all;
    for (int c = 0; c < complex.n_cells; ++c) {
        const double edge = portable_cbrt(volumes[complex.site_of(c)]);
        const double wanted = size > 0 ? std::min(size, kLargestSize * edge) : kDefaultPart * edge;
        if (width[c] < kFlatWidth * wanted) {
            all.flat.push_back({c, degrees_between({wanted, 0, 0}, {wanted, width[c], 0})});
        }
        const double thin = kSizeInWidth * width[c];
        const bool is_too_thin = !are_cut && thin < kLeastSize * wanted;
        all.sizes.push_back(is_too_thin ? wanted : std::clamp(thin, kLeastSize * wanted, wanted));
    }
    return all;
}

}  // namespace pcvt::space
