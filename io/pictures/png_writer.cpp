#include "io/pictures/png_writer.hpp"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <new>
#include <set>

#include "io/colours/colouring.hpp"
#include "io/forms/finite.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "mesher/plane/tile/tile_edges.hpp"

namespace pcvt {
namespace {

// The colours and widths of svg_writer.cpp; widths are shares of h, with limits in pixels of a
// picture of 800 x 800.
constexpr PackedColour kPackedEdge = 0x565c68;
constexpr PackedColour kPackedGradedEdge = 0x262a33;
constexpr PackedColour kPackedTriangleEdge = 0x8b919c;
constexpr PackedColour kPackedHole = 0xffffff;
constexpr PackedColour kPackedDot = 0x30343c;
constexpr double kPictureSide = 800;
constexpr double kLeastDottedPixels = 9;
constexpr int kRegular = 6;

/// Returns the colours of the faces, or of the sites of Delaunay triangles.
std::vector<Colour> colour_list(const TileColours& colours) {
    std::vector<Colour> list;
    for (const int k : colours.class_of) list.push_back(colours.classes[k].colour);
    return list;
}

/// Returns the number of sites of a tile, also of one in pieces.
int count_sites(const plane::Tile& tile) {
    if (!faces_have_sites(tile.kind)) {
        return tile.n_vertices() - static_cast<int>(tile.vertex_pairs.size());
    }
    return static_cast<int>(std::set<SiteId>(tile.face_site.begin(), tile.face_site.end()).size());
}

bool is_edge(const plane::Tile&, const plane::TileEdge&) { return true; }

bool is_grain_boundary(const plane::Tile& tile, const plane::TileEdge& edge) {
    return edge.right < 0 || tile.face_site[edge.left] != tile.face_site[edge.right];
}

/// A box outline cuts cells along edges that are none of theirs.
bool is_cell_edge(const plane::Tile& tile, const plane::TileEdge& edge) {
    return tile.whole_sides.empty() || !edge.on_seam || is_grain_boundary(tile, edge);
}

/// Draws a tile on a canvas of one period.
class PeriodPainter {
   public:
    PeriodPainter(const plane::Tile& tile, int width, int height)
        : tile_(tile), size_(width, height), canvas_(width, height, tile.walls) {
        const double side = std::sqrt(size_.x() * size_.y());
        scale_ = side / kPictureSide;
        spacing_ = kPictureSide / std::sqrt(count_sites(tile));
        std::vector<plane::Vec2> coordinates;
        for (const plane::Vec2& p : tile.points) coordinates.push_back(tile.lattice.to_lattice(p));
        // A vertex of the seam is its representative plus whole periods.
        for (const plane::VertexPair& pair : tile.vertex_pairs) {
            coordinates[pair.w] = coordinates[pair.v] + plane::Vec2(pair.offset.i, pair.offset.j);
        }
        for (const plane::Vec2& u : coordinates) places_.push_back(pixel(u));
    }

    void draw_faces(const std::vector<Colour>& colour_of) {
        std::vector<plane::Vec2> corners{pixel({0, 0}), pixel({1, 0}), pixel({1, 1}),
                                         pixel({0, 1})};
        if (!tile_.holes.empty()) canvas_.add_polygon(corners, kPackedHole);
        for (int f = 0; f < tile_.n_faces(); ++f) {
            checkpoint_each(f);
            corners.clear();
            for (const int v : tile_.faces[f]) corners.push_back(places_[v]);
            canvas_.add_polygon(corners, packed(colour_of[f]));
        }
    }

    void draw_edges(bool (*is_drawn)(const plane::Tile&, const plane::TileEdge&),
                    PackedColour colour, double width) {
        for (const plane::TileEdge& edge : tile_edges(tile_)) {
            if (!is_drawn(tile_, edge)) continue;
            canvas_.add_stroke(places_[edge.v], places_[edge.w], scale_ * width, colour);
        }
    }

    void draw_dots() {
        if (spacing_ < kLeastDottedPixels) return;
        for (const plane::Vec2& site : tile_.site_points) {
            const plane::Vec2 place = pixel(tile_.lattice.to_lattice(site));
            canvas_.add_stroke(place, place, scale_ * width(0.09, 0.6, 6), kPackedDot);
        }
    }

    void draw_sites(const TileColours& colours) {
        const bool dense = spacing_ < kLeastDottedPixels;
        const double size = dense ? 0.7 * spacing_ : width(0.36, 3, 16);
        for (int v = 0; v < tile_.n_vertices(); ++v) {
            checkpoint_each(v);
            const ColourClass& mark = colours.classes[colours.class_of[v]];
            const bool regular = mark.name == kRegularClass;
            const double rim = regular ? width(0.09, 0.6, 6) : size + width(0.06, 0.3, 2);
            if (!dense) canvas_.add_stroke(places_[v], places_[v], scale_ * rim, kPackedDot);
            if (regular) continue;
            canvas_.add_stroke(places_[v], places_[v], scale_ * size, packed(mark.colour));
        }
    }

    double width(double fraction, double least, double most) const {
        return std::clamp(fraction * spacing_, least, most);
    }
    RgbImage render() const { return canvas_.render(); }

   private:
    plane::Vec2 pixel(const plane::Vec2& u) const {
        return {u.x() * size_.x(), (1 - u.y()) * size_.y()};
    }

    const plane::Tile& tile_;
    plane::Vec2 size_;
    PeriodicCanvas canvas_;
    double scale_;
    /// The spacing h of the sites in a picture of 800 x 800.
    double spacing_;
    std::vector<plane::Vec2> places_;
};

/// The objects that outlive libpng's longjmp().
struct Encoder {
    Encoder() = default;
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;
    ~Encoder() { png_destroy_write_struct(&png, &info); }

    png_structp png = nullptr;
    png_infop info = nullptr;
    std::vector<png_const_bytep> rows;
    std::string bytes;
    bool is_full = false;
};

[[noreturn]] void fail(png_structp png, png_const_charp) { png_longjmp(png, 1); }

void warn(png_structp, png_const_charp) {}

void append(png_structp png, png_bytep data, png_size_t n) {
    auto* encoder = static_cast<Encoder*>(png_get_io_ptr(png));
    try {
        encoder->bytes.append(reinterpret_cast<const char*>(data), n);
    } catch (const std::bad_alloc&) {
        encoder->is_full = true;
    }
    if (encoder->is_full) png_error(png, "out of memory");
}

void flush(png_structp) {}

/// Makes the calls that may jump back. It must not have local objects with destructors.
bool encode(Encoder& encoder, png_uint_32 width, png_uint_32 height) {
    if (setjmp(png_jmpbuf(encoder.png)) != 0) return false;
    png_set_user_limits(encoder.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_write_fn(encoder.png, &encoder, append, flush);
    png_set_IHDR(encoder.png, encoder.info, width, height, 8, PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(encoder.png, encoder.info);
    for (png_uint_32 row = 0; row < height; ++row) {
        checkpoint();
        png_write_row(encoder.png, encoder.rows[row]);
    }
    png_write_end(encoder.png, encoder.info);
    return true;
}

}  // namespace

int image_height(const plane::Lattice& lattice, int width) {
    const double height =
        std::max(1.0, std::round(width * lattice.b().norm() / lattice.a().norm()));
    if (width * height <= kMostImagePixels) return static_cast<int>(height);
    const double most = std::sqrt(kMostImagePixels * lattice.a().norm() / lattice.b().norm());
    throw InvalidInput("an image of " + std::to_string(width) + " x " +
                       std::to_string(static_cast<std::int64_t>(height)) +
                       " pixels is too large; take at most " +
                       std::to_string(std::max(1, static_cast<int>(most))) + " pixels");
}

RgbImage draw_period(const plane::Tile& tile, const FileOptions& options, int width) {
    require_finite(tile);
    const plane::MeshKindRow& kind = mesh_kind_row(tile.kind);
    const Colouring colouring =
        options.colouring.value_or(default_picture_colouring(tile, options.quantities()));
    const TileColours colours = tile_colours(tile, colouring, options.quantities());
    const bool graded = colouring_row(colouring).shows_values;
    PeriodPainter painter(tile, width, image_height(tile.lattice, width));
    if (!kind.faces_have_sites) {
        const std::size_t n_faces = tile.faces.begin.size() - 1;
        painter.draw_faces(std::vector<Colour>(n_faces, side_colour(kRegular)));
        painter.draw_edges(is_edge, kPackedTriangleEdge, painter.width(0.03, 0.05, 1.6));
        painter.draw_sites(colours);
        return painter.render();
    }
    painter.draw_faces(colour_list(colours));
    if (kind.grain_size) {
        painter.draw_edges(is_edge, kPackedTriangleEdge, painter.width(0.01, 0.03, 0.8));
        painter.draw_edges(is_grain_boundary, kPackedEdge, painter.width(0.04, 0.08, 2));
        return painter.render();
    }
    painter.draw_edges(is_cell_edge, graded ? kPackedGradedEdge : kPackedEdge,
                       painter.width(0.03, 0.06, 1.6));
    if (!graded) painter.draw_dots();
    return painter.render();
}

std::string encode_png(const RgbImage& image) {
    Encoder encoder;
    for (int row = 0; row < image.height; ++row) {
        checkpoint();
        encoder.rows.push_back(image.rgb.data() + std::size_t{3} * image.width * row);
    }
    encoder.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, warn);
    if (encoder.png != nullptr) encoder.info = png_create_info_struct(encoder.png);
    if (encoder.info == nullptr) throw std::bad_alloc();
    if (!encode(encoder, static_cast<png_uint_32>(image.width),
                static_cast<png_uint_32>(image.height))) {
        throw std::bad_alloc();
    }
    return std::move(encoder.bytes);
}

std::vector<EncodedFile> encode_tile_png(const plane::Tile& tile, const FileOptions& options,
                                         const std::string& path) {
    const int width = options.pixels == 0 ? kDefaultPixels : options.pixels;
    return only_file(path, encode_png(draw_period(tile, options, width)));
}

}  // namespace pcvt
