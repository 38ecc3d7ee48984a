#include "io/run_files/png_image.hpp"

#include <png.h>

#include <array>
#include <csetjmp>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string_view>

#include "io/bytes/bad_file.hpp"

namespace pcvt {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
/// The bytes of a chunk's length, type and checksum, without its data.
constexpr std::size_t kChunkFrame = 12;
constexpr std::size_t kHeaderLength = 13;
/// The bytes of a decoded pixel: four samples of 16 bits.
constexpr std::size_t kPixelBytes = 8;

[[noreturn]] void throw_bad_file(const std::string& name, const std::string& what) {
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
        throw_bad_file(name, "does not begin with its header");
    }
    outline.width = big_endian(chunk.data() + 8);
    outline.height = big_endian(chunk.data() + 12);
    outline.wants_palette = chunk[17] == PNG_COLOR_TYPE_PALETTE;
    if (outline.width == 0 || outline.height == 0) throw_bad_file(name, "has no pixels");
    if (std::uint64_t{outline.width} * outline.height > kMostPixels) {
        throw LimitExceeded(name + ": " + std::to_string(outline.width) + " x " +
                            std::to_string(outline.height) + " pixels are more than " +
                            std::to_string(kMostPixels) + "; scale the image down");
    }
}

/// Checks every chunk. Keeps the critical chunks and tRNS.
Outline outline_of(const std::string& name, const std::string& bytes) {
    if (!bytes.starts_with(kSignature)) throw_bad_file(name, "is not a PNG");
    Outline outline;
    outline.bytes = kSignature;
    bool has_palette = false;
    bool has_pixels = false;
    // Walk over the chunks; the first one is the header.
    for (std::size_t at = kSignature.size();;) {
        const std::size_t left = bytes.size() - at;
        if (left < kChunkFrame) throw_bad_file(name, "is truncated");
        const std::size_t length = big_endian(bytes.data() + at);
        if (length > left - kChunkFrame) throw_bad_file(name, "is truncated");
        const std::string_view chunk = std::string_view(bytes).substr(at, length + kChunkFrame);
        const std::string_view type = chunk.substr(4, 4);
        if (outline.width == 0) read_header(name, chunk, outline);
        // The palette comes before the pixels.
        has_palette = has_palette || type == "PLTE";
        has_pixels = has_pixels || type == "IDAT";
        if (has_pixels && outline.wants_palette && !has_palette) {
            throw_bad_file(name, "is a palette picture without its palette");
        }
        // Drop chunks that decoders may ignore.
        const bool critical = (type[0] & 0x20) == 0;
        if (critical || type == "tRNS") outline.bytes += chunk;
        if (type == "IEND") break;
        at += chunk.size();
    }
    if (!has_pixels) throw_bad_file(name, "holds no pixels");
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
};

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
    png_set_expand_16(decoder.png);
    png_set_gray_to_rgb(decoder.png);
    png_set_add_alpha(decoder.png, 0xffff, PNG_FILLER_AFTER);
    png_set_interlace_handling(decoder.png);
    png_read_update_info(decoder.png, decoder.info);
    if (png_get_rowbytes(decoder.png, decoder.info) * decoder.rows.size() !=
        decoder.pixels.size()) {
        png_error(decoder.png, "pixels of an unknown form");
    }
    png_read_image(decoder.png, decoder.rows.data());
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

}  // namespace

GreyImage decode_png(const std::string& name, const std::string& bytes) {
    // Allocate the pixels, whose number is known to be within the limit.
    const Outline outline = outline_of(name, bytes);
    Decoder decoder;
    decoder.bytes = &outline.bytes;
    decoder.pixels.resize(kPixelBytes * outline.width * outline.height);
    for (std::size_t row = 0; row < outline.height; ++row) {
        decoder.rows.push_back(decoder.pixels.data() + kPixelBytes * outline.width * row);
    }
    // Decode them as RGBA with 16 bits.
    decoder.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &decoder, fail, warn);
    if (decoder.png != nullptr) decoder.info = png_create_info_struct(decoder.png);
    if (decoder.info == nullptr) throw std::bad_alloc();
    if (!decode(decoder)) {
        throw_bad_file(name, "is damaged: " + std::string(decoder.complaint.data()));
    }
    // Convert them to grey.
    GreyImage image{static_cast<int>(outline.width), static_cast<int>(outline.height), {}};
    image.grey.reserve(std::size_t{outline.width} * outline.height);
    for (std::size_t at = 0; at < decoder.pixels.size(); at += kPixelBytes) {
        image.grey.push_back(grey(decoder.pixels.data() + at));
    }
    return image;
}

}  // namespace pcvt
