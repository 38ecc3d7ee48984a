#include "io/pictures/periodic_canvas.hpp"

#include <gmock/gmock.h>

#include <array>
#include <random>

#include "tests/support/rolled_pixels.hpp"

namespace pcvt {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using testing::rolled;

constexpr int kCanvasWidth = 24;
constexpr int kHeight = 16;

/// Random shapes, all moved by the same number of pixels. Their corners are multiples of 1/64.
RgbImage scene(int x, int y, Walls walls = Walls::kNone) {
    std::mt19937_64 random(3);
    const auto place = [&]() -> plane::Vec2 {
        return {static_cast<double>(random() % (64 * kCanvasWidth)) / 64 + x,
                static_cast<double>(random() % (64 * kHeight)) / 64 + y};
    };
    PeriodicCanvas canvas(kCanvasWidth, kHeight, walls);
    for (int k = 0; k < 20; ++k) {
        const auto colour = static_cast<PackedColour>(random() % 0x1000000);
        canvas.add_polygon(std::array{place(), place(), place()}, colour);
        canvas.add_stroke(place(), place(), 1.5, ~colour & 0xffffff);
        const plane::Vec2 centre = place();
        canvas.add_stroke(centre, centre, 3, colour);
    }
    return canvas.render();
}

// Law 1.
TEST(PeriodicCanvas, MovedShapesGiveTheRolledImage) {
    const RgbImage image = scene(0, 0);
    for (const auto& [x, y] : {std::pair(1, 0), std::pair(0, 1), std::pair(7, 13)}) {
        EXPECT_EQ(scene(x, y).rgb, rolled(image, x, y));
    }
}

// Law 2.
TEST(PeriodicCanvas, ShapesMovedByPeriodsGiveTheSameImage) {
    EXPECT_EQ(scene(-3 * kCanvasWidth, 5 * kHeight).rgb, scene(0, 0).rgb);
}

/// A disc of radius 4 at the centre of each side of the canvas, in its own colour, and its copies
/// beyond the opposite sides, which only a canvas without walls shows.
RgbImage discs_on_sides(Walls walls) {
    PeriodicCanvas canvas(kCanvasWidth, kHeight, walls);
    canvas.add_polygon(std::array{plane::Vec2(0, 0), plane::Vec2(kCanvasWidth, 0),
                                  plane::Vec2(kCanvasWidth, kHeight), plane::Vec2(0, kHeight)},
                       0xffffff);
    const std::array discs{std::pair(plane::Vec2(0, kHeight / 2.0), 0xff0000),
                           std::pair(plane::Vec2(kCanvasWidth, kHeight / 2.0), 0x0000ff),
                           std::pair(plane::Vec2(kCanvasWidth / 2.0, 0), 0xffff00),
                           std::pair(plane::Vec2(kCanvasWidth / 2.0, kHeight), 0x00ffff)};
    for (const auto& [at, colour] : discs) {
        canvas.add_stroke(at, at, 8, static_cast<PackedColour>(colour));
    }
    return canvas.render();
}

PackedColour colour_at(const RgbImage& image, int x, int y) {
    const unsigned char* rgb = &image.rgb[std::size_t{3} * (y * image.width + x)];
    return static_cast<PackedColour>(rgb[0] << 16 | rgb[1] << 8 | rgb[2]);
}

// Law 3.
TEST(PeriodicCanvas, NothingContinuesBeyondAWall) {
    for (const WallsRow& row : kWalls) {
        const RgbImage image = discs_on_sides(row.walls);
        const auto shown = [&](int x, int y) { return colour_at(image, x, y); };
        // The later disc covers the other one where the sides continue in each other.
        EXPECT_EQ(shown(0, kHeight / 2), row.across[0] ? 0xff0000U : 0x0000ffU) << row.word;
        EXPECT_EQ(shown(kCanvasWidth - 1, kHeight / 2), 0x0000ffU) << row.word;
        EXPECT_EQ(shown(kCanvasWidth / 2, 0), row.across[1] ? 0xffff00U : 0x00ffffU) << row.word;
        EXPECT_EQ(shown(kCanvasWidth / 2, kHeight - 1), 0x00ffffU) << row.word;
    }
}

// Laws 1 and 2 along the walls.
TEST(PeriodicCanvas, ShapesMayMoveAlongWalls) {
    const RgbImage across_x = scene(0, 0, Walls::kX);
    EXPECT_EQ(scene(0, 5, Walls::kX).rgb, rolled(across_x, 0, 5));
    EXPECT_EQ(scene(0, kHeight, Walls::kX).rgb, across_x.rgb);
    const RgbImage across_y = scene(0, 0, Walls::kY);
    EXPECT_EQ(scene(7, 0, Walls::kY).rgb, rolled(across_y, 7, 0));
    EXPECT_EQ(scene(kCanvasWidth, 0, Walls::kY).rgb, across_y.rgb);
}

TEST(PeriodicCanvas, APixelIsTheMeanOfWhatCoversIt) {
    PeriodicCanvas canvas(2, 1, Walls::kNone);
    canvas.add_polygon(
        std::array{plane::Vec2(0, 0), plane::Vec2(2, 0), plane::Vec2(2, 1), plane::Vec2(0, 1)},
        0x000000);
    canvas.add_polygon(std::array{plane::Vec2(1.75, 0), plane::Vec2(2.5, 0), plane::Vec2(2.5, 1),
                                  plane::Vec2(1.75, 1)},
                       0x0000ff);
    EXPECT_THAT(canvas.render().rgb, ElementsAre(0, 0, 128, 0, 0, 64));
}

TEST(PeriodicCanvas, StrokesHaveRoundEnds) {
    PeriodicCanvas canvas(64, 64, Walls::kNone);
    canvas.add_polygon(
        std::array{plane::Vec2(0, 0), plane::Vec2(64, 0), plane::Vec2(64, 64), plane::Vec2(0, 64)},
        0x000000);
    canvas.add_stroke({20, 32}, {44, 32}, 16, 0xffffff);
    const RgbImage image = canvas.render();
    double area = 0;
    for (std::size_t k = 0; k < image.rgb.size(); k += 3) area += image.rgb[k] / 255.0;
    EXPECT_NEAR(area, 24 * 16 + 3.14159 * 64, 1);
}

TEST(PeriodicCanvas, AShapeWiderThanTheCanvasCoversIt) {
    PeriodicCanvas canvas(5, 4, Walls::kNone);
    canvas.add_stroke({1, 1}, {1, 1}, 40, 0x010101);
    EXPECT_THAT(canvas.render().rgb, Each(1));
    EXPECT_THAT(PeriodicCanvas(5, 4, Walls::kNone).render().rgb, Each(255));
}

TEST(PeriodicCanvas, GapsTakeTheColourToTheirLeft) {
    PeriodicCanvas canvas(4, 1, Walls::kNone);
    canvas.add_polygon(
        std::array{plane::Vec2(1, 0), plane::Vec2(2, 0), plane::Vec2(2, 1), plane::Vec2(1, 1)},
        0x010101);
    EXPECT_THAT(canvas.render().rgb, Each(1));
}

}  // namespace
}  // namespace pcvt
