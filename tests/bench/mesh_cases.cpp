#include <filesystem>

#include "io/formats/file_proof.hpp"
#include "io/outputs/output_set.hpp"
#include "mesher/plane/cvt/cvt.hpp"
#include "mesher/plane/proof/generated_tile.hpp"
#include "mesher/plane/tile/build_tile.hpp"
#include "tests/bench/cases.hpp"

namespace pcvt::bench {
namespace {

/// Cells after this number of iterations have about the valences of a converged run.
constexpr int kMeshIterations = 20;

plane::CvtResult some_cells(const Input& input) {
    plane::CvtOptions options;
    options.run.max_iterations = kMeshIterations;
    options.numbering = plane::Numbering::kByColumns;
    return compute_cvt(input.lattice, input.sites(), options);
}

/// The tile of the cells, with its proof.
void add_tile(const Input& input) {
    add_case("tile", input, [=](benchmark::State& state) {
        const plane::CvtResult cells = some_cells(input);
        for ([[maybe_unused]] auto _ : state) {
            const plane::BuiltTile built = build_tile(cells.delaunay, {});
            benchmark::DoNotOptimize(verify_generated_tile(built.tile));
        }
    })->Iterations(1);
}

/// Files of the tile: encoded, on the disk, read back and proved.
void add_files(const Input& input) {
    add_case("files", input, [=](benchmark::State& state) {
        const plane::CvtResult cells = some_cells(input);
        const plane::Tile tile = build_tile(cells.delaunay, {}).tile;
        const std::string folder = std::filesystem::temp_directory_path().string();
        for ([[maybe_unused]] auto _ : state) {
            for (const std::string extension : {".obj", ".glb"}) {
                const std::string path = folder + "/pcvt-bench" + extension;
                const Format& format = *find_format(path);
                OutputSet outputs;
                const auto files = encode_tile(format, tile, path);
                outputs.stage_and_compare(files);
                prove_tile_files(format, files, tile, plane::Vec2::Zero());
            }
        }
    })->Iterations(1);
}

}  // namespace

void add_mesh_cases(const Input& input) {
    if (input.lattice_name != "unit") return;
    add_tile(input);
    add_files(input);
}

}  // namespace pcvt::bench
