#include "io/colours/palette.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "io/pictures/plot_svg.hpp"

namespace pcvt {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

/// The colours that the colour-blind see, on linear RGB: G. M. Machado, M. M. Oliveira, L. A. F.
/// Fernandes, A physiologically-based model for simulation of color vision deficiency, IEEE TVCG 15
/// (2009), severity 1.
constexpr Matrix kNormal{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr Matrix kProtanopia{{{0.152286, 1.052583, -0.204868},
                              {0.114503, 0.786281, 0.099216},
                              {-0.003882, -0.048116, 1.051998}}};
constexpr Matrix kDeuteranopia{{{0.367322, 0.860646, -0.227968},
                                {0.280085, 0.672501, 0.047413},
                                {-0.011820, 0.042940, 0.968881}}};
constexpr Matrix kTritanopia{{{1.255528, -0.076749, -0.178779},
                              {-0.078411, 0.930809, 0.147602},
                              {0.004733, 0.691367, 0.303900}}};

using Triple = std::array<double, 3>;

Triple apply(const Matrix& matrix, const Triple& v) {
    Triple result{};
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) result[i] += matrix[i][j] * v[j];
        result[i] = std::max(result[i], 0.0);
    }
    return result;
}

/// CIE L*a*b* of linear sRGB, white D65.
Triple lab(const Triple& rgb) {
    constexpr Matrix kXyz{
        {{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}};
    Triple xyz = apply(kXyz, rgb);
    xyz[0] /= 0.9505;
    xyz[2] /= 1.0890;
    for (double& t : xyz) t = t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116;
    return {116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])};
}

/// The difference of two colours, CIE 1976, as an eye sees them.
double difference(Colour colour, Colour other, const Matrix& eye) {
    const auto seen = [&](Colour c) {
        const Colour light = linear(c);
        return lab(apply(eye, {light.r, light.g, light.b}));
    };
    const Triple p = seen(colour);
    const Triple q = seen(other);
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

double difference(int sides, int other, const Matrix& eye) {
    return difference(side_colour(sides), side_colour(other), eye);
}

/// Expects that readers can distinguish all colours of a legend.
void expect_distinct(const std::vector<Colour>& legend) {
    for (const Matrix& eye : {kNormal, kProtanopia, kDeuteranopia}) {
        for (std::size_t k = 0; k < legend.size(); ++k) {
            for (std::size_t m = 0; m < k; ++m) {
                EXPECT_GE(difference(legend[k], legend[m], eye), 15)
                    << hex(legend[k]) << " and " << hex(legend[m]);
            }
        }
    }
}

std::vector<Colour> with_seams(std::vector<Colour> legend) {
    for (std::size_t k = 0; k < kSeamColours; ++k) legend.push_back(seam_colour(k));
    return legend;
}

/// The contrast of two colours, WCAG 2.1.
double contrast(Colour colour, Colour other) {
    const double one = luminance(colour) + 0.05;
    const double two = luminance(other) + 0.05;
    return std::max(one, two) / std::min(one, two);
}

TEST(Palette, EveryEyeTellsTheNumbersOfSidesApart) {
    // Twenty is plain at a glance; two is the least difference that anyone sees.
    for (const Matrix& eye : {kNormal, kProtanopia, kDeuteranopia, kTritanopia}) {
        for (int sides = 3; sides <= 9; ++sides) {
            for (int other = 3; other < sides; ++other) {
                EXPECT_GT(difference(sides, other, eye), 20) << sides << " and " << other;
            }
        }
    }
}

TEST(Palette, EveryLegendIsDistinctToColourBlindEyes) {
    std::vector<Colour> sides;
    for (int n = 3; n <= 9; ++n) sides.push_back(side_colour(n));
    expect_distinct(with_seams(sides));
    std::vector<Colour> cells;
    for (int k = 0; k < kCellColours; ++k) cells.push_back(cell_colour(k));
    expect_distinct(with_seams(cells));
    for (int classes = 1; classes <= kValueClasses; ++classes) {
        std::vector<Colour> values;
        for (int k = 0; k < classes; ++k) {
            values.push_back(value_colour(classes == 1 ? 1 : double(k) / (classes - 1)));
        }
        expect_distinct(with_seams(values));
    }
    sides.push_back(*colour_of_hex(kCutHexagon));
    sides.push_back(*colour_of_hex(kBorderCell));
    expect_distinct(sides);
}

TEST(Palette, SeriesOfPlotsAreDistinctAndLegible) {
    std::vector<Colour> series;
    for (const char* colour : {kPlotBlue, kPlotOrange, kPlotGreen, kPlotGrey}) {
        series.push_back(*colour_of_hex(colour));
        EXPECT_GE(contrast(series.back(), {1, 1, 1}), 3);
        EXPECT_GE(contrast(series.back(), *colour_of_hex("#1a1d24")), 3);
    }
    expect_distinct(series);
}

TEST(Palette, SeamsAreLegibleOnLightAndDarkPages) {
    for (std::size_t k = 0; k < kSeamColours; ++k) {
        EXPECT_GE(contrast(seam_colour(k), {1, 1, 1}), 2.8);
        EXPECT_GE(contrast(seam_colour(k), *colour_of_hex("#0d1117")), 2.8);
    }
}

TEST(Palette, HexIsReadBack) {
    EXPECT_EQ(hex(*colour_of_hex("#0d93e2")), "#0d93e2");
    for (const char* text :
         {"", "#", "#12345", "#1234567", "123456", "#12345g", "#-12345", "white"}) {
        EXPECT_FALSE(colour_of_hex(text)) << text;
    }
}

TEST(Palette, HexagonsAreTheCalmestAndLightest) {
    const auto lightness = [](int sides) {
        const Colour light = linear(side_colour(sides));
        return lab({light.r, light.g, light.b});
    };
    for (const int sides : {3, 4, 5, 7, 8, 9}) EXPECT_LT(lightness(sides)[0], lightness(6)[0] - 15);
    EXPECT_LT(std::hypot(lightness(6)[1], lightness(6)[2]), 10);
}

TEST(Palette, RareNumbersShareTheOuterColours) {
    EXPECT_EQ(hex(side_colour(1)), hex(side_colour(3)));
    EXPECT_EQ(hex(side_colour(40)), hex(side_colour(9)));
}

TEST(Palette, HexSpellsBytes) {
    EXPECT_EQ(hex({0, 1, 128.0 / 255}), "#00ff80");
    EXPECT_EQ(hex({-1, 2, 0.5 / 255}), "#00ff01");
}

TEST(Palette, SizesAreLighterTheLargerTheyAre) {
    double before = -1;
    for (int k = 0; k <= 20; ++k) {
        const Colour c = linear(value_colour(k / 20.0));
        const double luminance = 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
        EXPECT_GT(luminance, before);
        before = luminance;
    }
    EXPECT_EQ(hex(value_colour(-1)), hex(value_colour(0)));
    EXPECT_EQ(hex(value_colour(2)), hex(value_colour(1)));
}

}  // namespace
}  // namespace pcvt
