#include <gmock/gmock.h>

#include "io/mpas/mpas_format.hpp"
#include "io/mpas/mpas_reader.hpp"
#include "io/mpas/mpas_writer.hpp"
#include "io/tiles/tile_file.hpp"
#include "mesher/finite_volume/mpas_grid_proof.hpp"
#include "tests/support/hexagons.hpp"
#include "tests/support/mutation.hpp"

/// The netCDF library allocates as much memory as a damaged header states, and copes with a
/// refusal. The limit spares the sanitizer the shadow of such blocks.
extern "C" const char* __asan_default_options() {
    return "allocator_may_return_null=1:max_allocation_size_mb=64";
}

namespace pcvt {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

MpasGrid example() { return mpas_grid(testing::hexagonal_cells(6, 4), Vec2(0, 0)); }

std::string fault_of(const std::string& bytes) {
    try {
        prove_mpas_grid(decode_mpas("t.nc", bytes));
    } catch (const InvalidInput& fault) {
        return fault.what();
    }
    return "";
}

TEST(Mpas, EveryTableReadsBackExactly) {
    const MpasGrid grid = example();
    const MpasGrid read = decode_mpas("t.nc", encode_mpas(grid));
    for (const MpasVariable& variable : mpas_variables()) {
        if (variable.indices != nullptr) {
            EXPECT_EQ(read.*variable.indices, grid.*variable.indices) << variable.name;
        } else if (variable.counts != nullptr) {
            EXPECT_EQ(read.*variable.counts, grid.*variable.counts) << variable.name;
        } else {
            EXPECT_EQ(read.*variable.numbers, grid.*variable.numbers) << variable.name;
        }
    }
    EXPECT_EQ(read.x_period, grid.x_period);
    EXPECT_EQ(read.y_period, grid.y_period);
}

TEST(Mpas, TheSameGridGivesTheSameBytesInThe64BitOffsetFormat) {
    const std::string bytes = encode_mpas(example());
    EXPECT_THAT(bytes, StartsWith(std::string("CDF\2", 4)));
    EXPECT_EQ(encode_mpas(example()), bytes);
}

TEST(Mpas, OtherFilesAreRefused) {
    const std::string bytes = encode_mpas(example());
    EXPECT_EQ(fault_of(bytes), "");
    EXPECT_THAT(fault_of(""), StartsWith("t.nc: not a netCDF file of the classic formats; "));
    EXPECT_THAT(fault_of("\x89HDF\r\n\x1a\n"), StartsWith("t.nc: not a netCDF file"));
    for (const char* name : {"nCells", "x_period", "kiteAreasOnVertex"}) {
        std::string other = bytes;
        other[other.find(name)] = 'q';
        EXPECT_THAT(fault_of(other), HasSubstr(std::string(name) + " cannot be read: "));
    }
}

TEST(Mpas, IdsThatDoNotCountFromOneAreRefused) {
    std::string bytes = encode_mpas(example());
    ASSERT_EQ(bytes.back(), 48);
    bytes.back() = 47;
    EXPECT_THAT(fault_of(bytes), StartsWith("t.nc: indexToVertexID does not count from 1; "));
}

TEST(Mpas, ATruncatedFileIsRefused) {
    const std::string bytes = encode_mpas(example());
    for (std::size_t length = 0; length < bytes.size(); length += 97) {
        EXPECT_NE(fault_of(bytes.substr(0, length)), "") << length;
    }
}

TEST(Mpas, DamagedFilesGiveAMeshOrAFaultAndNothingElse) {
    std::mt19937_64 random(3);
    const std::string bytes = encode_mpas(example());
    int n_refused = 0;
    for (int k = 0; k < 2000; ++k) {
        const std::string fault = fault_of(testing::mutated(bytes, random));
        if (fault.empty()) continue;
        ++n_refused;
        EXPECT_THAT(fault, ::testing::AnyOf(StartsWith("t.nc: "), StartsWith("law (")));
    }
    EXPECT_GT(n_refused, 1500);
}

}  // namespace
}  // namespace pcvt
