#include "io/run_files/png_image.hpp"

#include <png.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <string_view>

#include "io/bytes/bad_file.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
/// The bytes of a chunk's length, type and checksum, without its data.
constexpr std::size_t kChunkFrame = 12;
constexpr std::size_t kHeaderLength = 13;
/// The bytes of a decoded pixel: four samples of 16 bits, or the index of a palette entry.
constexpr std::size_t kPixelBytes = 8;
constexpr std::size_t kIndexBytes = 1;

[[noreturn]] void throw_bad_png(const std::string& name, const std::string& what) {
    throw BadFile(name + ": " + what + "; give a whole PNG");
}

std::uint32_t big_endian(const char* bytes) {
    std::uint32_t value = 0;
    for (int k = 0; k < 4; ++k) value = value << 8 | static_cast<unsigned char>(bytes[k]);
    return value;
}

/// The properties of an image that its chunks show before any pixel is decoded.
struct Outline {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    bool wants_palette = false;
    /// The file without the chunks that do not affect the pixels.
    std::string bytes;
};

void read_header(const std::string& name, std::string_view chunk, Outline& outline) {
    if (chunk.substr(4, 4) != "IHDR" || big_endian(chunk.data()) != kHeaderLength) {
        throw_bad_png(name, "does not begin with its header");
    }
    outline.width = big_endian(chunk.data() + 8);
    outline.height = big_endian(chunk.data() + 12);
    outline.wants_palette = chunk[17] == PNG_COLOR_TYPE_PALETTE;
    if (outline.width == 0 || outline.height == 0) throw_bad_png(name, "has no pixels");
    const std::string size = name + ": " + std::to_string(outline.width) + " x " +
                             std::to_string(outline.height) + " pixels are more than ";
    if (std::uint64_t{outline.width} * outline.height > kMostPixels) {
        throw LimitExceeded(size + std::to_string(kMostPixels) + "; scale the image down");
    }
    if (std::max(outline.width, outline.height) > kLongestSide) {
        throw LimitExceeded(size + std::to_string(kLongestSide) +
                            " along a side; scale the image down");
    }
}

/// Checks every chunk. Keeps the critical chunks and tRNS.
Outline outline_of(const std::string& name, const std::string& bytes) {
    if (!bytes.starts_with(kSignature)) throw_bad_png(name, "is not a PNG");
    Outline outline;
    outline.bytes = kSignature;
    bool has_palette = false;
    bool has_pixels = false;
    // Walk over the chunks; the first one is the header.
    for (std::size_t at = kSignature.size();;) {
        const std::size_t left = bytes.size() - at;
        if (left < kChunkFrame) throw_bad_png(name, "is truncated");
        const std::size_t length = big_endian(bytes.data() + at);
        if (length > left - kChunkFrame) throw_bad_png(name, "is truncated");
        const std::string_view chunk = std::string_view(bytes).substr(at, length + kChunkFrame);
        const std::string_view type = chunk.substr(4, 4);
        if (outline.width == 0) read_header(name, chunk, outline);
        // The palette comes before the pixels.
        has_palette = has_palette || type == "PLTE";
        has_pixels = has_pixels || type == "IDAT";
        if (has_pixels && outline.wants_palette && !has_palette) {
            throw_bad_png(name, "is a palette picture without its palette");
        }
        // Drop chunks that decoders may ignore.
        const bool critical = (type[0] & 0x20) == 0;
        if (critical || type == "tRNS") outline.bytes += chunk;
        if (type == "IEND") break;
        at += chunk.size();
    }
    if (!has_pixels) throw_bad_png(name, "holds no pixels");
    return outline;
}

/// The objects that outlive libpng's longjmp().
struct Decoder {
    Decoder() = default;
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;
    ~Decoder() { png_destroy_read_struct(&png, &info, nullptr); }

    png_structp png = nullptr;
    png_infop info = nullptr;
    const std::string* bytes = nullptr;
    std::size_t at = 0;
    std::vector<png_byte> pixels;
    std::vector<png_bytep> rows;
    std::array<char, 100> complaint{};
    bool is_out_of_memory = false;
};

/// Allocates for libpng, which calls a lack of memory an error of the file.
png_voidp allocate(png_structp png, png_alloc_size_t size) {
    void* block = std::malloc(size);
    if (block == nullptr) static_cast<Decoder*>(png_get_mem_ptr(png))->is_out_of_memory = true;
    return block;
}

void release(png_structp, png_voidp block) { std::free(block); }

[[noreturn]] void fail(png_structp png, png_const_charp message) {
    auto* decoder = static_cast<Decoder*>(png_get_error_ptr(png));
    std::strncpy(decoder->complaint.data(), message, decoder->complaint.size() - 1);
    png_longjmp(png, 1);
}

void warn(png_structp, png_const_charp) {}

void read(png_structp png, png_bytep to, png_size_t n) {
    auto* decoder = static_cast<Decoder*>(png_get_io_ptr(png));
    if (n > decoder->bytes->size() - decoder->at) png_error(png, "truncated");
    std::memcpy(to, decoder->bytes->data() + decoder->at, n);
    decoder->at += n;
}

/// Makes the calls that may jump back. It must not have local objects with destructors.
bool decode(Decoder& decoder) {
    if (setjmp(png_jmpbuf(decoder.png)) != 0) return false;
    png_set_read_fn(decoder.png, &decoder, read);
    png_read_info(decoder.png, decoder.info);
    if (png_get_color_type(decoder.png, decoder.info) == PNG_COLOR_TYPE_PALETTE) {
        // libpng would replace an index beyond the palette by black.
        png_set_packing(decoder.png);
    } else {
        png_set_expand_16(decoder.png);
        png_set_gray_to_rgb(decoder.png);
        png_set_add_alpha(decoder.png, 0xffff, PNG_FILLER_AFTER);
    }
    const int n_passes = png_set_interlace_handling(decoder.png);
    png_read_update_info(decoder.png, decoder.info);
    if (png_get_rowbytes(decoder.png, decoder.info) * decoder.rows.size() !=
        decoder.pixels.size()) {
        png_error(decoder.png, "pixels of an unknown form");
    }
    for (int pass = 0; pass < n_passes; ++pass) {
        for (png_bytep row : decoder.rows) {
            checkpoint();
            png_read_row(decoder.png, row, nullptr);
        }
    }
    png_read_end(decoder.png, nullptr);
    return true;
}

double sample(const png_byte* bytes) { return (bytes[0] * 256 + bytes[1]) / 65535.0; }

float grey(const png_byte* pixel) {
    const double shown =
        0.2126 * sample(pixel) + 0.7152 * sample(pixel + 2) + 0.0722 * sample(pixel + 4);
    const double opacity = sample(pixel + 6);
    return static_cast<float>(shown * opacity + (1 - opacity));
}

/// Returns the grey of each entry of the palette.
std::vector<float> palette_greys(const Decoder& decoder) {
    png_colorp colours = nullptr;
    int n_colours = 0;
    png_get_PLTE(decoder.png, decoder.info, &colours, &n_colours);
    png_bytep opacities = nullptr;
    int n_opacities = 0;
    png_get_tRNS(decoder.png, decoder.info, &opacities, &n_opacities, nullptr);
    std::vector<float> greys;
    for (int k = 0; k < n_colours; ++k) {
        const auto [red, green, blue] = colours[k];
        const png_byte opacity = k < n_opacities ? opacities[k] : png_byte{0xff};
        const std::array<png_byte, kPixelBytes> pixel{red,  red,  green,   green,
                                                      blue, blue, opacity, opacity};
        greys.push_back(grey(pixel.data()));
    }
    return greys;
}

void append_palette_greys(const std::string& name, const Decoder& decoder, GreyImage& image) {
    const std::vector<float> greys = palette_greys(decoder);
    for (const png_byte index : decoder.pixels) {
        if (index >= greys.size()) {
            throw BadFile(name + ": a pixel has the palette entry " + std::to_string(index) +
                          ", but the palette ends at " + std::to_string(greys.size()) +
                          "; save the image again");
        }
        image.grey.push_back(greys[index]);
    }
}

}  // namespace

GreyImage decode_png(const std::string& name, const std::string& bytes) {
    // Allocate the pixels, whose number is known to be within the limit.
    const Outline outline = outline_of(name, bytes);
    Decoder decoder;
    decoder.bytes = &outline.bytes;
    const std::size_t pixel_bytes = outline.wants_palette ? kIndexBytes : kPixelBytes;
    decoder.pixels.resize(pixel_bytes * outline.width * outline.height);
    for (std::size_t row = 0; row < outline.height; ++row) {
        decoder.rows.push_back(decoder.pixels.data() + pixel_bytes * outline.width * row);
    }
    // Decode them as RGBA with 16 bits, or as indices.
    decoder.png = png_create_read_struct_2(PNG_LIBPNG_VER_STRING, &decoder, fail, warn, &decoder,
                                           allocate, release);
    if (decoder.png != nullptr) decoder.info = png_create_info_struct(decoder.png);
    if (decoder.info == nullptr) throw std::bad_alloc();
    if (!decode(decoder)) {
        if (decoder.is_out_of_memory) throw std::bad_alloc();
        throw_bad_png(name, "is damaged: " + std::string(decoder.complaint.data()));
    }
    // Convert them to grey.
    GreyImage image{static_cast<int>(outline.width), static_cast<int>(outline.height), {}};
    image.grey.reserve(std::size_t{outline.width} * outline.height);
    if (outline.wants_palette) {
        append_palette_greys(name, decoder, image);
        return image;
    }
    for (std::size_t at = 0; at < decoder.pixels.size(); at += kPixelBytes) {
        checkpoint_each(long(at), 1 << 16);
        image.grey.push_back(grey(decoder.pixels.data() + at));
    }
    return image;
}

}  // namespace pcvt
