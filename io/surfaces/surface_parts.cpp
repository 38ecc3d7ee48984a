#include "io/surfaces/surface_parts.hpp"

#include <map>
#include <utility>

#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

/// Truncated octahedra have this many faces; like hexagons they are pale, and others stand out.
constexpr int kUsualFaces = 14;
constexpr int kUsualSides = 6;

/// The runs of faces with equal keys.
template <class Key>
std::vector<SurfacePart> runs(int n_faces, const Key& key) {
    std::vector<SurfacePart> parts;
    for (int f = 0; f < n_faces; ++f) {
        checkpoint_each(f);
        if (f == 0 || key(f) != key(f - 1)) {
            SurfacePart& part = parts.emplace_back();
            part.first_face = f;
        }
        ++parts.back().n_faces;
    }
    return parts;
}

SurfaceParts cell_parts(const SurfaceList& list) {
    SurfaceParts result;
    result.parts = runs(list.faces.n_faces(), [&](int f) { return list.cell[f]; });
    std::map<int, int> class_of;
    for (const SurfacePart& part : result.parts) class_of[part.n_faces] = 0;
    for (auto& [n_faces, colour] : class_of) {
        colour = static_cast<int>(result.classes.size());
        ColourClass& shown = result.classes.emplace_back();
        shown.colour = side_colour(n_faces - kUsualFaces + kUsualSides);
        shown.name = "faces_" + std::to_string(n_faces);
    }
    for (SurfacePart& part : result.parts) {
        part.name = "cell_" + std::to_string(list.cell[part.first_face]);
        part.colour = class_of[part.n_faces];
    }
    return result;
}

SurfaceParts seam_parts(const SurfaceList& list) {
    SurfaceParts result;
    result.parts = runs(list.faces.n_faces(), [&](int f) { return list.offset[f]; });
    // Both sides of a seam have one colour.
    std::map<space::Offset, int> class_of;
    for (SurfacePart& part : result.parts) {
        const space::Offset offset = list.offset[part.first_face];
        part.name = seam_name(offset);
        const auto [found, is_new] = class_of.try_emplace(std::max(offset, -offset),
                                                          static_cast<int>(result.classes.size()));
        part.colour = found->second;
        if (!is_new) continue;
        ColourClass& shown = result.classes.emplace_back();
        shown.colour = seam_colour(static_cast<std::size_t>(part.colour));
        shown.name = seam_name(found->first);
    }
    return result;
}

}  // namespace

SurfaceParts surface_parts(const SurfaceList& list) {
    return list.form == SurfaceForm::kCells ? cell_parts(list) : seam_parts(list);
}

}  // namespace pcvt
