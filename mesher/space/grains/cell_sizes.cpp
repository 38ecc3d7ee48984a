#include "mesher/space/grains/cell_sizes.hpp"

#include <algorithm>

#include "mesher/base/checkpoint.hpp"
#include "mesher/portable/portable_functions.hpp"
#include "mesher/space/grains/grain_surface.hpp"
#include "mesher/space/grains/tetrahedron_shape.hpp"

namespace pcvt::space {
namespace {

constexpr double kDefaultPart = 1.0 / 3;
/// The size of tetrahedra in a flat piece of a cell over its thickness, and the least part of their
/// size in the whole cell. Larger tetrahedra are flat, and smaller ones make those beside them
/// flat.
constexpr double kThicknesses = 3;
constexpr double kLeastPart = 0.3;

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

/// The volumes of the cells over half of their surfaces: the thickness of flat ones.
std::vector<double> thicknesses(const CellComplex& complex, const std::vector<CellBody>& bodies) {
    std::vector<double> surfaces(bodies.size(), 0);
    for (int f = 0; f < complex.n_faces(); ++f) {
        const auto corners = complex.corners_of(f);
        const Vec3 first = complex.position(corners[0]);
        Vec3 twice = Vec3::Zero();
        for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
            twice += cross_product(complex.position(corners[k]) - first,
                                   complex.position(corners[k + 1]) - first);
        }
        surfaces[complex.faces[f].cell] += length(twice) / 2;
        surfaces[complex.faces[f].neighbour] += length(twice) / 2;
    }
    std::vector<double> found;
    for (std::size_t c = 0; c < bodies.size(); ++c) {
        found.push_back(2 * bodies[c].volume / surfaces[c]);
    }
    return found;
}

/// Makes the sizes of the tetrahedra in flat pieces of cells smaller.
void limit_in_pieces(const CellComplex& complex, const std::vector<CellBody>& bodies,
                     std::vector<double>& sizes) {
    const std::vector<double> thickness = thicknesses(complex, bodies);
    for (int c = 0; c < complex.n_cells; ++c) {
        sizes[c] *= std::clamp(kThicknesses * thickness[c] / sizes[c], kLeastPart, 1.0);
    }
}

}  // namespace

CellSizes cell_sizes(const CellComplex& complex, double size) {
    const std::vector<double> width = widths(complex);
    const std::vector<CellBody> bodies = cell_bodies(complex);
    std::vector<double> volumes(bodies.size(), 0);
    for (int c = 0; c < complex.n_cells; ++c) volumes[complex.site_of(c)] += bodies[c].volume;
    CellSizes all;
    for (int c = 0; c < complex.n_cells; ++c) {
        const double edge = portable_cbrt(volumes[complex.site_of(c)]);
        const double wanted = size > 0 ? std::min(size, kLargestSize * edge) : kDefaultPart * edge;
        const double thin = kSizeInWidth * width[c];
        const bool is_flat = thin < kLeastSizeInWidth * wanted;
        if (is_flat)
            all.flat.push_back({c, degrees_between({wanted, 0, 0}, {wanted, width[c], 0})});
        all.sizes.push_back(is_flat ? wanted : std::min(wanted, thin));
    }
    if (!complex.piece_cell.empty()) limit_in_pieces(complex, bodies, all.sizes);
    return all;
}

}  // namespace pcvt::space
