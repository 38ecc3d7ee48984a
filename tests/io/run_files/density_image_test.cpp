#include "io/run_files/density_image.hpp"

#include <gmock/gmock.h>

#include "io/forms/tile_file.hpp"
#include "mesher/plane/density/density_survey.hpp"
#include "tests/support/densities.hpp"
#include "tests/support/png_bytes.hpp"

namespace pcvt {
namespace {

using ::testing::ElementsAre;
using ::testing::FloatNear;
using ::testing::HasSubstr;
using testing::png_bytes;
using testing::png_chunk;
using testing::PngHeader;

std::vector<float> greys(const std::string& bytes) { return decode_png("t.png", bytes).grey; }

TEST(PngImage, SamplesOfEveryDepthAreDividedByTheirLargestValue) {
    EXPECT_THAT(greys(png_bytes({3, 1}, {std::string("\x00\x33\xff", 3)})),
                ElementsAre(0, FloatNear(0.2F, 1e-6F), 1));
    EXPECT_THAT(greys(png_bytes({2, 1, 16}, {std::string("\x33\x33\xff\xff", 4)})),
                ElementsAre(FloatNear(0.2F, 1e-6F), 1));
    EXPECT_THAT(greys(png_bytes({4, 1, 1}, {"\xa0"})), ElementsAre(1, 0, 1, 0));
    EXPECT_THAT(greys(png_bytes({2, 1, 4}, {"\x3f"})), ElementsAre(FloatNear(0.2F, 1e-6F), 1));
}

TEST(PngImage, ColoursBecomeTheirLuminanceAndTransparencyBecomesWhite) {
    const std::string red_green("\xff\x00\x00\x00\xff\x00", 6);
    EXPECT_THAT(greys(png_bytes({2, 1, 8, 2}, {red_green})),
                ElementsAre(FloatNear(0.2126F, 1e-6F), FloatNear(0.7152F, 1e-6F)));
    const std::string black_clear("\x00\xff\x00\x00\x00\x33", 6);
    EXPECT_THAT(greys(png_bytes({3, 1, 8, 4}, {black_clear})),
                ElementsAre(0, 1, FloatNear(0.8F, 1e-6F)));
    const std::string palette = png_chunk("PLTE", std::string("\x00\x00\x00\xff\xff\xff", 6));
    EXPECT_THAT(greys(png_bytes({2, 1, 8, 3}, {std::string("\x01\x00", 2)}, palette)),
                ElementsAre(1, 0));
    const std::string clear = palette + png_chunk("tRNS", std::string("\x00", 1));
    EXPECT_THAT(greys(png_bytes({2, 1, 8, 3}, {std::string("\x01\x00", 2)}, clear)),
                ElementsAre(1, 1));
}

TEST(PngImage, GammaAndColourProfilesAreIgnored) {
    const std::string gamma = png_chunk("gAMA", testing::big_endian(100000)) +
                              png_chunk("iCCP", "nonsense that no decoder needs to see");
    EXPECT_THAT(greys(png_bytes({1, 1}, {"\x33"}, gamma)), ElementsAre(FloatNear(0.2F, 1e-6F)));
}

std::string png_refusal(const std::string& bytes) {
    try {
        decode_png("t.png", bytes);
    } catch (const BadFile& error) {
        return error.what();
    }
    return "accepted";
}

TEST(PngImage, EveryPrefixIsRefusedAsTruncated) {
    const std::string whole = png_bytes({3, 2}, {"abc", "def"});
    EXPECT_EQ(png_refusal(whole), "accepted");
    for (std::size_t length = 8; length < whole.size(); ++length) {
        ASSERT_EQ(png_refusal(whole.substr(0, length)), "t.png: is truncated; give a whole PNG");
    }
    for (std::size_t length = 0; length < 8; ++length) {
        ASSERT_EQ(png_refusal(whole.substr(0, length)), "t.png: is not a PNG; give a whole PNG");
    }
}

TEST(PngImage, DamageIsRefusedWhereverItLies) {
    const std::string whole = png_bytes({3, 2}, {"abc", "def"});
    for (std::size_t at = 8; at < whole.size(); ++at) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x41);
        try {
            decode_png("t.png", damaged);
            // The damage turned a chunk into one that decoders skip.
            ADD_FAILURE() << "byte " << at;
        } catch (const Error&) {
        }
    }
    EXPECT_THAT(png_refusal(png_bytes({3, 3}, {"abc", "def"})), HasSubstr("is damaged"));
    EXPECT_THAT(png_refusal(png_bytes({0, 2}, {"", ""})), HasSubstr("no pixels"));
    EXPECT_THAT(png_refusal(png_bytes({3, 2, 7}, {"abc", "def"})), HasSubstr("is damaged"));
}

TEST(PngImage, APaletteMustPrecedeThePixels) {
    const std::vector<std::string> rows{std::string("\x01\x00", 2)};
    EXPECT_THAT(png_refusal(png_bytes({2, 1, 8, 3}, rows)), HasSubstr("without its palette"));
    // The missing palette is found before memory is allocated for the pixels.
    EXPECT_THAT(png_refusal(png_bytes({4096, 4096, 8, 3}, rows)), HasSubstr("without its palette"));
}

TEST(PngImage, APixelBeyondThePaletteIsRefused) {
    const std::string palette = png_chunk("PLTE", std::string("\x00\x00\x00\xff\xff\xff", 6));
    EXPECT_EQ(png_refusal(png_bytes({2, 1, 8, 3}, {std::string("\x01\x02", 2)}, palette)),
              "t.png: a pixel has the palette entry 2, but the palette ends at 2; "
              "save the image again");
    // Two bits a pixel: entries 0 1 1 1 and 0 1 3 0.
    EXPECT_THAT(greys(png_bytes({4, 1, 2, 3}, {"\x15"}, palette)), ElementsAre(0, 1, 1, 1));
    EXPECT_THAT(png_refusal(png_bytes({4, 1, 2, 3}, {"\x1c"}, palette)), HasSubstr("entry 3"));
}

TEST(PngImage, HugePicturesAreRefusedByTheirHeader) {
    for (const PngHeader& huge :
         {PngHeader{4097, 4096}, PngHeader{1U << 31, 1U << 31}, PngHeader{0xffffffff, 1},
          PngHeader{16385, 1}, PngHeader{1, 16385}}) {
        EXPECT_THROW(decode_png("t.png", png_bytes(huge, {"a"})), LimitExceeded);
    }
}

double at(const plane::Density& density, double u, double v) {
    return testing::value_at(density.make_function(), {0, 0, u, v});
}

TEST(DensityImage, PixelCentresLieAtHalfPixelsAndRowZeroIsOnTop) {
    const plane::Density density = image_density({2, 2, {0, 0.25F, 0.5F, 1}}, {1, 5});
    EXPECT_DOUBLE_EQ(at(density, 0.25, 0.75), 1);
    EXPECT_DOUBLE_EQ(at(density, 0.75, 0.75), 2);
    EXPECT_DOUBLE_EQ(at(density, 0.25, 0.25), 3);
    EXPECT_DOUBLE_EQ(at(density, 0.75, 0.25), 5);
    EXPECT_DOUBLE_EQ(at(density, 0.5, 0.5), (1 + 2 + 3 + 5) / 4.0);
    EXPECT_THAT(density.u_breaks, ElementsAre(0.25, 0.75));
}

TEST(DensityImage, IsBilinearAcrossTheSeam) {
    const plane::Density density = image_density({4, 2, {0, 1, 1, 0.5F, 0, 0, 0, 0}}, {1, 2});
    EXPECT_DOUBLE_EQ(at(density, 0, 0.75), 1.25);
    EXPECT_DOUBLE_EQ(at(density, 0x1.fffffffffffffp-1, 0.75), 1.25);
    EXPECT_DOUBLE_EQ(at(density, 0.0625, 0.75), 1.125);
    EXPECT_DOUBLE_EQ(at(density, 0.125, 0), 1);
    EXPECT_DOUBLE_EQ(at(density, 0.375, 0), 1.5);
    EXPECT_DOUBLE_EQ(at(density, 0.375, 0x1.fffffffffffffp-1), 1.5);
    const plane::Density dot = image_density({1, 1, {0.5F}}, {1, 2});
    EXPECT_DOUBLE_EQ(at(dot, 0.9, 0.1), 1.5);
}

// Single-precision differences of pixels would bend the density between their centres.
TEST(DensityImage, IsLinearBetweenTwoCentresToTheLastDigits) {
    const plane::Density density = image_density({2, 1, {0.1F, 1}}, {0.01, 1});
    for (const double share : {0.125, 0.25, 0.5, 0.875}) {
        const double left = at(density, 0.25, 0.5);
        const double right = at(density, 0.75, 0.5);
        EXPECT_NEAR(at(density, 0.25 + share / 2, 0.5), left + share * (right - left), 1e-15);
    }
}

TEST(DensityImage, IntegratesToTheMeanOfItsPixels) {
    const plane::Density density = image_density({3, 2, {0, 1, 0.25F, 0.5F, 1, 0}}, {1, 9});
    EXPECT_NEAR(integral(plane::Lattice::rectangle(2, 3), density), 6 * (1 + 8 * 2.75 / 6), 1e-12);
}

}  // namespace
}  // namespace pcvt
