#include "io/colours/cell_colours.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <string>

#include "io/colours/pole_colours.hpp"
#include "io/colours/value_classes.hpp"
#include "mesher/base/error.hpp"
#include "mesher/portable/portable_functions.hpp"

namespace pcvt {
namespace {

/// Truncated octahedra have this many faces; like hexagons they are pale, and others stand out.
constexpr int kUsualFaces = 14;
constexpr int kUsualSides = 6;
/// Replaces relative volumes that rounding made zero or negative.
constexpr double kLeastVolumeShare = 1e-12;
/// The difference of the components of colours of orientations.
constexpr int kColourStep = 15;

TileColours colours_by_faces(const std::vector<int>& n_faces) {
    // The number of cells with each number of faces, then its class.
    std::vector<int> of_number(1 + *std::max_element(n_faces.begin(), n_faces.end()), 0);
    for (const int n : n_faces) ++of_number[n];
    TileColours colours{.class_of = {}, .classes = {}, .explanation = ", by number of faces"};
    for (int n = 0; n < std::ssize(of_number); ++n) {
        if (of_number[n] == 0) continue;
        const std::string number = std::to_string(n);
        colours.classes.push_back({.colour = side_colour(n - kUsualFaces + kUsualSides),
                                   .name = "faces_" + number,
                                   .label = number + " faces: " + std::to_string(of_number[n])});
        of_number[n] = static_cast<int>(colours.classes.size()) - 1;
    }
    for (const int n : n_faces) colours.class_of.push_back(of_number[n]);
    return colours;
}

TileColours colours_by_volume(const std::vector<double>& volumes) {
    const double mean =
        std::accumulate(volumes.begin(), volumes.end(), 0.0) / double(volumes.size());
    std::vector<double> octaves;
    for (const double volume : volumes) {
        octaves.push_back(portable_log2(std::max(volume / mean, kLeastVolumeShare)) / 3);
    }
    const ValueClasses sizes(octaves, {"size", 2, " h"});
    TileColours colours{.class_of = {},
                        .classes = sizes.classes(),
                        .explanation = ", by size; h = cbrt(volume / n)"};
    for (const double octave : octaves) colours.class_of.push_back(sizes.of(octave));
    return colours;
}

/// A colour of pole_colour() with rounded components, as red, green and blue in one number.
int rounded_pole_colour(const BungeAngles& angles) {
    int packed = 0;
    for (const int part : pole_colour(angles)) {
        packed = 256 * packed + (part + kColourStep / 2) / kColourStep * kColourStep;
    }
    return packed;
}

std::vector<SiteId> all_cells(const CellQuantities& cells) {
    std::vector<SiteId> sites(cells.n_faces.size());
    std::iota(sites.begin(), sites.end(), 0);
    return sites;
}

}  // namespace

TileColours orientation_classes(std::span<const BungeAngles> angles) {
    std::vector<int> shown;
    for (const BungeAngles& own : angles) shown.push_back(rounded_pole_colour(own));
    std::vector<int> classes = shown;
    std::sort(classes.begin(), classes.end());
    classes.erase(std::unique(classes.begin(), classes.end()), classes.end());
    TileColours colours{.class_of = {},
                        .classes = {},
                        .explanation =
                            ", by orientation (inverse pole figure along z of cubic "
                            "crystals: red 001, green 011, blue 111)"};
    for (const int packed : classes) {
        const Colour srgb{(packed >> 16) / 255.0, (packed >> 8 & 255) / 255.0,
                          (packed & 255) / 255.0};
        colours.classes.push_back({srgb, "ipf_" + hex(srgb).substr(1), ""});
    }
    for (const int packed : shown) {
        const auto found = std::lower_bound(classes.begin(), classes.end(), packed);
        colours.class_of.push_back(static_cast<int>(found - classes.begin()));
    }
    return colours;
}

TileColours phase_classes(const CellMaterials& materials, std::span<const SiteId> cells) {
    const std::vector<int>& phases = materials.site_phase;
    TileColours colours{.class_of = {}, .classes = {}, .explanation = " by phase"};
    for (const SiteId site : cells) {
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

TileColours cell_colours(Colouring colouring, const CellQuantities& cells) {
    TileColours colours;
    switch (colouring) {
        case Colouring::kFaces:
            return colours_by_faces(cells.n_faces);
        case Colouring::kSize:
            return colours_by_volume(cells.volumes);
        case Colouring::kCells:
            return cell_classes({cells.classes.begin(), cells.classes.end()});
        case Colouring::kPhase:
            colours = phase_classes(*cells.materials, all_cells(cells));
            colours.explanation = ", by phase";
            return colours;
        case Colouring::kOrientation:
            return orientation_classes(cells.materials->site_orientation);
        default:
            throw InternalError("cells in space do not have the quantity that colours show");
    }
}

}  // namespace pcvt
