#include "io/run_files/site_table.hpp"

#include <gmock/gmock.h>

#include <string>

#include "io/run_files/cell_writer.hpp"
#include "mesher/plane/mesh/cell_measures.hpp"
#include "mesher/plane/mesh/voronoi.hpp"

namespace pcvt {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

SiteTable<2> plane_table(std::string_view text, const SiteColumns& wanted = {}) {
    return parse_site_table<2>({.path = "t.csv"}, text, wanted);
}

template <int kDimension = 2>
std::string site_table_fault(std::string_view text, const TableName& name = {"t.csv"},
                             const SiteColumns& wanted = {}) {
    try {
        parse_site_table<kDimension>(name, text, wanted);
    } catch (const BadFile& fault) {
        return fault.what();
    }
    return "";
}

TEST(SiteTable, ATableOfCellsGivesItsSitesWeightsPhasesAndAnglesBack) {
    const plane::Lattice lattice({1, 0}, {0.3, 0.9});
    const plane::Sites sites(lattice, uniform_points(lattice, 9, 1));
    CellRows rows{.sites = sites.coordinates(),
                  .cells = cell_table(cell_mesh(plane::PeriodicDelaunay(sites)))};
    rows.weights = Eigen::VectorXd::LinSpaced(9, -0.3, 0.4);
    rows.materials.phase_names = {"a", "b-2"};
    for (int k = 0; k < 9; ++k) {
        rows.materials.site_phase.push_back(k % 2);
        rows.materials.site_orientation.push_back({40.0 * k, 20.0 * k, 0.1 * k});
    }
    const SiteTable<2> table = plane_table(encode_cells(rows));
    EXPECT_EQ(table.sites.points, rows.sites);
    EXPECT_EQ(table.weights.value().weights, rows.weights);
    EXPECT_EQ(table.weights.value().lines, table.sites.lines);
    EXPECT_EQ(table.phases.value().names, rows.materials.phase_names);
    EXPECT_EQ(table.phases.value().site_phases, rows.materials.site_phase);
    EXPECT_EQ(table.orientations, rows.materials.site_orientation);
}

TEST(SiteTable, EmptyColumnsGiveNothing) {
    const SiteTable<2> table = plane_table("x,y,weight,phase,phi1,Phi,phi2\n1,2,,,,,\n3,4,,,,,\n");
    EXPECT_EQ(table.sites.points.cols(), 2);
    EXPECT_FALSE(table.weights || table.phases);
    EXPECT_TRUE(table.orientations.empty());
    EXPECT_FALSE(plane_table("1 2\n3 4\n").weights);
}

TEST(SiteTable, EachQuantityIsTakenByItself) {
    const std::string text = "Y,X,Weight,PHASE\n1,2,3,a\n4,5,6,b\n";
    const SiteTable<2> table = plane_table(text);
    EXPECT_THAT(table.sites.points.col(0), ElementsAre(2, 1));
    EXPECT_EQ(table.weights.value().weights, Eigen::Vector2d(3, 6));
    EXPECT_THAT(table.phases.value().site_phases, ElementsAre(0, 1));
    EXPECT_TRUE(table.orientations.empty());
    EXPECT_TRUE(plane_table("x,y,phi1,Phi\n1,2,3,4\n").orientations.empty());
    EXPECT_EQ(plane_table("x,y,phi1,Phi,phi2\n1,2,3,4,5\n").orientations.size(), 1U);
    EXPECT_FALSE(parse_site_table<2>({"t.csv", {"X", "Y"}}, text, {}).weights);
}

TEST(SiteTable, AColumnThatARowFillsIsFilledInAllRows) {
    const std::string remedy = ", or take only the positions, --input t.csv:x,y";
    EXPECT_EQ(site_table_fault("x,y,weight\n1,2,\n3,4,5\n"),
              "t.csv:2: column 'weight': the field is empty; give a number" + remedy);
    EXPECT_EQ(site_table_fault("x,y,weight\n1,2,5\n3,4,\n"),
              "t.csv:3: column 'weight': the field is empty; give a number" + remedy);
    EXPECT_EQ(site_table_fault("x,y,phase\n1,2,\n3,4,a\n"),
              "t.csv:2: column 'phase': the field is empty; fill it" + remedy);
    EXPECT_EQ(site_table_fault("x,y,phi1,Phi,phi2\n1,2,,,\n3,4,,,5\n"),
              "t.csv:2: column 'phi1': the field is empty; give a number" + remedy);
    EXPECT_EQ(
        site_table_fault("x,y,phase\n1,2,Iron bcc\n"),
        "t.csv:2: column 'phase': 'Iron bcc' is not the name of a phase; take 1 to 60 letters, "
        "digits, _ or -" +
            remedy);
}

TEST(SiteTable, ColumnsThatAreNotWantedMayHoldAnything) {
    const std::string text = "x,y,weight,phase,phi1,Phi,phi2\n1,2,kg,Iron bcc,a,b,c\n3,4,,,,,\n";
    EXPECT_EQ(plane_table(text, {false, false, false}).sites.points.cols(), 2);
    EXPECT_THAT(site_table_fault(text, {"t.csv"}, {true, false, false}), HasSubstr("'weight'"));
    EXPECT_THAT(site_table_fault(text, {"t.csv"}, {false, true, false}), HasSubstr("'phase'"));
    EXPECT_THAT(site_table_fault(text, {"t.csv"}, {false, false, true}), HasSubstr("'phi1'"));
    EXPECT_EQ(site_table_fault(text, {"t.csv", {"x", "y"}}), "");
}

TEST(SiteTable, StandardInputIsNamedInFaultsAndTypedInRemedies) {
    EXPECT_EQ(site_table_fault("x,y,weight\n1,2,kg\n", {"-"}),
              "standard input:2: column 'weight': 'kg' is not a number; write a decimal such as "
              "-1.5e3, or take only the positions, --input -:x,y");
}

TEST(SiteTable, SpaceHasTheSameQuantities) {
    const auto table = parse_site_table<3>(
        {"t.csv"}, "x,y,z,weight,phase,phi1,Phi,phi2\n1,2,3,0.5,a,1,2,3\n4,5,6,0.25,b,4,5,6\n", {});
    EXPECT_EQ(table.sites.points.col(1), Eigen::Vector3d(4, 5, 6));
    EXPECT_EQ(table.weights->weights[1], 0.25);
    EXPECT_EQ(table.phases->site_phases, (std::vector<int>{0, 1}));
    EXPECT_EQ(table.orientations[1].Phi, 5);
    EXPECT_EQ(site_table_fault<3>("x,y,z,weight\n1,2,3,4\n1,2,4,kg\n"),
              "t.csv:3: column 'weight': 'kg' is not a number; write a decimal such as -1.5e3, or "
              "take only the positions, --input t.csv:x,y,z");
    EXPECT_EQ(site_table_fault<3>("x,y,z,weight\n1,2,3,4\n", {"t.csv", {"x", "y", "z"}}), "");
}

}  // namespace
}  // namespace pcvt
