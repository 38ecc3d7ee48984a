#include <gmock/gmock.h>

#include "io/forms/tile_file.hpp"
#include "io/mpas/mpas_format.hpp"
#include "io/mpas/mpas_graph.hpp"
#include "io/mpas/mpas_reader.hpp"
#include "io/mpas/mpas_writer.hpp"
#include "io/mpas/netcdf_file.hpp"
#include "mesher/finite_volume/mpas_grid_proof.hpp"
#include "tests/support/hexagons.hpp"
#include "tests/support/mutation.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

MpasGrid example() { return mpas_grid(testing::hexagonal_cells(6, 4), plane::Vec2(0, 0)); }

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

TEST(Mpas, AMeshThatIsNoPlaneTorusIsRefused) {
    const std::string bytes = encode_mpas(example());
    for (const char* name : {"on_a_sphere", "is_periodic"}) {
        std::string other = bytes;
        const std::size_t value = other.find(name) + 20;
        ASSERT_TRUE(other[value] == 'N' || other[value] == 'Y') << other.substr(value, 4);
        other[value] = 'x';
        EXPECT_THAT(fault_of(other), HasSubstr(std::string("attribute ") + name + " is not "));
    }
}

TEST(Mpas, ADensityThatDiffersFromItsMeanIsRefused) {
    MpasGrid grid = example();
    grid.mesh_density[3] = 0.25;
    const std::string bytes = encode_mpas(grid);
    EXPECT_EQ(fault_of(bytes), "");
    grid.mesh_density[3] = 0.5;
    std::string other = encode_mpas(grid);
    const std::size_t mean = bytes.find("mesh_density_mean") + 28;
    other.replace(mean, 8, bytes, mean, 8);
    EXPECT_THAT(fault_of(other), HasSubstr("law (5) of C-grids, density: its mean is "));
    grid.mesh_density.assign(grid.mesh_density.size(), 0.5);
    EXPECT_THAT(fault_of(encode_mpas(grid)), HasSubstr("not above 0 and up to 1"));
}

TEST(Mpas, TheCoriolisParameterReadsBackAndIsProved) {
    MpasGrid grid = mpas_grid(testing::hexagonal_cells(6, 4), plane::Vec2(-3, 7));
    EXPECT_FALSE(decode_mpas("t.nc", encode_mpas(grid)).coriolis);
    const Coriolis coriolis{.f = 1e-4, .beta = -0.3};
    fill_coriolis(coriolis, grid);
    for (std::size_t v = 0; v < grid.y_vertex.size(); ++v) {
        EXPECT_EQ(grid.f_vertex[v], 1e-4 - 0.3 * grid.y_vertex[v]);
    }
    const MpasGrid read = decode_mpas("t.nc", encode_mpas(grid));
    EXPECT_EQ(read.coriolis, coriolis);
    EXPECT_EQ(read.f_cell, grid.f_cell);
    EXPECT_EQ(fault_of(encode_mpas(grid)), "");
    grid.f_edge[2] += 1e-9;
    EXPECT_THAT(fault_of(encode_mpas(grid)), HasSubstr("law (6) of C-grids, Coriolis parameter"));
}

TEST(Mpas, VariablesHaveUnitsAndNamesAndTheFileItsHistory) {
    const std::string bytes = encode_mpas(example(), "pcvt 1.2.3: mesh; seed 4");
    EXPECT_THAT(bytes, HasSubstr("pcvt 1.2.3: mesh; seed 4"));
    EXPECT_THAT(encode_mpas(example()), Not(HasSubstr("history")));
    for (const MpasVariable& variable : mpas_variables()) {
        EXPECT_NE(std::string(variable.units), "");
        EXPECT_EQ(bytes.find(variable.long_name) == std::string::npos, is_coriolis(variable));
    }
}

TEST(Mpas, AnotherGraphIsRefusedWithItsLine) {
    const MpasGrid grid = example();
    std::string graph = encode_mpas_graph(grid);
    EXPECT_NO_THROW(compare_mpas_graph(grid, "t.graph.info", graph));
    const std::size_t second = graph.find('\n') + 1;
    graph[second] = graph[second] == '3' ? '4' : '3';
    EXPECT_THROW(compare_mpas_graph(grid, "t.graph.info", graph), BadFile);
}

TEST(Mpas, ATruncatedFileIsRefused) {
    const std::string bytes = encode_mpas(example());
    for (std::size_t length = 0; length < bytes.size(); length += 97) {
        EXPECT_NE(fault_of(bytes.substr(0, length)), "") << length;
    }
}

TEST(Mpas, CountsThatTheFileCannotHoldAreRefusedBeforeMemoryIsAllocated) {
    const std::string bytes = encode_mpas(example());
    // The numbers of dimensions and of global attributes, the lengths of the first name and value.
    const std::size_t attributes = bytes.find(std::string("\0\0\0\x0C", 4), bytes.find("Time"));
    for (const std::size_t place :
         {std::size_t{12}, std::size_t{16}, attributes + 4, attributes + 8}) {
        std::string other = bytes;
        other.replace(place, 4, "\x7F\xFF\xFF\xF0");
        EXPECT_THAT(fault_of(other), StartsWith("t.nc: the header ends too early at byte "))
            << place;
    }
    EXPECT_THAT(fault_of(std::string("CDF\x02\0\0\0\0\0\0\0\x0B\0\0\0\1", 16)),
                StartsWith("t.nc: the header has another list than is due at byte 16; "));
    EXPECT_THAT(fault_of("CDF\x03"), StartsWith("t.nc: the header is of version 3, not 1, 2 or 5"));
}

// The bytes of CDF-1 and CDF-5 as `nccopy -k` makes them, written out.
TEST(Mpas, NumbersOfEveryTypeAndVersionAreRead) {
    const auto file = [](char version, const std::string& type, const std::string& value) {
        const std::string wide = version == 5 ? std::string(4, '\0') : "";
        const std::string one = wide + std::string("\0\0\0\1", 4);
        const std::string none = std::string(4, '\0') + wide + std::string(4, '\0');
        const std::string offset = version == 1 ? "" : std::string(4, '\0');
        std::string bytes = std::string("CDF") + version + wide + std::string(4, '\0');
        bytes += std::string("\0\0\0\x0A", 4) + one + one + std::string("n\0\0\0", 4) + one + none;
        bytes += std::string("\0\0\0\x0B", 4) + one + one + std::string("v\0\0\0", 4) + one + wide +
                 std::string(4, '\0') + none + std::string("\0\0\0", 3) + type + one + offset;
        const auto begin = static_cast<char>(bytes.size() + 4);
        return bytes + std::string("\0\0\0", 3) + begin + value;
    };
    const std::vector<std::pair<std::string, std::string>> values{
        {"\1", "\xF9"},
        {"\3", "\xFF\xF9"},
        {"\4", "\xFF\xFF\xFF\xF9"},
        {"\5", std::string("\xC0\xE0\0\0", 4)},
        {"\6", std::string("\xC0\x1C\0\0\0\0\0\0", 8)},
        {"\12", "\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xF9"}};
    for (const char version : {'\1', '\2', '\5'}) {
        for (const auto& [type, value] : values) {
            const std::string bytes = file(version, type, value);
            const NetcdfFile read("t.nc", bytes);
            EXPECT_EQ(read.dimension("n"), 1u);
            EXPECT_EQ(read.integers("v", {1}), std::vector<int>{-7}) << int(type[0]);
        }
        const std::string bytes = file(version, "\7", "\xF9");
        EXPECT_EQ(NetcdfFile("t.nc", bytes).numbers("v", {1}), std::vector<double>{249});
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
