#include "io/colours/cell_colours.hpp"

#include <algorithm>
#include <array>
#include <map>
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
    std::map<int, int> n_cells;
    for (const int n : n_faces) ++n_cells[n];
    TileColours colours{.class_of = {}, .classes = {}, .explanation = ", by number of faces"};
    std::map<int, int> class_of;
    for (const auto& [n, count] : n_cells) {
        class_of[n] = static_cast<int>(colours.classes.size());
        colours.classes.push_back(
            {.colour = side_colour(n - kUsualFaces + kUsualSides),
             .name = "faces_" + std::to_string(n),
             .label = std::to_string(n) + " faces: " + std::to_string(count)});
    }
    for (const int n : n_faces) colours.class_of.push_back(class_of.at(n));
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

TileColours colours_by_orientation(const std::vector<BungeAngles>& angles) {
    std::vector<std::array<int, 3>> shown;
    for (const BungeAngles& own : angles) {
        std::array<int, 3>& colour = shown.emplace_back();
        const auto exact = pole_colour(own);
        std::transform(exact.begin(), exact.end(), colour.begin(), [](int part) {
            return (part + kColourStep / 2) / kColourStep * kColourStep;
        });
    }
    std::map<std::array<int, 3>, int> class_of;
    for (const auto& colour : shown) class_of.try_emplace(colour, 0);
    TileColours colours{.class_of = {},
                        .classes = {},
                        .explanation =
                            ", by orientation (inverse pole figure along z of cubic "
                            "crystals: red 001, green 011, blue 111)"};
    for (auto& [colour, k] : class_of) {
        k = static_cast<int>(colours.classes.size());
        const Colour srgb{colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0};
        colours.classes.push_back({srgb, "ipf_" + hex(srgb).substr(1), ""});
    }
    for (const auto& colour : shown) colours.class_of.push_back(class_of.at(colour));
    return colours;
}

std::vector<SiteId> all_cells(const CellQuantities& cells) {
    std::vector<SiteId> sites(cells.n_faces.size());
    std::iota(sites.begin(), sites.end(), 0);
    return sites;
}

}  // namespace

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
            return colours_by_orientation(cells.materials->site_orientation);
        default:
            throw InternalError("cells in space do not have the quantity that colours show");
    }
}

}  // namespace pcvt
