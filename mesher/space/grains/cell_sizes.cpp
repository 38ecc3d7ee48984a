#include "mesher/space/grains/cell_sizes.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "mesher/base/checkpoint.hpp"
#include "mesher/portable/portable_functions.hpp"
#include "mesher/space/grains/grain_surface.hpp"
#include "mesher/space/grains/tetrahedron_shape.hpp"

namespace pcvt::space {
namespace {

constexpr double kDefaultPart = 1.0 / 3;
/// The tetrahedra in a cube whose edge is the size, with those that are smaller at the faces.
constexpr double kTetrahedraInCube = 12;
constexpr double kMostInCell = 2e6;

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

FlatCell::FlatCell(SiteId site, double n_tetrahedra)
    : LimitExceeded("the cell of site " + std::to_string(site) + " is so flat that it would take " +
                    std::to_string(std::lround(n_tetrahedra / 1e6)) +
                    " million tetrahedra; pcvt makes at most 2 million in a cell"),
      site_(site) {}

std::vector<double> cell_sizes(const CellComplex& complex, double size) {
    const std::vector<double> width = widths(complex);
    const std::vector<CellBody> bodies = cell_bodies(complex);
    std::vector<double> sizes;
    for (int c = 0; c < complex.n_cells; ++c) {
        const double edge = portable_cbrt(bodies[c].volume);
        const double wanted = size > 0 ? std::min(size, kLargestSize * edge) : kDefaultPart * edge;
        sizes.push_back(std::min(wanted, kSizeInWidth * width[c]));
        const double n = kTetrahedraInCube * bodies[c].volume / std::pow(sizes[c], 3);
        if (sizes[c] < wanted && n > kMostInCell) throw FlatCell(c, n);
    }
    return sizes;
}

}  // namespace pcvt::space
