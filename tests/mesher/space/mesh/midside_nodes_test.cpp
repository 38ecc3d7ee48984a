#include "mesher/space/mesh/midside_nodes.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <utility>

#include "mesher/space/proof/tetrahedral_proof.hpp"

namespace pcvt::space {
namespace {

/// Tiles of few sites, whose edges join images of one site, and of more.
std::vector<TetrahedralMesh> random_tiles() {
    const Lattice oblique({1, 0.2, 0.1}, {-0.3, 0.9, 0.2}, {0.4, 0.3, 1.2});
    std::vector<TetrahedralMesh> meshes;
    for (const int n : {1, 2, 3, 8, 40}) {
        meshes.push_back(
            tetrahedral_mesh(periodic_delaunay(Sites(oblique, uniform_points(oblique, n, 3)))));
    }
    return meshes;
}

TEST(MidsideNodes, AreOneForEachEdge) {
    for (const TetrahedralMesh& mesh : random_tiles()) {
        const MidsideNodes nodes = midside_nodes(mesh);
        std::map<std::pair<int, int>, int> of_edge;
        std::set<int> distinct;
        for (int t = 0; t < mesh.n_tetrahedra(); ++t) {
            for (std::size_t k = 0; k < kEdgeCorners.size(); ++k) {
                const auto& [i, j] = kEdgeCorners[k];
                const int v = mesh.tetrahedra[t][i];
                const int w = mesh.tetrahedra[t][j];
                const int node = nodes.of_tetrahedron[t][k];
                const Vec3 middle = (mesh.points[v] + mesh.points[w]) / 2;
                EXPECT_LE((nodes.points[node - mesh.n_points()] - middle).norm(), 1e-14);
                EXPECT_EQ(of_edge.emplace(std::minmax(v, w), node).first->second, node);
                distinct.insert(node);
            }
        }
        EXPECT_EQ(distinct.size(), of_edge.size());
        EXPECT_EQ(nodes.points.size(), of_edge.size());
    }
}

TEST(MidsideNodes, AreExactTranslatesOfTheirRepresentatives) {
    for (const TetrahedralMesh& mesh : random_tiles()) {
        const MidsideNodes nodes = midside_nodes(mesh);
        std::set<int> representatives;
        for (std::size_t k = 0; k < nodes.points.size(); ++k) {
            const int of = nodes.orbit[k] - mesh.n_points();
            EXPECT_LE(of, static_cast<int>(k));
            EXPECT_EQ(nodes.orbit[of], nodes.orbit[k]);
            EXPECT_EQ(nodes.points[k],
                      Vec3(nodes.points[of] + mesh.lattice.translation(nodes.offset[k])));
            representatives.insert(of);
        }
        // The torus has as many edges.
        EXPECT_EQ(static_cast<int>(representatives.size()), prove_tetrahedra(mesh).n_edges);
    }
}

}  // namespace
}  // namespace pcvt::space
