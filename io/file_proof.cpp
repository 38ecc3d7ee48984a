#include "io/file_proof.hpp"

#include <algorithm>
#include <optional>

#include "mesher/base/error.hpp"
#include "mesher/finite_volume/mpas_grid_proof.hpp"
#include "mesher/proof/generated_tile.hpp"
#include "mesher/tile/tile_equality.hpp"

namespace pcvt {
namespace {

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

void require_on_disk(const OutputSet& outputs, const std::vector<EncodedFile>& files) {
    for (const EncodedFile& file : files) {
        if (outputs.holds(file.path, file.bytes)) continue;
        throw OutputError(file.path + ": the disk gives back other bytes than were written");
    }
}

void prove_tile_files(const TileFormat& format, const std::vector<EncodedFile>& files,
                      const Tile& original, const Vec2& origin) {
    const std::string& path = files.front().path;
    Precision precision = Precision::kDouble;
    try {
        const TileFile file = decode_tile(format, files, std::nullopt);
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

void prove_grid_files(const TileFormat& format, const std::vector<EncodedFile>& files) {
    try {
        prove_mpas_grid(std::get<GridReader*>(format.read)(files));
    } catch (const InvalidInput& error) {
        throw InternalError(files.front().path + " breaks a law of C-grids: " + error.what());
    }
}

}  // namespace pcvt
