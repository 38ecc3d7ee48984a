#include "io/colours/colouring.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "io/colours/site_classes.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "mesher/plane/geometry/face_polygon.hpp"
#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/mesh/valence.hpp"
#include "mesher/plane/tile/tile_valence.hpp"
#include "mesher/portable/decimal_text.hpp"
#include "mesher/portable/portable_functions.hpp"

namespace pcvt {
namespace {

/// The width of the finest classes, in octaves.
constexpr double kFinestClass = 1.0 / 16;
/// Replaces relative areas that rounding made zero or negative.
constexpr double kLeastShare = 1e-12;

static_assert(kSiteClasses == kCellColours);

const std::vector<SiteId>& owners(const plane::Tile& tile) {
    return faces_have_sites(tile.kind) ? tile.face_site : tile.vertex_site;
}

std::string rounded(double value, int digits) {
    std::array<char, 32> text;
    char* const end = write_decimal(text.data(), text.data() + text.size(), value,
                                    std::chars_format::general, digits);
    return {text.data(), end};
}

/// Returns the area of each site's cell, over all faces of the cell, or a third of the area of the
/// triangles at each site.
std::map<SiteId, double> site_areas(const plane::Tile& tile) {
    std::map<SiteId, double> areas;
    for (int f = 0; f < tile.n_faces(); ++f) {
        checkpoint_each(f);
        const double area = plane::polygon_area(plane::face_polygon(tile.points, tile.faces[f]));
        if (faces_have_sites(tile.kind)) {
            areas[tile.face_site[f]] += area;
        } else {
            for (const int v : tile.faces[f]) areas[tile.vertex_site[v]] += area / 3;
        }
    }
    return areas;
}

/// The words of a legend of values.
struct ValueWords {
    /// The beginning of the classes' names, before their number.
    std::string name;
    int digits;
    /// Follows the values.
    std::string unit;
};

/// Returns classes of one ratio for values that are given by their logarithms to the base 2.
TileColours colours_by_value(const plane::Tile& tile, const std::map<SiteId, double>& octaves,
                             const ValueWords& words) {
    double least = octaves.begin()->second;
    double most = least;
    for (const auto& [site, octave] : octaves) {
        least = std::min(least, octave);
        most = std::max(most, octave);
    }
    // The finest classes that cover the range.
    double width = kFinestClass;
    while (most - least > width * (kValueClasses - 1)) width *= 2;
    const int lowest = static_cast<int>(std::floor(least / width));
    const auto index = [&](double octave) {
        return static_cast<int>(std::floor(octave / width)) - lowest;
    };
    const int last = index(most);
    std::vector<int> count(static_cast<std::size_t>(last) + 1, 0);
    for (const auto& [site, octave] : octaves) ++count[index(octave)];
    // One class per owner, one label per class.
    TileColours colours;
    for (const SiteId site : owners(tile)) colours.class_of.push_back(index(octaves.at(site)));
    for (int k = 0; k <= last; ++k) {
        const auto bound = [&](int c) {
            return rounded(std::exp2((lowest + c) * width), words.digits);
        };
        colours.classes.push_back({.colour = value_colour(last == 0 ? 1 : double(k) / last),
                                   .name = words.name + "_" + std::to_string(k),
                                   .label = bound(k) + " to " + bound(k + 1) + words.unit + ": " +
                                            std::to_string(count[k])});
    }
    return colours;
}

/// Returns the numbers of sides of the faces, or the valences of the vertices.
std::vector<int> numbers_of_sides(const plane::Tile& tile) {
    return faces_have_sites(tile.kind) ? cell_sides(tile) : vertex_valences(tile);
}

/// Returns the numbers that the legend counts: one per whole cell, piece or site.
std::vector<int> counted_sides(const plane::Tile& tile, const std::vector<int>& sides) {
    if (faces_have_sites(tile.kind)) return sides;
    std::vector<bool> is_copy(sides.size());
    for (const plane::VertexPair& pair : tile.vertex_pairs) is_copy[pair.w] = true;
    std::vector<int> result;
    for (int v = 0; v < tile.n_vertices(); ++v) {
        checkpoint_each(v);
        if (!is_copy[v]) result.push_back(sides[v]);
    }
    return result;
}

std::string sides_label(const plane::Tile& tile, int n, int count) {
    if (!faces_have_sites(tile.kind)) {
        return "valence " + std::to_string(n) + ": " + std::to_string(count);
    }
    const std::string label = std::to_string(n) + (n == 1 ? " side" : " sides");
    // A number of pieces would mislead.
    return tile.whole_sides.empty() ? label + ": " + std::to_string(count) : label;
}

bool has_phases(const SiteQuantities& quantities) {
    return quantities.materials != nullptr && !quantities.materials->site_phase.empty();
}

bool are_there(ColouringNeed needs, const SiteQuantities& quantities) {
    switch (needs) {
        case ColouringNeed::kNothing:
            return true;
        case ColouringNeed::kDensity:
            return !quantities.densities.empty();
        case ColouringNeed::kPhases:
        case ColouringNeed::kTags:
            return has_phases(quantities);
        case ColouringNeed::kOrbits:
            return !quantities.orbits.empty();
    }
    return false;
}

}  // namespace

TileColours colours_by_sides(const plane::Tile& tile, const SiteQuantities&) {
    TileColours colours;
    const std::vector<int> sides = numbers_of_sides(tile);
    std::map<int, int> class_of;
    for (const auto& [n, count] : plane::histogram(counted_sides(tile, sides))) {
        class_of[n] = static_cast<int>(colours.classes.size());
        colours.classes.push_back({.colour = side_colour(n),
                                   .name = "sides_" + std::to_string(n),
                                   .label = sides_label(tile, n, count)});
    }
    for (const int n : sides) colours.class_of.push_back(class_of.at(n));
    return colours;
}

TileColours colours_by_size(const plane::Tile& tile, const SiteQuantities&) {
    std::map<SiteId, double> octaves = site_areas(tile);
    const double mean = tile.lattice.area() / static_cast<double>(octaves.size());
    for (auto& [site, octave] : octaves) {
        octave = portable_log2(std::max(octave / mean, kLeastShare)) / 2;
    }
    TileColours colours = colours_by_value(tile, octaves, {"size", 2, " h"});
    colours.explanation = " by size; h = sqrt(area / n)";
    return colours;
}

TileColours colours_by_cells(const plane::Tile& tile, const SiteQuantities&) {
    TileColours colours{.class_of = site_classes(tile), .classes = {}, .explanation = {}};
    for (int k = 0; k < kCellColours; ++k) {
        colours.classes.push_back({cell_colour(k), "cell_colour_" + std::to_string(k), ""});
    }
    return colours;
}

TileColours colours_by_density(const plane::Tile& tile, const SiteQuantities& quantities) {
    const std::span<const double> densities = quantities.densities;
    std::map<SiteId, double> octaves;
    for (const SiteId site : owners(tile)) {
        octaves[site] = portable_log2(densities[static_cast<std::size_t>(site) % densities.size()]);
    }
    TileColours colours = colours_by_value(tile, octaves, {"density", 3, ""});
    colours.explanation = " by density";
    return colours;
}

TileColours colours_by_phase(const plane::Tile& tile, const SiteQuantities& quantities) {
    const CellMaterials& materials = *quantities.materials;
    const std::vector<int>& phases = materials.site_phase;
    TileColours colours{.class_of = {}, .classes = {}, .explanation = " by phase"};
    for (const SiteId site : owners(tile)) {
        colours.class_of.push_back(phases[static_cast<std::size_t>(site) % phases.size()]);
    }
    // The cells of one period.
    for (int k = 0; k < static_cast<int>(materials.phase_names.size()); ++k) {
        const std::string& name = materials.phase_names[k];
        colours.classes.push_back(
            {.colour = cell_colour(k % kCellColours),
             .name = phase_group(name),
             .label = name + ": " + std::to_string(std::count(phases.begin(), phases.end(), k))});
    }
    return colours;
}

TileColours colours_by_tag(const plane::Tile& tile, const SiteQuantities& quantities) {
    TileColours colours = colours_by_phase(tile, quantities);
    colours.explanation = " by tag";
    return colours;
}

TileColours colours_by_orbit(const plane::Tile& tile, const SiteQuantities& quantities) {
    const std::span<const int> orbits = quantities.orbits;
    TileColours colours{.class_of = {}, .classes = {}, .explanation = " by orbit"};
    const int n_orbits = *std::max_element(orbits.begin(), orbits.end()) + 1;
    // With more orbits, some have the same colour.
    const bool has_legend = n_orbits <= kCellColours;
    for (int k = 0; k < n_orbits; ++k) {
        const std::string name = std::to_string(k);
        std::string label;
        if (has_legend) {
            const auto n = std::count(orbits.begin(), orbits.end(), k);
            label = "orbit " + name + ": " + std::to_string(n);
        }
        colours.classes.push_back({.colour = {}, .name = "orbit_" + name, .label = label});
    }
    const std::vector<int> colour_of = site_classes(tile, orbits);
    for (const SiteId site : owners(tile)) {
        const int orbit = orbits[static_cast<std::size_t>(site) % orbits.size()];
        colours.classes[orbit].colour = cell_colour(colour_of[colours.class_of.size()]);
        colours.class_of.push_back(orbit);
    }
    return colours;
}

TileColours tile_colours(const plane::Tile& tile, Colouring colouring,
                         const SiteQuantities& quantities) {
    const ColouringRow& row = colouring_row(colouring);
    if (!are_there(row.needs, quantities)) {
        throw InternalError(std::string("there is no ") + row.word + " to show in colours");
    }
    return row.colours(tile, quantities);
}

Colouring default_picture_colouring(const plane::Tile& tile, const SiteQuantities& quantities) {
    if (has_phases(quantities)) return Colouring::kPhase;
    if (mesh_kind_row(tile.kind).grain_size) return Colouring::kCells;
    return quantities.densities.empty() ? Colouring::kSides : Colouring::kSize;
}

}  // namespace pcvt
