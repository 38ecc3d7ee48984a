#include "plugin/job/job_proof.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "io/mpas/mpas_reader.hpp"
#include "mesher/finite_volume/mpas_grid_proof.hpp"
#include "mesher/tile/tile_equality.hpp"

namespace pcvt {
namespace {

/// The proof compares positions within this many ulps of the largest coordinate.
constexpr double kUlps = 4;
/// A tile whose smallest feature is this many times that rounding keeps its laws.
constexpr double kResolved = 1e3;

double shortest_edge(const Tile& tile) {
    double shortest = std::numeric_limits<double>::infinity();
    for (int f = 0; f < tile.n_faces(); ++f) {
        Vec2 from = tile.points[tile.corners[tile.face_begin[f + 1] - 1]];
        for (int c = tile.face_begin[f]; c < tile.face_begin[f + 1]; ++c) {
            const Vec2 to = tile.points[tile.corners[c]];
            shortest = std::min(shortest, (to - from).norm());
            from = to;
        }
    }
    return shortest;
}

bool fits_single_precision(const Tile& tile) {
    double largest = 0;
    for (const Vec2& point : tile.points) largest = std::max(largest, point.cwiseAbs().maxCoeff());
    const double smallest = std::min({shortest_edge(tile), reduce(tile.lattice).reduced.a().norm(),
                                      std::sqrt(tile.lattice.area() / tile.n_faces())});
    return kResolved * kUlps * largest * double(std::numeric_limits<float>::epsilon()) <= smallest;
}

std::vector<EdgePair> sorted(std::vector<EdgePair> pairs) {
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

/// Whether every law of a tile says the same of both: the proof of the one is that of the other.
bool is_the_same(const TileFile& file, const Tile& proved) {
    return file.precision == Precision::kDouble && same_geometry(file.tile, proved) &&
           (!file.has_vertex_pairs || file.tile.vertex_pairs == proved.vertex_pairs) &&
           (!file.has_edge_pairs || sorted(file.tile.edge_pairs) == sorted(proved.edge_pairs));
}

void prove_with_pairs(const TileFile& file) {
    const TileProof proof = prove_tile(file.tile, file.precision);
    if (file.has_vertex_pairs) compare_vertex_pairs(file.tile, proof);
    if (file.has_edge_pairs) compare_edge_pairs(file.tile, proof);
}

[[noreturn]] void refuse_single_precision(const std::string& path, const Vec2& origin) {
    throw InvalidInput(path + ": the format's single precision is too coarse for this tile; " +
                       "take another format" +
                       (origin == Vec2::Zero() ? "" : ", or an origin nearer to 0,0"));
}

}  // namespace

TileProof verify_generated_tile(const Tile& tile) {
    try {
        TileProof proof = prove_tile(tile, Precision::kDouble);
        compare_vertex_pairs(tile, proof);
        compare_edge_pairs(tile, proof);
        return proof;
    } catch (const NotATile& error) {
        throw InternalError(std::string("the tile breaks a law of tiles: ") + error.what());
    }
}

void require_on_disk(const OutputSet& outputs, const std::vector<EncodedFile>& files) {
    for (const EncodedFile& file : files) {
        if (outputs.holds(file.path, file.bytes)) continue;
        throw OutputError(file.path + ": the disk gives back other bytes than were written");
    }
}

void prove_files(const TileFormat& format, const std::vector<EncodedFile>& files,
                 const Tile& original, const Vec2& origin) {
    const std::string& path = files.front().path;
    Precision precision = Precision::kDouble;
    try {
        const TileFile file = format.decode(files, std::nullopt);
        precision = file.precision;
        if (!is_the_same(file, original)) prove_with_pairs(file);
    } catch (const NotATile& error) {
        if (precision == Precision::kSingle && !fits_single_precision(original)) {
            refuse_single_precision(path, origin);
        }
        throw InternalError(path + " breaks a law of tiles: " + error.what());
    } catch (const BadFile& error) {
        throw InternalError(std::string("a file is not read back: ") + error.what());
    }
}

void prove_mpas_grid_file(const EncodedFile& file) {
    try {
        prove_mpas_grid(decode_mpas(file.path, file.bytes));
    } catch (const InvalidInput& error) {
        throw InternalError(file.path + " breaks a law of C-grids: " + error.what());
    }
}

}  // namespace pcvt
