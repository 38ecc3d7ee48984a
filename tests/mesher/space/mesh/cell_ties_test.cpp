#include "mesher/space/mesh/cell_ties.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <utility>

#include "mesher/base/disjoint_sets.hpp"
#include "mesher/space/mesh/cell_choice.hpp"
#include "tests/support/polyhedra.hpp"

namespace pcvt::space {
namespace {

/// A vertex, or the first and the second end of an edge relative to an image of the first.
using Feature = std::pair<int, VertexImage>;

struct TiedCells {
    CellComplex complex;
    Reduction reduction;
    std::vector<Offset> chosen;
    std::vector<Offset> tied;
};

TiedCells tied_cells(const Lattice& lattice, const Points& points) {
    const Sites sites(lattice, points);
    TiedCells cells{.complex = testing::complex_of({"", lattice, points}),
                    .reduction = sites.reduction(),
                    .chosen = {},
                    .tied = {}};
    cells.chosen = chosen_images(cells.complex, cell_bodies(cells.complex),
                                 domain_corner(lattice, cells.reduction, Vec3::Zero()));
    cells.tied = tied_images(cells.complex, cells.reduction, cells.chosen);
    return cells;
}

/// The translation that takes the second side of a face in the tile to the first.
Offset gap_at(const TiedCells& cells, const CellFace& face) {
    return cells.tied[face.cell] + face.offset - cells.tied[face.neighbour];
}

/// Of each vertex and edge, which of its images lie on a slave, by the faces of the tile.
std::map<Feature, std::map<Offset, bool>> images_of(const TiedCells& cells) {
    std::map<Feature, std::map<Offset, bool>> images;
    const auto add_side = [&](int f, const Offset& frame, bool is_slave) {
        const auto corners = cells.complex.corners_of(f);
        for (std::size_t k = 0; k < corners.size(); ++k) {
            VertexImage p = corners[k];
            VertexImage q = corners[(k + 1) % corners.size()];
            images[{p.vertex, {-1, {}}}][p.offset + frame] |= is_slave;
            // The same edge from the neighbour's side begins at its other end.
            const Feature forwards{p.vertex, {q.vertex, q.offset - p.offset}};
            const Feature backwards{q.vertex, {p.vertex, p.offset - q.offset}};
            const bool turns = backwards < forwards;
            images[turns ? backwards : forwards][(turns ? q : p).offset + frame] |= is_slave;
        }
    };
    for (int f = 0; f < cells.complex.n_faces(); ++f) {
        const CellFace& face = cells.complex.faces[f];
        const Offset gap = cells.reduction.to_original(gap_at(cells, face));
        add_side(f, cells.tied[face.cell], gap > Offset{});
        add_side(f, cells.tied[face.neighbour] - face.offset, -gap > Offset{});
    }
    return images;
}

int n_untied(const TiedCells& cells) {
    int n = 0;
    for (const auto& [feature, images] : images_of(cells)) {
        const auto n_masters = std::count_if(images.begin(), images.end(),
                                             [](const auto& image) { return !image.second; });
        n += n_masters == 1 ? 0 : 1;
    }
    return n;
}

bool is_connected(const TiedCells& cells) {
    DisjointSets parts(cells.complex.n_cells);
    for (const CellFace& face : cells.complex.faces) {
        if (gap_at(cells, face) == Offset{}) parts.unite(face.cell, face.neighbour);
    }
    for (int c = 0; c < cells.complex.n_cells; ++c) {
        if (parts.find(c) != parts.find(0)) return false;
    }
    return true;
}

/// Images of cells that are joined across faces in a random order, a ragged tile.
std::vector<Offset> ragged_images(const CellComplex& complex, std::uint64_t seed) {
    std::vector<CellFace> faces = complex.faces;
    std::mt19937_64 random(seed);
    for (std::size_t k = faces.size(); k > 1; --k) std::swap(faces[k - 1], faces[random() % k]);
    std::vector<Offset> images(complex.n_cells);
    std::vector<char> is_placed(complex.n_cells, 0);
    is_placed[0] = 1;
    for (int n_placed = 1; n_placed < complex.n_cells;) {
        for (const CellFace& face : faces) {
            if (is_placed[face.cell] == is_placed[face.neighbour]) continue;
            if (is_placed[face.cell] != 0) {
                images[face.neighbour] = images[face.cell] + face.offset;
            } else {
                images[face.cell] = images[face.neighbour] - face.offset;
            }
            is_placed[face.cell] = is_placed[face.neighbour] = 1;
            ++n_placed;
        }
    }
    return images;
}

/// Exact lattices and random sites, from usual tiles and from ragged ones.
TEST(CellTies, LeaveOneImageOfEachVertexAndEdgeOnNoSlave) {
    const Lattice cube = Lattice::box(1, 1, 1);
    int n_moved = 0;
    for (const int n : {1, 2, 3, 4, 5, 7, 8, 12, 15, 24}) {
        std::vector<Points> cases{testing::lattice_points(n), uniform_points(cube, n, n)};
        if (n == 8) cases.push_back(testing::grid_points(2));
        for (const Points& points : cases) {
            TiedCells cells = tied_cells(cube, points);
            for (int seed = 0; seed < 8; ++seed) {
                SCOPED_TRACE(n);
                const auto images = seed == 0 ? cells.chosen : ragged_images(cells.complex, seed);
                cells.tied = tied_images(cells.complex, cells.reduction, images);
                EXPECT_EQ(n_untied(cells), 0);
                EXPECT_TRUE(is_connected(cells));
                if (cells.tied == images) continue;
                ++n_moved;
                cells.tied = images;
                EXPECT_GT(n_untied(cells), 0);
            }
        }
    }
    EXPECT_GT(n_moved, 10);
}

}  // namespace
}  // namespace pcvt::space
