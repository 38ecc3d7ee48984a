#include "io/forms/tetrahedra_contacts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "tests/support/tetrahedra_files.hpp"

namespace pcvt {
namespace {

/// Whole grains of few cells, which touch images of themselves, and of more, of both orders.
std::vector<space::TetrahedralMesh> whole_grains() {
    std::vector<space::TetrahedralMesh> meshes;
    for (const int n : {1, 2, 6}) {
        for (const int order : {1, 2}) {
            meshes.push_back(testing::grain_tetrahedra(n));
            meshes.back().order = order;
        }
    }
    return meshes;
}

TEST(TetrahedraContacts, HaveEachTriangleOnce) {
    for (const space::TetrahedralMesh& mesh : whole_grains()) {
        const TetrahedraContacts contacts = cell_contacts(mesh, element_mesh(mesh));
        EXPECT_EQ(contacts.triangles.size(), 2 * mesh.tetrahedra.size());
        std::set<std::pair<int, int>> sides;
        std::size_t n_on_seam = 0;
        for (const SharedTriangle& triangle : contacts.triangles) {
            for (const int k : {0, 1}) {
                EXPECT_TRUE(sides.emplace(triangle.tetrahedra[k], triangle.apexes[k]).second);
            }
            if (triangle.is_on_seam()) ++n_on_seam;
        }
        EXPECT_EQ(n_on_seam, prove_tetrahedra(mesh).pairs.size());
    }
}

/// The numbers of cells at each node, as images of whole cells: a cell and the offset of the node.
std::vector<std::size_t> cells_at_nodes(const space::TetrahedralMesh& mesh,
                                        const ElementMesh& elements) {
    std::map<int, std::set<std::tuple<int, int, int, int>>> cells;
    for (int t = 0; t < elements.elements.size(); ++t) {
        for (const int v : elements.elements.nodes[t]) {
            const int* const offset = &elements.offsets[3 * static_cast<std::size_t>(v)];
            cells[elements.orbit[v]].emplace(mesh.cell[t], offset[0], offset[1], offset[2]);
        }
    }
    std::vector<std::size_t> counts;
    for (const int orbit : elements.orbit) counts.push_back(cells[orbit].size());
    return counts;
}

TEST(TetrahedraContacts, AreThoseOfImagesOfWholeCells) {
    for (const space::TetrahedralMesh& mesh : whole_grains()) {
        const ElementMesh elements = element_mesh(mesh);
        const TetrahedraContacts contacts = cell_contacts(mesh, elements);
        const std::vector<std::size_t> counts = cells_at_nodes(mesh, elements);
        for (std::size_t k = 0; k < 3; ++k) {
            std::vector<int> wanted;
            for (int v = 0; v < elements.n_nodes(); ++v) {
                if (counts[v] >= k + 2) wanted.push_back(v);
            }
            EXPECT_EQ(contacts.nodes[k], wanted);
            EXPECT_FALSE(wanted.empty());
        }
        // The nodes of triangles between cells, and their images.
        std::set<int> orbits;
        for (const SharedTriangle& triangle : contacts.triangles) {
            if (!triangle.is_between_cells) continue;
            const auto nodes = elements.elements.nodes[triangle.tetrahedra[0]];
            for (std::size_t i = 0; i < nodes.size(); ++i) {
                if (is_on_side(i, triangle.apexes[0])) orbits.insert(elements.orbit[nodes[i]]);
            }
        }
        for (int v = 0; v < elements.n_nodes(); ++v) {
            EXPECT_EQ(orbits.contains(elements.orbit[v]), counts[v] >= 2);
        }
    }
}

}  // namespace
}  // namespace pcvt
