#include "mesher/space/box/box_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "mesher/space/box/plane_cut.hpp"

namespace pcvt::space {
namespace {

/// Parts of h within which vertices lie on a plane. Corners of cells within 1e-9 h are one vertex,
/// so that the corners of a face may lie that far from its plane; the last tolerance is for faces
/// in a side of the box.
constexpr std::array kTolerances{1e-10, 1e-12, 4e-9};
/// Where snapped vertices make polyhedra of no kind, fewer are tried.
constexpr double kNextSnap = 30;
constexpr std::array kAxes{"first", "second", "third"};

/// Offsets in the two bases of a lattice.
class BasisChange {
   public:
    explicit BasisChange(const Reduction& reduction) : reduction_(reduction) {}

    Offset to_original(const Offset& offset) const { return reduction_.to_original(offset); }
    /// The inverse of to_original(): by cofactors, because the determinant is 1 or -1.
    Offset to_reduced(const Offset& offset) const {
        const auto& m = reduction_.m;
        const auto minor = [&](int r, int k) {
            const int r1 = 3 * ((r + 1) % 3);
            const int r2 = 3 * ((r + 2) % 3);
            const int k1 = (k + 1) % 3;
            const int k2 = (k + 2) % 3;
            return m[r1 + k1] * m[r2 + k2] - m[r1 + k2] * m[r2 + k1];
        };
        const int determinant = m[0] * minor(0, 0) + m[1] * minor(0, 1) + m[2] * minor(0, 2);
        const std::array<int, 3> o = offset.components();
        std::array<int, 3> reduced{};
        for (int r = 0; r < 3; ++r) {
            for (int k = 0; k < 3; ++k) reduced[r] += determinant * minor(r, k) * o[k];
        }
        return Offset::of(reduced);
    }

   private:
    const Reduction& reduction_;
};

template <class Change>
void change_offsets(CellComplex& complex, const Change& change) {
    for (CellFace& face : complex.faces) face.offset = change(face.offset);
    for (VertexImage& corner : complex.corners) corner.offset = change(corner.offset);
}

/// A side of a face of a cell, in the frame of the cell.
struct Side {
    SiteId cell;
    VertexImage from;
    VertexImage to;

    friend auto operator<=>(const Side&, const Side&) = default;
};

/// Whether each side of a face of a cell has one other face of the cell, in reverse.
bool is_closed(const CellComplex& complex) {
    std::vector<Side> sides;
    for (int f = 0; f < complex.n_faces(); ++f) {
        const CellFace& face = complex.faces[f];
        const auto corners = complex.corners_of(f);
        for (std::size_t k = 0; k < corners.size(); ++k) {
            VertexImage from = corners[k];
            VertexImage to = corners[(k + 1) % corners.size()];
            sides.push_back({face.cell, from, to});
            from.offset = from.offset - face.offset;
            to.offset = to.offset - face.offset;
            sides.push_back({face.neighbour, to, from});
        }
    }
    std::sort(sides.begin(), sides.end());
    if (std::adjacent_find(sides.begin(), sides.end()) != sides.end()) return false;
    return std::all_of(sides.begin(), sides.end(), [&](const Side& side) {
        return std::binary_search(sides.begin(), sides.end(), Side{side.cell, side.to, side.from});
    });
}

/// Cuts along one axis, with the first tolerance that gives polyhedra.
CutCells cut_soundly(int axis, const Vec3& origin, double spacing, double snapped,
                     const CutCells& whole) {
    std::vector<Nearness> tries;
    if (snapped > 0) {
        tries = {{kTolerances[0], snapped}, {kTolerances[0], snapped / kNextSnap}};
    }
    for (const double tolerance : kTolerances) tries.push_back({tolerance});
    for (auto [all, with_long_edges] : tries) {
        CutCells cut = whole;
        if (cut_along(axis, origin, {all * spacing, with_long_edges * spacing}, cut) &&
            is_closed(cut.complex)) {
            return cut;
        }
    }
    throw UncutCells(std::string("the sides of the box across the ") + kAxes[axis] +
                     " period vector nearly contain a face of a cell; take another --origin, or "
                     "remove fewer short edges");
}

/// Moves the frame of each piece so that the piece lies in the box, and each vertex to its image
/// with coordinates from 0 to below 1.
void move_into_box(CutCells& cells) {
    CellComplex& complex = cells.complex;
    std::vector<Offset> vertex_shift;
    for (std::size_t v = 0; v < complex.vertices.size(); ++v) {
        const auto& [i, j, k] = cells.level[v];
        const Offset& shift = vertex_shift.emplace_back(Offset{-(i >> 1), -(j >> 1), -(k >> 1)});
        complex.vertices[v] += complex.reduced.translation(shift);
    }
    const auto frame = [&](SiteId piece) { return -Offset::of(cells.slab[piece]); };
    for (int f = 0; f < complex.n_faces(); ++f) {
        CellFace& face = complex.faces[f];
        const Offset shift = frame(face.cell);
        face.offset = face.offset + shift - frame(face.neighbour);
        for (int c = complex.begin[f]; c < complex.begin[f + 1]; ++c) {
            Offset& offset = complex.corners[c].offset;
            offset = offset + shift - vertex_shift[complex.corners[c].vertex];
        }
    }
    std::vector<Vec3> sites;
    for (SiteId p = 0; p < complex.n_cells; ++p) {
        sites.push_back(complex.sites[cells.cell[p]] + complex.reduced.translation(frame(p)));
    }
    complex.sites = std::move(sites);
}

}  // namespace

CellComplex cells_in_box(const Sites& sites, const CellComplex& complex, const Vec3& origin,
                         double snapped) {
    const Lattice& lattice = sites.lattice();
    // Cut at an origin near 0, where coordinates have the fewest roundings.
    const Vec3 u = lattice.to_lattice(origin);
    const Vec3 whole(std::floor(u.x()), std::floor(u.y()), std::floor(u.z()));
    const Vec3 near = origin - lattice.to_position(whole);
    const BasisChange basis(sites.reduction());
    CutCells cells{.complex = complex};
    cells.complex.reduced = lattice;
    change_offsets(cells.complex, [&](const Offset& o) { return basis.to_original(o); });
    cells.cell.resize(static_cast<std::size_t>(complex.n_cells));
    std::iota(cells.cell.begin(), cells.cell.end(), 0);
    cells.slab.resize(cells.cell.size());
    cells.level.resize(complex.vertices.size());
    for (int axis = 0; axis < 3; ++axis) {
        cells = cut_soundly(axis, near, sites.spacing(), snapped, cells);
    }
    move_into_box(cells);
    CellComplex pieces = std::move(cells.complex);
    const Vec3 back = lattice.to_position(whole);
    for (Vec3& vertex : pieces.vertices) vertex += back;
    for (Vec3& site : pieces.sites) site += back;
    change_offsets(pieces, [&](const Offset& o) { return basis.to_reduced(o); });
    pieces.reduced = complex.reduced;
    pieces.piece_cell = std::move(cells.cell);
    return pieces;
}

}  // namespace pcvt::space
