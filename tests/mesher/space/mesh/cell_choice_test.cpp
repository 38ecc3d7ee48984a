#include "mesher/space/mesh/cell_choice.hpp"

#include <gtest/gtest.h>

#include <random>

#include "mesher/base/disjoint_sets.hpp"
#include "mesher/plane/proof/validate.hpp"
#include "mesher/space/mesh/polyhedral_assembly.hpp"
#include "mesher/space/proof/polyhedral_proof.hpp"
#include "tests/support/polyhedra.hpp"

namespace pcvt::space {
namespace {

/// Law (1), where the centroids are far from each other.
TEST(ChosenImages, AreConnectedWhereverTheCentroidsLie) {
    std::mt19937 random(1);
    for (const testing::SpaceCase& c : testing::space_cases()) {
        const CellComplex complex = testing::complex_of(c);
        std::vector<CellBody> bodies = cell_bodies(complex);
        for (CellBody& body : bodies) {
            const Offset offset{int(random() % 3), int(random() % 3), int(random() % 3)};
            body.centroid += complex.reduced.translation(offset);
        }
        const std::vector<Offset> images = chosen_images(complex, bodies, Vec3::Zero());
        DisjointSets parts(complex.n_cells);
        for (const CellFace& face : complex.faces) {
            if (images[face.cell] + face.offset == images[face.neighbour]) {
                parts.unite(face.cell, face.neighbour);
            }
        }
        for (int s = 0; s < complex.n_cells; ++s) EXPECT_EQ(parts.find(s), 0) << c.name;
    }
}

/// A cell that lies elsewhere, moved by a period, fits the torus, but the tile is not connected.
TEST(ProvePolyhedra, NamesTheBrokenConnection) {
    const Lattice cube = Lattice::box(1, 1, 1);
    PolyhedronList cells =
        polyhedron_list(testing::mesh_of({"", cube, uniform_points(cube, 40, 5)}));
    std::vector<int> moved(cells.points.size(), -1);
    for (int c = cells.faces.begin[cells.cell_begin[3]]; c < cells.faces.begin[cells.cell_begin[4]];
         ++c) {
        int& v = cells.faces.corners[c];
        if (moved[v] < 0) {
            moved[v] = static_cast<int>(cells.points.size());
            cells.points.push_back(cells.points[v] + Vec3(4, 0, 0));
        }
        v = moved[v];
    }
    try {
        prove_polyhedra(assembled_mesh(cube, cells));
        ADD_FAILURE();
    } catch (const NotATile& error) {
        EXPECT_NE(std::string(error.what()).find("(5)"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace pcvt::space
