#include "io/pictures/png_writer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "io/colours/colouring.hpp"
#include "io/run_files/png_image.hpp"
#include "mesher/base/error.hpp"
#include "mesher/plane/tile/build_tile.hpp"
#include "tests/support/example_lattices.hpp"
#include "tests/support/rolled_pixels.hpp"
#include "tests/support/tile_equality.hpp"
#include "tests/support/walled_tiles.hpp"

namespace pcvt {
namespace {

using testing::kOblique;
using testing::rolled;

const plane::Lattice kRectangle = plane::Lattice::rectangle(2, 1);
constexpr int kPictureWidth = 256;

plane::Tile tile(const plane::Lattice& lattice, plane::MeshKind kind, plane::Outline outline) {
    const plane::PeriodicDelaunay delaunay(plane::Sites(lattice, uniform_points(lattice, 40, 5)));
    plane::TileOptions options;
    options.kind = kind;
    options.outline = outline;
    return build_tile(delaunay, options).tile;
}

plane::Tile moved(plane::Tile tile, const plane::Vec2& by) {
    for (plane::Vec2& p : tile.points) p += by;
    for (plane::Vec2& p : tile.site_points) p += by;
    return tile;
}

int n_different(const std::vector<unsigned char>& image, const std::vector<unsigned char>& other) {
    int n = 0;
    for (std::size_t k = 0; k < image.size(); ++k) n += image[k] != other[k];
    return n;
}

TEST(PngWriter, AMovedTileGivesTheRolledImage) {
    for (const plane::Lattice& lattice : {kRectangle, kOblique}) {
        for (const plane::MeshKind kind :
             {plane::MeshKind::kVoronoi, plane::MeshKind::kDelaunay, plane::MeshKind::kGrains}) {
            const plane::Tile at_zero = tile(lattice, kind, plane::Outline::kWhole);
            const RgbImage image = draw_period(at_zero, {}, kPictureWidth);
            const int x = 37;
            const int y = 11;
            const plane::Vec2 by =
                double(x) / kPictureWidth * lattice.a() - double(y) / image.height * lattice.b();
            const RgbImage other = draw_period(moved(at_zero, by), {}, kPictureWidth);
            ASSERT_EQ(image.height, other.height);
            // Rounding moves a sample across an edge now and then.
            EXPECT_LE(n_different(other.rgb, rolled(image, x, y)), 6);
        }
    }
}

/// The number of pixels of a colour 0xrrggbb.
int n_pixels(const RgbImage& image, PackedColour colour) {
    int n = 0;
    for (std::size_t k = 0; k < image.rgb.size(); k += 3) {
        const auto* const pixel = image.rgb.data() + k;
        n += (pixel[0] << 16 | pixel[1] << 8 | pixel[2]) == static_cast<int>(colour);
    }
    return n;
}

// Dark edges separate cells whose colours form a scale; grey ones separate the few colours of
// sides.
TEST(PngWriter, EdgesAreAsDarkAsTheirColouringNeeds) {
    constexpr PackedColour kGrey = 0x565c68;
    constexpr PackedColour kDark = 0x262a33;
    const plane::Tile cells = tile(kRectangle, plane::MeshKind::kVoronoi, plane::Outline::kWhole);
    const RgbImage by_sides = draw_period(cells, {}, 4 * kPictureWidth);
    EXPECT_GT(n_pixels(by_sides, kGrey), 1000);
    EXPECT_EQ(n_pixels(by_sides, kDark), 0);
    const RgbImage by_size = draw_period(cells, {.colouring = Colouring::kSize}, 4 * kPictureWidth);
    EXPECT_GT(n_pixels(by_size, kDark), 1000);
    EXPECT_EQ(n_pixels(by_size, kGrey), 0);
}

TEST(PngWriter, TheOutlineDoesNotShow) {
    for (const plane::Lattice& lattice : {kRectangle, kOblique}) {
        const RgbImage whole = draw_period(
            tile(lattice, plane::MeshKind::kVoronoi, plane::Outline::kWhole), {}, kPictureWidth);
        const RgbImage box = draw_period(
            tile(lattice, plane::MeshKind::kVoronoi, plane::Outline::kBox), {}, kPictureWidth);
        EXPECT_LE(n_different(whole.rgb, box.rgb), 30);
    }
}

/// Returns the sum of the differences between two columns.
int step(const RgbImage& image, int column, int other) {
    int sum = 0;
    for (int row = 0; row < image.height; ++row) {
        for (int k = 0; k < 3; ++k) {
            const auto at = [&](int x) -> int {
                return image.rgb[3 * (row * image.width + x) + k];
            };
            sum += std::abs(at(column) - at(other));
        }
    }
    return sum;
}

TEST(PngWriter, TheLastColumnContinuesInTheFirst) {
    const RgbImage image = draw_period(
        tile(kRectangle, plane::MeshKind::kVoronoi, plane::Outline::kBox), {}, kPictureWidth);
    int most = 0;
    for (int x = 0; x + 1 < kPictureWidth; ++x) most = std::max(most, step(image, x, x + 1));
    EXPECT_LE(step(image, kPictureWidth - 1, 0), most);
    EXPECT_GT(step(image, 0, kPictureWidth / 2), 2 * most);
}

/// Returns the part of an image that is nearer to the end of an axis (0: right, 1: top) than to its
/// beginning.
std::vector<unsigned char> far_half(const RgbImage& image, int axis) {
    std::vector<unsigned char> part;
    for (int row = 0; row < image.height; ++row) {
        for (int x = 0; x < image.width; ++x) {
            if (axis == 0 ? 2 * x < image.width : 2 * row >= image.height) continue;
            const auto at = image.rgb.begin() + std::ptrdiff_t{3} * (row * image.width + x);
            part.insert(part.end(), at, at + 3);
        }
    }
    return part;
}

TEST(PngWriter, DotsOnAWallDoNotShowAtTheOppositeOne) {
    for (const auto& [walls, axis] : {std::pair(Walls::kX, 0), std::pair(Walls::kY, 1)}) {
        const plane::Tile cells = testing::walled_tile(walls, WallCells::kHalf, 14, {});
        plane::Tile without = cells;
        const auto on_first_wall = [axis = axis](const plane::Vec2& p) { return p[axis] == 0; };
        ASSERT_GT(std::erase_if(without.site_points, on_first_wall), 0U);
        const RgbImage image = draw_period(cells, {}, kPictureWidth);
        const RgbImage fewer = draw_period(without, {}, kPictureWidth);
        EXPECT_NE(image.rgb, fewer.rgb);
        EXPECT_EQ(far_half(image, axis), far_half(fewer, axis));
    }
}

TEST(PngWriter, ShowsUToTheRightAndVUpwards) {
    for (const plane::Lattice& lattice : testing::awkward_lattices()) {
        const plane::Tile cells = tile(lattice, plane::MeshKind::kVoronoi, plane::Outline::kWhole);
        const TileColours colours = tile_colours(cells, Colouring::kSides, {});
        const RgbImage image = draw_period(cells, {}, 600);
        for (int f = 0; f < cells.n_faces(); ++f) {
            // Between the dot at the site and a corner.
            const plane::Vec2 p =
                0.6 * cells.site_points[f] + 0.4 * cells.points[cells.faces[f][0]];
            const plane::Vec2 u = lattice.to_lattice(p);
            const int x = static_cast<int>((u.x() - std::floor(u.x())) * image.width);
            const int row = static_cast<int>((1 - (u.y() - std::floor(u.y()))) * image.height);
            const std::size_t at = 3 * (static_cast<std::size_t>(row) * image.width + x);
            const auto expected =
                std::stoul(hex(colours.classes[colours.class_of[f]].colour).substr(1), nullptr, 16);
            const unsigned long shown =
                image.rgb[at] << 16 | image.rgb[at + 1] << 8 | image.rgb[at + 2];
            EXPECT_EQ(shown, expected) << f;
        }
    }
}

TEST(PngWriter, FilesHaveTheSizeAndPixelsOfTheImage) {
    const plane::Tile cells = tile(kRectangle, plane::MeshKind::kVoronoi, plane::Outline::kWhole);
    const auto files = encode_tile_png(cells, {.pixels = 300}, "t.png");
    ASSERT_EQ(files.size(), 1U);
    const GreyImage read = decode_png("t.png", files[0].bytes);
    EXPECT_EQ(read.width, 300);
    EXPECT_EQ(read.height, 150);
    const RgbImage image = draw_period(cells, {}, 300);
    for (std::size_t k = 0; k < read.grey.size(); ++k) {
        const unsigned char* rgb = &image.rgb[3 * k];
        EXPECT_NEAR(read.grey[k], (0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]) / 255,
                    1e-5);
    }
    EXPECT_EQ(decode_png("t", encode_tile_png(cells, {}, "t")[0].bytes).width, kDefaultPixels);
}

TEST(PngWriter, RefusesImagesThatAreTooLarge) {
    EXPECT_EQ(image_height(kRectangle, 10000), 5000);
    EXPECT_THROW(image_height(kRectangle, 20000), InvalidInput);
    EXPECT_EQ(image_height(plane::Lattice::rectangle(1000, 1), 10), 1);
}

}  // namespace
}  // namespace pcvt
