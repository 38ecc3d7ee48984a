#include "mesher/plane/proof/generated_tile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/geometry/face_polygon.hpp"
#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/proof/site_labels.hpp"

namespace pcvt::plane {
namespace {

/// The proof compares positions within this many ulps of the largest coordinate.
constexpr double kPositionUlps = 4;
/// A tile whose smallest feature is this many times that rounding keeps its laws.
constexpr double kResolved = 1e3;

/// Returns the least of the lengths of edges and of the widths of faces.
double finest_feature(const Tile& tile) {
    double finest = std::numeric_limits<double>::infinity();
    for (int f = 0; f < tile.n_faces(); ++f) {
        checkpoint_each(f);
        Vec2 from = tile.points[tile.faces[f].back()];
        double perimeter = 0;
        for (const int v : tile.faces[f]) {
            const double length = (tile.points[v] - from).norm();
            finest = std::min(finest, length);
            perimeter += length;
            from = tile.points[v];
        }
        // A face is nowhere longer than half of its perimeter.
        const double area = polygon_area(face_polygon(tile.points, tile.faces[f]));
        finest = std::min(finest, area / (perimeter / 2));
    }
    return finest;
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

bool fits_single_precision(const Tile& tile, const Vec2& from) {
    double largest = 0;
    for (const Vec2& point : tile.points) {
        largest = std::max(largest, (point - from).cwiseAbs().maxCoeff());
    }
    const double smallest = std::min({finest_feature(tile), reduce(tile.lattice).reduced.a().norm(),
                                      std::sqrt(tile.lattice.area() / tile.n_faces())});
    return kResolved * kPositionUlps * largest * double(std::numeric_limits<float>::epsilon()) <=
           smallest;
}

}  // namespace pcvt::plane
