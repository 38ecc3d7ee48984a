#include "io/pictures/cell_colours.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>

#include "io/tiles/palette.hpp"
#include "mesher/lattice/polygon.hpp"
#include "mesher/mesh/valence.hpp"
#include "mesher/tile/tile_valence.hpp"

namespace pcvt {
namespace {

constexpr int kMostClasses = 9;
/// The width of the finest classes, in octaves.
constexpr double kFinestClass = 1.0 / 16;
/// Replaces relative areas that rounding made zero or negative.
constexpr double kLeastShare = 1e-12;

std::string two_digits(double value) {
    std::array<char, 32> text;
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 2);
    return {text.data(), end.ptr};
}

double face_area(const Tile& tile, int face) {
    Polygon polygon;
    for (const int v : tile.faces[face]) {
        polygon.push_back(tile.points[v]);
    }
    return polygon_area(polygon);
}

/// Returns log2(sqrt(area) / h) of each site's cell, over all faces of the cell.
std::map<SiteId, double> size_octaves(const Tile& tile) {
    std::map<SiteId, double> octaves;
    for (int f = 0; f < tile.n_faces(); ++f) octaves[tile.face_site[f]] += face_area(tile, f);
    const double mean = tile.lattice.area() / static_cast<double>(octaves.size());
    for (auto& [site, octave] : octaves) {
        octave = std::log2(std::max(octave / mean, kLeastShare)) / 2;
    }
    return octaves;
}

}  // namespace

CellColours colours_by_sides(const Tile& tile) {
    CellColours colours;
    const std::vector<int> sides = cell_sides(tile);
    const std::map<int, int> counts = histogram(sides);
    std::map<int, std::string> colour_of;
    for (const auto& [n, count] : counts) colour_of[n] = hex(side_colour(n));
    colours.of_face.reserve(sides.size());
    for (const int n : sides) colours.of_face.push_back(colour_of[n]);
    for (const auto& [n, count] : counts) {
        std::string label = std::to_string(n) + (n == 1 ? " side" : " sides");
        // A number of pieces would mislead.
        if (tile.whole_sides.empty()) label += ": " + std::to_string(count);
        colours.meaning.push_back({LegendEntry::Mark::kPatch, colour_of[n], label});
    }
    return colours;
}

CellColours colours_by_size(const Tile& tile) {
    // The range of the sizes.
    const std::map<SiteId, double> octaves = size_octaves(tile);
    double least = octaves.begin()->second;
    double most = least;
    for (const auto& [site, octave] : octaves) {
        least = std::min(least, octave);
        most = std::max(most, octave);
    }
    // The finest classes that cover it.
    double width = kFinestClass;
    while (most - least > width * (kMostClasses - 1)) width *= 2;
    const int lowest = static_cast<int>(std::floor(least / width));
    const int last = static_cast<int>(std::floor(most / width)) - lowest;
    const auto index = [&](double octave) {
        return static_cast<int>(std::floor(octave / width)) - lowest;
    };
    const auto colour = [&](int k) { return hex(size_colour(last == 0 ? 1 : double(k) / last)); };
    std::vector<int> count(static_cast<std::size_t>(last) + 1, 0);
    for (const auto& [site, octave] : octaves) ++count[index(octave)];
    // One colour per face, one legend entry per class.
    CellColours colours;
    for (const SiteId site : tile.face_site) {
        colours.of_face.push_back(colour(index(octaves.at(site))));
    }
    for (int k = 0; k <= last; ++k) {
        const std::string label = two_digits(std::exp2((lowest + k) * width)) + " to " +
                                  two_digits(std::exp2((lowest + k + 1) * width)) +
                                  " h: " + std::to_string(count[k]);
        colours.meaning.push_back({LegendEntry::Mark::kPatch, colour(k), label});
    }
    return colours;
}

}  // namespace pcvt
