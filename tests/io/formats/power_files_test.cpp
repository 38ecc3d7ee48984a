#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "io/formats/file_proof.hpp"
#include "mesher/base/error.hpp"
#include "tests/support/damaged_text.hpp"
#include "tests/support/example_lattices.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/power_tiles.hpp"

// Power cells and elongated cells in the files of every format that is read back.
namespace pcvt {
namespace {

using testing::CellShape;
using ::testing::HasSubstr;
using testing::kOblique;

constexpr int kSites = 24;

bool holds_power_cells(const Format& format, const plane::Tile& tile, plane::Outline outline) {
    if (!format.needs_tile() || !format.is_readable()) return false;
    if (!format.holds_polygons && tile.kind == plane::MeshKind::kVoronoi) return false;
    return !format.is_folder || outline == plane::Outline::kWhole ||
           tile.kind != plane::MeshKind::kVoronoi;
}

std::vector<FileOptions> forms(const Format& format) {
    std::vector<FileOptions> forms{{}};
    if (format.takes.gltf_nodes) forms.push_back({.gltf_nodes = GltfNodes::kOne});
    if (format.takes.single_precision) forms.push_back({.single_precision = true});
    return forms;
}

/// The complaint of `pcvt check`; empty if it accepts the files.
std::string power_refusal(const Format& format, const std::vector<EncodedFile>& files) {
    try {
        prove_file(format, files, decode_tile(format, files, std::nullopt));
        return "";
    } catch (const InvalidInput& fault) {
        return fault.what();
    }
}

/// Whether the format takes the numbers of the tile: fields of 20 characters do not take all.
bool has_room(const Format& format, const plane::Tile& tile) {
    const double size = tile.lattice.a().norm();
    return format.extension != ".inp" || (size > 0.1 && size < 1e5);
}

/// Expects that a file states the weights and the metric of its tile.
void expect_same_notes(const TileFile& file, const plane::Tile& tile) {
    EXPECT_EQ(file.tile.metric, tile.metric);
    ASSERT_EQ(file.tile.site_weights.size(), tile.site_weights.size());
    if (file.precision == plane::Precision::kDouble) {
        EXPECT_EQ(file.tile.site_weights, tile.site_weights);
    }
    for (std::size_t s = 0; s < tile.site_weights.size(); ++s) {
        EXPECT_EQ(static_cast<float>(file.tile.site_weights[s]),
                  static_cast<float>(tile.site_weights[s]));
    }
}

void expect_round_trips(const plane::Tile& tile, plane::Outline outline) {
    for (const Format& format : formats()) {
        if (!holds_power_cells(format, tile, outline) || !has_room(format, tile)) continue;
        const std::string path = "t" + std::string(format.extension);
        SCOPED_TRACE(path);
        for (const FileOptions& options : forms(format)) {
            const std::vector<EncodedFile> files = encode_tile(format, tile, path, options);
            const TileFile file = decode_tile(format, files, std::nullopt);
            expect_same_notes(file, tile);
            EXPECT_EQ(power_refusal(format, files), "");
            EXPECT_NO_THROW(prove_tile_files(format, files, tile, plane::Vec2::Zero()));
        }
    }
}

TEST(PowerFiles, EveryFormatOfEveryMeshIsProvedBySitesWeightsAndMetricSlow) {
    int seed = 0;
    for (const CellShape& shape : testing::cell_shapes()) {
        for (const auto& [name, lattice] : testing::lattices()) {
            SCOPED_TRACE(std::string(shape.name) + " on " + name);
            const std::vector<plane::TileOptions> kinds = testing::tile_kinds();
            const plane::TileOptions& options = kinds[++seed % kinds.size()];
            expect_round_trips(testing::power_tile(lattice, kSites, seed, shape, options),
                               options.outline);
        }
        for (const plane::TileOptions& options : testing::tile_kinds()) {
            SCOPED_TRACE(shape.name);
            expect_round_trips(testing::power_tile(kOblique, kSites, ++seed, shape, options, 3),
                               options.outline);
        }
    }
}

TEST(PowerFiles, FewSitesTouchTheirOwnImagesSlow) {
    for (const CellShape& shape : testing::cell_shapes()) {
        for (int n = 1; n <= 8; ++n) {
            for (const plane::MeshKind kind :
                 {plane::MeshKind::kVoronoi, plane::MeshKind::kDelaunay,
                  plane::MeshKind::kGrains}) {
                SCOPED_TRACE(std::string(shape.name) + ' ' + std::to_string(n));
                expect_round_trips(testing::power_tile(kOblique, n, n, shape, {.kind = kind}),
                                   plane::Outline::kWhole);
            }
        }
    }
}

/// The formats that hold cells.
std::vector<const Format*> cell_formats() {
    std::vector<const Format*> of_cells;
    for (const Format& format : formats()) {
        const bool reads = format.needs_tile() && format.is_readable();
        if (reads && format.holds_polygons) of_cells.push_back(&format);
    }
    return of_cells;
}

/// The complaint of `pcvt check` about the files of `written`.
std::string power_refusal(const Format& format, const plane::Tile& written) {
    const std::string path = "t" + std::string(format.extension);
    const std::vector<EncodedFile> files = encode_tile(format, written, path);
    return power_refusal(format, files);
}

TEST(PowerFiles, ExchangedWeightsAreRefusedInEveryFormat) {
    const plane::Tile tile = testing::power_tile(kOblique, kSites, 1, testing::cell_shapes()[0]);
    for (const Format* format : cell_formats()) {
        EXPECT_EQ(power_refusal(*format, tile), "");
        for (int s = 0; s + 1 < kSites; ++s) {
            plane::Tile changed = tile;
            std::swap(changed.site_weights[s], changed.site_weights[s + 1]);
            EXPECT_THAT(power_refusal(*format, changed), HasSubstr("law of the sites"))
                << format->extension << ' ' << s;
        }
    }
}

TEST(PowerFiles, AWeightThatIsOffByAHundredThousandthIsRefused) {
    const double squared = kOblique.area() / kSites;
    int n_large = 0;
    for (const CellShape& shape :
         {CellShape{"power", "lognormal:0.7"}, testing::cell_shapes()[2]}) {
        const plane::Tile tile = testing::power_tile(kOblique, kSites, 2, shape);
        for (int s = 0; s < kSites; ++s) {
            // The steps are also relative to the weight itself, unless it is small compared with
            // h^2.
            const double weight = tile.site_weights[s];
            const bool is_large = std::abs(weight) > squared / 2;
            const double scale = is_large ? weight : squared;
            n_large += is_large ? 1 : 0;
            for (const double step : {1e-5 * scale, -1e-5 * scale, 1e-5 * squared}) {
                plane::Tile changed = tile;
                changed.site_weights[s] += step;
                EXPECT_THAT(power_refusal(*find_format("t.obj"), changed),
                            HasSubstr("law of the sites"))
                    << s;
            }
        }
    }
    EXPECT_GT(n_large, 0);
}

TEST(PowerFiles, CellsWithoutTheirWeightsAreRefused) {
    plane::Tile tile = testing::power_tile(kOblique, kSites, 3, testing::cell_shapes()[0]);
    tile.site_weights.clear();
    for (const Format* format : cell_formats()) {
        EXPECT_THAT(power_refusal(*format, tile), HasSubstr("law of the sites"))
            << format->extension;
    }
}

TEST(PowerFiles, AnotherMetricIsRefused) {
    for (const CellShape& shape : {testing::cell_shapes()[1], testing::cell_shapes()[2]}) {
        const plane::Tile tile = testing::power_tile(kOblique, kSites, 4, shape);
        const double ratio = tile.metric.ratio();
        const double degrees = tile.metric.degrees();
        for (const plane::Metric& metric :
             {plane::Metric(), plane::Metric(ratio, degrees + 1e-3),
              plane::Metric(ratio, degrees - 90), plane::Metric(ratio * 1.00001, degrees),
              plane::Metric(1 / ratio, degrees)}) {
            plane::Tile changed = tile;
            changed.metric = metric;
            for (const char* path : {"t.obj", "t.ply", "t.om", "t.vtu", "t.foam"}) {
                EXPECT_THAT(power_refusal(*find_format(path), changed),
                            HasSubstr("law of the sites"))
                    << path << ' ' << metric.ratio() << ' ' << metric.degrees();
            }
        }
        plane::Tile turned = tile;
        turned.metric = plane::Metric(ratio, degrees + 180);
        EXPECT_EQ(power_refusal(*find_format("t.obj"), turned), "");
    }
}

/// The complaint about a text file with `piece` replaced.
std::string power_fault_with(const plane::Tile& tile, const std::string& path,
                             const std::string& name, const std::string& piece,
                             const std::string& other) {
    const Format& format = *find_format(path);
    const std::vector<EncodedFile> files =
        testing::exchanged(encode_tile(format, tile, path), name, piece, other);
    return power_refusal(format, files);
}

TEST(PowerFiles, NotesThatAreMalformedAreRefusedInOneLine) {
    const plane::Tile tile = testing::power_tile(kOblique, 5, 5, testing::cell_shapes()[2]);
    const auto fault = [&](const std::string& piece, const std::string& other) {
        return power_fault_with(tile, "t.obj", ".obj", piece, other);
    };
    EXPECT_EQ(fault("", ""), "");
    EXPECT_THAT(fault("# pcvt metric 0.4 -77.25", "# pcvt metric 0.4"),
                HasSubstr("the note metric is unclear; write its numbers: ratio degrees"));
    EXPECT_THAT(fault("# pcvt metric 0.4 -77.25", "# pcvt metric 400 -77.25"),
                HasSubstr("the aspect ratio must lie between 0.01 and 100"));
    EXPECT_THAT(
        fault("# pcvt metric 0.4 -77.25\n", "# pcvt metric 0.4 -77.25\n# pcvt metric 0.4 -77.25\n"),
        HasSubstr("a second line states the metric; keep one"));
    const std::string text = encode_tile(*find_format("t.obj"), tile, "t.obj")[0].bytes;
    const std::size_t begin = text.find("\n# pcvt site ") + 1;
    const std::string row = text.substr(begin, text.find('\n', begin) - begin);
    EXPECT_THAT(fault(row, row.substr(0, row.rfind(' '))),
                HasSubstr("there are 4 weights for 5 sites; give one each or none"));
    EXPECT_THAT(fault(row, row + " 7"), HasSubstr("more numbers than x, y and weight"));
    EXPECT_THAT(fault(row, row.substr(0, row.rfind(' ')) + " x"), HasSubstr("'x'"));
}

TEST(PowerFiles, ACaseOfOpenFoamStatesItsSites) {
    const plane::Tile tile = testing::power_tile(kOblique, 9, 5, testing::cell_shapes()[0]);
    const auto fault = [&](const std::string& piece, const std::string& other) {
        return power_fault_with(tile, "t.foam", "polyMesh/boundary", piece, other);
    };
    EXPECT_EQ(fault("", ""), "");
    EXPECT_THAT(fault("// pcvt sites 0 1", "// pcvt sites 1 0"), HasSubstr("law of the sites"));
    EXPECT_THAT(fault("// pcvt sites 0 1", "// pcvt sites 0"), HasSubstr("8 sites for 9 faces"));
    EXPECT_THAT(fault("// pcvt sites", "// pcvt places"), HasSubstr("does not know 'places'"));
}

}  // namespace
}  // namespace pcvt
