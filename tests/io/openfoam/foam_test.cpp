#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "mesher/plane/proof/validate.hpp"
#include "tests/support/grid_tile.hpp"
#include "tests/support/layer_case.hpp"
#include "tests/support/mutation.hpp"
#include "tests/support/tile_equality.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::vector<EncodedFile> grid_case() {
    return testing::layer_case(testing::grid_tile(plane::Lattice({1, 0}, {0.37, 0.81}), 3, 2));
}

EncodedFile& file_named(std::vector<EncodedFile>& files, const std::string& name) {
    return *std::find_if(files.begin(), files.end(),
                         [&](const EncodedFile& f) { return f.path == "t.foam/" + name; });
}

std::string fault_of(const std::vector<EncodedFile>& files,
                     const std::optional<plane::Lattice>& lattice = {}) {
    try {
        decode_foam_layer(files, lattice);
    } catch (const InvalidInput& fault) {
        return fault.what();
    }
    return "";
}

/// Returns the fault of the example with `piece` of the file `name` replaced by `other`.
std::string fault_with(const std::string& name, const std::string& piece,
                       const std::string& other) {
    auto files = grid_case();
    std::string& text = file_named(files, name).bytes;
    const std::size_t at = text.find(piece);
    EXPECT_NE(at, std::string::npos) << piece;
    text.replace(at, piece.size(), other);
    return fault_of(files);
}

TEST(Foam, TilesReadBackExactlyWithTheirEdgePairs) {
    for (const plane::Lattice& lattice : testing::awkward_lattices()) {
        for (const plane::Tile& tile :
             {testing::grid_tile(lattice, 3, 2), testing::grid_tile(lattice, 1, 1),
              testing::triangle_grid_tile(lattice, 2, 5)}) {
            const TileFile file = decode_foam_layer(testing::layer_case(tile), std::nullopt);
            EXPECT_TRUE(file.has_edge_pairs);
            EXPECT_EQ(file.tile.points, tile.points);
            EXPECT_EQ(file.tile.kind, tile.kind);
            EXPECT_EQ(file.tile.lattice.a(), lattice.a());
            EXPECT_EQ(file.tile.lattice.b(), lattice.b());
            const plane::TileProof proof = prove_tile(file.tile, file.precision);
            compare_edge_pairs(file.tile, proof);
            compare_edge_pairs(tile, proof);
        }
    }
}

TEST(Foam, TheCaseHasTheEntriesThatTheSolversNeed) {
    auto files = grid_case();
    const auto text = [&](const char* name) { return file_named(files, name).bytes; };
    EXPECT_THAT(text("system/controlDict"), HasSubstr("application     icoFoam"));
    for (const char* entry : {"PISO", "PIMPLE", "potentialFlow", "PhiRefCell", "SIMPLE"}) {
        EXPECT_THAT(text("system/fvSolution"), HasSubstr(entry));
    }
    for (const char* entry : {"div(phi,U) ", "div(phi,T) ", "Gauss skewCorrected linear",
                              "laplacianSchemes     { default Gauss linear corrected; }"}) {
        EXPECT_THAT(text("system/fvSchemes"), HasSubstr(entry));
    }
    for (const char* entry : {"transportModel Newtonian", "nu [0 2 -1", "DT [0 2 -1"}) {
        EXPECT_THAT(text("constant/transportProperties"), HasSubstr(entry));
    }
    EXPECT_THAT(text("constant/turbulenceProperties"), HasSubstr("laminar"));
    EXPECT_EQ(text("t.foam"), "");
    for (const char* field : {"0/U", "0/p", "0/T"}) {
        for (const char* patch : {"seam_0_1 { type cyclic; }", "seam_-1_0 { type cyclic; }",
                                  "back { type empty; }", "front { type empty; }"}) {
            EXPECT_THAT(file_named(files, field).bytes, HasSubstr(patch));
        }
    }
    EXPECT_EQ(std::count_if(files.begin(), files.end(),
                            [](const EncodedFile& f) {
                                return f.bytes.find('$') != std::string::npos &&
                                       f.path.find("fvSolution") == std::string::npos;
                            }),
              0);
}

/// Returns the number after `key` in a file of the case.
double number_after(std::vector<EncodedFile>& files, const std::string& name,
                    const std::string& key) {
    const std::string& text = file_named(files, name).bytes;
    return std::stod(text.substr(text.find("\n" + key) + 1 + key.size()));
}

TEST(Foam, TheFirstStepHasACourantNumberOfAtMostAHalf) {
    for (const auto& [columns, rows] : {std::pair(12, 12), std::pair(90, 30), std::pair(10, 200)}) {
        const plane::Tile tile = testing::grid_tile(plane::Lattice::rectangle(1, 1), columns, rows);
        auto files = testing::layer_case(tile);
        const double step = number_after(files, "system/controlDict", "deltaT");
        const double end = number_after(files, "system/controlDict", "endTime");
        const double interval = number_after(files, "system/controlDict", "writeInterval");
        const double rate =
            cell_flow(DecayingFlow(tile.lattice), tile, extruded_mesh(tile)).courant_rate;
        EXPECT_LE(step * rate, 0.45 * (1 + 1e-12));
        EXPECT_NEAR(step * interval * 5, end, 1e-12);
        EXPECT_GE(interval, 10);
        // One more step per interval would not be needed.
        EXPECT_TRUE(interval == 10 || end / (5 * (interval - 1)) * rate > 0.45);
    }
}

TEST(Foam, CellsThatAreTooLargeForTheFlowStartAtRest) {
    auto files = testing::layer_case(testing::grid_tile(plane::Lattice::rectangle(1, 1), 1, 2));
    EXPECT_THAT(file_named(files, "constant/transportProperties").bytes,
                HasSubstr("U and T start as 0"));
    EXPECT_THAT(file_named(files, "0/U").bytes, HasSubstr("\n2\n(\n(0 0 0)\n(0 0 0)\n);\n"));
    EXPECT_THAT(file_named(files, "0/T").bytes, HasSubstr("\n2\n(\n0\n0\n);\n"));
}

TEST(Foam, ABoundaryOfAnotherProgramNeedsTheLattice) {
    auto files = grid_case();
    std::string& text = file_named(files, "constant/polyMesh/boundary").bytes;
    text.replace(text.find("// pcvt lattice"), 7, "// also");
    EXPECT_THAT(fault_of(files), HasSubstr("names no lattice; pass --lattice"));
    EXPECT_EQ(fault_of(files, plane::Lattice({1, 0}, {0.37, 0.81})), "");
    EXPECT_THAT(fault_of(files, plane::Lattice({1, 0}, {0.37, 0.8})),
                HasSubstr("a separation other than"));
}

TEST(Foam, FaultsNameTheirFileAndLine) {
    EXPECT_EQ(fault_of(grid_case()), "");
    EXPECT_THAT(fault_with("constant/polyMesh/points", "ascii", "binary"),
                StartsWith("t.foam/constant/polyMesh/points:4: the format is not ascii; "));
    EXPECT_THAT(fault_with("constant/polyMesh/points", "\n(0 0 0)", "\n(0 zero 0)"),
                StartsWith("t.foam/constant/polyMesh/points:12: 'zero' is not a number; "));
    EXPECT_THAT(fault_with("constant/polyMesh/owner", "(\n", "(\nx"), HasSubstr("owner:13: "));
    EXPECT_THAT(fault_with("constant/polyMesh/faces", "\n(\n4(", "\n(\n9999(\n"),
                HasSubstr("does not fit the file; give the whole file"));
    EXPECT_THAT(fault_with("constant/polyMesh/boundary", "cyclic", "wall"),
                HasSubstr("'seam_0_1' is neither an empty one, a wall nor one side of a seam; "));
    EXPECT_THAT(fault_with("constant/polyMesh/boundary", "Patch  seam_0_-1", "Patch  other"),
                HasSubstr("there is no patch 'other'; "));
    EXPECT_THAT(fault_with("constant/polyMesh/boundary", " 0);", " 1);"),
                HasSubstr("a separation leaves the plane; make z 0"));
    EXPECT_THAT(fault_with("constant/polyMesh/boundary", "seam_0_1", "seam_0_1_0"),
                HasSubstr("'seam_0_1_0' is neither"));
    auto files = grid_case();
    files.erase(files.begin() + 2);
    EXPECT_THAT(fault_of(files), HasSubstr("there is no constant/polyMesh/owner beside it; "));
}

TEST(Foam, CommentsAndOneLineListsAreRead) {
    auto files = grid_case();
    std::string& text = file_named(files, "constant/polyMesh/owner").bytes;
    for (char& c : text) c = c == '\n' ? ' ' : c;
    text = "/* by\n hand */" + text + "// the end";
    EXPECT_EQ(fault_of(files), "");
}

const CellMaterials& two_phases() {
    static const CellMaterials phases{.phase_names = {"1st", "b"},
                                      .site_phase = {0, 1, 1, 0, 1, 1}};
    return phases;
}

std::vector<EncodedFile> phase_example() {
    return testing::layer_case(testing::grid_tile(plane::Lattice({1, 0}, {0.37, 0.81}), 3, 2), 0,
                               &two_phases());
}

TEST(Foam, CellsOfAPhaseAreAZone) {
    auto files = phase_example();
    EXPECT_THAT(file_named(files, "constant/polyMesh/cellZones").bytes,
                HasSubstr("2\n(\nphase_1st\n{\n    type            cellZone;\n    cellLabels      "
                          "List<label>\n2\n(\n0\n3\n)\n;\n}\nphase_b\n"));
    EXPECT_EQ(decode_foam_layer(files, {}).materials, two_phases());
    auto without = grid_case();
    EXPECT_THAT(file_named(without, "constant/polyMesh/cellZones").bytes, HasSubstr("0\n(\n)\n"));
}

TEST(Foam, FalsePhasesAreRefused) {
    const auto fault = [](const std::string& piece, const std::string& other) {
        auto files = phase_example();
        std::string& text = file_named(files, "constant/polyMesh/boundary").bytes;
        const std::size_t at = text.find(piece);
        EXPECT_NE(at, std::string::npos) << piece;
        text.replace(at, piece.size(), other);
        return fault_of(files);
    };
    EXPECT_THAT(fault("site_phases 0 1 1 0 1 1", "site_phases 0 1 1 0 1"), HasSubstr("phases"));
    EXPECT_THAT(fault("site_phases 0", "site_phases 2"), HasSubstr("t.foam"));
    auto files = phase_example();
    std::erase_if(files, [](const EncodedFile& f) { return f.path.ends_with("cellZones"); });
    EXPECT_THAT(fault_of(files), HasSubstr("there is no constant/polyMesh/cellZones beside it"));
}

TEST(Foam, NonFiniteCoordinatesAreInternalErrors) {
    plane::Tile tile = testing::grid_tile(plane::Lattice::rectangle(1, 1), 1, 1);
    tile.points[0].x() = std::nan("");
    EXPECT_THROW(testing::layer_case(tile), InternalError);
}

TEST(Foam, DamagedFilesGiveATileOrAFaultAndNothingElse) {
    std::mt19937_64 random(3);
    const auto sound = grid_case();
    int n_refused = 0;
    for (int k = 0; k < 3000; ++k) {
        auto files = sound;
        std::string& bytes = files[random() % 5].bytes;
        bytes = testing::mutated(bytes, random);
        const std::string fault = fault_of(files);
        if (fault.empty()) continue;
        ++n_refused;
        EXPECT_THAT(fault, ::testing::AnyOf(StartsWith("t.foam/"), StartsWith("law (")));
    }
    EXPECT_GT(n_refused, 2000);
}

}  // namespace
}  // namespace pcvt
