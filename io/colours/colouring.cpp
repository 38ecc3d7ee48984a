#include "io/colours/colouring.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "io/colours/cell_colours.hpp"
#include "io/colours/site_classes.hpp"
#include "io/colours/value_classes.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "mesher/plane/geometry/face_polygon.hpp"
#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/mesh/valence.hpp"
#include "mesher/plane/tile/tile_valence.hpp"
#include "mesher/portable/portable_functions.hpp"

namespace pcvt {
namespace {

/// Replaces relative areas that rounding made zero or negative.
constexpr double kLeastShare = 1e-12;

static_assert(kSiteClasses == kCellColours);

const std::vector<SiteId>& owners(const plane::Tile& tile) {
    return faces_have_sites(tile.kind) ? tile.face_site : tile.vertex_site;
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

/// Returns classes of one ratio for values that are given by their logarithms to the base 2.
TileColours colours_by_value(const plane::Tile& tile, const std::map<SiteId, double>& octaves,
                             const ValueWords& words) {
    std::vector<double> values;
    for (const auto& [site, octave] : octaves) values.push_back(octave);
    const ValueClasses classes(values, words);
    TileColours colours{.class_of = {}, .classes = classes.classes(), .explanation = {}};
    for (const SiteId site : owners(tile)) {
        colours.class_of.push_back(classes.of(octaves.at(site)));
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

bool has_orientations(const SiteQuantities& quantities) {
    return quantities.materials != nullptr && !quantities.materials->site_orientation.empty();
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
        case ColouringNeed::kOrientations:
            return has_orientations(quantities);
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

TileColours cell_classes(std::vector<int> class_of) {
    TileColours colours{.class_of = std::move(class_of), .classes = {}, .explanation = {}};
    for (int k = 0; k < kCellColours; ++k) {
        colours.classes.push_back({cell_colour(k), "cell_colour_" + std::to_string(k), ""});
    }
    return colours;
}

TileColours colours_by_cells(const plane::Tile& tile, const SiteQuantities&) {
    return cell_classes(site_classes(tile));
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
    return phase_classes(*quantities.materials, owners(tile));
}

TileColours colours_by_tag(const plane::Tile& tile, const SiteQuantities& quantities) {
    TileColours colours = colours_by_phase(tile, quantities);
    colours.explanation = " by tag";
    return colours;
}

TileColours colours_by_orientation(const plane::Tile& tile, const SiteQuantities& quantities) {
    TileColours colours = orientation_classes(quantities.materials->site_orientation);
    const std::vector<int> of_site = std::move(colours.class_of);
    colours.class_of.clear();
    for (const SiteId site : owners(tile)) {
        colours.class_of.push_back(of_site[static_cast<std::size_t>(site) % of_site.size()]);
    }
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
    if (row.colours == nullptr || !are_there(row.needs, quantities)) {
        throw InternalError(std::string("there is no ") + row.word + " to show in colours");
    }
    return row.colours(tile, quantities);
}

Colouring default_picture_colouring(const plane::Tile& tile, const SiteQuantities& quantities) {
    if (has_phases(quantities)) return Colouring::kPhase;
    if (has_orientations(quantities)) return Colouring::kOrientation;
    if (mesh_kind_row(tile.kind).grain_size) return Colouring::kCells;
    return quantities.densities.empty() ? Colouring::kSides : Colouring::kSize;
}

}  // namespace pcvt
