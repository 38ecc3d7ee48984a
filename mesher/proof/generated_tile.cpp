#include "mesher/proof/generated_tile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "mesher/base/checkpoint.hpp"
#include "mesher/proof/site_labels.hpp"

namespace pcvt {
namespace {

/// The proof compares positions within this many ulps of the largest coordinate.
constexpr double kPositionUlps = 4;
/// A tile whose smallest feature is this many times that rounding keeps its laws.
constexpr double kResolved = 1e3;

double shortest_edge(const Tile& tile) {
    double shortest = std::numeric_limits<double>::infinity();
    for (int f = 0; f < tile.n_faces(); ++f) {
        checkpoint_each(f);
        Vec2 from = tile.points[tile.faces[f].back()];
        for (const int v : tile.faces[f]) {
            shortest = std::min(shortest, (tile.points[v] - from).norm());
            from = tile.points[v];
        }
    }
    return shortest;
}

}  // namespace

TileProof verify_generated_tile(const Tile& tile) {
    try {
        TileProof proof = prove_tile(tile, Precision::kDouble);
        compare_vertex_pairs(tile, proof);
        compare_edge_pairs(tile, proof);
        compare_wall_edges(tile, proof);
        prove_sites(tile, proof);
        return proof;
    } catch (const NotATile& error) {
        throw InternalError(std::string("the tile breaks a law of tiles: ") + error.what());
    }
}

bool fits_single_precision(const Tile& tile) {
    double largest = 0;
    for (const Vec2& point : tile.points) largest = std::max(largest, point.cwiseAbs().maxCoeff());
    const double smallest = std::min({shortest_edge(tile), reduce(tile.lattice).reduced.a().norm(),
                                      std::sqrt(tile.lattice.area() / tile.n_faces())});
    return kResolved * kPositionUlps * largest * double(std::numeric_limits<float>::epsilon()) <=
           smallest;
}

}  // namespace pcvt
