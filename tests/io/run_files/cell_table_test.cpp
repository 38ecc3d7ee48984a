#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <charconv>
#include <optional>

#include "io/bytes/bad_file.hpp"
#include "io/run_files/cell_reader.hpp"
#include "io/run_files/cell_writer.hpp"
#include "mesher/plane/mesh/cell_measures.hpp"
#include "mesher/plane/mesh/voronoi.hpp"

namespace pcvt {
namespace {

CellRows example_rows(bool weighted, bool with_materials) {
    const plane::Sites sites(plane::Lattice({1, 0}, {0.3, 0.9}),
                             uniform_points(plane::Lattice({1, 0}, {0.3, 0.9}), 9, 1));
    CellRows rows{.sites = sites.coordinates(),
                  .cells = cell_table(cell_mesh(plane::PeriodicDelaunay(sites)))};
    if (weighted) rows.weights = Eigen::VectorXd::LinSpaced(9, -0.3, 0.4);
    if (!with_materials) return rows;
    rows.materials.phase_names = {"a", "b-2"};
    for (int k = 0; k < 9; ++k) {
        rows.materials.site_phase.push_back(k % 2);
        rows.materials.site_orientation.push_back({40.0 * k, 20.0 * k, 0.1 * k});
        rows.orbits.push_back(k / 2);
    }
    return rows;
}

/// The number in the field that holds the character; nothing for another field.
std::optional<double> number_at(const std::string& text, std::size_t at) {
    if (text[at] == ',' || text[at] == '\n') return {};
    const std::size_t begin = text.find_last_of(",\n", at) + 1;
    const std::string field = text.substr(begin, text.find_first_of(",\n", at) - begin);
    double value = 0;
    const auto [end, fault] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (fault != std::errc() || end != field.data() + field.size()) return {};
    return value;
}

TEST(CellRows, AreReadBack) {
    for (const bool weighted : {false, true}) {
        for (const bool with_materials : {false, true}) {
            const CellRows rows = example_rows(weighted, with_materials);
            EXPECT_TRUE(reads_back("c.csv", encode_cells(rows), rows));
            EXPECT_FALSE(
                reads_back("c.csv", encode_cells(rows), example_rows(!weighted, with_materials)));
            EXPECT_FALSE(
                reads_back("c.csv", encode_cells(rows), example_rows(weighted, !with_materials)));
        }
    }
}

TEST(CellRows, OfSpaceAreReadBack) {
    CellRows rows{.sites = Eigen::MatrixXd::Random(3, 2), .cells = {}};
    rows.cells.dimension = 3;
    rows.cells.measure = {0.25, 0.75};
    rows.cells.surface = {3, 5};
    rows.cells.sides = {2, 2};
    rows.cells.neighbour_begin = {0, 2, 4};
    rows.cells.neighbours = {0, 1, 0, 1};
    const std::string text = encode_cells(rows);
    EXPECT_THAT(text,
                ::testing::HasSubstr("\nsite,x,y,z,weight,volume,diameter,faces,sphericity,"));
    EXPECT_TRUE(reads_back("c.csv", text, rows));
    for (double* const number : {&rows.sites(2, 1), &rows.cells.measure[1]}) {
        CellRows other = rows;
        *number += 1e-15;
        EXPECT_FALSE(reads_back("c.csv", text, rows));
        rows = other;
    }
    rows.cells.dimension = 2;
    EXPECT_THROW(reads_back("c.csv", text, rows), BadFile);
}

/// The writer and the reader share the order of the fields, so this row is stated. The cube of edge
/// 2 has the diameter (48 / pi)^(1/3) = 2.4814... and the sphericity (pi / 6)^(1/3) = 0.80599...
TEST(CellRows, EachColumnHoldsTheQuantityOfItsName) {
    CellRows rows{.sites = Eigen::Vector3d(0.5, 0.25, 0.125), .cells = {}};
    rows.weights = Eigen::VectorXd::Constant(1, -0.5);
    rows.cells.dimension = 3;
    rows.cells.measure = {8};
    rows.cells.surface = {24};
    rows.cells.sides = {6};
    rows.cells.neighbour_begin = {0, 6};
    rows.cells.neighbours = {0, 0, 0, 0, 0, 0};
    EXPECT_THAT(
        encode_cells(rows),
        ::testing::ContainsRegex(
            "neighbours\n0,0\\.5,0\\.25,0\\.125,-0\\.5,8,2\\.4814[0-9]*,6,0\\.80599[0-9]*,"));
}

TEST(CellRows, TheHeadStatesTheUnits) {
    const std::string text = encode_cells(example_rows(true, true));
    EXPECT_THAT(text, ::testing::HasSubstr("lengths in the unit of the period vectors\n"));
    EXPECT_THAT(text, ::testing::HasSubstr("\n# weight: length squared; phi1, Phi, phi2: Bunge's "
                                           "angles in degrees\nsite,x,y,weight,"));
}

TEST(CellRows, TheHeadNamesPowerCellsWhereSitesHaveWeights) {
    EXPECT_THAT(encode_cells(example_rows(true, true)),
                ::testing::StartsWith("# The power cells (Laguerre cells) of one period, written"));
    EXPECT_THAT(encode_cells(example_rows(false, true)),
                ::testing::StartsWith("# The Voronoi cells of one period, written by pcvt; "));
    // Files with the head of earlier versions are read.
    const CellRows rows = example_rows(true, true);
    std::string text = encode_cells(rows);
    text.replace(0, text.find('\n'), "# The Voronoi cells of one period, written by pcvt");
    EXPECT_TRUE(reads_back("c.csv", text, rows));
}

TEST(CellRows, OtherOrbitsAreFound) {
    const CellRows rows = example_rows(true, true);
    CellRows other = rows;
    other.orbits.back() = 3;
    EXPECT_FALSE(reads_back("c.csv", encode_cells(rows), other));
    other.orbits.clear();
    EXPECT_FALSE(reads_back("c.csv", encode_cells(rows), other));
}

TEST(CellRows, EveryChangedCharacterIsFound) {
    const CellRows rows = example_rows(true, true);
    const std::string text = encode_cells(rows);
    for (std::size_t at = text.find("\n0,") + 1; at < text.size(); ++at) {
        std::string damaged = text;
        damaged[at] = damaged[at] == '7' ? '8' : '7';
        // A digit of 17 may not change the number.
        const std::optional<double> number = number_at(text, at);
        if (number && number == number_at(damaged, at)) continue;
        bool found = true;
        try {
            found = !reads_back("c.csv", damaged, rows);
        } catch (const BadFile&) {
        }
        EXPECT_TRUE(found) << at << ": " << text.substr(at, 20);
    }
}

TEST(CellRows, MissingAndFurtherRowsAreFound) {
    const CellRows rows = example_rows(false, false);
    const std::string text = encode_cells(rows);
    EXPECT_FALSE(reads_back("c.csv", text.substr(0, text.rfind('\n', text.size() - 2) + 1), rows));
    EXPECT_FALSE(
        reads_back("c.csv", text + text.substr(text.rfind('\n', text.size() - 2) + 1), rows));
    EXPECT_TRUE(reads_back("c.csv", text + "# a comment\n", rows));
    EXPECT_THROW(reads_back("c.csv", text + "9,1\n", rows), BadFile);
    EXPECT_THROW(reads_back("c.csv", "site,x,y\n", rows), BadFile);
}

}  // namespace
}  // namespace pcvt
