#include "io/forms/box_sets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "mesher/space/box/box_cells.hpp"
#include "mesher/space/box/box_sides.hpp"
#include "tests/support/tetrahedra_files.hpp"

namespace pcvt {
namespace {

/// Tetrahedra in n random cells of an oblique lattice, cut at a box.
ElementMesh grains_in_box(int n, int order) {
    const space::Lattice oblique({1, 0.2, 0.1}, {-0.3, 0.9, 0.2}, {0.4, 0.3, 1.2});
    const testing::SpaceCase c{"random", oblique, uniform_points(oblique, n, 3)};
    const space::Sites sites(oblique, c.points);
    const space::Vec3 origin(0.1, -0.2, 0.3);
    Workers one_worker(1);
    space::TetrahedralMesh mesh =
        mesh_grains(sites, cells_in_box(sites, testing::complex_of(c), origin),
                    {.size = 0.7 * sites.spacing(), .n_rounds = 0}, one_worker, origin)
            .mesh.tetrahedra;
    put_on_sides(origin, mesh);
    mesh.order = order;
    return element_mesh(mesh);
}

/// Law (1).
void expect_each_once(const ElementMesh& mesh, const std::vector<BoxSet>& sets) {
    std::map<int, int> n_images;
    for (const int orbit : mesh.orbit) ++n_images[orbit];
    std::set<int> seen;
    for (const BoxSet& set : sets) {
        for (const int v : set.nodes) {
            EXPECT_TRUE(seen.insert(v).second);
            EXPECT_GT(n_images[mesh.orbit[v]], 1);
        }
    }
    const auto n_tied = std::count_if(mesh.orbit.begin(), mesh.orbit.end(),
                                      [&](int orbit) { return n_images[orbit] > 1; });
    EXPECT_EQ(std::ssize(seen), n_tied);
}

TEST(BoxSets, HoldEachNodeOfTheBoundaryOnceInTheOrderOfItsPartners) {
    for (const int order : {1, 2}) {
        const ElementMesh mesh = grains_in_box(3, order);
        const std::vector<BoxSet> sets = box_sets(mesh);
        ASSERT_EQ(sets.size(), 6 + 12 + 8);
        expect_each_once(mesh, sets);
        std::map<std::string, std::vector<int>> nodes;
        for (const BoxSet& set : sets) nodes[set.name] = set.nodes;
        EXPECT_EQ(nodes.at("corner_1_1_1").size(), 1);
        // Law (2), for one set of each kind.
        using Pair = std::array<std::string, 2>;
        for (const auto& [one, other] :
             {Pair{"side_0_1_0", "side_0_-1_0"}, Pair{"edge_1_0_1", "edge_-1_0_1"},
              Pair{"corner_1_1_1", "corner_-1_1_-1"}}) {
            ASSERT_EQ(nodes.at(one).size(), nodes.at(other).size());
            for (std::size_t k = 0; k < nodes[one].size(); ++k) {
                EXPECT_EQ(mesh.orbit[nodes[one][k]], mesh.orbit[nodes[other][k]]);
            }
        }
        // The first vector takes the lower side to the upper one.
        const int low = nodes.at("side_1_0_0").front();
        const int high = nodes.at("side_-1_0_0").front();
        for (int k = 0; k < 3; ++k) {
            EXPECT_NEAR(mesh.nodes[high][k] - mesh.nodes[low][k], mesh.periods[k], 1e-12);
        }
    }
}

TEST(BoxSets, AreThereOnlyForBoxes) {
    EXPECT_TRUE(box_sets(element_mesh(testing::grain_tetrahedra(6))).empty());
}

}  // namespace
}  // namespace pcvt
