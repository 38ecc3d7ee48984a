#include <gmock/gmock.h>

#include "mesher/plane/proof/validate.hpp"
#include "tests/support/example_lattices.hpp"
#include "tests/support/grid_tile.hpp"

namespace pcvt::plane {
namespace {

using ::testing::AllOf;
using testing::grid_tile;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::kSquare;
using testing::triangle_grid_tile;

/// Returns the message that refuses the stored pairs; empty if they are correct.
std::string pairs_refusal(const Tile& tile) {
    const TileProof proof = prove_tile(tile, Precision::kDouble);
    try {
        compare_vertex_pairs(tile, proof);
        compare_edge_pairs(tile, proof);
        return "";
    } catch (const NotATile& error) {
        return error.what();
    }
}

TEST(StoredPairs, WrongOnesAreNamed) {
    Tile tile = grid_tile(kSquare, 3, 2);
    tile.vertex_pairs[2].offset = {1, 1};
    EXPECT_THAT(pairs_refusal(tile),
                AllOf(HasSubstr("vertex pair 2"), HasSubstr("the offset is (")));
    tile.vertex_pairs[2].w = 5;
    EXPECT_THAT(pairs_refusal(tile), AllOf(HasSubstr("vertex pair 2"), HasSubstr("not images")));
    tile.vertex_pairs[2].w = 12;
    EXPECT_THAT(pairs_refusal(tile), HasSubstr("vertex pair 2 names vertex 12; there are 12"));
    tile = grid_tile(kSquare, 3, 2);
    std::swap(tile.edge_pairs[1].w0, tile.edge_pairs[1].w1);
    EXPECT_THAT(pairs_refusal(tile),
                AllOf(HasSubstr("edge pair 1"), HasSubstr("no two boundary edges")));
    tile.edge_pairs[1].w0 = -1;
    EXPECT_THAT(pairs_refusal(tile), HasSubstr("edge pair 1 names vertex -1"));
}

TEST(StoredPairs, EachOneIsNeeded) {
    const Tile whole = triangle_grid_tile(Lattice({1, 0}, {7, 1}), 3, 2);
    for (std::size_t k = 0; k < whole.vertex_pairs.size(); ++k) {
        Tile tile = whole;
        tile.vertex_pairs.erase(tile.vertex_pairs.begin() + static_cast<int>(k));
        EXPECT_THAT(pairs_refusal(tile), HasSubstr("does not follow from the stored vertex pairs"));
    }
    for (std::size_t k = 0; k < whole.edge_pairs.size(); ++k) {
        Tile tile = whole;
        tile.edge_pairs.erase(tile.edge_pairs.begin() + static_cast<int>(k));
        EXPECT_THAT(pairs_refusal(tile), HasSubstr("edge pairs lack"));
    }
}

TEST(StoredPairs, AnyGeneratingSetIsAccepted) {
    // The pairs of the four corners of a one-cell tile form a chain instead of a star.
    Tile tile = grid_tile(Lattice({1, 0}, {7, 1}), 1, 1);
    tile.vertex_pairs = {{3, 2, {-1, 0}}, {1, 3, {0, 1}}, {2, 0, {0, -1}}, {0, 3, {1, 1}}};
    EXPECT_THAT(pairs_refusal(tile), IsEmpty());
    tile.vertex_pairs[1].offset = {1, 0};
    EXPECT_THAT(pairs_refusal(tile), HasSubstr("vertex pair 1"));
}

}  // namespace
}  // namespace pcvt::plane
