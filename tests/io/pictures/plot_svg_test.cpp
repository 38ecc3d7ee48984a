#include "io/pictures/plot_svg.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <regex>

#include "io/pictures/cell_panels.hpp"
#include "io/pictures/plot_ticks.hpp"
#include "mesher/base/error.hpp"

namespace pcvt {
namespace {

using ::testing::DoubleNear;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::Pointwise;

/// Returns the numbers in the groups of each match.
std::vector<plane::Vec2> pairs(const std::string& text, const std::string& pattern) {
    const std::regex regex(pattern);
    std::vector<plane::Vec2> found;
    for (std::sregex_iterator at(text.begin(), text.end(), regex), end; at != end; ++at) {
        found.emplace_back(std::stod((*at)[1]), std::stod((*at)[2]));
    }
    return found;
}

Plot dots(bool x_logarithmic, bool y_logarithmic, std::vector<plane::Vec2> points) {
    return {"t",
            {"x", x_logarithmic},
            {"y", y_logarithmic},
            {{PlotSeries::Mark::kDots, "", kPlotBlue, std::move(points), {}}}};
}

std::vector<plane::Vec2> drawn_dots(const Plot& plot) {
    return pairs(encode_plots("t", {plot}), R"re(<circle cx="([\d.]+)" cy="([\d.]+)")re");
}

void expect_ticks(const std::vector<double>& ticks, const std::vector<double>& expected) {
    EXPECT_THAT(ticks, Pointwise(DoubleNear(1e-9), expected));
}

TEST(Plot, TicksAreRoundNumbersInsideTheAxis) {
    expect_ticks(axis_ticks(0, 10, false), {0, 2, 4, 6, 8, 10});
    expect_ticks(axis_ticks(-1, 1, false), {-1, -0.5, 0, 0.5, 1});
    expect_ticks(axis_ticks(9, 20000, true), {10, 100, 1000, 10000});
    expect_ticks(axis_ticks(4, 150, true), {5, 10, 20, 50, 100});
    expect_ticks(axis_ticks(2.5, 5.5, true), {3, 4, 5});
    for (double high = 1e-9; high < 1e9; high *= 1.7) {
        const auto ticks = axis_ticks(0, high, false);
        EXPECT_GE(ticks.size(), 4u) << high;
        EXPECT_LE(ticks.size(), 10u) << high;
        EXPECT_LE(ticks.back(), high * (1 + 1e-6));
    }
}

TEST(Plot, ValuesThatDifferByRoundingAreDrawnAsOne) {
    EXPECT_EQ(drawn_dots(dots(false, false, {{1, 1e17}, {2, 1e17 + 16}})).size(), 2U);
}

TEST(Plot, EqualStepsHaveEqualLengths) {
    const auto linear = drawn_dots(dots(false, false, {{1, 2}, {2, 4}, {3, 6}}));
    ASSERT_EQ(linear.size(), 3u);
    EXPECT_LT((linear[0] + linear[2] - 2 * linear[1]).norm(), 0.01);
    EXPECT_LT(linear[0].x(), linear[2].x());
    EXPECT_GT(linear[0].y(), linear[2].y());
    const auto power = drawn_dots(dots(true, true, {{10, 3}, {100, 30}, {1000, 300}}));
    ASSERT_EQ(power.size(), 3u);
    EXPECT_LT((power[0] + power[2] - 2 * power[1]).norm(), 0.01);
}

TEST(Plot, LabelsFactorOutPowersOfTen) {
    const std::string small = encode_plots("t", {dots(false, false, {{0, 1e-3}, {1, 2.2e-3}})});
    EXPECT_THAT(small, HasSubstr("y (× 10⁻³)"));
    EXPECT_THAT(small, HasSubstr(">1.4<"));
    const std::string decades = encode_plots("t", {dots(true, false, {{1e2, 1}, {1e5, 2}})});
    EXPECT_THAT(decades, HasSubstr(">10⁴<"));
    EXPECT_THAT(decades, Not(HasSubstr(">10000<")));
}

TEST(Plot, ASinglePointAndAConstantAreDrawn) {
    EXPECT_EQ(drawn_dots(dots(false, false, {{5, 7}})).size(), 1u);
    EXPECT_EQ(drawn_dots(dots(true, true, {{5, 7}, {6, 7}})).size(), 2u);
}

TEST(Plot, PointsThatCannotBeDrawnAreRefused) {
    EXPECT_THROW(encode_plots("t", {dots(true, false, {{0, 1}})}), InternalError);
    EXPECT_THROW(encode_plots("t", {dots(false, false, {{0, NAN}})}), InternalError);
    EXPECT_THROW(encode_plots("t", {dots(false, false, {})}), InternalError);
}

TEST(Plot, ValuesBelongToTheMarksOfThePicture) {
    Plot plot{.title = "t", .x = {"x"}, .y = {"y", true}, .series = {}};
    plot.series.push_back({PlotSeries::Mark::kLine, "a", kPlotBlue, {{0, 1}, {4, 100}, {9, 0.5}}});
    plot.series.push_back({PlotSeries::Mark::kDashes, "bound", kPlotGrey, {{0, 1}, {9, 1}}});
    const std::string json = plot_points({plot, plot});
    EXPECT_THAT(json, HasSubstr("{\"label\": \"a\", \"points\": ["));
    EXPECT_THAT(json, Not(HasSubstr("bound")));
    const std::vector<plane::Vec2> marks =
        pairs(encode_plots("t", {plot, plot}).substr(0), R"re([ML"](\d[\d.]*) (\d[\d.]*))re");
    for (const char* values : {",0,1]", ",4,100]", ",9,0.5]"}) EXPECT_THAT(json, HasSubstr(values));
    for (const plane::Vec2& pixel : pairs(json, R"re(\[(\d[\d.]*),(\d[\d.]*),)re")) {
        EXPECT_THAT(marks, ::testing::Contains(pixel));
    }
}

TEST(Plot, TextIsEscaped) {
    Plot plot = dots(false, false, {{0, 1}});
    plot.title = "a < b & c";
    EXPECT_THAT(encode_plots("t", {plot}), HasSubstr("a &lt; b &amp; c"));
}

TEST(CellPanels, EachPanelIsDrawnInItsPlaceWithYUpwards) {
    CellPanel panel;
    panel.outline = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    panel.cells = {{{{0, 0}, {1, 0}, {1, 0.25}, {0, 0.25}}, "#123456"}};
    panel.caption = {"one", "two"};
    const std::string svg = encode_cell_panels({"title", {}}, {panel, panel, panel}, {2, 100});
    const auto cells = pairs(svg, R"re(fill="#123456" d="M([\d.]+) ([\d.]+)L)re");
    const auto outlines = pairs(svg, R"re(fill="none"[^>]*d="M([\d.]+) ([\d.]+)L)re");
    ASSERT_EQ(cells.size(), 3u);
    ASSERT_EQ(outlines.size(), 3u);
    for (int k = 0; k < 3; ++k) EXPECT_EQ(cells[k], outlines[k]);
    EXPECT_GE(cells[1].x(), cells[0].x() + 100);
    EXPECT_EQ(cells[1].y(), cells[0].y());
    EXPECT_EQ(cells[2].x(), cells[0].x());
    EXPECT_GE(cells[2].y(), cells[0].y() + 100);
    // The first corner is the lower left one, the third one is the upper right one.
    const auto thirds = pairs(svg, R"re(fill="#123456" d="M[^L]*L[^L]*L([\d.]+) ([\d.]+)L)re");
    EXPECT_EQ(thirds.at(0), cells[0] + plane::Vec2(100, -25));
}

}  // namespace
}  // namespace pcvt
